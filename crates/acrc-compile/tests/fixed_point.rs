//! A listing compiles to the words it was listed from, for generated programs.

mod common;

use acrc_image::list::{ListOptions, list_annotated};
use acrc_image::{UnitName, encode};
use acrc_syntax::units::Level;
use common::{compile_file, listing, program};
use proptest::prelude::*;
use proptest::sample::select;

fn number() -> impl Strategy<Value = String> {
    prop_oneof![
        4 => "[0-9]{1,4}",
        1 => "[0-9]{9,15}",
        2 => "[0-9]{1,4}\\.[0-9]{0,9}",
        1 => "\\.[0-9]{1,8}",
        1 => "[1-9](\\.[0-9]{1,9})?[eE][+-]?[0-9]{1,2}",
        1 => select(vec!["2147483647", "2147483648", "4294967295", "9007199254740992", "1e-005", "1e38", "1e39", "1e-40", "0.0", "5.0000000"]).prop_map(str::to_owned),
    ]
}

fn operand(index: impl Strategy<Value = String> + Clone + 'static) -> impl Strategy<Value = String> {
    let computed = index.clone().prop_map(|index| format!("({index})"));
    let number = prop_oneof!["[0-9]{1,5}".prop_map(|number| number), computed];
    let scalar = (select(vec!["P", "LV", "SV", "DV", "BIT", "BIT ", "p"]), number.clone())
        .prop_map(|(class, number)| format!("{class}{number}"));
    let array = (select(vec!["LA", "SA", "DA"]), number, index)
        .prop_map(|(class, number, element)| format!("{class}{number}({element})"));
    prop_oneof![3 => scalar, 1 => array, 1 => Just("Speed".to_owned())]
}

fn expression() -> BoxedStrategy<String> {
    let leaf = prop_oneof![3 => number(), 2 => operand("[0-9]{1,3}".prop_map(|number| number))];
    leaf.prop_recursive(4, 20, 2, |inner| {
        let operators = vec!["+", "-", "*", "/", "**", " MOD ", " AND ", " OR ", " XOR ", "=", "<>", "<", ">", "<=", ">=", "<<", ">>", " and "];
        let sign = (select(vec!["-", "+", "NOT ", "- "]), inner.clone()).prop_map(|(sign, operand)| format!("{sign}{operand}"));
        prop_oneof![
            2 => (inner.clone(), select(operators), inner.clone()).prop_map(|(left, operator, right)| format!("{left} {operator} {right}")),
            2 => inner.clone().prop_map(|inner| format!("({inner})")),
            1 => sign.prop_map(|signed| format!("({signed})")),
            1 => (select(vec!["SIN", "ABS", "FLOOR", "RND", "sqrt"]), inner.clone()).prop_map(|(function, argument)| format!("{function}({argument})")),
            1 => operand(inner),
        ]
    })
    .boxed()
}

fn string() -> impl Strategy<Value = String> {
    prop_oneof![
        3 => "\"[ -!#-~]{0,12}\"",
        1 => Just("$V0".to_owned()),
        1 => Just("($V1 + \"µ\")".to_owned()),
        1 => Just("CHR$(34)".to_owned()),
    ]
}

fn value() -> impl Strategy<Value = String> {
    prop_oneof![2 => number(), 1 => number().prop_map(|number| format!("-{number}")), 2 => expression().prop_map(|value| format!("({value})"))]
}

fn axes() -> impl Strategy<Value = String> {
    let axis = (select(vec!["X", "y", "ARM"]), select(vec!["", " ", "/", " / "]), value())
        .prop_map(|(name, gap, value)| format!("{name}{gap}{value}"));
    proptest::collection::vec(axis, 1..4).prop_map(|axes| axes.join(" "))
}

fn simple() -> impl Strategy<Value = String> {
    let valued = (select(vec!["ACC", "DEC", "vel ", "DWL ", "STP", "FOV "]), value())
        .prop_map(|(command, value)| format!("{command} {value}"));
    let axial = (select(vec!["JOG ABS ", "JOG VEL ", "PPU ", "RES ", "MOV ", ""]), axes())
        .prop_map(|(command, axes)| format!("{command}{axes}"));
    let flag = prop_oneof![
        "-?[0-9]{1,4}",
        "BIT ?[0-9]{1,4}",
        Just("Flag".to_owned()),
        expression().prop_map(|index| format!("BIT({index})"))
    ];
    let flags = (select(vec!["SET ", "CLR ", "INH "]), flag).prop_map(|(command, flag)| format!("{command}{flag}"));
    let assigned = (operand(expression()), expression()).prop_map(|(target, value)| format!("{target} = {value}"));
    let mark = || select(vec![",", ";", "; "]);
    let printed = (
        select(vec!["PRINT ", "? ", "PRINT #1, ", "PRINT USING \"##.#\"; "]),
        string(),
        mark(),
        expression(),
        select(vec!["", ",", ";"]),
    )
        .prop_map(|(command, text, mark, value, end)| format!("{command}{text}{mark}{value}{end}"));
    let fixed = select(vec![
        "DIM LV(2)",
        "DIM $V(1,10)",
        "DIM LA0(500)",
        "DIM DA0(LV1)",
        "GOTO Loop1",
        "GOSUB 100",
        "RETURN",
        "END",
        "BREAK",
        "RUN PROG1",
        "HALT ALL",
        "AXIS0 JOG INC 5",
        "MASTER0 VEL 500",
        "MSEEK X(1,0)",
        "GEAR SRC X ENC2",
        "OPEN \"COM1:9600,N,8,1\" AS #1",
        "CLOSE #1",
        "INPUT; \"n\"; LV0, LV1",
        "ATTACH SLAVE0 AXIS0 \"X\"",
        "ENC0 RES",
        "IHPOS -P6160 (40000,5.5)",
        "MASK P4097 (1,2)",
        "JOG OFF X",
        "DRIVE ON X Y",
        "X2 SINE Y(0,90,90,100)",
    ])
    .prop_map(str::to_owned);
    prop_oneof![2 => valued, 2 => axial, 2 => flags, 3 => assigned, 2 => printed, 3 => fixed]
}

fn line() -> impl Strategy<Value = String> {
    let chain = proptest::collection::vec(simple(), 1..4).prop_map(|statements| statements.join(" : ")).boxed();
    let one_line_if =
        (expression(), chain.clone()).prop_map(|(condition, chain)| format!("IF ({condition}) THEN {chain}"));
    let opener = prop_oneof![
        expression().prop_map(|condition| format!("IF ({condition})")),
        expression().prop_map(|condition| format!("WHILE ({condition})")),
        (expression(), expression()).prop_map(|(first, last)| format!("FOR LV0 = {first} TO {last} STEP 2")),
    ];
    let closer = select(vec!["ENDIF", "WEND", "NEXT", "ELSE"]).prop_map(str::to_owned);
    let remark = "REM[ -~]{0,20}"
        .prop_filter("a word of its own", |remark| !remark.as_bytes().get(3).is_some_and(u8::is_ascii_alphanumeric));
    prop_oneof![6 => chain, 2 => one_line_if, 1 => opener, 1 => closer, 1 => remark, 1 => Just("'dropped".to_owned()), 1 => Just(String::new())]
}

/// Contacts and coils of a PLC program, side by side or not.
fn rungs() -> impl Strategy<Value = String> {
    let contact = (
        select(vec!["LD", "LD NOT", "AND", "AND NOT", "OR", "or not", "OUT", "OUT NOT", "KR"]),
        select(vec!["24", "BIT 24", "BIT25", "Flag", "BIT(LV0 + 1)", "(P0)", "(P0 AND 3)"]),
    )
        .prop_map(|(word, flag)| format!("{word} {flag}"));
    let timer = (select(vec!["TIM", "CNT"]), select(vec!["0 100", "1, 5", "0 (P1)", "2 Speed"]))
        .prop_map(|(word, values)| format!("{word} {values}"));
    let joined = select(vec!["AND LD", "OR LD", "END", "SET 32", "P0 = P1 + 1 :", "IF (Flag) THEN CLR 33"])
        .prop_map(str::to_owned);
    let statement = prop_oneof![6 => contact, 1 => timer, 2 => joined];
    let gap = select(vec![" ", " : ", "\n", "\n' a comment\n"]);
    proptest::collection::vec((statement, gap), 1..12)
        .prop_map(|statements| statements.into_iter().map(|(statement, gap)| statement + gap).collect())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_listing_compiles_to_the_same_words(lines in proptest::collection::vec(line(), 1..8)) {
        let definitions = "#DEFINE Speed P7\n#DEFINE Flag BIT128\n_Loop1\n";
        let source = format!("{definitions}{}\n", lines.join("\n"));
        let image = match compile_file(&source, common::PROGRAM, true) {
            Ok(image) => image,
            Err(errors) => return Err(TestCaseError::fail(format!("{source}\n{errors:?}"))),
        };
        let unit = image.programs.last().expect("a stored text");
        let listed = listing(unit, &image);
        let (again, image) = program(&listed);
        prop_assert_eq!((&again.words, &again.strings), (&unit.words, &unit.strings), "{}\n--- listed\n{}", source, listed);
        prop_assert_eq!(listing(&again, &image), listed);
        let annotated = list_annotated(unit, &image.aliases, &ListOptions::default()).expect("what can be listed");
        let (annotated_again, _) = program(&annotated);
        prop_assert_eq!((&annotated_again.words, &annotated_again.strings), (&unit.words, &unit.strings), "{}", annotated);
        let instructions = again.decode().expect("compiled units decode");
        let encoded = encode(UnitName::Program(0), &instructions).expect("decoded statements are valid");
        prop_assert_eq!((encoded.words, encoded.strings), (again.words, again.strings));
    }

    #[test]
    fn a_listing_of_a_plc_program_compiles_to_the_same_words(rungs in rungs()) {
        let source = format!("#DEFINE Speed P7\n#DEFINE Flag BIT128\n{rungs}\n");
        let compiled = |text: &str| {
            let image = compile_file(text, Level::Plc(0), true)
                .map_err(|errors| TestCaseError::fail(format!("{text}\n{errors:?}")))?;
            let unit = image.programs.last().expect("a stored text").clone();
            Ok::<_, TestCaseError>((listing(&unit, &image), unit))
        };
        let (listed, unit) = compiled(&source)?;
        let (listed_again, again) = compiled(&listed)?;
        prop_assert_eq!((&again.words, &again.strings), (&unit.words, &unit.strings), "{}\n--- listed\n{}", source, listed);
        prop_assert_eq!(listed_again, listed);
    }
}
