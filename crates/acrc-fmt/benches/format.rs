//! How fast a text is formatted, in bytes per second, beside reading it.

use std::fmt::Write;
use std::hint::black_box;

use acrc_fmt::{Options, format, format_tree};
use acrc_syntax::parse;
use criterion::{Criterion, Throughput, criterion_group, criterion_main};

const BYTES: usize = 10 << 20;

/// An untidy machine program of about the wanted size.
fn program(bytes: usize) -> String {
    let mut text = String::with_capacity(bytes + 1024);
    let mut cycle = 0_u32;
    while text.len() < bytes {
        write_cycle(&mut text, cycle);
        cycle += 1;
    }
    text
}

fn write_cycle(text: &mut String, cycle: u32) {
    let (x, y, flag) = (cycle % 500, cycle % 300, 32 + cycle % 90);
    let _ = write!(
        text,
        "\
REM ------ station {cycle}: pick, check and place ------
_Station{cycle}
ACC750 DEC750 STP750 VEL {x}.5 : REM profile of the transfer
X{x}.25 Y-{y} : REM above the nest
INH -516 : REM until the master stands still
IF (BIT {flag} AND NOT PartMissing)
  SET {flag}  :REM close the gripper
  dwl 0.15
  lv0=lv0+1
  PartCount=PartCount + LV1*2-(P{x}/1000)
ELSE IF (P{x} > 4000 OR BIT 8467)
  CLR{flag}
  PRINT #1, \"no part in nest \";LV0;\" of station {cycle}\"
  IF (LV0>=10) THEN GOSUB Alarm : LV0 = 0
ENDIF
REM the arrays hold the measured heights of the last parts
LA0(LV0)=LA0(LV0-1)+RND(1000)
AXIS2 JOG ABS {y}
JOG VEL X{x} Y 20 Z 5.5
DA0(LV0) = P12290 / P12375 : REM position in units
WHILE (BIT 24 = 0) : REM operator
WEND
Z / -12.5
GOTO Station{cycle}
"
    );
}

fn benchmark(criterion: &mut Criterion) {
    let text = program(BYTES);
    let tree = parse(&text);
    let options = Options::default();
    let mut group = criterion.benchmark_group("format");
    group.throughput(Throughput::Bytes(text.len() as u64));
    group.sample_size(10);
    group.bench_function("parse", |bencher| bencher.iter_with_large_drop(|| parse(black_box(&text))));
    group.bench_function("layout", |bencher| {
        bencher.iter_with_large_drop(|| format_tree(black_box(&text), &tree, &options));
    });
    group.bench_function("parse and layout", |bencher| {
        bencher.iter_with_large_drop(|| format(black_box(&text), &options));
    });
    group.finish();
}

criterion_group!(benches, benchmark);
criterion_main!(benches);
