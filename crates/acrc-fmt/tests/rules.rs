//! What each rule does to an untidy program: the text before, and the text after.

mod support;

use acrc_fmt::{BlockEnds, KeywordCase, Options, format};

/// The text before and after. Tabs are shown, and where each line ends.
fn shown(text: &str, options: Options) -> String {
    support::checked(text);
    let visible = |text: &str| text.replace('\t', "\u{2192}").replace('\r', "\u{240D}").replace('\n', "|\n");
    format!("{}--\n{}", visible(text), visible(&format(text, &options).text))
}

fn standard(text: &str) -> String {
    shown(text, Options::default())
}

const MESSY: &str = "\
#define Clamp Bit40
#DEFINE setHeight p5
prog0
program
dim lv(2) : dim $v(1,20)
_Start
if(lv0 mod 2=1 and not Clamp)then set Clamp:gosub Step2
axis0 jog abs 5 : x5 Y/sqrt(p5) z setHeight
print chr$(65); \"set p5\" : rem set p5 to lv0
'set p5 to lv0
goto Start
_Step2
return
endp
";

#[test]
fn keywords_are_written_in_capitals() {
    insta::assert_snapshot!(standard(MESSY));
}

#[test]
fn keywords_are_written_small_when_asked_for() {
    insta::assert_snapshot!(shown(MESSY, Options { keyword_case: KeywordCase::Lower, ..Options::default() }));
}

#[test]
fn keywords_stay_as_they_are_when_asked_for() {
    insta::assert_snapshot!(shown(MESSY, Options { keyword_case: KeywordCase::Keep, ..Options::default() }));
}

#[test]
fn statements_are_set_off() {
    insta::assert_snapshot!(standard(
        "SET32:CLR 33  :  DWL0.5\nACC10DEC10   STP10 VEL 1\nSET34SET35\n:REM first a colon\nX5::Y5\nIF(P0)THENSET 32:CLR33\n\
         REM  text: of a remark\nDWL 1 REM no colon\nDWL 1'late\n10SET32\n20   GOTO10\n"
    ));
}

#[test]
fn expressions_are_spaced_evenly() {
    insta::assert_snapshot!(standard(
        "P0=P1+P2*-3\nP0 = ( P1-P2 )/SQRT ( P3 )\nP0=- P1 - -1\nLA0 ( LV0-1 )=P ( LV1 ) MOD 4\nBIT 40 = NOT BIT24\n\
         IF(P0>=1AND P1<>2OR(BIT 3=0))THEN P0=2**3<<1\n$V0=$V1+CHR$ (65)+\"a\"\nWHILE(P0<1E5)\nWEND\n\
         FOR LV0=0TO 9STEP 1\nNEXT\nFOR LV0=-1 TO-P0\nNEXT\n"
    ));
}

#[test]
fn arguments_are_spaced_evenly() {
    insta::assert_snapshot!(standard(
        "X 5 Y-3 Z / -.5\nX(P0)Y (P0+1) Z P2\nX1.5Y 2\nX10Y20SINE Z(0,90,90,100)\nMOV X Speeds\nPPU X 4000\nSLM X( 24,0 )\n\
         JOG VEL X20Y5\nJOG ABS AXIS0/5\nRES AXIS 0 5\nAXIS 0 PPU4000\nENC 0 RES\nENC0 MULT4\nATTACH SLAVE0AXIS1\"X\"\n\
         ATTACH AXIS 0 ENC 0 DAC 0\nGEAR SRC X ENC2\nSET34\nSET BIT 34\nINH-516\nINH - BIT 516\nINH -Clamps\n\
         IHPOS-P12290(100,5)\nVEL 10\nVEL(P0)\nDWL ( P0 )\nPROG 1\nRUN PROG 1\nCONFIG ENC2 DAC2 STEPPER4\nCLEAR COM1\n\
         DIM LV10\nDIM LA 2\nDIM PROG 0 (100)\n"
    ));
}

#[test]
fn input_and_output_are_spaced_evenly() {
    insta::assert_snapshot!(standard(
        "PRINT\"a\";P0,P1;\nPRINT#1,\"a\"  ;  P0\nPRINT USING\"##.#\";P0\n?P0\nINPUT;\"name\";$V0\nINPUT # 1 , LV0,LV1\n\
         OPEN\"COM1:9600,n,8,1\"AS # 1\nCLOSE#1\n"
    ));
}

#[test]
fn numbers_keep_their_distance() {
    // A letter behind a number could become its exponent, a number behind a name a part of it.
    insta::assert_snapshot!(standard(
        "X1 E5\nX1E5\nVEL 0x10\nVEL 0 X10\nGOTO Loop1\nLoop1 = 5\nC 5\nX5Y=3\nX 5 Y=3\nDACSTEP 2\nNEXT X 5\nNEXT : X 5\n"
    ));
}

#[test]
fn blocks_are_indented_as_the_controller_lists_them() {
    insta::assert_snapshot!(standard(BLOCKS));
}

#[test]
fn ends_of_blocks_stand_below_their_openers_when_asked_for() {
    let options = Options { block_ends: BlockEnds::Opener, indent: 2, ..Options::default() };
    insta::assert_snapshot!(shown(BLOCKS, options));
}

const BLOCKS: &str = "\
PROGRAM
  FOR LV0 = 0 TO 9
 IF (BIT 24)
\t\tSET 32
'nobody there
ELSEIF (BIT 25)
SET 33
      ELSE
WHILE (BIT 26)
WEND
IF (BIT 27) THEN CLR 32 : CLR 33
ENDIF
NEXT
FOR LV0 = 0 TO 9 : X/1 : NEXT
IF (BIT 28) : SET 1
_Inside
SET 2 : ENDIF
    END
ENDP
";

#[test]
fn a_block_that_does_not_close_is_not_indented() {
    insta::assert_snapshot!(standard(
        "PROGRAM\nWHILE (BIT 1)\nIF (BIT 24)\n  SET 32\nWEND\nNEXT\nENDP\nPROGRAM\nENDIF\nSET 33\nENDP\n"
    ));
}

#[test]
fn numbers_of_lines_stand_before_the_indentation() {
    insta::assert_snapshot!(standard("10FOR LV0=0 TO 9\n20 IF (BIT 24)\n 30 SET 32\n100   ENDIF\n110NEXT\n120\n"));
}

#[test]
fn remarks_of_neighbouring_lines_stand_in_a_column() {
    insta::assert_snapshot!(standard(
        "HLIM X3 : REM hardware limits\nJOG ACC X500:REM ramp\nX5    REM no colon\nDWL 0.25 ' late\nSET 32\n\
         SET 33 : REM alone\n\nIF (BIT 24) : REM part there\nSET 34 : REM close\nENDIF : REM done\nREM a line of its own\n\
         X5 : REM near\nPRINT \"a text that is so long that its remark has no column with others\" : REM far\nY5 : REM near\n\
         PRINT \"ä\" : REM by characters\nPRINT \"ab\" : REM not by bytes\n"
    ));
}

#[test]
fn tables_of_names_and_memory_stand_in_columns() {
    insta::assert_snapshot!(standard(
        "DIM PROG0(8192)\nDIM PROG10 (1000)\nDIM P(100):REM user variables\nDIM DEF  (20)\n\n#DEFINE LightCurtain BIT10\n\
         #DEFINE Camera     BIT34 : REM output\n#DEFINE Exposures P0\nREM others\n#DEFINE Long P1\n#DEFINE LongLong P1 : #DEFINE Two P2\n\
         DIM LV(1)\nDIM LV10\nDIM $V(1,10)\n"
    ));
}

#[test]
fn columns_are_left_out_when_asked_for() {
    let options = Options { align_remarks: false, align_tables: false, ..Options::default() };
    insta::assert_snapshot!(shown("#DEFINE A   P0   : REM a\n#DEFINE LongLong P1 : REM b\n", options));
}

#[test]
fn subroutines_are_set_apart() {
    insta::assert_snapshot!(standard(
        "\n\n\nPROGRAM\n\n\n\nGOSUB A\nEND\n_A\nSET 1\nRETURN : REM done\nREM opens the gripper\n'and waits\n_B\nSET 2\n\
         IF (BIT 2) THEN RETURN\n_C\nSET 3\nRETURN\n\n\nREM of the label below\n_D\nRETURN\nREM of the routine above\n\n_E : REM on the line of a label\nRETURN : REM done\n_LongName : REM on the line of a label\n_E2\nRETURN\nENDP\n\n\n"
    ));
}

#[test]
fn lines_that_cannot_be_read_stay() {
    insta::assert_snapshot!(standard(
        "PROGRAM\nif(bit 24)\n  set  32,,   \n\tprint \"open   \nclr32\nP0=0x1F\nIF (BIT 1) THEN\nx5:frobnicate  now:y5\nendif\nENDP\n"
    ));
    let unreadable = format("SET 32\n@\nIF (P0) THEN\nX5\n", &Options::default()).unreadable;
    assert_eq!(unreadable, [2, 3]);
}

#[test]
fn regions_are_left_alone() {
    insta::assert_snapshot!(standard(
        "set32\n  '  ACRC: fmt  off\nset33   :   clr34\n\n\n   x5  \n'acrc:fmt on\nset35\nRETURN\nREM acrc: fmt off\n_a\n   set 36\n\n"
    ));
}

#[test]
fn line_ends_are_unified() {
    insta::assert_snapshot!(standard("SET 32 \r\nSET 33\t\r\nSET 34\n\n\nSET 35"));
    assert_eq!(format("SET 1\rSET 2", &Options::default()).text, "SET 1\rSET 2\r");
    assert_eq!(format("", &Options::default()).text, "");
    assert_eq!(format(" \n\n\t\r\n", &Options::default()).text, "");
}

#[test]
fn typographic_characters_stay_for_the_linter() {
    insta::assert_snapshot!(standard(
        "X5\u{A0}Y5   SET32\nINH   \u{2013}516\nPRINT\u{201C}a\u{201D};P0\n\u{A0}\u{A0}SET32 \u{A0} \nREM a\u{A0}\u{2026} \n"
    ));
}
