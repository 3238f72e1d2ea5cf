if vim.g.loaded_acrobasic then
  return
end
vim.g.loaded_acrobasic = true

local command = vim.api.nvim_create_user_command

command('AcrobasicInstall', function()
  vim.notify('built ' .. require('acrobasic.treesitter').install())
end, { desc = 'Build the tree-sitter parser of AcroBASIC' })
command('AcrcSim', function(call)
  require('acrobasic').sim(call.args ~= '' and call.args or nil)
end, { nargs = '?', desc = 'Run the project in virtual time, or one program: PROG3' })
command('AcrcReport', function()
  require('acrobasic').report()
end, { desc = 'Open the page of the last dry run' })
command('AcrcMem', function()
  require('acrobasic').mem()
end, { desc = 'Show where the memory of the controller goes' })
command('AcrcDownload', function(call)
  require('acrobasic').download(call.args)
end, { nargs = 1, desc = 'Send the project to the controller at an address' })
