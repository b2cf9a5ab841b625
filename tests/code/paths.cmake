cmake_minimum_required(VERSION 3.22)

# The code of projects is built wherever they lie: paths with spaces, letters of other languages, quotes, brackets.
#   cmake -D ROOT=FOLDER -D WORK=FOLDER -D GENERATOR=NAME -D COMPILER=FILE -P paths.cmake

file(REMOVE_RECURSE ${WORK})
set(tree ${WORK}/plumb)  # a small engine, with the CMake files of the real one
file(COPY ${ROOT}/engine/cmake/ DESTINATION ${tree}/engine/cmake)
file(COPY ${ROOT}/projects/CMakeLists.txt DESTINATION ${tree}/projects)
file(WRITE ${tree}/include/plumb.hpp "#pragma once\n#define PLUMB_MODULE(module) extern const char* module\n")
file(WRITE ${tree}/player/main.cpp
    "#include <cstdio>\n#include <plumb.hpp>\nPLUMB_MODULE(word);\n"
    "int main(int count, char**) { std::puts(count > 1 ? PLUMB_PLAYER : word); }\n")
file(WRITE ${tree}/CMakeLists.txt [[
cmake_minimum_required(VERSION 3.22)
project(paths LANGUAGES CXX)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
set(PLUMB_EDITOR ON)
add_library(engine INTERFACE)
target_include_directories(engine INTERFACE include)
add_library(plumb::engine ALIAS engine)
include(engine/cmake/project_code.cmake)
add_subdirectory(projects)
]])
file(WRITE "${tree}/projects/My Game/main.cpp" "this has a name that no program can have")
set(build "${WORK}/build")

# Makes a project and enters it into the build. @param name  path of the folder
function(add_project path)
    file(WRITE "${path}/code/game.cpp"
        "#include <plumb.hpp>\n#include \"parts/word.hpp\"\nPLUMB_MODULE(word);\n"
        "const char* word = WORD;\nconst char* place = __FILE__;\n")
    file(WRITE "${path}/code/parts/word.hpp" "#define WORD \"it is built\"\n")
    foreach(time IN ITEMS first second)
        execute_process(COMMAND ${CMAKE_COMMAND} -D "PROJECT=${path}" -D BUILD=${build}
            -P ${tree}/engine/cmake/code_target.cmake OUTPUT_VARIABLE ${time} OUTPUT_STRIP_TRAILING_WHITESPACE)
    endforeach()
    if(first STREQUAL "" OR NOT first STREQUAL second)
        message(FATAL_ERROR "${path} has the target '${first}', then '${second}'")
    endif()
    set(targets ${targets} ${first} PARENT_SCOPE)
endfunction()

set(targets "")
add_project("${WORK}/größe/spiel")
add_project("${WORK}/ゲーム")
add_project("${WORK}/a b")
add_project("${WORK}/it's")
add_project("${WORK}/Tom & Jerry (2)")
add_project("${WORK}/#1 100% $5 \${HOME} $<1:x>")
add_project("${WORK}/[a]/{b}/it")
add_project("${WORK}/[b")
add_project("${WORK}/a;b")
add_project("${WORK}/\"quoted\"!")
add_project("${tree}/projects/plain-1")
add_project("${tree}/projects/My other game")
add_project("${tree}/projects/größe")
list(LENGTH targets count)
list(REMOVE_DUPLICATES targets)
list(LENGTH targets different)
if(NOT different EQUAL count)
    message(FATAL_ERROR "${count} projects have ${different} targets")
endif()

function(run)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT result EQUAL 0)
        message(FATAL_ERROR "${ARGN} fails:\n${output}")
    endif()
    set(output "${output}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} -S ${tree} -B ${build} -G ${GENERATOR} -D CMAKE_CXX_COMPILER=${COMPILER})
foreach(target IN LISTS targets)
    run(${CMAKE_COMMAND} --build ${build} --target ${target}-code ${target}-player)
    run(${build}/bin/${target}-player)
    if(NOT output STREQUAL "it is built\n")
        message(FATAL_ERROR "${target}-player prints '${output}'")
    endif()
endforeach()

# For exports, the same code gives the same bytes wherever it lies, and whatever was exported before.
file(COPY ${build}/projects.txt DESTINATION ${WORK}/exports)
run(${CMAKE_COMMAND} -S ${tree} -B ${WORK}/exports -G ${GENERATOR} -D CMAKE_CXX_COMPILER=${COMPILER} -D PLUMB_EXPORTED=ON)
set(players "")
foreach(target IN ITEMS outside-1 outside-3 plain-1)
    run(${CMAKE_COMMAND} --build ${WORK}/exports --target ${target}-player)
    list(APPEND players ${WORK}/exports/exported/${target}-player/player)
endforeach()
list(GET players 0 first)
foreach(player IN LISTS players)
    run(${CMAKE_COMMAND} -E compare_files ${first} ${player})
endforeach()

# What no build can pass on is an error that says so.
execute_process(COMMAND ${CMAKE_COMMAND} -D "PROJECT=${WORK}/a\\b" -D BUILD=${build}
    -P ${tree}/engine/cmake/code_target.cmake RESULT_VARIABLE result ERROR_VARIABLE output OUTPUT_QUIET)
string(REGEX REPLACE "[ \n]+" " " output "${output}")
if(result EQUAL 0 OR NOT output MATCHES "contains a backslash or a line break; rename the folder")
    message(FATAL_ERROR "a backslash in a path: ${result}, ${output}")
endif()
file(REMOVE_RECURSE ${WORK})
