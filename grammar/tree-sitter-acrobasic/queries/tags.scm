(label name: (label_name) @name) @definition.function
(jump target: (label_name) @name) @reference.call
(define name: (name) @name) @definition.constant
