--# repOfNothing | result: 0
return #string.rep('', math.maxinteger)
--# repOfNothingWithSeparator | error: resulting string too large
return #string.rep('', math.maxinteger, 'x')
--# repTooLarge | error: resulting string too large
return #string.rep('xx', math.maxinteger)
--# repFillsTheMemory | error: not enough memory
return #string.rep('x', 1 << 30)
--# repFillsTheMemoryAndIsCaught | error: not enough memory
while true do pcall(string.rep, 'x', 1 << 30) end
--# repAgainAndAgain | error: 
for i = 1, 1e7 do local s = string.rep('x', 1000000) end
--# repAgainAndAgainCaught | error: not enough memory
while true do pcall(string.rep, 'x', 1 << 24) end
--# memoryInACoroutineIsCaught | error: not enough memory
while true do coroutine.resume(coroutine.create(function() return string.rep('x', 1 << 30) end)) end
--# memoryInAWrappedCoroutine | error: not enough memory
while true do pcall(coroutine.wrap(function() return string.rep('x', 1 << 30) end)) end
--# memoryWithHandler | error: not enough memory
while true do xpcall(string.rep, function() return 1 end, 'x', 1 << 30) end
--# memoryWithClose | error: 
while true do
  pcall(function()
    local c <close> = setmetatable({}, {__close = function() error('other') end})
    return string.rep('x', 1 << 30)
  end)
end
--# memoryAfterYieldIsCaught | error: not enough memory
local co = coroutine.wrap(function()
  while true do pcall(function() coroutine.yield() return string.rep('x', 1 << 30) end) end
end)
while true do co() end
--# listFillsTheMemory | error: not enough memory
local t = {}
for i = 1, 1e7 do t[i] = {i} end
--# listFillsTheMemoryAndIsCaught | error: not enough memory
local all = {}
while true do pcall(function() for i = 1, 1e7 do all[#all + 1] = {} end end) end
--# textsFillTheMemory | error: not enough memory
local s = 'x'
while true do s = s .. s end
--# coroutinesFillTheMemory | error: not enough memory
local t = {}
for i = 1, 1e7 do t[i] = coroutine.create(function() end) end
--# closuresFillTheMemory | error: not enough memory
local t = {}
for i = 1, 1e7 do t[i] = function() return i end end
--# keysFillTheMemory | error: not enough memory
local t = {}
for i = 1, 1e7 do t['k' .. i] = i end
--# concatenationsAgainAndAgain | error: not enough memory
local s = string.rep('x', 1000000)
for i = 1, 1e7 do local t = s .. i end
--# nearlyFull | error: not enough memory
local keep = {}
for i = 1, 400000 do keep[i] = {i} end
for i = 1, 1e7 do local s = ('x'):rep(4000000) .. i end
--# errorAsIfNoMemory | error: not enough memory
pcall(error, 'not enough memory', 0)
--# tableConcatWithoutEnd | error: 
return #table.concat(setmetatable({}, {__index = function() return 'xxxxxxxxxxxxxxxx' end}), '', 1, math.maxinteger)
--# tableConcatOfFunctionsOfTheLibrary | error: too much work
return #table.concat(setmetatable({}, {__index = table.concat}), '', 1, math.maxinteger)
--# tableConcatLongSeparator | error: not enough memory
return #table.concat({1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, string.rep('x', 8000000))
--# tableConcatAtTheEndOfIntegers | result: ab
local t = {[math.maxinteger - 1] = 'a', [math.maxinteger] = 'b'}
return table.concat(t, '', math.maxinteger - 1, math.maxinteger)
--# moveWithoutEnd | error: too much work
table.move({}, 1, math.maxinteger - 1, 2, {})
--# moveBackwardWithoutEnd | error: too much work
local t = {}
table.move(t, 1, 1 << 60, 2)
--# moveTooMany | error: too many elements to move
table.move({}, math.mininteger, math.maxinteger, 1)
--# moveWraps | error: wrap around
table.move({}, 1, 10, math.maxinteger)
--# insertWithHugeLength | error: too much work
table.insert(setmetatable({}, {__len = function() return 1 << 60 end}), 1, 'x')
--# insertWithLargestLength | result: nil
local t = setmetatable({}, {__len = function() return math.maxinteger end})
table.insert(t, math.maxinteger, 'x')
return tostring(t[1])
--# removeWithHugeLength | error: too much work
table.remove(setmetatable({}, {__len = function() return 1 << 60 end}), 1)
--# removeOutside | error: position out of bounds
table.remove({1, 2, 3}, 7)
--# lengthIsNoInteger | error: object length is not an integer
table.remove(setmetatable({}, {__len = function() return 'x' end}))
--# sortWithHugeLength | error: too long to be sorted
table.sort(setmetatable({}, {__len = function() return 1 << 60 end}))
--# sortWithNegativeLength | result: 0
local t = setmetatable({}, {__len = function() return -5 end})
table.sort(t)
table.sort(setmetatable({}, {__len = function() return math.mininteger end}))
return rawlen(t)
--# sortAgainAndAgain | error: too much work
local t = {}
for i = 1, 100000 do t[i] = i end
for i = 1, 1e7 do table.sort(t, rawequal) end
--# unpackHugeRange | error: too many results to unpack
return table.unpack({}, 1, 1 << 60)
--# unpackMostOfAll | error: too many results to unpack
return table.unpack({}, math.mininteger, math.maxinteger)
--# unpackAgainAndAgain | error: too much work
local t = {}
for i = 1, 1e7 do math.max(1, table.unpack(t, 1, 200000) or 1) end
--# unpackIntoSelect | error: takes too long
local function f(...) for i = 1, 1e7 do select('#', ...) end end
f(table.unpack({}, 1, 200000))
--# byteOfALongText | error: string slice too long
return string.byte(string.rep('x', 10000000), 1, -1)
--# charOfMany | result: 200000
local t = {}
for i = 1, 200000 do t[i] = 65 end
return #string.char(table.unpack(t))
--# charOutOfRange | error: value out of range
return string.char(256)
--# patternOfManyRepeats | error: too many steps
return (('a'):rep(3000)):find('.-.-.-.-b')
--# patternWithManyOptions | error: nested too deeply
return (('a'):rep(300)):find(('a?'):rep(300) .. ('a'):rep(300))
--# patternWithLongSet | error: too many steps
return (('a'):rep(1000000)):find('[' .. ('b'):rep(1000000) .. ']')
--# patternWithLongSetRepeated | error: too many steps
return (('a'):rep(1000000)):find('[^' .. ('b'):rep(1000000) .. ']*c')
--# patternWithManySets | error: too many steps
return (('a'):rep(100000)):find(('[^' .. ('b'):rep(100) .. ']'):rep(10000) .. 'c')
--# patternFrontiers | error: too many steps
return (('a'):rep(1000000)):find('%f[' .. ('b'):rep(100000) .. ']')
--# patternBalanced | error: too many steps
return (('('):rep(100000)):find('%b()')
--# patternBackReference | error: too many steps
return (('a'):rep(20000)):find('(a*)%1b')
--# patternManyCaptures | error: too many captures
return ('x'):find(('()'):rep(33))
--# patternDeepCaptures | error: too many captures
return ('x'):find(('('):rep(1000))
--# patternUnfinished | error: unfinished capture
return ('x'):find('(x')
--# patternEndsInASet | error: malformed pattern
return ('x'):find('[%')
--# patternEndsInARange | error: malformed pattern
return ('x'):find('[a-')
--# patternEndsInAPercent | error: malformed pattern
return ('x'):find('x%')
--# patternBackToNothing | error: invalid pattern capture
return ('x'):find('%9')
--# patternNul | result: 2 4
local a, b = ('a\0b\0'):find('%z[^\0]\0')
return a .. ' ' .. b
--# plainFindOfALongText | error: too many steps
return (('a'):rep(2000000)):find(('a'):rep(1000000) .. 'b', 1, true)
--# findWithoutSpecialsOfALongText | error: too many steps
return (('a'):rep(2000000)):find(('a'):rep(1000000) .. 'b')
--# plainFindOfALongTextThatIsThere | result: 1000000
return (('a'):rep(1000000) .. 'b'):find('ab', 1, true)
--# findAgainAndAgain | error: too
local s = ('a'):rep(1000)
for i = 1, 1e7 do s:find('.-.-b') end
--# findAgainAndAgainCaught | error: too
local s = ('a'):rep(3000)
while true do pcall(string.find, s, '.-.-.-.-b') end
--# plainFindAgainAndAgain | error: too much work
local s = ('a'):rep(10000000)
for i = 1, 1e7 do s:find('b', 1, true) end
--# gsubWithFunctionsOfTheLibrary | error: too
local s = ('a'):rep(1000000)
for i = 1, 1e7 do s:gsub('.', string.upper) end
--# gsubGrows | error: 
local s = ('a'):rep(1000)
while true do s = s:gsub('a', 'aaaaaaaaaa') end
--# gsubReplacementWithBadCapture | error: invalid use of '%'
return ('x'):gsub('x', '%2')
--# gsubReplacementEndsInPercent | error: invalid use of '%'
return ('x'):gsub('x', '%')
--# gmatchAgainAndAgain | error: too
local s = ('a'):rep(3000)
for i = 1, 1e7 do for a in s:gmatch('(.-)(.-)b') do end end
--# upperAgainAndAgain | error: 
local s = ('a'):rep(10000000)
for i = 1, 1e7 do s:upper() end
--# utf8LengthAgainAndAgain | error: too much work
local s = ('a'):rep(10000000)
for i = 1, 1e7 do utf8.len(s) end
--# utf8OffsetAgainAndAgain | error: too much work
local s = ('a'):rep(10000000)
for i = 1, 1e7 do utf8.offset(s, -1, 1) end
--# utf8BadBytes | result: nil 1
local a, b = utf8.len('\255')
return tostring(a) .. ' ' .. b
--# utf8Codepoint | error: invalid UTF-8 code
return utf8.codepoint('\xe4\xbd')
--# utf8CodepointOutside | error: out of bounds
return utf8.codepoint('abc', 1, 1000)
--# utf8CodepointOfALongText | error: string slice too long
return utf8.codepoint(('a'):rep(10000000), 1, -1)
--# utf8OffsetInsideOfACharacter | error: initial position is a continuation byte
return utf8.offset('\u{20ac}', 1, 2)
--# utf8OffsetFar | result: nil
return tostring(utf8.offset('abc', math.maxinteger))
--# utf8CodesOfBadBytes | error: invalid UTF-8 code
for _ in utf8.codes('ab\xff') do end
--# utf8CharTooLarge | error: value out of range
return utf8.char(-1)
--# pairsAgainAndAgain | error: too much work
local t = {}
for i = 1, 100000 do t['k' .. i] = i end
for i = 1, 1e7 do for k in pairs(t) do break end end
--# nextAgainAndAgain | error: too much work
local t = {}
for i = 1, 100000 do t['k' .. i] = i end
local k
while true do k = next(t, k) end
--# printAgainAndAgain | error: 
local s = ('a'):rep(10000000)
while true do print(s) end
--# formatAgainAndAgain | error: not enough memory
local s = ('a'):rep(10000000)
while true do string.format('%s', s) end
--# manyArguments | error: takes too long
local function f(...) return f(1, 2, 3, 4, ...) end
f()
--# manyResults | error: 
local function f(n) if n > 0 then return n, f(n - 1) end end
return select('#', f(1000000))
--# selectNegative | error: index out of range
return select(-5, 1, 2)
--# deepTables | result: 100000
local t = {}
for i = 1, 100000 do t = {t} end
local n = 0
while t[1] do t = t[1] n = n + 1 end
return n
