cmake_minimum_required(VERSION 3.22)

# JSON comes from files from anywhere, so no accessor may be used that throws when a value has
# another type than expected. Each line: a pattern, and what to use instead.
#
#   cmake -D ROOT=. -P check_json.cmake

set(denied
    "(\\.|->)value\\(\"|findMember, findText or JsonFields"
    "(\\.|->)at\\(\"|findMember, findText or JsonFields"
    "get_ref<|jsonText or findText"
    "(\\.|->)get<std::string>|jsonText or stringOrEmpty"
    "\\.dump\\(\\)|compactText: dump throws for a text that is not UTF-8"
)

set(broken 0)
set(count 0)
foreach(folder engine editor player)
    file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/${folder}/*.?pp)
    foreach(file IN LISTS files)
        math(EXPR count "${count} + 1")
        foreach(line IN LISTS denied)
            string(FIND "${line}" "|" cut REVERSE)
            string(SUBSTRING "${line}" 0 ${cut} pattern)
            math(EXPR cut "${cut} + 1")
            string(SUBSTRING "${line}" ${cut} -1 instead)
            file(STRINGS ${ROOT}/${file} found REGEX "${pattern}")
            foreach(hit IN LISTS found)
                string(STRIP "${hit}" hit)
                if(NOT hit MATCHES "^//")
                    message("${file}: ${hit}\n  throws for a wrong type; use ${instead} (reflect/json_members.hpp)")
                    math(EXPR broken "${broken} + 1")
                endif()
            endforeach()
        endforeach()
    endforeach()
endforeach()
if(count EQUAL 0)
    message(FATAL_ERROR "no source was found below ${ROOT}; this rule would check nothing")
endif()
if(broken)
    message(FATAL_ERROR "${broken} line(s) may throw at a file that is wrong")
endif()
