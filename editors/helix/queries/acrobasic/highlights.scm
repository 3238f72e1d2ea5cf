; What is what, in the scopes of Helix. Later patterns win.

(keyword) @keyword
(daughter) @keyword
["PRINT" "?" "USING" "INPUT" "OPEN" "DTALK" "AS" "CLOSE" "DIM"] @keyword
"#DEFINE" @keyword.directive
["PROGRAM" "ENDP"] @keyword.control
["IF" "THEN" "ELSEIF" "ELSE" "ENDIF"] @keyword.control.conditional
["FOR" "TO" "STEP" "NEXT" "WHILE" "WEND"] @keyword.control.repeat
(jump (keyword) @keyword.control)

(operator_word) @keyword.operator
["+" "-" "*" "/" "**" "^" "=" "<>" "<" "<=" ">" ">=" "<<" ">>"] @operator
[":" "," ";"] @punctuation.delimiter
["(" ")"] @punctuation.bracket

(number) @constant.numeric
(line_number) @label
(string) @string
(comment) @comment.line
(remark) @comment.line
(remark "REM" @comment.line)
(remark_text) @comment.line

(label) @label
(label "_" @label)
(label_name) @label

(function) @function.builtin
(parameter "P" @variable.parameter)
(bit "BIT" @constant.builtin)
(variable_class) @variable.builtin
(name) @variable
(define name: (name) @constant)
(axis_name) @variable.other.member
(device "#" @punctuation.special)
