cmake_minimum_required(VERSION 3.22)

# The name of the targets that contain the code of a project: NAME-code and NAME-player of project_code.cmake. It is
# that of the folder for projects in `projects`, outside-1, outside-2 ... for others. projects/CMakeLists.txt includes
# this file; the script plumb and the editor run it:
#
#   cmake -D PROJECT=FOLDER -D BUILD=FOLDER -P code_target.cmake     prints NAME; nothing for a project without code

# Sets `out` to the name. @param list  file with the folders of other projects, one a line; a new one is added to it
function(code_target folder list out)
    set(known "")
    if(EXISTS ${list})
        file(STRINGS ${list} known)
    endif()
    list(FIND known "${folder}" index)
    get_filename_component(parent "${folder}" DIRECTORY)
    get_filename_component(projects ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../../projects REALPATH)
    if(index EQUAL -1 AND parent STREQUAL projects)
        get_filename_component(name "${folder}" NAME)
        set(${out} ${name} PARENT_SCOPE)
        return()
    endif()
    if(index EQUAL -1)
        list(LENGTH known index)
        file(APPEND ${list} "${folder}\n")
    endif()
    math(EXPR number "${index} + 1")
    set(${out} outside-${number} PARENT_SCOPE)
endfunction()

if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
    file(GLOB_RECURSE sources "${PROJECT}/code/*.cpp")
    if(sources)
        get_filename_component(folder "${PROJECT}" REALPATH)
        code_target("${folder}" "${BUILD}/projects.txt" name)
        execute_process(COMMAND ${CMAKE_COMMAND} -E echo ${name})
    endif()
endif()
