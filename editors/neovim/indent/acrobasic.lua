if vim.b.did_indent then
  return
end
vim.b.did_indent = 1

vim.opt_local.autoindent = true
vim.opt_local.indentexpr = "v:lua.require'acrobasic.indent'.of(v:lnum)"
vim.opt_local.indentkeys = '!^F,o,O,=~endif,=~else,=~elseif,=~next,=~wend,=~endp'
vim.b.undo_indent = 'setlocal autoindent< indentexpr< indentkeys<'
