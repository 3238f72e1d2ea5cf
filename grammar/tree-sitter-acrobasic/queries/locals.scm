; Labels and axis names belong to their program, aliases to all programs.

(program) @local.scope
(source_file) @local.scope

(label name: (label_name) @local.definition.label)
(jump target: (label_name) @local.reference)

(define name: (name) @local.definition.macro)
(name) @local.reference
(axis_name) @local.reference
