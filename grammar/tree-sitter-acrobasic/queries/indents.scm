[
  (program)
  (if_block)
  (for_block)
  (while_block)
] @indent.begin

["ENDP" "ENDIF" "NEXT" "WEND"] @indent.end
["ENDP" "ENDIF" "NEXT" "WEND" "ELSE" "ELSEIF"] @indent.branch

(comment) @indent.auto
