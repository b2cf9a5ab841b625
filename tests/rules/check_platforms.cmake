cmake_minimum_required(VERSION 3.22)

# What differs between operating systems is in folders named posix, windows, web and desktop (posix and windows), of which
# a build compiles its own: no other file of the engine and of the player asks for the system.
#
#   cmake -D ROOT=. -P check_platforms.cmake

set(systems "_WIN32|__MINGW|__linux__|__APPLE__|__EMSCRIPTEN__|__unix__|__wasm__|EMSCRIPTEN_")
set(allowed
    "engine/app/module.hpp"  # a macro for the code of projects
)

file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/engine/*.?pp ${ROOT}/engine/*.inl ${ROOT}/player/*.?pp)
if(NOT files)
    message(FATAL_ERROR "no source was found below ${ROOT}; this rule would check nothing")
endif()
set(broken 0)
foreach(file IN LISTS files)
    if(file MATCHES "/(posix|windows|web|desktop)/" OR file IN_LIST allowed)
        continue()
    endif()
    file(STRINGS ${ROOT}/${file} hits REGEX "^ *#.*(${systems})")
    foreach(hit IN LISTS hits)
        message("${file}: ${hit}\n  put what differs into a folder of the system, see engine/core/os.hpp")
        math(EXPR broken "${broken} + 1")
    endforeach()
endforeach()
if(broken)
    message(FATAL_ERROR "${broken} line(s) ask for the system")
endif()
