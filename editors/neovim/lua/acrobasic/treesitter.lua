--- The tree-sitter grammar: compiled from `grammar/` beside this folder, and put where Neovim looks for parsers.
local M = {}

local LANGUAGE = 'acrobasic'

--- The folder of the grammar in the repository that this file lies in.
function M.grammar()
  local here = debug.getinfo(1, 'S').source:sub(2)
  return vim.fn.fnamemodify(here, ':p:h:h:h:h:h') .. '/grammar/tree-sitter-acrobasic'
end

local function compiler()
  for _, name in ipairs({ vim.env.CC or 'cc', 'cc', 'gcc', 'clang' }) do
    if vim.fn.executable(name) == 1 then
      return name
    end
  end
  error('no C compiler is installed: set CC to the one to use')
end

--- Colours a buffer by its tree, when the parser is installed.
function M.start(buffer)
  if #vim.api.nvim_get_runtime_file('parser/' .. LANGUAGE .. '.so', false) == 0 then
    return
  end
  local fine, failure = pcall(function()
    if vim.treesitter.start then
      vim.treesitter.start(buffer, LANGUAGE)
    else
      vim.treesitter.highlighter.new(vim.treesitter.get_parser(buffer, LANGUAGE), {})
    end
  end)
  if not fine then
    vim.notify_once('no colours for AcroBASIC: ' .. tostring(failure), vim.log.levels.WARN)
  end
end

--- Refuses a parser that is newer than this Neovim.
local function check(parser)
  for _, line in ipairs(vim.fn.readfile(parser, '', 60)) do
    local version = tonumber(line:match('^#define LANGUAGE_VERSION (%d+)'))
    local most = vim.treesitter.language_version
    if version and most and version > most then
      error(('this Neovim reads parsers up to version %d; that of AcroBASIC has %d'):format(most, version))
    end
  end
end

--- Compiles the parser and copies its queries into the folder that is on every 'runtimepath'. Takes some seconds.
function M.install(site)
  local grammar = M.grammar()
  site = site or vim.fn.stdpath('data') .. '/site'
  vim.fn.mkdir(site .. '/parser', 'p')
  vim.fn.mkdir(site .. '/queries/' .. LANGUAGE, 'p')
  local source = grammar .. '/src'
  check(source .. '/parser.c')
  local library = site .. '/parser/' .. LANGUAGE .. '.so'
  local said = vim.fn.system({
    compiler(), '-O1', '-shared', '-fPIC', '-I', source, '-o', library, source .. '/parser.c', source .. '/scanner.c',
  })
  if vim.v.shell_error ~= 0 then
    error('the parser was not built: ' .. said)
  end
  for _, query in ipairs(vim.fn.glob(grammar .. '/queries/*.scm', true, true)) do
    local copy = site .. '/queries/' .. LANGUAGE .. '/' .. vim.fn.fnamemodify(query, ':t')
    vim.fn.writefile(vim.fn.readfile(query, 'b'), copy, 'b')
  end
  -- Neovim remembers which folders of 'runtimepath' there are; they may be new.
  vim.o.runtimepath = vim.o.runtimepath
  for _, buffer in ipairs(vim.api.nvim_list_bufs()) do
    if vim.api.nvim_buf_is_loaded(buffer) and vim.bo[buffer].filetype == LANGUAGE then
      M.start(buffer)
    end
  end
  return library
end

return M
