vim.api.nvim_create_autocmd({ 'BufNewFile', 'BufRead' }, {
  pattern = { '*.8K', '*.8k' },
  command = 'setfiletype acrobasic',
})
