//! How fast text becomes tokens and a tree, in bytes per second.
//!
//! The text looks like the programs that people keep: half of it remarks, many short statements, some conditions, an
//! expression with more than one operator here and there.

use std::fmt::Write;
use std::hint::black_box;

use acrc_syntax::{lexer, parse};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};

const BYTES: usize = 10 << 20;

/// A machine program of about the wanted size; the numbers in it change from cycle to cycle.
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
ACC 750 DEC 750 STP 750 VEL {x}.5 : REM profile of the transfer
X{x}.25 Y-{y} : REM above the nest
INH -516 : REM until the master stands still
IF (BIT {flag} AND NOT PartMissing)
  SET {flag} : REM close the gripper
  DWL 0.15
  LV0 = LV0 + 1
  PartCount = PartCount + LV1 * 2 - (P{x} / 1000)
ELSE IF (P{x} > 4000 OR BIT 8467)
  CLR {flag}
  PRINT #1, \"no part in nest \"; LV0; \" of station {cycle}\"
  IF (LV0 >= 10) THEN GOSUB Alarm : LV0 = 0
ENDIF
REM the arrays hold the measured heights of the last parts
LA0(LV0) = LA0(LV0 - 1) + RND(1000)
AXIS2 JOG ABS {y}
JOG VEL X{x} Y 20 Z 5.5
DA0(LV0) = P12290 / P12375 : REM position in units
WHILE (BIT 24 = 0) : REM operator
WEND
Z/-12.5
GOTO Station{cycle}
"
    );
}

fn benchmark(criterion: &mut Criterion) {
    let text = program(BYTES);
    let mut group = criterion.benchmark_group("syntax");
    group.throughput(Throughput::Bytes(text.len() as u64));
    group.sample_size(10);
    group.bench_function("lex", |bencher| bencher.iter_with_large_drop(|| lexer::tokenize(black_box(&text))));
    group.bench_function("parse", |bencher| bencher.iter_with_large_drop(|| parse(black_box(&text))));
    group.finish();
}

criterion_group!(benches, benchmark);
criterion_main!(benches);
