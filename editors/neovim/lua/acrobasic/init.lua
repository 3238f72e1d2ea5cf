--- AcroBASIC in Neovim, 0.7 and later: starts `acrc lsp` for the files of a project.
local M = {}

--- What can be changed with `setup`.
M.options = {
  --- The program, by name or path, with its arguments.
  cmd = { 'acrc', 'lsp' },
  --- Settings of the server, below `acrc`: see docs/lsp.md.
  settings = {},
  --- Called with the client and the buffer when the server serves it.
  on_attach = nil,
  --- Replaces what this Neovim can do, for completion plugins.
  capabilities = nil,
}

--- Sets options; only needed for other options than the usual ones.
function M.setup(options)
  M.options = vim.tbl_deep_extend('force', M.options, options or {})
end

--- The folder of the project that a file belongs to.
function M.root(file)
  local folder = vim.fn.fnamemodify(file, ':p:h')
  local found = vim.fn.findfile('acrc.toml', vim.fn.escape(folder, ' ,;') .. ';')
  return found ~= '' and vim.fn.fnamemodify(found, ':p:h') or folder
end

--- The configuration for a client in a folder.
function M.config(root)
  local options = M.options
  -- An empty table would be sent as a list.
  local settings = next(options.settings) and options.settings or vim.empty_dict()
  return {
    name = 'acrc',
    cmd = options.cmd,
    root_dir = root,
    workspace_folders = { { uri = vim.uri_from_fname(root), name = vim.fn.fnamemodify(root, ':t') } },
    filetypes = { 'acrobasic' },
    init_options = settings,
    settings = { acrc = settings },
    capabilities = options.capabilities or vim.lsp.protocol.make_client_capabilities(),
    on_attach = options.on_attach,
  }
end

--- Clients by folder, where Neovim keeps no account of them.
local clients = {}

--- Starts the server for a buffer, or joins the one that runs for its project.
function M.start(buffer)
  local file = vim.api.nvim_buf_get_name(buffer)
  if file == '' or vim.bo[buffer].buftype ~= '' then
    return
  end
  if vim.fn.executable(M.options.cmd[1]) == 0 then
    vim.notify_once(M.options.cmd[1] .. ' is not installed: no language server for AcroBASIC', vim.log.levels.WARN)
    return
  end
  local root = M.root(file)
  if vim.lsp.start then
    return vim.lsp.start(M.config(root), { bufnr = buffer })
  end
  local id = clients[root]
  if not id or not vim.lsp.get_client_by_id(id) then
    id = vim.lsp.start_client(M.config(root))
    clients[root] = id
  end
  if id then
    vim.lsp.buf_attach_client(buffer, id)
  end
  return id
end

--- Runs a command of the server about a buffer and hands its answer to `done`.
function M.execute(command, argument, done)
  vim.cmd('silent wall')
  argument.uri = vim.uri_from_bufnr(0)
  local params = { command = command, arguments = { argument } }
  vim.lsp.buf_request(0, 'workspace/executeCommand', params, function(failure, answer)
    if failure then
      vim.notify(failure.message, vim.log.levels.ERROR)
    elseif answer and answer ~= vim.NIL then
      done(answer)
    end
  end)
end

--- Shows a text in a window of its own.
local function show(name, text)
  vim.cmd('botright new')
  local buffer = vim.api.nvim_get_current_buf()
  vim.bo[buffer].buftype = 'nofile'
  vim.bo[buffer].bufhidden = 'wipe'
  vim.api.nvim_buf_set_lines(buffer, 0, -1, false, vim.split(text, '\n', { trimempty = true }))
  vim.bo[buffer].modifiable = false
  pcall(vim.api.nvim_buf_set_name, buffer, name)
end

--- Runs the project in virtual time, or one program of it.
function M.sim(program)
  M.execute('acrc.sim', { program = program }, function(answer)
    vim.notify(answer.summary)
  end)
end

--- Shows where the memory of the controller goes.
function M.mem()
  M.execute('acrc.mem', {}, function(answer)
    show('acrc mem', answer.output .. answer.errors)
  end)
end

--- Sends the project to a controller, when the question has been answered.
function M.download(to)
  M.execute('acrc.download', { to = to }, function(answer)
    show('acrc download', answer.output .. answer.errors)
  end)
end

--- Opens the page of the last dry run.
function M.report()
  M.execute('acrc.report', {}, function(answer)
    vim.notify(answer.report)
  end)
end

return M
