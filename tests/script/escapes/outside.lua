--# io | error: attempt to index a nil value (global 'io')
return io.open('escaped.txt', 'w')
--# ioThroughG | result: nil
return tostring(_G.io)
--# os | error: attempt to index a nil value (global 'os')
return os.time()
--# osExit | error: attempt to index a nil value (global 'os')
os.exit(1)
--# osExecute | error: attempt to index a nil value (global 'os')
os.execute('touch escaped.txt')
--# clock | result: nil nil nil
return tostring(clock) .. ' ' .. tostring(time) .. ' ' .. tostring(date)
--# exit | error: attempt to call a nil value (global 'exit')
exit()
--# package | error: attempt to index a nil value (global 'package')
return package.loadlib('libc.so.6', '*')
--# packageLoaded | error: attempt to index a nil value (global 'package')
return package.loaded._G
--# require | error: attempt to call a nil value (global 'require')
return require('os')
--# dofile | error: attempt to call a nil value (global 'dofile')
return dofile('/etc/passwd')
--# loadfile | error: attempt to call a nil value (global 'loadfile')
return loadfile('/etc/passwd')
--# load | error: attempt to call a nil value (global 'load')
return load('return 1')()
--# loadWithEnvironment | error: attempt to call a nil value (global 'load')
return load('return io', 'x', 't', {})()
--# loadByteCode | error: attempt to call a nil value (global 'load')
return load('\27Lua\84\0\25\147\13\10\26\10', 'x', 'b')()
--# loadstring | error: attempt to call a nil value (global 'loadstring')
return loadstring('return 1')()
--# setfenv | error: attempt to call a nil value (global 'setfenv')
setfenv(1, {})
--# module | error: attempt to call a nil value (global 'module')
module('x')
--# newproxy | error: attempt to call a nil value (global 'newproxy')
newproxy(true)
--# stringDump | error: attempt to call a nil value (field 'dump')
return string.dump(function() end)
--# stringDumpThroughAText | error: attempt to call a nil value (method 'dump')
return (''):dump()
--# debug | error: attempt to index a nil value (global 'debug')
return debug.getregistry()
--# debugSethook | error: attempt to index a nil value (global 'debug')
debug.sethook()
--# debugUpvalue | error: attempt to index a nil value (global 'debug')
debug.setupvalue(function() end, 1, 1e18)
--# collectgarbage | error: attempt to call a nil value (global 'collectgarbage')
return collectgarbage('count')
--# warn | error: attempt to call a nil value (global 'warn')
warn('@on')
--# registryByNumber | result: nil nil
return tostring(_G[1]) .. ' ' .. tostring(_G[2])
--# loadedTable | result: nil nil
return tostring(_G._LOADED) .. ' ' .. tostring(_G._PRELOAD)
--# canaryByName | error: attempt to call a nil value (global 'canary')
canary()
--# environmentRemoved | error: attempt to index a nil value (upvalue '_ENV')
local print = print
_ENV = nil
return tostring(1)
--# environmentReplaced | error: attempt to call a nil value (global 'print')
local _ENV = {}
print(1)
--# environmentAsParameter | result: 3
local function f(_ENV) return a + b end
return f({a = 1, b = 2})
--# environmentWithOwnIndex | result: io-os
local _ENV = setmetatable({}, {__index = function(_, name) return name end})
return io .. '-' .. os
--# environmentIsAText | error: attempt to call a nil value (global 'dump')
local _ENV = 'text'
return dump()
--# environmentIsALibrary | result: 3
local tostring = tostring
local _ENV = math
return max(1, 3)
--# environmentIsALibraryAndIsWritten | error: tables of the library cannot be changed (field 'max')
local _ENV = math
max = 1
--# metatableOfTheEnvironment | result: false
return tostring(getmetatable(_G))
--# newMetatableOfTheEnvironment | error: cannot change a protected metatable
setmetatable(_G, {__index = function() return 1 end})
--# metatableOfTexts | result: false
return tostring(getmetatable(''))
--# changeMetatableOfTexts | error: attempt to index a boolean value
getmetatable('').__index = function() return 1 end
--# setMetatableOfTexts | error: table expected
setmetatable('', {__index = {}})
--# setMetatableOfNil | error: table expected
setmetatable(nil, {})
--# metatablesOfOtherTypes | result: nil nil nil nil
local mt = getmetatable
return tostring(mt(1)) .. ' ' .. tostring(mt(print)) .. ' ' .. tostring(mt(nil)) .. ' ' .. tostring(mt(true))
--# metatableOfACoroutine | result: nil
return tostring(getmetatable(coroutine.create(print)))
--# libraryWrite | error: tables of the library cannot be changed (field 'rep')
string.rep = function() return 'stolen' end
--# libraryNewName | error: tables of the library cannot be changed (field 'leak')
math.leak = {}
--# libraryRemove | error: tables of the library cannot be changed (field 'sort')
table.sort = nil
--# libraryRawset | error: tables of the library cannot be changed (field 'rep')
rawset(string, 'rep', print)
--# libraryRawsetNoText | error: tables of the library cannot be changed (field 'number')
rawset(math, 1, print)
--# libraryInsert | error: tables of the library cannot be changed
table.insert(math, 'x')
--# libraryMove | error: tables of the library cannot be changed
table.move({1, 2, 3}, 1, 3, 1, utf8)
--# libraryRemoveLast | error: tables of the library cannot be changed
table.remove(coroutine)
--# librarySort | result: 0
table.sort(math)
return #math
--# librarySetMetatable | error: cannot change a protected metatable
setmetatable(coroutine, {})
--# libraryGetMetatable | result: false
return tostring(getmetatable(utf8))
--# libraryRawget | result: nil
return tostring(rawget(string, 'rep'))
--# libraryNext | result: nil
return tostring(next(string))
--# libraryPairsGivesACopy | result: function
for name, f in pairs(string) do assert(type(f) == 'function' or name == 'charpattern') end
local _, copy = pairs(string)
copy.rep = nil
rawset(copy, 'format', nil)
return type(string.rep)
--# libraryPairsIsComplete | result: close create isyieldable resume running status wrap yield
local names = {}
for name in pairs(coroutine) do names[#names + 1] = name end
return table.concat(names, ' ')
--# metamethodOfTheLibrary | result: nil nil
return tostring(string.__newindex) .. ' ' .. tostring(string.__index)
--# globalsOfOthers | result: mine
print = function() return 'mine' end
stolen = 1
tostring = nil
rawset(_G, 'leaked', 1)
return _G.print()
--# globalsThroughG | result: mine
_G._G = nil
string = 'mine'
return string
--# functionsOfOthersStay | result: true
local before = pcall
pcall = nil
return tostring(_ENV.pcall == before)
--# textMethodsWithoutTheGlobal | result: xx
string = nil
return ('x'):rep(2)
--# finalizer | error: __gc is not available
setmetatable({}, {__gc = function() while true do end end})
--# finalizerLater | result: 1
local mt = {}
local t = setmetatable({}, mt)
mt.__gc = function() stolen = 1 end
t = nil
for i = 1, 10000 do local x = {i} end
return 1
--# finalizerInherited | error: __gc is not available
local mt = setmetatable({}, {__index = {__gc = print}})
mt.__gc = false
setmetatable({}, mt)
--# weakTable | error: __mode is not available
setmetatable({}, {['__' .. 'mode'] = 'k'})
--# weakTableByName | error: __mode is not available
local mt = {}
local t = setmetatable({}, mt)
mt.__mode = 'k'
--# weakTableByText | error: __mode is not available
local mt = {}
local t = setmetatable({}, mt)
rawset(mt, "__mode", 'k')
--# weakTableByLongText | error: __mode is not available
local mt = {}
mt[ [==[__mode]==] ] = 'k'
--# textAboutModes | result: the __mode of a table
return "the __mode of a table"
