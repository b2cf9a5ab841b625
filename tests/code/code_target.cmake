cmake_minimum_required(VERSION 3.22)

# The targets of a project's code are named by its folder in projects, elsewhere by its line in the list of the build.
#   cmake -D TESTED=…/engine/cmake -D WORK=FOLDER -P code_target.cmake

file(REMOVE_RECURSE ${WORK})
set(engine ${WORK}/engine)  # a copy, because a project is made beside it
file(COPY ${TESTED}/code_target.cmake DESTINATION ${engine}/engine/cmake)
file(WRITE ${engine}/projects/mine/code/game.cpp "")
file(WRITE ${engine}/projects/plain/project.json "{}")
file(WRITE "${engine}/projects/My Game/code/game.cpp" "")
foreach(name IN ITEMS one "the other" größe)
    file(WRITE "${WORK}/${name}/code/parts/game.cpp" "")
endforeach()
file(CREATE_LINK ${engine} ${WORK}/link SYMBOLIC)

function(expect name project)
    execute_process(COMMAND ${CMAKE_COMMAND} -D "PROJECT=${project}" -D BUILD=${WORK}
        -P ${WORK}/link/engine/cmake/code_target.cmake RESULT_VARIABLE result OUTPUT_VARIABLE output)
    if(NOT result EQUAL 0 OR NOT "${output}" STREQUAL "${name}")
        message(FATAL_ERROR "${project} has the target '${output}' instead of '${name}'")
    endif()
endfunction()

expect("mine\n" ${engine}/projects/mine)
expect("mine\n" ${WORK}/link/projects/../projects/mine)
expect("" ${engine}/projects/plain)
expect("outside-1\n" ${WORK}/one)
expect("outside-2\n" "${WORK}/the other")
expect("outside-1\n" ${WORK}/one)
expect("outside-3\n" ${WORK}/größe)
expect("outside-4\n" "${engine}/projects/My Game")  # no target can have the name
expect("outside-3\n" ${WORK}/größe)
include(${engine}/engine/cmake/code_target.cmake)
code_target("${WORK}/the other" ${WORK}/projects.txt name)
if(NOT name STREQUAL "outside-2")
    message(FATAL_ERROR "the build names it ${name}")
endif()
file(REMOVE_RECURSE ${WORK})
