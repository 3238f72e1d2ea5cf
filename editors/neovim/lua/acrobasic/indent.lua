--- Indentation by the words that begin and end blocks, as a person types. `acrc fmt` has the last word.
local M = {}

--- The text without its line number, texts and comments, in capitals.
local function code(text)
  text = text:upper():gsub('"[^"]*"?', ''):gsub("'.*", ''):gsub('\226\128\152.*', ''):gsub('\226\128\153.*', '')
  return (text:gsub('^%s*%d*%s*', ''))
end

--- Whether a line begins with a word; letters behind it would make another word.
local function begins(line, word)
  return line:find('^' .. word .. '%f[%A]') ~= nil
end

local function opens(line)
  if begins(line, 'IF') then
    -- With something behind `THEN` the line is complete.
    return not line:find('%f[%a]THEN%s*%S') and not line:find('%)THEN%s*%S')
  end
  if begins(line, 'FOR') then
    return not line:find(':%s*NEXT%f[%A]')
  end
  if begins(line, 'WHILE') then
    return not line:find(':%s*WEND%f[%A]')
  end
  return begins(line, 'ELSE') or begins(line, 'ELSEIF')
end

local function closes(line)
  for _, word in ipairs({ 'ENDIF', 'ELSE', 'ELSEIF', 'NEXT', 'WEND' }) do
    if begins(line, word) then
      return true
    end
  end
  return false
end

--- The indentation of a line, for 'indentexpr'.
function M.of(number)
  local line = code(vim.fn.getline(number))
  if begins(line, 'ENDP') or begins(line, 'PROGRAM') then
    return 0
  end
  local before = vim.fn.prevnonblank(number - 1)
  if before == 0 then
    return 0
  end
  local step = vim.fn.shiftwidth()
  local indent = vim.fn.indent(before)
  if opens(code(vim.fn.getline(before))) then
    indent = indent + step
  end
  if closes(line) then
    indent = indent - step
  end
  return math.max(indent, 0)
end

return M
