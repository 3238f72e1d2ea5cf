if vim.b.did_ftplugin then
  return
end
vim.b.did_ftplugin = 1

vim.opt_local.comments = "b:',:REM"
vim.opt_local.commentstring = "'%s"
vim.opt_local.suffixesadd = { '.8K', '.8k' }
vim.opt_local.expandtab = true
vim.opt_local.shiftwidth = 4
vim.opt_local.softtabstop = 4
vim.opt_local.formatoptions:remove('t')
vim.b.undo_ftplugin = 'setlocal comments< commentstring< suffixesadd< expandtab< shiftwidth< softtabstop< formatoptions<'

local buffer = vim.api.nvim_get_current_buf()
require('acrobasic.treesitter').start(buffer)
require('acrobasic').start(buffer)
