cmake_minimum_required(VERSION 3.22)

# Plays the replay of a project with code by the project's own player: each recorded hash must be met, and the output must
# contain a text. With another seed the same replay must fail, or it would check nothing.
#
#   cmake -D PLAYER=arena-player -D PROJECT=FOLDER -D REPLAY=FILE -D EXPECTED=REGEX -D WORK=FOLDER -P project_replay.cmake

function(play replay result output)
    execute_process(COMMAND ${PLAYER} ${PROJECT} --headless --replay ${replay}
        RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
    set(${result} ${code} PARENT_SCOPE)
    set(${output} "${out}${err}" PARENT_SCOPE)
endfunction()

play(${REPLAY} code output)
if(NOT code EQUAL 0 OR output MATCHES "warning:|error:")
    message(FATAL_ERROR "the replay fails (${code}); record_arena.py records it again:\n${output}")
endif()
if(NOT output MATCHES "${EXPECTED}")
    message(FATAL_ERROR "the output contains no \"${EXPECTED}\":\n${output}")
endif()
message("${CMAKE_MATCH_0}")

file(READ ${REPLAY} text)
string(REGEX REPLACE "seed [0-9a-f]+" "seed 00000000000000ff" text "${text}")
file(WRITE ${WORK}/other_seed.replay "${text}")
play(${WORK}/other_seed.replay code output)
if(NOT code EQUAL 1 OR NOT output MATCHES "differs from the recorded one")
    message(FATAL_ERROR "with another seed the replay must differ; it returned ${code}:\n${output}")
endif()
