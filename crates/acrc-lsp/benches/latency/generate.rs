//! Projects as long as those of large machines.

use std::fmt::Write as _;
use std::fs;

use tempfile::TempDir;

/// Where somebody types: at the end of the line below the one that has this.
pub(crate) const MARK: &str = "cursor";

/// Programs besides the setup.
const PROGRAMS: usize = 14;
/// Stations of a program; each is a subroutine of some twenty lines.
const STATIONS: usize = 34;
/// Aliases of the setup.
const ALIASES: usize = 300;

/// Files in a folder.
pub(crate) struct Project {
    folder: TempDir,
    pub(crate) files: Vec<(String, String)>,
    /// The file in which somebody types.
    pub(crate) edited: usize,
}

impl Project {
    pub(crate) fn write(files: &[(String, String)]) -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        for (name, text) in files {
            fs::write(folder.path().join(name), text).expect("the file can be written");
        }
        Self { folder, edited: files.len() / 2, files: files.to_vec() }
    }

    pub(crate) fn uri(&self, name: &str) -> String {
        format!("file://{}/{name}", self.folder.path().canonicalize().expect("the folder is there").display())
    }

    pub(crate) fn lines(&self) -> usize {
        self.files.iter().map(|(_, text)| text.lines().count()).sum()
    }
}

/// A project of one short program.
pub(crate) fn small() -> Vec<(String, String)> {
    vec![("Prog0.8K".to_owned(), program(0, 1))]
}

/// A machine with a setup and many programs.
pub(crate) fn programs() -> Vec<(String, String)> {
    let mut files = vec![("Setup.8K".to_owned(), setup())];
    files.extend((0..PROGRAMS).map(|number| (format!("Prog{number}.8K"), program(number, STATIONS))));
    files
}

fn setup() -> String {
    let mut text = String::from("SYS\nHALT ALL\nNEW ALL\nDETACH ALL\nCLEAR\nDIM P(4096)\nDIM DEF(400)\n");
    for number in 0..PROGRAMS {
        writeln!(text, "DIM PROG{number}(64000)").expect("a string takes everything");
    }
    for axis in 0..8 {
        writeln!(text, "ATTACH AXIS{axis} ENC{axis} DAC{axis} ENC{axis}").expect("a string takes everything");
    }
    writeln!(text, "' {MARK}").expect("a string takes everything");
    for alias in 0..ALIASES {
        let operand = if alias % 2 == 0 { format!("BIT{}", 128 + alias) } else { format!("P{}", 100 + alias) };
        writeln!(text, "#DEFINE Station{alias} {operand}").expect("a string takes everything");
    }
    for (program, axes) in ["XY", "ZA", "BC", "UV"].iter().enumerate() {
        writeln!(text, "PROG{program}\nATTACH MASTER{program}").expect("a string takes everything");
        for (slave, axis) in axes.chars().enumerate() {
            let number = program * 2 + slave;
            writeln!(text, "ATTACH SLAVE{slave} AXIS{number} \"{axis}\"\nPPU {axis}2000")
                .expect("a string takes everything");
        }
        writeln!(text, "ACC 100 DEC 100 STP 100 VEL 10").expect("a string takes everything");
    }
    text
}

fn program(number: usize, stations: usize) -> String {
    let mut text = format!("PROGRAM\n' program {number} of the machine\nDIM LV(20)\nDIM DV(20)\n_Start\n");
    for station in 0..stations {
        writeln!(text, "GOSUB Do{station}").expect("a string takes everything");
    }
    text.push_str("GOTO Start\n");
    for station in 0..stations {
        let flag = (number * stations + station) * 2 % ALIASES;
        let (axis, mark) = (["X", "Z", "B", "U"][number % 4], if station == stations / 2 { MARK } else { "part" });
        let moves = if number < 4 { format!("    {axis}{station}.5\n    INH -516\n") } else { String::new() };
        write!(
            text,
            "_Do{station}\n' {mark}\nP900 = P901\nIF (Station{flag})\n    SET Station{next}\n    P{user} = P{user} + 1\n{moves}\
             ELSE\n    CLR Station{next}\n    FOR LV1 = 0 TO 9 STEP 1\n        DV1 = DV1 + SQRT(P{user} * 2.5)\n    NEXT\n\
             ENDIF\nWHILE (Station{flag} AND NOT Station{next})\n    DWL 0.05\nWEND\nINH 32\n\
             IF (P{user} > 1000) THEN P{user} = 0\nPRINT \"station \"; {station}; \" done\"\nRETURN\n",
            next = (flag + 2) % ALIASES,
            user = 500 + station,
        )
        .expect("a string takes everything");
    }
    text.push_str("ENDP\n");
    text
}

/// All programs in one file.
pub(crate) fn one_file() -> Vec<(String, String)> {
    let mut text = setup();
    for number in 0..PROGRAMS {
        writeln!(text, "PROG{number}").expect("a string takes everything");
        text.push_str(&program(number, STATIONS));
    }
    vec![("machine.8K".to_owned(), text)]
}

/// All modules in one.
pub(crate) fn one_python_file() -> Vec<(String, String)> {
    vec![("machine.py".to_owned(), python().into_iter().map(|(_, text)| text).collect())]
}

/// Python of the same length in as many files.
pub(crate) fn python() -> Vec<(String, String)> {
    let files = PROGRAMS + 1;
    let module = |file: usize| {
        let mut text = String::from("import math\n\n\n");
        for station in 0..STATIONS {
            let mark = if station == STATIONS / 2 { MARK } else { "part" };
            write!(
                text,
                "def station_{station}(flags, values):\n    # {mark}\n    total = values[0]\n    if flags[{station}]:\n        flags[{station} + 1] = True\n\
                 \x20       values[{station}] += 1\n        values[{station} + 1] = {station}.5\n    else:\n\
                 \x20       flags[{station} + 1] = False\n        for index in range(10):\n\
                 \x20           values[index] += math.sqrt(values[{station}] * 2.5)\n    while flags[{station}]:\n\
                 \x20       flags[{station}] = False\n    if values[{station}] > 1000:\n        values[{station}] = 0\n\
                 \x20   print(\"station\", {station}, \"done\")\n    return values\n\n\n",
            )
            .expect("a string takes everything");
        }
        (format!("module{file}.py"), text)
    };
    (0..files).map(module).collect()
}
