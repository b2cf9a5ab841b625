# The code of a project: FOLDER/code/*.cpp, which contains one PLUMB_MODULE (app/module.hpp).
#
#   NAME-code    a library that the editor loads, and loads again after a change
#   NAME-player  the player with the code linked in; an export contains it
include(${CMAKE_CURRENT_LIST_DIR}/code_target.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/player_program.cmake)

# Compiles the code of a game for a debugger, if asked to.
function(debug_code target)
    if(PLUMB_DEBUG_CODE)
        target_compile_options(${target} PRIVATE $<$<NOT:$<CXX_COMPILER_ID:MSVC>>:-O0 -g>)
    endif()
endfunction()

# Lets reports of crashes (core/crash.hpp) name the functions of a game's code. Exported functions of the engine would
# stay in the program even if they are not used. The libraries of sanitizers must be exported.
function(name_functions program)
    set_target_properties(${program} PROPERTIES ENABLE_EXPORTS ON)
    if(CMAKE_SYSTEM_NAME STREQUAL "Linux" AND NOT PLUMB_SANITIZE)
        target_link_options(${program} PRIVATE -Wl,--exclude-libs,ALL)
    endif()
endfunction()

function(add_project_code name folder)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${folder}/code/*.cpp")
    if(NOT sources)
        return()
    endif()
    # Checked before they are compiled, again whenever a file is changed, added or removed.
    set(check ${PROJECT_SOURCE_DIR}/engine/cmake/check_module.cmake)
    set(checked ${CMAKE_CURRENT_BINARY_DIR}/${name}-module.txt)
    add_custom_command(OUTPUT ${checked} COMMENT "Checking PLUMB_MODULE in ${folder}/code"
        COMMAND ${CMAKE_COMMAND} -D "FOLDER=${folder}/code" -D "FILES=${sources}" -D STAMP=${checked} -P ${check}
        DEPENDS ${sources} ${check} VERBATIM)
    # Compiled once for both. The header of all that games use is compiled once, too: a change is built in some 4 s.
    add_library(${name}-objects OBJECT ${sources} ${checked})
    target_link_libraries(${name}-objects PUBLIC plumb::engine)
    target_precompile_headers(${name}-objects PRIVATE <plumb.hpp>)
    target_compile_options(${name}-objects PRIVATE $<$<NOT:$<CXX_COMPILER_ID:MSVC>>:-Wall -Wextra>)
    target_compile_definitions(${name}-objects PRIVATE PLUMB_RELOADABLE)
    # The program does not depend on where the project is.
    target_compile_options(${name}-objects PRIVATE
        "$<$<NOT:$<CXX_COMPILER_ID:MSVC>>:-fmacro-prefix-map=${folder}/=>")
    # Each version of a library that is loaded again has its own types; gcc makes inline variables unique in the program.
    target_compile_options(${name}-objects PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>)

    debug_code(${name}-objects)

    add_executable(${name}-player ${PROJECT_SOURCE_DIR}/player/main.cpp)
    target_link_libraries(${name}-player PRIVATE ${name}-objects plumb::engine)
    name_functions(${name}-player)
    name_player(${name}-player)
    finish_player(${name}-player)

    if(NOT PLUMB_EDITOR)
        return()
    endif()
    # Links no library: the engine's functions are those of the editor that loads it.
    add_library(${name}-code MODULE $<TARGET_OBJECTS:${name}-objects>)
    set_target_properties(${name}-code PROPERTIES PREFIX "" LINKER_LANGUAGE CXX
        LIBRARY_OUTPUT_DIRECTORY ${CMAKE_RUNTIME_OUTPUT_DIRECTORY})
    if(APPLE)
        target_link_options(${name}-code PRIVATE -undefined dynamic_lookup)
    endif()
endfunction()

# Lets a program load the code of projects while it runs: the code uses the functions of the engine that are in the
# program, so all of them are, not only those that the program uses itself.
function(export_engine program)
    set(layers core math physics codec platform reflect input ecs assets audio render scene gameplay script app)
    set_target_properties(${program} PROPERTIES ENABLE_EXPORTS ON)
    add_dependencies(${program} ${layers})
    if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
        list(TRANSFORM layers REPLACE "(.+)" "$<TARGET_FILE:\\1>")
        list(JOIN layers "," files)
        target_link_options(${program} PRIVATE -Wl,--whole-archive,${files},--no-whole-archive)
    elseif(APPLE)
        foreach(layer IN LISTS layers)
            target_link_options(${program} PRIVATE -Wl,-force_load,$<TARGET_FILE:${layer}>)
        endforeach()
    endif()
endfunction()
