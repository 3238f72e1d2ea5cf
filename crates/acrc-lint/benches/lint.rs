//! How fast a project is linted: 1,000 files of 10 KB, cold and after an edit.

use std::fmt::Write as _;
use std::hint::black_box;

use acrc_analysis::project::{Config, FileGlob, LintLevel, Override};
use acrc_analysis::{Database, FileRole, Project, SourceFile};
use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};

const FILES: usize = 1000;
const FILE_BYTES: usize = 10 << 10;

/// The setup of the generated project: aliases and axes for sixteen programs.
fn setup() -> String {
    let mut text = String::from("SYS\nDIM DEF(60)\nDIM P(200)\n");
    for letter in 'A'..='Z' {
        let number = u32::from(letter) - u32::from('A');
        let _ = writeln!(text, "#DEFINE Clamp{letter} BIT{}\n#DEFINE Count{letter} P{number}", 32 + number);
    }
    for axis in 0..8 {
        let _ = writeln!(text, "AXIS{axis} PPU 1000");
    }
    for program in 0..8 {
        let _ = writeln!(text, "PROG{program}\nATTACH MASTER{program}\nATTACH SLAVE0 AXIS{program} \"X\"");
        let _ = writeln!(text, "ACC 100 DEC 100 STP 100 VEL 25");
    }
    text
}

/// A program of about `FILE_BYTES` bytes with the mixture of statements that machine programs have.
fn program(number: usize) -> String {
    let level = number % 8;
    let in_motion = 516 + 32 * level;
    let mut text = format!("PROG{level}\nPROGRAM\nGOSUB Step0\nEND\n");
    let mut step = 0;
    while text.len() < FILE_BYTES {
        let letter = char::from(b'A' + (step % 26) as u8);
        let (output, input, value, counter, next) = (40 + step % 24, step % 24, step % 100, step % 50, step + 1);
        let _ = write!(
            text,
            "REM --- station {step} ---\n_Step{step}\nX/{step}.5 : REM to the station\nINH -{in_motion}\nSET Clamp{letter}\n\
             DWL 0.25\nCLR Clamp{letter} : SET {output}\nCount{letter} = Count{letter} + 1\n\
             IF (Count{letter} > 100) THEN PRINT \"station {step} is full\" : GOTO Full{step}\n\
             IF ((BIT {input} AND NOT BIT 25) OR P{value} <= 1.5)\n    P{value} = (P1 * 2 + SQRT(P2)) / 3\nELSE\n    \
             JOG VEL X25\nENDIF\nWHILE (P{counter} < 10)\n    P{counter} = P{counter} + 1\nWEND\n\
             _Full{step}\nGOSUB Step{next}\nRETURN\n\n",
        );
        step += 1;
    }
    let _ = writeln!(text, "_Step{step}\nRETURN");
    text.push_str("ENDP\n");
    text
}

fn generate() -> Vec<(String, String)> {
    let programs = (0..FILES).map(|number| (format!("part{number:03}.8K"), program(number)));
    std::iter::once(("Setup.8K".to_owned(), setup())).chain(programs).collect()
}

/// Choices of rules that every file must be compared with.
fn choices() -> Config {
    let mut config = Config::default();
    let glob = |pattern: &str| FileGlob::new(pattern).expect("a pattern");
    for digit in 0..10 {
        let selectors = vec!["style".to_owned(), "ACR103".to_owned()];
        config.lint.per_file_ignores.0.push((glob(&format!("part*{digit}.8K")), selectors));
    }
    config.lint.overrides.push(Override {
        files: vec![glob("part*.8K")],
        extend_select: vec!["flow".to_owned()],
        severity: [("ACR101".to_owned(), LintLevel::Warning)].into(),
        ..Override::default()
    });
    config
}

fn load(db: &Database, files: &[(String, String)], config: Config) -> (Project, Vec<SourceFile>) {
    let inputs: Vec<_> = files
        .iter()
        .map(|(name, text)| SourceFile::new(db, name.clone(), text.clone(), FileRole::of(name), Vec::new()))
        .collect();
    (Project::new(db, inputs.clone(), acrc_catalog::default_model(), config), inputs)
}

fn lint(criterion: &mut Criterion) {
    let files = generate();
    let bytes: usize = files.iter().map(|(_, text)| text.len()).sum();
    let mut group = criterion.benchmark_group("lint");
    group.sample_size(10).throughput(Throughput::Bytes(bytes as u64));
    group.bench_function("parsing alone", |bencher| {
        bencher.iter(|| files.iter().map(|(_, text)| acrc_syntax::parse(text).statements().len()).sum::<usize>());
    });
    for (name, config) in [("cold", Config::default()), ("cold, with choices for files", choices())] {
        group.bench_function(name, |bencher| {
            bencher.iter_batched_ref(
                || {
                    let db = Database::new();
                    let (project, _) = load(&db, &files, config.clone());
                    (db, project)
                },
                |(db, project)| black_box(acrc_lint::check(db, *project)),
                BatchSize::PerIteration,
            );
        });
    }
    group.bench_function("cold, all processors", |bencher| {
        bencher.iter_batched_ref(
            || {
                let db = Database::new();
                let (project, _) = load(&db, &files, Config::default());
                (db, project)
            },
            |(db, project)| black_box(acrc_lint::check_in_parallel(db, *project)),
            BatchSize::PerIteration,
        );
    });
    group.finish();

    let mut db = Database::new();
    let (project, inputs) = load(&db, &files, Config::default());
    let findings: usize = acrc_lint::check(&db, project).iter().map(|(_, found)| found.len()).sum();
    assert_eq!(findings, 0, "the generated project is clean");
    let mut group = criterion.benchmark_group("edit");
    group.sample_size(10);
    group.bench_function("one line", |bencher| {
        let mut turn = 0;
        bencher.iter(|| {
            turn += 1;
            let text = format!("{}REM edit {turn}\n", files[500].1);
            db.edit(inputs[500], text);
            black_box(acrc_lint::check(&db, project))
        });
    });
    group.finish();
}

criterion_group!(benches, lint);
criterion_main!(benches);
