//! What a person reads: one snapshot a topic.

use acrc_catalog::{Explanation, explain, nearest_command};

macro_rules! explains {
    ($($name:ident: $topic:literal,)+) => {
        $(
            #[test]
            fn $name() {
                insta::assert_snapshot!(explain($topic).render());
            }
        )+
    };
}

explains! {
    a_parent: "JOG",
    a_daughter: "jog  home",
    a_command_with_one_value: "VEL",
    a_command_with_tuples: "MSEEK",
    a_command_of_the_prompt: "ATTACH SLAVE",
    a_setting_of_two_parameters: "TLM",
    a_setting_of_flags: "HLIM",
    a_parameter_of_a_setting: "P12337",
    a_flag_of_a_setting: "BIT16149",
    an_unconfirmed_command: "PM DB",
    a_part_of_a_statement: "THEN",
    a_command_and_a_keyword: "STEP",
    a_command_and_an_operator: "AND",
    a_function: "SIN",
    a_function_with_an_optional_argument: "mid$",
    an_operator: "**",
    an_operand: "LV0",
    an_object: "SLAVE",
    an_axis_parameter: "P12290",
    an_axis_parameter_of_another_axis: "p 13058",
    a_flag_word: "P4361",
    a_parameter_of_an_unknown_word: "P5000",
    a_parameter_of_a_block: "P14199",
    a_parameter_beyond_the_space: "P65000",
    a_number_beyond_any_number: "P99999999999",
    a_user_variable: "P(100)",
    an_axis_flag: "BIT8467",
    a_flag_of_the_upper_masters: "BIT 7466",
    a_flag_of_a_node: "BIT13057",
    a_flag_of_a_known_group: "BIT1112",
    an_unknown_flag: "BIT 40000",
    an_acronym: "KAMR",
    a_field_of_two_rows: "in motion",
    a_model: "ACR9000",
    a_message: "unknown command",
    a_near_miss: "JGO",
    nothing_similar: "qqqqqqqq",
}

#[test]
fn a_daughter_is_found_by_its_own_word() {
    assert!(matches!(explain("HOMVF"), Explanation::Entries(entries) if entries.len() == 1));
}

#[test]
fn every_name_of_the_catalogue_is_a_topic() {
    for command in acrc_catalog::all_commands() {
        assert!(matches!(explain(command.name), Explanation::Entries(_)), "{}", command.name);
    }
    for row in acrc_catalog::all_bits() {
        assert!(matches!(explain(row.field), Explanation::Entries(_)), "{}", row.field);
    }
    for row in acrc_catalog::all_parameters() {
        assert!(matches!(explain(row.field), Explanation::Entries(_)), "{}", row.field);
    }
}

#[test]
fn the_nearest_command_of_a_slip() {
    for (slip, command) in
        [("VLE", "VEL"), ("PRNT", "PRINT"), ("GOSUBB", "GOSUB"), ("ENDFI", "ENDIF"), ("attahc", "ATTACH")]
    {
        assert_eq!(nearest_command(slip), Some(command), "{slip}");
    }
    assert_eq!(nearest_command("QQQQQ"), None);
}
