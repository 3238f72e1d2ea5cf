; What is what, for colours. Later patterns win.

(keyword) @keyword
(daughter) @keyword
[
  "PROGRAM" "ENDP" "IF" "THEN" "ELSEIF" "ELSE" "ENDIF" "FOR" "TO" "STEP" "NEXT" "WHILE" "WEND"
] @keyword
["PRINT" "?" "USING" "INPUT" "OPEN" "DTALK" "AS" "CLOSE" "DIM" "#DEFINE"] @keyword
(jump (keyword) @keyword)

(operator_word) @keyword.operator
["+" "-" "*" "/" "**" "^" "=" "<>" "<" "<=" ">" ">=" "<<" ">>"] @operator
[":" "," ";"] @punctuation.delimiter
["(" ")"] @punctuation.bracket

(number) @number
(line_number) @label
(string) @string
(comment) @comment
(remark) @comment
(remark "REM" @comment)
(remark_text) @comment

(label) @label
(label "_" @label)
(label_name) @label

(function) @function.builtin
(parameter "P" @variable.parameter)
(bit "BIT" @constant.builtin)
(variable_class) @variable.builtin
(name) @variable
(axis_name) @variable
(device "#" @punctuation.special)
