//! The tree of each construct of the language: source and tree side by side.

mod support;

use acrc_syntax::debug_tree;

/// Reads a program that has nothing wrong, and shows it with its tree.
fn shown(source: &str) -> String {
    let tree = support::checked(source);
    assert!(tree.errors().is_empty(), "{:#?}", tree.errors());
    format!("{source}\n----\n{}", debug_tree(&tree, source))
}

macro_rules! tree {
    ($name:ident, $source:expr) => {
        #[test]
        fn $name() {
            insta::assert_snapshot!(shown($source));
        }
    };
}

tree!(separators, "ACC10 DEC10 VEL 5 : STP 10\n:DWL 1\nSET34 CLR8499 : : INH -516 :");
tree!(line_numbers_and_comments, "10 VEL 1000\n20\n' the download drops this\n  30 REM kept : with its colons");
tree!(remarks, "REM\nREM-----stored-----\nrem lower case\nVEL 5 : REM behind a statement\n:REM at once");
tree!(labels, "_Start\n_Loop1\n_9\nGOTO Start : GOSUB Loop1\ngoto 100\nGOTO LOOP1E3");
tree!(
    assignments,
    "P0=1\nLV0 = LV1\n$V0 = \"\"\nBIT32=1\nBIT 33 = NOT BIT 34\nP(12288 + 256) = 2.5\nLA0(LV0) = 4\nSpeed = 10\nCount1 = -1"
);
tree!(
    expressions,
    "P0 = 2 + 6 / 3 * 5 - 9\nP0 = -2 ** 2\nP0 = (1 + P1) * -(P2 - 3)\nP0 = NOT BIT 5 = 1 AND P1 > 2 OR P2 <> 3\n\
     P0 = SIN(P1) + RND(1000) MOD 7 << 2\n$V0 = UCASE$(INKEY$(1)) + CHR$(27)\nP0 = LA0(1) + DA1(LV0 - 1)\nP0 = 1e-005 + .5 + 2."
);
tree!(
    moves,
    "X10\nX/25 Y -30\nX1.5Y2\nMOV X(P0 + 1) Y(DA0(LV0))\nX2 SINE Y(0,90,90,100)\nCIRCW X(10, 5) Y(0, 5)\nX / 0.2\nx5 P0=1"
);
tree!(
    axis_commands,
    "PPU X 4000 Y 4000\nSLM X(24, 0)\nRES X 0 RES Y 0\nRES X Y\nJOG VEL X(P0) Y Fast\nRES AXIS0\nRES AXIS1 5"
);
tree!(axis_lists, "DRIVE ON X Y\nDRIVE ON AXIS1 AXIS2\nDRIVE OFF X Y5\nDRIVE X\nJOG FWD AXIS0");
tree!(
    prefixes,
    "AXIS0 PPU 4 AXIS1 PPU 5\nAXIS0 PPU Ratio\nAXIS3 JOG INC 5\nAXIS0 SLM (24,0)\nAXIS7 OFF\nMASTER0 VEL500\nENC 0 RES\nENC0 SRC 0\nADC MODE 1\nDAC0 GAIN 3276.8"
);
tree!(
    sources,
    "GEAR SRC X ENC2 Y NONE\nGEAR SRC AXIS0 P12288\nSRC CLOCK\nSRC ENC0\nPLS0 BASE LA0\nCAM SEG X(0, 100, LA0)"
);
tree!(
    flags,
    "SET 32\nSET BIT32\nSET BIT(32)\nSET Ready\nCLR (P0)\nINH -516\nINH -Ready\nINH +5\nTRG (2, 1)\nINT -24 X100"
);
tree!(ladder, "LD 5 AND 6 OUT 32\nLD NOT 5 OR BIT 7 AND LD OR NOT 8\nTIM 0 100 CNT 1, 5\nTIM 0 Preset\nKR 3");
tree!(parameters_with_values, "IHPOS P12290 (100, 5)\nIHPOS -P12290 (Height, 0)\nMASK P4097 (1, 2)");
tree!(
    attachments,
    "ATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH AXIS0 ENC0 DAC0 ENC0\nATTACH\nDETACH ALL\nDETACH SLAVE0"
);
tree!(
    hardware,
    "CONFIG NONE STEPPER4 DACSTEP2 NONE\nCONFIG CLEAR\nCMT0 ENC0 ENC1\nCMT0 MAX RPM 3000\nFSTAT0 (48, 2)\nFSTAT ON"
);
tree!(
    program_control,
    "PROG0\nPROG 15\nPLC3\nSYS\nHALT PROG0 : RUN ALL\nLRUN\nLIST 10, 20\nINVK PROG7\nSYNC ON MASTER0 MASTER1"
);
tree!(
    one_line_if,
    "IF (P0 > 4) THEN GOSUB 100 : P0 = 0\nIF(P0=1)THEN PRINT \"ok\"\nIF (0) THENP12288= 0\nIF (P0) THEN IF (P1) THEN END"
);
tree!(block_if, "IF (BIT 24)\nELSEIF (BIT 25)\nELSE IF (BIT 26)\nELSE\nENDIF\nELSE : IF (BIT 27)\nIF (Ready) : REM go");
tree!(loops, "FOR LV0 = 0 TO 9\nNEXT\nFOR LV0=0 TO (LV1-1) STEP 2\nWHILE(BIT10=-1)\nBREAK\nWEND");
tree!(
    printing,
    "PRINT\nPRINT \"a\"; P0, LV0;\nPRINT(P1/P2)\n?P(12288 + 256)\n? Ready\nPRINT #1, USING \"##\"; Hours; \" h\"\nPRINT #1\nPRINT \"a\" P0=5"
);
tree!(input, "INPUT $V0\nINPUT; \"how many\"; $V0, P1\nINPUT #1, \"name\", $V1");
tree!(
    devices,
    "OPEN \"COM1:9600,n,8,1\" AS #1\nOPEN DTALK \"COM2:\" AS # 2\nCLOSE #1\nTALK TO \"COM1\"\nIP MASK \"255.255.255.0\""
);
tree!(
    memory,
    "DIM\nDIM LV(10)\nDIM $V(1, 80)\nDIM P (100)\nDIM PROG0(8192)\nDIM LA(2)\nDIM LA0(LV1)\nCLEAR\nCLEAR COM1\nCLEAR STREAM1"
);
tree!(aliases, "#DEFINE Ready BIT128 : REM handshake\n#define Speed 5\n#DEFINE Height1 LA0(2)\nReady = 1");
tree!(unusual_blanks, "\tVEL\t5\t\n   \n  PROG   0  \r\nX  /  2\rSET\u{20}BIT 5");
tree!(
    two_loosely_known_commands,
    "K 0.5 X1 Y2 W 1\nCAM ON IHPOS X P12290 (5, 0)\nINTCAP X 2 ENC1\nROTATE 45 X0 Y0\nDEF Speed"
);
