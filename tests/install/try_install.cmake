# Installs the engine into an empty folder, and builds and runs programs that use only the installed files:
#   cmake -D BUILD=… -D SOURCE=… -D WORK=… -D FLAGS=… -P try_install.cmake

function(run)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT result EQUAL 0)
        list(JOIN ARGN " " command)
        message(FATAL_ERROR "${command}\nended with ${result}:\n${output}")
    endif()
    set(output "${output}" PARENT_SCOPE)
endfunction()

function(expect text)
    if(NOT output MATCHES "${text}")
        message(FATAL_ERROR "expected '${text}' in:\n${output}")
    endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
run(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/build -G ${GENERATOR} -D CMAKE_BUILD_TYPE=Debug
    -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_PREFIX_PATH=${WORK}/prefix "-DCMAKE_CXX_FLAGS=${FLAGS}")
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/game)
expect("entities: 2")
run(${WORK}/build/falling)
expect("fell 4.0[0-9]* m in 0.9 s")
# The cube falls 4.9 m and keeps half of its 9.9 m/s. It is read up to 1/60 s after the bounce, so up to 0.17 m/s less.
expect("bounced with (4.8|4.9) m/s")
expect("the cube is red\nthe cube is blue")
expect("pushed the heavy one less")
expect("slid 2.[0-9] m on rough ground, 10.0 m on smooth")
file(REMOVE_RECURSE ${WORK})
