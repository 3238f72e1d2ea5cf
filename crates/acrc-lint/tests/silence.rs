//! Programs that are right, in the spellings that are found in the field: no rule may complain.

use acrc_analysis::project::Config;
use acrc_analysis::{Database, FileRole, Project, SourceFile};
use acrc_diagnostics::Severity;

/// Errors and warnings in a project, as lines of text.
fn complaints(files: &[(&str, &str)]) -> Vec<String> {
    let db = Database::new();
    let inputs = files.iter().map(|(name, text)| {
        SourceFile::new(&db, (*name).to_owned(), (*text).to_owned(), FileRole::of(name), Vec::new())
    });
    let project = Project::new(&db, inputs.collect(), acrc_catalog::default_model(), Config::default());
    let mut complaints = Vec::new();
    for (file, found) in acrc_lint::check(&db, project) {
        for diagnostic in found.iter().filter(|diagnostic| diagnostic.severity > Severity::Advice) {
            let text = &file.text(&db)[diagnostic.span.range()];
            complaints.push(format!("{}: `{text}`: {} {}", file.name(&db), diagnostic.code, diagnostic.message));
        }
    }
    complaints
}

fn assert_silent(text: &str) {
    assert_eq!(complaints(&[("test.8K", text)]), Vec::<String>::new(), "{text}");
}

#[test]
fn ladder_programs() {
    assert_silent(
        "SYS\nDIM PLC0(1000)\nPLC0\nPROGRAM\nLD 5 AND 6 OUT 32\nLD NOT 7\nOR 8\nTIM 0 100\nOUT 33\nENDP\nRUN PLC0\n",
    );
}

#[test]
fn numbered_lines() {
    assert_silent(
        "PROG0\nNEW\n10 P0 = 0\n20 P0 = P0 + 1\n30 IF (P0 < 10) THEN GOTO 20\n40 GOSUB 100\n50 END\n100 RETURN\n",
    );
}

#[test]
fn spellings_of_the_field() {
    let setup = "#DEFINE EXITFLAG P5\nPROG0\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH SLAVE1 AXIS1 \"Y\"\n";
    for line in [
        "ACC10 DEC10 STP10 VEL1",
        "CLR 8467 CLR8499",
        "RES X 0 RES Y 0",
        "X1.5Y2",
        "X / 0.2 Y/-3",
        "PPU X4000 Y 4000 HLIM X3Y3",
        "AXIS0 JOG INC 5 : AXIS1 RES",
        "JOG OFF X JOG FWD X Y",
        "EXITFLAG=30:GOTO Done",
        "MOV X(P0+P1) Y(SQRT(P2))",
        "IF (BIT24 AND NOT BIT25)THEN SET34:CLR35",
        "?P12290/P12375",
        "GEAR SRC X ENC2 : GEAR RATIO X-2.5 : GEAR ON X",
        "IHPOS -P12290 (100, 0)",
        "SET BIT(32 + P0)",
        "DRIVE ON AXIS0 AXIS1",
        "FOV 0.5 MASTER0 VEL 5",
    ] {
        assert_silent(&format!("{setup}PROGRAM\n{line}\n_Done\nENDP\n"));
    }
}

#[test]
fn a_whole_project() {
    let setup = "SYS\nHALT ALL\nNEW ALL\nCLEAR\nDETACH ALL\nDIM PROG0(8192)\nDIM PROG1(4096)\nDIM P(100)\nDIM DEF(10)\n\
                 #DEFINE Ready BIT128\n#DEFINE Lamp BIT33\n#DEFINE Cycles P10\n\
                 ATTACH AXIS0 ENC0 DAC0 ENC0\nATTACH AXIS1 STEPPER0 STEPPER0\nAXIS0 PPU 2000\nAXIS0 EXC (0.5,-0.5)\n\
                 PROG0\nDETACH\nATTACH MASTER0\nATTACH SLAVE0 AXIS0 \"X\"\nATTACH SLAVE1 AXIS1 \"ROT\"\n\
                 ACC 100 DEC 100 STP 100 VEL 20 JOG VEL X10\n";
    let motion = "PROGRAM\nDIM LV(2)\nDIM $V(1,20)\nDRIVE ON X ROT\nGOSUB Home\n_Cycle\nSET Ready\n\
                  FOR LV0 = 1 TO 4 STEP 1\nROT/90\nINH -516\nIF (BIT 5)\nGOSUB Press\nELSE IF (BIT 6)\nBREAK\nELSE\n\
                  DWL 0.1\nENDIF\nNEXT\nCycles = Cycles + 1\n$V0 = \"cycle \" + STR$(Cycles)\nPRINT #1, $V0; \" done\"\n\
                  GOTO Cycle\n_Home\nJOG HOME X-1\nWHILE (NOT BIT 16134 AND NOT BIT 16135)\nWEND\n\
                  IF (BIT 16135) THEN END\nRETURN\n_Press\nSET Lamp\nX10\nX0\nINH -516\nCLR Lamp\nRETURN\nENDP\n";
    let watch = "PROGRAM\nPBOOT\n_Loop\nIF (Ready) THEN SET 40 : DWL 0.5\nCLR 40\nDWL 0.5\nGOTO Loop\nENDP\n";
    let files = [("Setup.8K", setup), ("Prog0.8K", motion), ("Prog1.8K", watch)];
    assert_eq!(complaints(&files), Vec::<String>::new());
}

#[test]
fn memory_as_it_is_given_in_the_field() {
    // The wizard's order; sizes without parentheses; stream buffers; a text that is entered again.
    assert_silent(
        "SYS\nHALT ALL\nNEW ALL\nCLEAR\nDETACH ALL\nDIM PROG0(1000)\nDIM PROG1 (500)\nDIM P (200)\nDIM DEF(2)\n\
         DIM COM1(1024)\nDIM STREAM2(2048)\n#DEFINE Speed P199\n#DEFINE Index LV3\nPROG0\nPROGRAM\nSET 32\nENDP\n\
         PROG1\nDIM LV(4)\nPROGRAM\nIndex = Speed\nENDP\nPROG0\nNEW\nPROGRAM\nCLR 32\nENDP\n",
    );
    // The system memory was given by hand, once and for all.
    assert_silent("PROG13\nPROGRAM\nP6 = P5\nENDP\n");
    // Variables are dimensioned at the prompt, and anew whenever the program runs.
    assert_silent("PROG0\nCLEAR\nDIM LV(2)\nPROGRAM\nCLEAR\nDIM LV(8)\nDIM DV(2)\nLV7 = DV1\nENDP\n");
    // What a subroutine dimensions after the main program asked for its size.
    assert_silent(
        "PROG0\nPROGRAM\nCLEAR\nDIM LV(2)\nDIM DA(1)\nGOSUB Ask\nFOR LV0 = 0 TO LV1 - 1\nDA0(LV0) = 0\nNEXT\nEND\n\
         _Ask\nINPUT \"points? \"; LV1\nDIM DA0(LV1)\nRETURN\nENDP\n",
    );
    // A ring, a table of rows, and a loop that ends before its bound.
    assert_silent(
        "PROG0\nPROGRAM\nCLEAR\nDIM LV(3)\nDIM LA(1)\nDIM LA0(12)\nWHILE (BIT 1)\nLA0(LV2 MOD 12) = P12290\n\
         LV2 = LV2 + 1\nWEND\nFOR LV0 = 0 TO 3\nFOR LV1 = 0 TO 2\nLA0(LV0 * 3 + LV1) = 0\nNEXT\nNEXT\n\
         FOR LV0 = 1 TO 12 STEP 4\nLA0(LV0) = LA0(LV0 - 1)\nNEXT\nENDP\n",
    );
}
