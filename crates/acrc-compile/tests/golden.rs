//! The words of each construct, with their source and their listing, for people to read.

mod common;

use acrc_image::dump::dump;
use common::{listing, program};

fn golden(source: &str) -> String {
    let (unit, image) = program(source);
    format!(
        "{source}\n--- {} bytes\n{}--- listed\n{}",
        unit.memory(),
        dump(&unit).expect("compiled units can be dumped"),
        listing(&unit, &image)
    )
}

macro_rules! golden {
    ($($name:ident: $source:literal;)*) => {
        $(#[test]
        fn $name() {
            insta::assert_snapshot!(golden($source));
        })*
    };
}

golden! {
    values: "ACC 10000\nDWL 0.25 : vel(P0)\nFOV 0.123456789";
    constants: "P1 = 7 P2 = -7 : P3 = 1.5 : P4 = -1e-005 : P5 = 39999.999404 : P6 = 4294967295 : P7 = -2147483648 : P8 = 3.0000000";
    flags: "SET34 CLR BIT 35 : INH -516 : INH +24 : INH -0 : SET BIT(LV0 + 1) : SET (P0) : INH -(P1)";
    operands: "P0 = P(12288+256*LV0) : LA0(LV1) = LA(2)(3) : BIT 32 = NOT BIT32 : $V0 = \"\"";
    expressions: "LV0 = 4+6/2 : DV0 = ((1+2)*-LV1) ** 2 : LV2 = (P0 > 5) and not Bit24 : DV1 = SQRT(DV0) + atan(1)";
    strings: "$V0 = UCASE$(INKEY$(1)) + CHR$(34) + MID$($V1, 2, 3)";
    axes: "X1.5Y2 : X/25 Y / -30 : PPU X4000 Y(P3) : SLM x(24, 0) : DRIVE ON X AXIS1";
    moves: "MOV X10 : X2 SINE Y(0,90,90,100) : CIRCW X(1,2) Y(3,4) Z5";
    objects: "AXIS0 PPU 4000 : AXIS3 JOG INC 5 : ENC 0 RES : MASTER1 VEL 500 : RES AXIS0 5 : GEAR SRC X ENC2 Y CLOCK : SRC P12290";
    system: "RUN PROG1 : HALT ALL : CONFIG ENC8 DAC4 DAC4 ADC8 : ATTACH SLAVE0 AXIS0 \"X\" : ATTACH MASTER0 : PLS0 BASE LA0 : CLOSE #1";
    blocks: "IF (P0 = 1)\nX5\nELSEIF (P0 = 2)\nX6\nELSE IF (1)\nWHILE (BIT 24)\nBREAK\nWEND\nELSE\nX7\nENDIF\nEND";
    one_line_if: "IF (BIT 24) THEN P0 = P0+1 : GOSUB 100\nIF(0)THEN\nEND";
    loops: "FOR LV0 = 0 TO 499\nNEXT\nFOR LV1 = LV2 TO (LV3-1) STEP 2 : NEXT";
    jumps: "_Start\nGOSUB Sub1 : GOTO Start\n_Sub1\nRETURN\nGOTO 100";
    printing: "PRINT \"a\"; P0, P1;\n?\nPRINT #1, \"x\"\nPRINT #1\nPRINT #1, USING \"##.#\"; P0; P1\nPRINT(P1/P2)";
    reading: "INPUT LV0\nINPUT; \"How many? \"; $V0\nINPUT #1, \"x, y\", LV0, LV1\nOPEN \"COM1:9600,N,8,1\" AS #1 REM port";
    memory: "DIM LV(2) : DIM $V(1,10) : DIM LA(3) : DIM LA0(500) : DIM $A0(5,10) : DIM DA0(LV1) : DIM LV10 : DIM";
    remarks: "REM  two blanks before\nREM---line---\t\nX5 : REM 45\u{b0} \u{2013} \u{201c}quoted\u{201d}\u{2026} \u{3a9}\nREM\n' vanishes\n\n_Name";
    aliases: "#DEFINE Speed P100\n#DEFINE Ready BIT128\n#DEFINE Ratio 3.125\nSET Ready : INH -Ready\nVEL (Speed * Ratio)\nSpeed = 5 : IF (Ready) THEN X(Speed)";
    line_numbers: "10 VEL 5 : X10\n20 REM second\nGOTO 10";
    many_items: "DRIVE ON A B C D E G H I J L M N O Q R S\nLIST 1 2\nPRINT 1; 2; 3; 4; 5, 6.5";
}

#[test]
fn line_numbers_can_be_shown_for_all_lines() {
    let (unit, image) = program("VEL 5\n15 ACC 10\nIF (P0)\nX5\nENDIF");
    let options = acrc_image::list::ListOptions { line_numbers: true };
    let listed = acrc_image::list::list(&unit, &image.aliases, &options).expect("compiled units can be listed");
    insta::assert_snapshot!(listed);
}
