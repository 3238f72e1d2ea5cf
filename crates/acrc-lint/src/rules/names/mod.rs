//! Axis names, attachments and aliases (guide, "Master/Slave Attachments" and "Aliases").

pub(crate) mod alias_name;
pub(crate) mod alias_operand;
pub(crate) mod axis_name;
pub(crate) mod duplicate_alias;
pub(crate) mod duplicate_attachment;
pub(crate) mod undeclared_axis;
pub(crate) mod undefined_alias;
