--# tostringTable | result: table
return tostring({})
--# tostringFunctions | result: function function
return tostring(print) .. ' ' .. tostring(function() end)
--# tostringThread | result: thread
return tostring(coroutine.create(print))
--# tostringWithName | result: 5 name
return '5 ' .. tostring(setmetatable({}, {__name = 'name'}))
--# tostringWithNumberAsName | result: table
return tostring(setmetatable({}, {__name = 5}))
--# printWithNumberAsName | result: 1
print(string.rep('x', 5000), setmetatable({}, {__name = 5}), string.rep('y', 5000))
return 1
--# printWithTableAsName | result: 1
print(setmetatable({}, {__name = {}}), setmetatable({}, {__name = print}), string.rep('y', 5000))
return 1
--# formatWithNumberAsName | result: table/7
return string.format('%s/%d', setmetatable({}, {__name = 5}), 7)
--# formatPointer | error: on each machine
return string.format('%p', {})
--# formatPointerOfAText | error: on each machine
return ('%p'):format('text')
--# formatPointerWithWidth | error: on each machine
return string.format('%-20p', print)
--# formatPointerAfterPercents | error: on each machine
return string.format('%%%%%p', print)
--# formatPointerAfterOthers | error: on each machine
return string.format('%d %s %5.2f %p', 1, 'x', 2, print)
--# formatPointerAfterNul | error: on each machine
return (string.format('%s\0%20p', 'x', {}):gsub('%z', ''))
--# formatEndsInAPercent | error: bad argument #2
return string.format('%')
--# formatOnlyFlags | error: on each machine
return string.format('%-----------------------------------p', 1)
--# formatStars | error: invalid conversion '%*' to 'format'
return string.format('%*d', 100, 1)
--# formatNumberOfBytes | error: invalid conversion '%n' to 'format'
return string.format('%n', 1)
--# formatSpecialFloat | error: format: argument 2 is nan
return string.format('%d', 0 / 0)
--# formatQuoted | error: value has no literal form
return string.format('%q', {})
--# formatQuotedFunction | error: value has no literal form
return string.format('%q', print)
--# formatHexFloat | error: on each machine
return string.format('%a', 1)
--# formatTooWide | error: invalid conversion
return string.format('%1000000d', 1)
--# formatTooPrecise | error: invalid conversion
return string.format('%.1000f', 1)
--# formatWidest | result: 99
return #string.format('%99.99s', 'x')
--# formatLargestNumber | result: 410
return #string.format('%99.99f', -1.7976931348623157e308) // 1
--# formatCodeNotText | error: number expected
return string.format('%c', {})
--# formatTooFew | error: bad argument #3
return string.format('%s %s', 1)
--# errorObjectWithAddress | result: table
return tostring(select(2, pcall(error, {})))
--# errorInConcat | error: attempt to concatenate a table value
return {} .. 'x'
--# errorInCall | error: attempt to call a table value
return ({})()
--# errorOfTostring | error: '__tostring' must return a string
return tostring(setmetatable({}, {__tostring = function() return {} end}))
--# errorOfGsub | error: invalid replacement value (a table)
return (('x'):gsub('x', function() return {} end))
--# concatOfTables | error: invalid value (at index 1) in table for 'concat'
return table.concat({{}})
--# lengthOfAFunction | error: attempt to get length of a function value
return #print
--# comparisonOfTables | error: attempt to compare two table values
return {} < {}
--# sortOfTables | error: attempt to compare two table values
table.sort({{}, {}})
--# sortOfFunctions | error: attempt to compare two function values
table.sort({print, pcall, error})
--# pairsWithTablesAsKeys | error: a key is a table
for k in pairs({[{}] = 1, [{}] = 2}) do stolen = k end
--# pairsWithFunctionsAsKeys | error: a key is a function
for k in pairs({[print] = 1, [pcall] = 2}) do stolen = k end
--# pairsWithThreadsAsKeys | error: a key is a thread
for k in pairs({[coroutine.create(print)] = 1}) do stolen = k end
--# nextWithTablesAsKeys | error: keys of this type have no order
local t = {[{}] = 1, [{}] = 2, [{}] = 3}
local k = next(t)
return next(t, k)
--# nextAfterAKeyThatIsNone | result: b
return next({a = 1, b = 2}, 'aa')
--# packPointers | error: invalid format option 'p'
return string.pack('p', {})
--# unpackBeyondTheText | error: data string too short
return string.unpack('i8', 'abc')
--# unpackFarAway | error: out of string
return string.unpack('i8', 'abcdefgh', 1 << 60)
--# unpackLongText | error: data string too short
return string.unpack('s8', '\255\255\255\255\255\255\255\127')
--# unpackTextWithoutEnd | error: unfinished string
return string.unpack('z', 'abc')
--# packSizeTooLarge | error: a.lua:1:
return string.packsize('c2147483647c2147483647c1') .. {}
--# packHugeText | error: not enough memory
return string.pack('c2147483000', 'x')
--# packAlignment | error: not power of 2
return string.pack('!16 Xi3', 1)
--# packIntegerSize | error: out of limits
return string.pack('i17', 1)
--# subWithLimits | result: abc||abc
local min, max = math.mininteger, math.maxinteger
return ('abc'):sub(min, max) .. '|' .. ('abc'):sub(max, min) .. '|' .. ('abc'):sub(-max, max)
--# byteWithLimits | result: 97 98 99
local a, b, c = ('abc'):byte(math.mininteger, math.maxinteger)
return a .. ' ' .. b .. ' ' .. c
--# findWithLimits | result: 1 nil nil
local s = 'abc'
return s:find('a', math.mininteger) .. ' ' .. tostring(s:find('a', math.maxinteger)) .. ' ' ..
  tostring(s:find('', math.maxinteger))
--# gmatchWithLimits | result: aa
local out = ''
for a in ('a'):gmatch('a', math.mininteger) do out = out .. a end
for a in ('a'):gmatch('a', -math.maxinteger) do out = out .. a end
for a in ('a'):gmatch('a', math.maxinteger) do out = out .. a end
return out
--# coroutineOfThisScript | result: thread true
local co, main = coroutine.running()
return tostring(co) .. ' ' .. tostring(main)
--# randomSeedIsOfTheGame | error: the game has one seed
math.randomseed(42)
--# randomRangeTooLarge | error: interval is too large
return math.random(math.mininteger, math.maxinteger)
--# randomZero | error: interval is empty
return math.random(0)
--# randomNoNumber | error: number has no integer representation
return math.random(0 / 0)
--# divisionByZero | error: a.lua:1: attempt to 
return 1 // 0
--# moduloByZero | error: a.lua:1: attempt to perform 'n%
return 1 % 0
--# smallestByMinusOne | result: true 0
return tostring(math.mininteger // -1 == math.mininteger) .. ' ' .. math.mininteger % -1
--# smallestRemainder | result: 0
return math.fmod(math.mininteger, -1)
--# fmodByZero | error: bad argument #2 to 'fmod' (zero)
return math.fmod(1, 0)
--# shifts | result: 0 0 -1
return (1 << 64) .. ' ' .. (1 >> math.maxinteger) .. ' ' .. (-1 << math.mininteger | -1)
--# floatToInteger | error: number has no integer representation
return 1 << 1e300
--# coercions | result: 10 nil nil nil 16.0
return tostring('5' * 2) .. ' ' .. tostring(tonumber('1,5')) .. ' ' .. tostring(tonumber('nan')) .. ' ' ..
  tostring(tonumber('inf')) .. ' ' .. tonumber('0x1p4')
--# coercionOfNoNumber | error: a.lua:1: attempt to 
return '1,5' + 1
--# longNumeral | result: inf nil
return tostring(tonumber(('1'):rep(100000) .. '.')) .. ' ' .. tostring(tonumber(('1'):rep(100000) .. ','))
--# tonumberBases | error: base out of range
return tonumber('10', 99)
--# mathOfSpecialNumbers | result: good
local numbers = {0 / 0, 1 / 0, -1 / 0, 1e300, -1e300, 1e-300, 0.0, -0.0, math.mininteger, math.maxinteger, 1e38, 4e9}
for _, name in ipairs({'sin', 'cos', 'tan', 'asin', 'acos', 'atan', 'exp', 'log', 'sqrt', 'floor', 'ceil', 'abs',
                       'modf', 'tointeger', 'deg', 'rad', 'type'}) do
  for _, x in ipairs(numbers) do pcall(math[name], x) end
end
for _, name in ipairs({'atan', 'log', 'pow', 'fmod', 'max', 'min', 'ult'}) do
  for _, x in ipairs(numbers) do for _, y in ipairs(numbers) do pcall(math[name], x, y) end end
end
return 'good'
--# specialNumbersAsText | result: nan nan inf -inf
return tostring(0 / 0) .. ' ' .. tostring(-(0 / 0)) .. ' ' .. (1 / 0) .. ' ' .. -(1 / 0)
--# nanAsKey | error: index is NaN
local t = {}
t[0 / 0] = 1
--# nilAsKey | error: index is nil
local t = {}
t[nil] = 1
