[
  (program)
  (if_block)
  (elseif_clause)
  (else_clause)
  (for_block)
  (while_block)
] @fold
