cmake_minimum_required(VERSION 3.22)

# Every header below a components/ folder is included by its layer's components.hpp, whose list names its type.
#
#   cmake -D ROOT=. -P check_components.cmake

file(GLOB headers RELATIVE ${ROOT}/engine ${ROOT}/engine/*/components/*.hpp ${ROOT}/engine/*/components/*/*.hpp)
if(NOT headers)
    message(FATAL_ERROR "no component was found below ${ROOT}/engine; this rule would check nothing")
endif()
set(missing)
foreach(header IN LISTS headers)
    string(REGEX REPLACE "/.*" "" layer ${header})
    get_filename_component(type ${header} NAME_WE)
    string(REPLACE "_" "" type ${type})
    file(READ ${ROOT}/engine/${layer}/components.hpp list)
    string(FIND "${list}" "\"${header}\"" included)
    string(TOLOWER "${list}" list)
    if(included EQUAL -1 OR NOT list MATCHES "[<, \n]${type}[,>]")
        message("${header} is not registered; add its include and its type to ${layer}/components.hpp")
        list(APPEND missing ${header})
    endif()
endforeach()
if(missing)
    message(FATAL_ERROR "a component that is not registered can be neither saved, scripted nor inspected")
endif()
