--- For those who start all their servers with `vim.lsp.enable('acrc')`, in Neovim 0.11 and later. Nothing is started twice.
local acrobasic = require('acrobasic')

return {
  cmd = acrobasic.options.cmd,
  filetypes = { 'acrobasic' },
  settings = { acrc = acrobasic.options.settings },
  root_dir = function(buffer, found)
    found(acrobasic.root(vim.api.nvim_buf_get_name(buffer)))
  end,
}
