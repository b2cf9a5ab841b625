--# loop | error: takes too long
while true do end
--# loopWithRepeat | error: takes too long
repeat until false
--# loopWithGoto | error: takes too long
::again:: goto again
--# gotoInNestedBlocks | error: takes too long
do do ::top:: if true then goto top end end end
--# gotoOutOfAFunction | error: no visible label 'out'
::out::
local function f() goto out end
f()
--# gotoContinue | result: 25
local s = 0
for i = 1, 10 do
  if i % 2 == 0 then goto continue end
  s = s + i
  ::continue::
end
return s
--# forOverAllIntegers | error: takes too long
for i = math.mininteger, math.maxinteger do end
--# forWithOverflowOfTheStep | result: 2
local n = 0
for i = math.maxinteger - 1, math.maxinteger do n = n + 1 end
return n
--# forWithStepZero | error: 'for' step is zero
for i = 1, 2, 0 do end
--# forWithTinyStep | error: takes too long
for x = 0, 1, 1e-300 do end
--# forToNan | result: 0
local n = 0
for i = 1, 0 / 0 do n = n + 1 end
return n
--# forToInfinity | error: takes too long
for i = 1, math.huge do end
--# recursionWithoutEnd | error: 
local function f() return 1 + f() end
f()
--# tailCallWithoutEnd | error: takes too long
local function f() return f() end
f()
--# catchAndGoOn | error: takes too long
while true do pcall(function() while true do end end) end
--# catchAndGoOnInACoroutine | error: takes too long
while true do
  coroutine.resume(coroutine.create(function() while true do end end))
end
--# catchWithHandler | error: takes too long
while true do xpcall(function() while true do end end, function() while true do end end) end
--# catchInRecursion | error: 
local function f() pcall(f) pcall(f) end
f()
while true do end
--# catchAndReturn | error: takes too long
local ok, message = pcall(function() while true do end end)
local function f() return message end
return f()
--# handlerThatFails | result: false
return tostring((xpcall(error, function(e) error(e) end, 'x')))
--# handlerThatNeverEnds | error: takes too long
xpcall(error, function() while true do end end)
for i = 1, 2 do end
--# handlerIsTheFunction | error: not enough memory
local function f() return f() .. error('x') end
return tostring((xpcall(f, f)))
--# errorOfAnError | error: takes too long
local e = setmetatable({}, {__tostring = function() while true do end end})
pcall(tostring, e)
while true do end
--# errorObjectThatNeverEnds | error: takes too long
error(setmetatable({}, {__tostring = function() while true do end end}))
--# errorObjectThatFails | error: inner
error(setmetatable({}, {__tostring = function() error('inner') end}))
--# budgetShadowed | error: the name __budget is reserved
local __budget = math.huge
while true do end
--# budgetAssigned | error: the name __budget is reserved
__budget = 1e18
while true do end
--# budgetAsParameter | error: the name __budget is reserved
local function f(__budget) while true do end end
f(1e18)
--# budgetAsLoopVariable | error: the name __budget is reserved
for __budget = 1e18, 1e18 do while true do end end
--# budgetAsField | error: the name __budget is reserved
local t = {__budget = 1}
--# budgetAsLabel | error: the name __budget is reserved
::__budget:: while true do end
--# budgetRead | error: the name __budget is reserved
return __budget
--# overBudgetShadowed | error: the name __overBudget is reserved
local function __overBudget() end
while true do end
--# overBudgetAsAttribute | error: the name __overBudget is reserved
local __overBudget <const> = print
--# budgetInTheEnvironment | error: takes too long
_ENV['__bud' .. 'get'] = 1e18
_ENV['__over' .. 'Budget'] = print
while true do end
--# budgetInAText | result: __budget
return '__budget' -- __budget
--# endOfTheFunctionAroundTheScript | error: 'end' closes nothing
end
while true do end
--# endOfTheFunctionThenAnother | error: 'end' closes nothing
return 1 end, (function(...) while true do end
--# untilWithoutRepeat | error: 'until' closes nothing
until true
--# elseWithoutIf | error: a.lua:1:
else while true do end
--# unfinishedLongComment | error: a.lua:
--[==[ while true do ]=] end
--# unfinishedLongText | error: unfinished long string
local s = [==[ ]=] while true do end
--# commentThatIsNotLong | error: takes too long
--[==
while true do end --]==]
--# commentThatIsNotLongEither | error: takes too long
--[=x[
while true do end --]=]
--# commentEndsEarly | error: takes too long
--[==[ ]=] ]==] while true do end
--# commentAtTheEnd | result: 1
return 1 --[[ end ]] -- end
--# longTextAsIndex | error: takes too long
local t = {x = 1}
local a = t[ [[x]]] while true do end
--# quotesInLongText | error: takes too long
local a = [["']] while true do end local b = [["']]
--# longBracketInQuotes | error: takes too long
local a = "[[" while true do end local b = "]]"
--# backslashesBeforeQuote | error: takes too long
local a = "\\" while true do end local b = "\\"
--# quoteInQuotes | error: takes too long
local a = "'" while true do end local b = "'"
--# escapedQuote | error: takes too long
local a = '\'' while true do end local b = '\''
--# commentInQuotes | error: takes too long
local a = '--' while true do end
--# commentInQuotesLong | error: takes too long
local a = '--[[' while true do end local b = ']]'
--# minusMinus | error: takes too long
local a = 1 - - 1 while true do end
--# numbersBeforeWords | error: malformed number
local a = 3for i = 1, 2 do end
--# numberThenConcat | error: malformed number
return 1..2
--# numberWithExponent | error: takes too long
local a = 0x1p-1 local b = 3e+1 while true do end
--# semicolons | error: takes too long
;;; while true do ;;; end ;;;
--# parenthesisAfterDo | error: takes too long
while true do (tostring)(1) end
--# headWithFunction | error: takes too long
while (function() for i = 1, 2 do end return true end)() do end
--# headWithTable | error: not enough memory
for _ in (function() return function() return {function() end} end end)() do end
--# untilWithFunction | error: takes too long
repeat local x = 1 until (function() repeat until true return false end)()
--# untilSeesLocals | result: 3
local n = 0
repeat local done = n == 2 n = n + 1 until done
return n
--# attributes | result: 4
local a <const> = 1
local b <close> = nil
local n = 0
for i = 1, 3 do local c <const> = i n = n + a end
return n + a
--# constIsAssigned | error: attempt to assign to const variable 'a'
local a <const> = 1
a = 2
--# wordsAsFields | error: takes too long
local t = {['while'] = 1, ["do"] = 2}
while t do end
--# methodsWithDots | error: takes too long
local t = {a = {}}
function t.a:f(x, ...) while true do end end
t.a:f()
--# functionWithComments | error: takes too long
local function f --[[ ) ]] ( a --[[ ) ]] , b -- )
) return f(a, b) end
f()
--# power | error: powers other than ^2
return 2 ^ 0.5
--# powerOfAPower | error: powers other than ^2
return 2 ^ 2 ^ 3
--# ifBlocksInLoops | error: takes too long
while true do if true then elseif false then else end end
--# loopInIndex | error: takes too long
local t = setmetatable({}, {__index = function(t, k) return t[k] end})
pcall(function() return t.x end)
while true do end
--# metamethodsRecurse | result: false false false false false false false
local mt = {}
for _, name in ipairs({'__index', '__call', '__concat', '__eq', '__lt', '__le', '__len', '__unm', '__add'}) do
  mt[name] = function(a, b)
    if name == '__index' then return a[b] elseif name == '__call' then return a() + 1
    elseif name == '__concat' then return a .. b elseif name == '__eq' then return a == b
    elseif name == '__lt' then return a < b elseif name == '__le' then return a <= b
    elseif name == '__len' then return #a else return -a end
  end
end
local function new() return setmetatable({}, mt) end
local out = {}
for i, f in ipairs({function() return new().x end, function() return new()() end, function() return new() .. new() end,
                    function() return new() == new() end, function() return new() < new() end,
                    function() return #new() end, function() return -new() end}) do
  out[i] = tostring((pcall(f)))
end
return table.concat(out, ' ')
--# indexChain | error: '__index' chain too long
local t = {}
setmetatable(t, {__index = t})
local a, b = {}, {}
setmetatable(a, {__index = b})
setmetatable(b, {__index = a})
return a.x
--# newIndexChain | error: '__newindex' chain too long
local a, b = {}, {}
setmetatable(a, {__newindex = b})
setmetatable(b, {__newindex = a})
a.x = 1
--# callChain | error: __call must be a function, found a table
local t = {}
for i = 1, 1000 do t = setmetatable({}, {__call = t}) end
t()
--# callOfItself | error: __call can be assigned
local t = setmetatable({}, {})
getmetatable(t).__call = t
t()
--# callOfItselfInBrackets | error: __call can be assigned
local t = setmetatable({}, {})
getmetatable(t)["__call"] = t
t()
--# callOfItselfInLongBrackets | error: __call can be assigned
local t = setmetatable({}, {})
getmetatable(t)[ [=[__call]=] ] = t
t()
--# callOfItselfAfterAFunction | error: __call can be assigned
local t = setmetatable({}, {})
local x
x, getmetatable(t).__call = function() end, t
t()
--# callOfItselfAsAGlobal | error: __call can be assigned
local t = setmetatable({}, {})
local _ENV = getmetatable(t)
__call = t
t()
--# callOfItselfInAFunctionInATable | error: __call can be assigned
local t = setmetatable({}, {})
local f = {function() getmetatable(t).__call = t end}
f[1]()
t()
--# callOfItselfByRawset | error: __call must be a function, found a table
local t = setmetatable({}, {})
rawset(getmetatable(t), '__call', t)
t()
--# callOfItselfFromTheStart | error: __call must be a function, found a table
local t = {}
setmetatable(t, {__call = t})
t()
--# callOfItselfFromAMadeKey | error: __call must be a function, found a table
local t = {}
setmetatable(t, {['__' .. 'call'] = t})
t()
--# callByFunctions | result: 7 12 3 4
local mt = {__call = function(self, a) return a + 1 end}
local t = setmetatable({}, mt)
local a = t(6)
function mt.__call(self, b) return b * 2 end
local b = t(6)
rawset(mt, '__call', function() return 3 end)
local c = t()
local function four() return 4 end
return a .. ' ' .. b .. ' ' .. c .. ' ' .. setmetatable({}, {["__call"] = four; x = {1}})()
--# closeThatNeverEnds | error: takes too long
local c <close> = setmetatable({}, {__close = function() while true do end end})
--# closeThatFails | error: again
local c <close> = setmetatable({}, {__close = function() error('again') end})
error('first')
--# closeAfterTheBudget | error: takes too long
local mt = {__close = function() while true do end end}
local function f(n)
  local c <close> = setmetatable({}, mt)
  if n > 0 then f(n - 1) end
  while true do end
end
f(100)
--# closeInAForLoop | error: takes too long
for i in function() return 1 end, nil, nil, setmetatable({}, {__close = function() while true do end end}) do end
--# closeOfACoroutine | error: takes too long
local co = coroutine.create(function()
  local c <close> = setmetatable({}, {__close = function() while true do end end})
  coroutine.yield()
end)
coroutine.resume(co)
coroutine.close(co)
while true do end
--# closeOfTheRunningCoroutine | error: cannot close a running coroutine
coroutine.close(coroutine.running())
--# resumeItself | result: cannot resume non-suspended coroutine
return select(2, coroutine.resume(coroutine.running()))
--# wrapThatCallsItself | error: cannot resume non-suspended coroutine
local f
f = coroutine.wrap(function() f() end)
f()
--# yieldFromOutside | error: attempt to yield from outside a coroutine
coroutine.yield()
--# yieldInSort | result: attempt to yield across a C-call boundary
local co = coroutine.create(function() table.sort({1, 2, 3}, function() coroutine.yield() end) end)
return select(2, coroutine.resume(co))
--# yieldInGsub | result: attempt to yield across a C-call boundary
local co = coroutine.create(function() local s = ('x'):gsub('x', coroutine.yield) end)
return select(2, coroutine.resume(co))
--# yieldInPcall | result: 1 2 true done
local co = coroutine.wrap(function()
  local ok, x = pcall(function() coroutine.yield(1) coroutine.yield(2) return 'done' end)
  return tostring(ok) .. ' ' .. x
end)
return co() .. ' ' .. co() .. ' ' .. co()
--# errorAfterAYieldInXpcall | result: handled: x
local co = coroutine.wrap(function()
  return select(2, xpcall(function(a) coroutine.yield() error(a, 0) end, function(e) return 'handled: ' .. e end, 'x'))
end)
co()
return co()
--# wrapNest | error: C stack overflow
local function nest() return coroutine.wrap(nest)() end
nest()
--# resumeNest | result: false
local function nest() return select(2, coroutine.resume(coroutine.create(nest))) end
return tostring(nest() == true)
--# pcallNest | error: overflow
local function nest() local ok, e = pcall(nest) error(e, 0) end
nest()
--# pcallOfPcall | result: 101
local n = 100
local arguments = {}
for i = 1, n do arguments[i] = pcall end
return select('#', pcall(table.unpack(arguments)))
--# pcallOfPcallDeep | result: false
local arguments = {}
for i = 1, 100000 do arguments[i] = pcall end
local results = {pcall(table.unpack(arguments))}
return tostring(results[#results - 1])
--# gsubNest | error: overflow
local function nest() return (('x'):gsub('x', nest)) end
nest()
--# sortNest | error: overflow
local function nest() table.sort({1, 2}, nest) end
nest()
--# tostringNest | error: overflow
local mt = {}
mt.__tostring = function(t) return tostring(t) end
tostring(setmetatable({}, mt))
--# printNest | error: overflow
local t = setmetatable({}, {})
getmetatable(t).__tostring = function() print(t) return '' end
print(t)
--# pairsNest | error: overflow
local t = setmetatable({}, {})
getmetatable(t).__pairs = function() return pairs(t) end
pairs(t)
--# pairsReturnsItself | error: overflow
local t = setmetatable({}, {__pairs = pairs})
pairs(t)
--# sortComparesAtRandom | result: 2000
local t = {}
for i = 1, 2000 do t[i] = i end
table.sort(t, function() return math.random() < 0.5 end)
return #t
--# sortChangesTheList | result: 0
local t = {}
for i = 1, 100 do t[i] = i end
pcall(table.sort, t, function(a, b) for k in pairs(t) do t[k] = nil end return a < b end)
for k in pairs(t) do t[k] = nil end
return #t
--# coroutineThatIsNone | error: thread expected
coroutine.resume({})
--# statusOfNothing | error: thread expected
return coroutine.status()
