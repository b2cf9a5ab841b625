cmake_minimum_required(VERSION 3.22)

# No source file is longer than 500 lines.
#
#   cmake -D ROOT=. -P check_sizes.cmake

file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/engine/*.?pp ${ROOT}/editor/*.?pp ${ROOT}/player/*.?pp
     ${ROOT}/projects/*.?pp ${ROOT}/tests/*.?pp)
if(NOT files)
    message(FATAL_ERROR "no source was found below ${ROOT}; this rule would check nothing")
endif()
set(broken 0)
foreach(file IN LISTS files)
    file(READ ${ROOT}/${file} text)
    string(REGEX MATCHALL "\n" ends "${text}")
    list(LENGTH ends lines)
    if(lines GREATER 500)
        message("${file} has ${lines} lines; split it by responsibility")
        math(EXPR broken "${broken} + 1")
    endif()
endforeach()
if(broken)
    message(FATAL_ERROR "${broken} file(s) are longer than 500 lines")
endif()
