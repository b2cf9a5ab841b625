cmake_minimum_required(VERSION 3.22)

# Runs the sample game briefly and expects the log lines that the seed shows, in their order.
#
#   cmake -D PROGRAM=seed_sample -P check_log.cmake

set(ENV{PLUMB_OPTIONS} "--frames 150 --replay sample.replay")
execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE output RESULT_VARIABLE code TIMEOUT 60)
if(NOT code EQUAL 0)
    message(FATAL_ERROR "the sample ended with ${code}:\n${output}")
endif()
set(rest "${output}")
foreach(line
    "[Engine] Initializing SDL2..."
    "[Engine] Created window: 800x600"
    "[Engine] OpenGL 3.3 Core Profile"
    "[Assets] Loaded: player.png (32x32, 4 frames)"
    "[Assets] Loaded: platform.png (100x20)"
    "[Engine] Starting game loop..."
    "[Collision] Player <-> Platform[1]"
    "[Input] Jump pressed"
    "[Physics] Player grounded: false"
    "[Physics] Player grounded: true")
    string(FIND "${rest}" "${line}" at)
    if(at EQUAL -1)
        message(FATAL_ERROR "\"${line}\" is not in the output, or not in its place:\n${output}")
    endif()
    string(SUBSTRING "${rest}" ${at} -1 rest)
endforeach()
