(if_block "ENDIF" @end) @indent
(for_block "NEXT" @end) @indent
(while_block "WEND" @end) @indent

(else_clause "ELSE" @outdent)
(elseif_clause "ELSEIF" @outdent)
