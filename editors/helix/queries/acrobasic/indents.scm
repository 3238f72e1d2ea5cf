[
  (if_block)
  (for_block)
  (while_block)
] @indent

[
  "ENDIF"
  "NEXT"
  "WEND"
  "ELSE"
  "ELSEIF"
] @outdent
