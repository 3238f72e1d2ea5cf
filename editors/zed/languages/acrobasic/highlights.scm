; What is what, in the captures of Zed. Later patterns win.

(name) @variable
(axis_name) @variable.special
(keyword) @keyword
(daughter) @keyword
[
  "PROGRAM" "ENDP" "IF" "THEN" "ELSEIF" "ELSE" "ENDIF" "FOR" "TO" "STEP" "NEXT" "WHILE" "WEND"
] @keyword
["PRINT" "?" "USING" "INPUT" "OPEN" "DTALK" "AS" "CLOSE" "DIM"] @keyword
"#DEFINE" @preproc

(operator_word) @operator
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

(function) @function
(parameter "P" @property)
(bit "BIT" @constant)
(variable_class) @variable.special
(define name: (name) @constant)
(device "#" @punctuation.special)
