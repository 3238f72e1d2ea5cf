-- A person's session with the real server: run by `nvim --headless -u test/init.lua -S test/session.lua` in a folder where
-- ACRC is the program and PROJECT a project to write to.
local WAIT = 20000
local project = vim.env.PROJECT

local SETUP = {
  'SYS', 'HALT ALL', 'NEW ALL', 'CLEAR', 'DIM PROG0(4096)', 'DIM DEF(10)', "' Größe in µm, 寸法 🙂", '#DEFINE Lamp BIT33', '',
}
local PROGRAM = {
  'PROGRAM', "' Prüfung der Lampe 🙂: läuft µ-genau", '_Start', 'CLR Lamp', 'IF (LV9 = 1)', 'SET Lamp', 'ENDIF', 'GOTO Strat', 'ENDP',
}

local function write(name, lines)
  vim.fn.writefile(lines, project .. '/' .. name)
end

local function wait(what, condition)
  local value
  local fine = vim.wait(WAIT, function()
    value = condition()
    return value
  end, 20)
  if not fine then
    error('waited in vain for ' .. what .. '\n' .. vim.inspect(vim.diagnostic.get()), 2)
  end
  return value
end

local function ask(method, params)
  local answers, failure = vim.lsp.buf_request_sync(0, method, params, WAIT)
  if not answers then
    error(method .. ': ' .. tostring(failure), 2)
  end
  local _, answer = next(answers)
  if not answer or answer.err or answer.error then
    error(method .. ': ' .. vim.inspect(answer), 2)
  end
  return answer.result
end

local function lines()
  return vim.api.nvim_buf_get_lines(0, 0, -1, false)
end

local function at(row, column)
  vim.api.nvim_win_set_cursor(0, { row, column })
  local params = vim.lsp.util.make_position_params(0, 'utf-16')
  return params
end

--- The finding with a code in a buffer.
local function finding(code, buffer)
  for _, diagnostic in ipairs(vim.diagnostic.get(buffer or 0)) do
    local found = diagnostic.code or (diagnostic.user_data and diagnostic.user_data.lsp.code)
    if found == code then
      return diagnostic
    end
  end
end

local function client()
  local all = (vim.lsp.get_clients or vim.lsp.get_active_clients)()
  return all[1], #all
end

local function same(found, expected)
  if not vim.deep_equal(found, expected) then
    error('found ' .. vim.inspect(found) .. '\nexpected ' .. vim.inspect(expected), 2)
  end
end

local tests = {
  {
    'opens and shows what is wrong',
    function()
      vim.cmd('edit ' .. project .. '/src/Prog0.8K')
      same(vim.bo.filetype, 'acrobasic')
      local found = wait('the unknown label', function()
        return finding('ACR101')
      end)
      same({ found.lnum, found.severity }, { 7, vim.diagnostic.severity.ERROR })
    end,
  },
  {
    'forgets what is repaired, in a line behind emoji too',
    function()
      vim.api.nvim_buf_set_text(0, 7, 5, 7, 10, { 'Start' })
      wait('no unknown label', function()
        return not finding('ACR101')
      end)
      vim.api.nvim_buf_set_lines(0, 7, 8, false, { "SET Lamp : ' 🙂", 'GOTO Strat' })
      local found = wait('the label again', function()
        return finding('ACR101')
      end)
      same({ found.lnum, found.col }, { 8, 5 })
      vim.api.nvim_buf_set_text(0, 8, 5, 8, 10, { 'Start' })
      wait('no unknown label', function()
        return not finding('ACR101')
      end)
    end,
  },
  {
    'completes an alias of the other file',
    function()
      vim.api.nvim_buf_set_lines(0, 7, 8, false, { 'SET La' })
      vim.bo.omnifunc = 'v:lua.vim.lsp.omnifunc'
      local answer = ask('textDocument/completion', at(8, 6))
      local labels = vim.tbl_map(function(item)
        return item.label
      end, answer.items or answer)
      assert(vim.tbl_contains(labels, 'Lamp'), vim.inspect(labels))
      vim.api.nvim_buf_set_lines(0, 7, 8, false, { 'SET Lamp' })
    end,
  },
  {
    'explains what stands at the cursor',
    function()
      local hover = ask('textDocument/hover', at(8, 5))
      local text = hover.contents.value or hover.contents
      assert(text:find('BIT33', 1, true), text)
    end,
  },
  {
    'renames across files',
    function()
      at(8, 5)
      vim.lsp.buf.rename('Lampe')
      wait('the new name', function()
        return lines()[8] == 'SET Lampe'
      end)
      same(lines()[4], 'CLR Lampe')
      local setup = vim.fn.bufnr(project .. '/src/Setup.8K')
      same(vim.api.nvim_buf_get_lines(setup, 7, 8, false), { '#DEFINE Lampe BIT33' })
      vim.cmd('silent wall')
    end,
  },
  {
    'applies a repair',
    function()
      local number = vim.fn.line('$') - 1
      vim.api.nvim_buf_set_lines(0, number, number, false, { 'SET BIT34' })
      local params = at(number + 1, 5)
      params.range = { start = params.position, ['end'] = params.position }
      params.context = { diagnostics = {} }
      local chosen
      wait('an alias for the bit', function()
        for _, action in ipairs(ask('textDocument/codeAction', params) or {}) do
          if action.edit and action.title:lower():find('alias') then
            chosen = action
            return true
          end
        end
      end)
      vim.lsp.util.apply_workspace_edit(chosen.edit, client().offset_encoding or 'utf-16')
      assert(lines()[number + 1] ~= 'SET BIT34', chosen.title)
    end,
  },
  {
    'formats',
    function()
      same(lines()[6], 'SET Lampe')
      if vim.lsp.buf.format then
        vim.lsp.buf.format({ timeout_ms = WAIT })
      else
        vim.lsp.buf.formatting_sync(nil, WAIT)
      end
      wait('the indentation', function()
        return lines()[6]:match('^%s+SET Lampe$')
      end)
    end,
  },
  {
    'runs the commands of acrc',
    function()
      local said = {}
      vim.notify = function(text)
        table.insert(said, text)
      end
      vim.cmd('AcrcSim PROG0')
      local summary = wait('the dry run', function()
        return said[1]
      end)
      assert(summary:find('virtual time', 1, true), summary)
      vim.cmd('AcrcMem')
      wait('the memory', function()
        return vim.bo.buftype == 'nofile'
      end)
      assert(table.concat(lines(), '\n'):find('PROG0', 1, true), vim.inspect(lines()))
      vim.cmd('bwipeout')
    end,
  },
  {
    'joins the server that runs for the project',
    function()
      vim.cmd('silent wall')
      vim.cmd('edit ' .. project .. '/src/Setup.8K')
      wait('the server', function()
        return next((vim.lsp.get_clients or vim.lsp.buf_get_clients)(vim.lsp.get_clients and { bufnr = 0 } or 0))
      end)
      local _, count = client()
      same(count, 1)
    end,
  },
  {
    'indents as it is typed',
    function()
      vim.cmd('enew | set filetype=acrobasic')
      vim.api.nvim_buf_set_lines(0, 0, -1, false, {
        'PROGRAM', 'FOR LV0 = 0 TO 3 STEP 1', 'IF (LV0 = 1)', 'SET 34', 'ELSE', "CLR 34 ' IF (", 'ENDIF', 'IF (LV0) THEN SET 35', 'NEXT', 'ENDP',
      })
      vim.cmd('silent normal! gg=G')
      local depth = vim.tbl_map(function(line)
        return #line:match('^ *') / 4
      end, lines())
      same(depth, { 0, 0, 1, 2, 1, 2, 1, 1, 0, 0 })
      vim.cmd('bwipeout!')
    end,
  },
  {
    'builds the grammar and reads every example with it',
    function()
      require('acrobasic.treesitter').install()
      for _, file in ipairs(vim.fn.glob(vim.env.EXAMPLES .. '/**/*.8K', true, true)) do
        vim.cmd('edit ' .. file)
        local root = vim.treesitter.get_parser(0, 'acrobasic'):parse()[1]:root()
        assert(not root:has_error(), file)
        local query = (vim.treesitter.query.get or vim.treesitter.query.get_query)('acrobasic', 'highlights')
        local count = 0
        for _ in query:iter_captures(root, 0, 0, vim.fn.line('$')) do
          count = count + 1
        end
        assert(count > 10, file .. ': ' .. count .. ' colours')
        assert(vim.treesitter.highlighter.active[vim.api.nvim_get_current_buf()], file .. ' is not coloured')
      end
    end,
  },
  {
    'reads the queries for other editors',
    function()
      local files = vim.fn.glob(vim.env.QUERIES .. '/**/*.scm', true, true)
      assert(#files >= 8, vim.inspect(files))
      for _, file in ipairs(files) do
        local parse = vim.treesitter.query.parse or vim.treesitter.parse_query
        local fine, failure = pcall(parse, 'acrobasic', table.concat(vim.fn.readfile(file), '\n'))
        assert(fine, file .. ': ' .. tostring(failure))
      end
    end,
  },
  {
    'ends the servers of both projects',
    function()
      wait('the server of the examples', function()
        local _, count = client()
        return count == 2
      end)
      vim.lsp.stop_client((vim.lsp.get_clients or vim.lsp.get_active_clients)())
      wait('the end', function()
        return not client()
      end)
    end,
  },
}

write('acrc.toml', { '[project]', 'name = "lamp"', 'files = ["src/Setup.8K", "src/Prog0.8K"]' })
vim.fn.mkdir(project .. '/src', 'p')
write('src/Setup.8K', SETUP)
write('src/Prog0.8K', PROGRAM)

for _, test in ipairs(tests) do
  local fine, failure = xpcall(test[2], debug.traceback)
  io.stdout:write((fine and 'ok ' or 'FAILED ') .. test[1] .. '\n' .. (fine and '' or tostring(failure) .. '\n'))
  io.stdout:flush()
  if not fine then
    vim.cmd('cquit 1')
  end
end
vim.cmd('qall!')
