//! Axis names, attachments and aliases (guide, "Master/Slave Attachments" and "Aliases").

pub(crate) mod alias_before_definition;
pub(crate) mod alias_name;
pub(crate) mod alias_of_local;
pub(crate) mod alias_operand;
pub(crate) mod alias_shadows;
pub(crate) mod alias_synonym;
pub(crate) mod axis_name;
pub(crate) mod duplicate_alias;
pub(crate) mod duplicate_attachment;
pub(crate) mod undeclared_axis;
pub(crate) mod undefined_alias;
pub(crate) mod unused_alias;
pub(crate) mod wrong_prompt;
