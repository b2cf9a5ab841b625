cmake_minimum_required(VERSION 3.22)

# Every header in a components/ folder is named in its layer's register_components.cpp.
#
#   cmake -D ROOT=. -P check_components.cmake

file(GLOB headers RELATIVE ${ROOT}/engine ${ROOT}/engine/*/components/*.hpp)
if(NOT headers)
    message(FATAL_ERROR "no component was found below ${ROOT}/engine; this rule would check nothing")
endif()
set(missing)
foreach(header IN LISTS headers)
    string(REGEX REPLACE "/.*" "" layer ${header})
    file(STRINGS ${ROOT}/engine/${layer}/register_components.cpp found REGEX "\"${header}\"")
    if(NOT found)
        message("${header} is not registered; add its include and one line to ${layer}/register_components.cpp")
        list(APPEND missing ${header})
    endif()
endforeach()
if(missing)
    message(FATAL_ERROR "a component that is not registered can be neither saved, scripted nor inspected")
endif()
