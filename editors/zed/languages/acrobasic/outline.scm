(program "PROGRAM" @name) @item
(label name: (label_name) @name) @item
(define "#DEFINE" @context name: (name) @name) @item
