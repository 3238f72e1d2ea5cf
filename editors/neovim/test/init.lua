-- A Neovim with nothing but this folder.
local here = vim.fn.fnamemodify(debug.getinfo(1, 'S').source:sub(2), ':p:h:h')
vim.opt.runtimepath:prepend(here)
vim.o.swapfile = false
vim.o.hidden = true
require('acrobasic').setup({ cmd = { vim.env.ACRC, 'lsp' } })
