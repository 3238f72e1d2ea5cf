//! The list of all rules, and the way from a code or name to its page.

use crate::rule::{Rule, RuleDoc};
use crate::rules::{arguments, compile, flow, motion, names, parameters, syntax};

/// Every rule, in the order of the codes.
pub(crate) const RULES: &[&Rule] = &[
    &syntax::SYNTAX_ERROR,
    &syntax::TYPOGRAPHIC_CHARACTER,
    &syntax::REMARK_WITHOUT_COLON,
    &syntax::ENCODING,
    &syntax::UNTERMINATED_STRING,
    &syntax::DETACHED_LABEL,
    &syntax::DIM_WITHOUT_PARENTHESES,
    &syntax::REMARK_ON_LABEL_LINE,
    &syntax::COMMENT_AFTER_STATEMENT,
    &syntax::EQUALS_AFTER_COMMAND,
    &compile::NOT_COMPILED,
    &compile::UNDEFINED_LABEL,
    &compile::DUPLICATE_LABEL,
    &compile::UNDEFINED_ALIAS,
    &compile::NUMBER_TOO_LARGE,
    &compile::TOO_DEEP,
    &arguments::unstorable_character::RULE,
    &compile::LIMIT,
    &compile::CONFLICTING_ALIAS,
    &flow::no_program::RULE,
    &names::alias_operand::RULE,
    &compile::AXIS_NAME,
    &flow::undefined_label::RULE,
    &flow::duplicate_label::RULE,
    &flow::unused_label::RULE,
    &flow::unclosed_block::RULE,
    &flow::unopened_block_end::RULE,
    &flow::crossed_blocks::RULE,
    &flow::program_not_closed::RULE,
    &flow::endp_without_program::RULE,
    &flow::break_outside_loop::RULE,
    &flow::goto_out_of_block::RULE,
    &flow::missing_return::RULE,
    &arguments::argument_count::RULE,
    &arguments::argument_kind::RULE,
    &arguments::argument_range::RULE,
    &names::undeclared_axis::RULE,
    &names::axis_name::RULE,
    &names::duplicate_attachment::RULE,
    &arguments::missing_parentheses::RULE,
    &arguments::report_before_move::RULE,
    &names::undefined_alias::RULE,
    &names::duplicate_alias::RULE,
    &names::alias_name::RULE,
    &arguments::number_too_large::RULE,
    &names::unused_alias::RULE,
    &names::alias_shadows::RULE,
    &names::alias_synonym::RULE,
    &names::alias_of_local::RULE,
    &names::alias_before_definition::RULE,
    &names::wrong_prompt::RULE,
    &parameters::unknown_number::RULE,
    &parameters::read_only::RULE,
    &parameters::value_out_of_range::RULE,
    &parameters::object_not_attached::RULE,
    &parameters::bit_as_number::RULE,
    &parameters::number_as_bit::RULE,
    &parameters::alias_exists::RULE,
    &parameters::request_bit_awaited::RULE,
    &parameters::inhibit_without_motion::RULE,
    &parameters::plc_beyond_flags::RULE,
    &parameters::wizard_number::RULE,
    &parameters::never_set_flag::RULE,
    &parameters::contradictory_bit_test::RULE,
    &motion::slave_before_master::RULE,
    &motion::master_in_two_programs::RULE,
    &motion::second_master::RULE,
    &motion::motion_without_attachments::RULE,
    &motion::drive_never_enabled::RULE,
    &motion::velocity_never_set::RULE,
    &motion::jog_velocity_never_set::RULE,
    &motion::ramp_never_set::RULE,
    &motion::homing_without_limits::RULE,
    &motion::limit_inputs_cross_block::RULE,
    &motion::kill_never_cleared::RULE,
    &motion::reversed_limits::RULE,
    &motion::software_limits_not_set::RULE,
    &motion::abrupt_stop::RULE,
    &motion::program_never_started::RULE,
    &motion::runs_empty_program::RULE,
    &motion::homing_velocity_never_set::RULE,
    &motion::slash_outside_linear_move::RULE,
    &motion::gear_without_source::RULE,
    &motion::pulses_per_unit_never_set::RULE,
    &motion::error_without_response::RULE,
    &motion::wait_for_other_master::RULE,
    &motion::wait_for_other_axis::RULE,
    &motion::coordinated_wait_for_jog::RULE,
    &motion::jog_stopped_at_once::RULE,
];

/// The pages of all rules, in the order of the codes.
pub fn rules() -> impl Iterator<Item = &'static RuleDoc> {
    RULES.iter().map(|rule| &rule.doc)
}

/// The page of a rule by its code (`ACR101`, in any case) or its name (`undefined-label`). Where the compiler has a code
/// of the same name, the name means that of the linter.
pub fn explain(topic: &str) -> Option<&'static RuleDoc> {
    let by_name = |doc: &&RuleDoc| doc.code.name.eq_ignore_ascii_case(topic);
    rules()
        .find(|doc| doc.code.id.eq_ignore_ascii_case(topic))
        .or_else(|| rules().filter(by_name).max_by_key(|doc| doc.group))
}
