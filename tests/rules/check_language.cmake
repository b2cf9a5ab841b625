cmake_minimum_required(VERSION 3.22)

# Comments, identifiers, texts and documents are written in the language of the field: a body, a shape or an entity is
# "it", never "who". Words are found alone and as a part of an identifier (kNobody, valueIsTold).
#
#   cmake -D ROOT=. -P check_language.cmake

set(folders editor engine player projects tests docs)
set(endings cpp hpp inl md txt cmake sh)
set(left_out "^tests/rules/check_language")

# The banned word in lower case, and the remedy. Exceptions are "path:word".
set(who "it, which, that, the noun (the body, the proxy), or the user if it is a person")
set(no_one "none, nothing, or the noun (no body, no component)")
set(some_one "one, something, or the noun (a body, a component)")
set(every_one "all, each, everything, or the noun (every body, all bodies)")
set(banned
    "who=${who}" "whom=${who}" "whoever=${who}"
    "nobody=${no_one}" "anybody=${no_one}" "anyone=${no_one}"
    "somebody=${some_one}" "someone=${some_one}" "everybody=${every_one}" "everyone=${every_one}"
    "told=reported, stored, given or known"
    "whence=from where" "foreseen=predicted" "foresee=predict" "foresight=prediction")
set(exceptions)

# One expression for all words; file(STRINGS) knows neither word boundaries nor letters of either case.
set(words "")
foreach(row IN LISTS banned)
    string(REGEX REPLACE "=.*" "" word "${row}")
    string(SUBSTRING ${word} 0 1 first)
    string(SUBSTRING ${word} 1 -1 rest)
    string(TOUPPER ${first} upper)
    list(APPEND lower_or_upper "[${first}${upper}]${rest}")
    list(APPEND upper_only "${upper}${rest}")
endforeach()
list(JOIN lower_or_upper "|" lower_or_upper)
list(JOIN upper_only "|" upper_only)
set(pattern "(^|[^A-Za-z])(${lower_or_upper})([^a-z]|$)|[a-z0-9](${upper_only})([^a-z]|$)")

set(globs "")
foreach(folder IN LISTS folders)
    foreach(ending IN LISTS endings)
        list(APPEND globs ${ROOT}/${folder}/*.${ending})
    endforeach()
endforeach()
file(GLOB_RECURSE files RELATIVE ${ROOT} ${globs})
if(NOT files)
    message(FATAL_ERROR "no text was found below ${ROOT}; this rule would check nothing")
endif()

set(broken 0)
set(unused ${exceptions})

# Names the lines of a file that has a banned word; a slow second look, so it is taken at few files only.
function(complain file)
    file(READ ${ROOT}/${file} text)
    string(REPLACE ";" "," text "${text}")
    string(REPLACE "[" "(" text "${text}")
    string(REPLACE "]" ")" text "${text}")
    string(REPLACE "\\" "/" text "${text}")
    string(REPLACE "\n" ";" lines "${text}")
    set(number 0)
    foreach(line IN LISTS lines)
        math(EXPR number "${number} + 1")
        if(NOT line MATCHES "${pattern}")
            continue()
        endif()
        string(TOLOWER "${CMAKE_MATCH_2}${CMAKE_MATCH_4}" word)
        if("${file}:${word}" IN_LIST exceptions)
            list(REMOVE_ITEM unused ${file}:${word})
            continue()
        endif()
        foreach(row IN LISTS banned)
            if(row MATCHES "^${word}=(.*)")
                message("${file}:${number}: \"${word}\"; write ${CMAKE_MATCH_1}")
            endif()
        endforeach()
        math(EXPR broken "${broken} + 1")
    endforeach()
    set(broken ${broken} PARENT_SCOPE)
    set(unused ${unused} PARENT_SCOPE)
endfunction()

foreach(file IN LISTS files)
    if(file MATCHES "${left_out}")
        continue()
    endif()
    file(STRINGS ${ROOT}/${file} found LIMIT_COUNT 1 REGEX "${pattern}")
    if(found)
        complain(${file})
    endif()
endforeach()
foreach(exception IN LISTS unused)
    message("check_language.cmake excepts ${exception}, which is not there")
    math(EXPR broken "${broken} + 1")
endforeach()
if(broken)
    message(FATAL_ERROR "${broken} line(s) speak the private language; say it as Box2D, EnTT, Godot and SDL do")
endif()
