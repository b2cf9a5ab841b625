cmake_minimum_required(VERSION 3.22)

# The code of a project has one PLUMB_MODULE; for none and for two the error names the files and the remedy.
#   cmake -D TESTED=…/engine/cmake -D WORK=FOLDER -P one_module.cmake

# Checks code of these files: NAME TEXT NAME TEXT ...; @ in a text is a semicolon.
function(check)
    file(REMOVE_RECURSE ${WORK})
    set(files "")
    while(ARGN)
        list(POP_FRONT ARGN name text)
        string(REPLACE "@" ";" text "${text}")
        file(WRITE ${WORK}/code/${name} "${text}\n")
        list(APPEND files ${WORK}/code/${name})
    endwhile()
    execute_process(COMMAND ${CMAKE_COMMAND} -D FOLDER=${WORK}/code -D "FILES=${files}" -D STAMP=${WORK}/stamp -P ${TESTED}/check_module.cmake
        RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    set(result ${result} PARENT_SCOPE)
    set(output "${output}" PARENT_SCOPE)
endfunction()

function(expect_accepted)
    check(${ARGN})
    if(NOT result EQUAL 0 OR NOT EXISTS ${WORK}/stamp)
        message(FATAL_ERROR "rejected: ${ARGN}\n${output}")
    endif()
endfunction()

function(expect_error error)
    check(${ARGN})
    string(FIND "${output}" "${WORK}/code: error: ${error}" at)
    if(result EQUAL 0 OR EXISTS ${WORK}/stamp OR at EQUAL -1)
        message(FATAL_ERROR "expected '${error}' for: ${ARGN}\n${output}")
    endif()
endfunction()

set(module "PLUMB_MODULE(module) { module.components<A>()@ }")
expect_accepted(game.cpp "${module}" parts/other.cpp "int other = 1@")
expect_accepted(game.cpp "namespace game {\n  PLUMB_MODULE (module) {}\n}")
expect_accepted(game.cpp "// ${module}\n/* old:\n${module}\n **/\n${module}" other.cpp "// PLUMB_MODULE(module)")
expect_accepted(game.cpp "auto path = \"assets/*.png\", quote = \"\\\"/*\"@\n${module}\n/* the end */")
expect_error("no .cpp file contains PLUMB_MODULE; write PLUMB_MODULE(module)" game.cpp "int no = 1@\n// ${module}")
expect_error("there are 2 PLUMB_MODULE, in game.cpp, parts/other.cpp; keep one"
    game.cpp "${module}" parts/other.cpp "int other = 1@\n${module}")
expect_error("there are 2 PLUMB_MODULE, in game.cpp, game.cpp; keep one" game.cpp "${module}\n${module}")
file(REMOVE_RECURSE ${WORK})
