cmake_minimum_required(VERSION 3.22)

# The name of the targets that contain the code of a project: NAME-code and NAME-player of project_code.cmake. It is
# that of the folder for projects in `projects` if targets can have it, outside-1, outside-2 ... for others.
# projects/CMakeLists.txt includes this file; the script plumb and the editor run it:
#
#   cmake -D PROJECT=FOLDER -D BUILD=FOLDER -P code_target.cmake     prints NAME; nothing for a project without code

set(target_name "^[A-Za-z0-9_.+-]+$")  # CMake's policy CMP0037

# Sets `out` to a path of the folder that CMake, Ninja and the shell pass on unchanged: its own, or that of a link in
# BUILD/links for one with quotes, brackets, semicolons or other characters that one of them interprets.
function(path_for_build folder build out)
    if(NOT folder MATCHES "[][(){}<>|&;*?!\"'`$#]")
        set(${out} "${folder}" PARENT_SCOPE)
        return()
    endif()
    get_filename_component(name "${folder}" NAME)
    string(REGEX REPLACE "[^A-Za-z0-9_.+-]+" "_" name "${name}")
    string(MD5 hash "${folder}")  # two folders may have the same name
    string(SUBSTRING ${hash} 0 8 hash)
    set(link "${build}/links/${name}-${hash}")
    if(NOT EXISTS "${link}")
        file(MAKE_DIRECTORY "${build}/links")
        file(CREATE_LINK "${folder}" "${link}" RESULT failed SYMBOLIC)
        if(NOT failed EQUAL 0)
            message(FATAL_ERROR "${folder}: its code cannot be built, because the path contains one of "
                "[](){}<>|&;*?!\"'`$# and a link to it cannot be created (${failed}); rename the folder")
        endif()
    endif()
    set(${out} "${link}" PARENT_SCOPE)
endfunction()

# Sets `out` to the name. @param list  file with the folders of other projects, one a line; a new one is added to it
function(code_target folder list out)
    set(known "")
    if(EXISTS "${list}")
        file(STRINGS "${list}" known ENCODING UTF-8)  # without it a letter outside of ASCII ends a line
    endif()
    list(FIND known "${folder}" index)
    get_filename_component(parent "${folder}" DIRECTORY)
    get_filename_component(name "${folder}" NAME)
    get_filename_component(projects ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../../projects REALPATH)
    if(index EQUAL -1 AND parent STREQUAL projects AND name MATCHES "${target_name}")
        set(${out} ${name} PARENT_SCOPE)
        return()
    endif()
    if(index EQUAL -1)
        list(LENGTH known index)
        file(APPEND "${list}" "${folder}\n")
    endif()
    math(EXPR number "${index} + 1")
    set(${out} outside-${number} PARENT_SCOPE)
endfunction()

if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
    if(PROJECT MATCHES "[\\\n]")  # file names of CMake cannot contain them
        message(FATAL_ERROR "${PROJECT}: its code cannot be built, because the path contains a backslash or a line "
            "break; rename the folder")
    endif()
    get_filename_component(folder "${PROJECT}" REALPATH)
    path_for_build("${folder}" "${BUILD}" folder)
    file(GLOB_RECURSE sources "${folder}/code/*.cpp")
    if(sources)
        code_target("${folder}" "${BUILD}/projects.txt" name)
        execute_process(COMMAND ${CMAKE_COMMAND} -E echo ${name})
    endif()
endif()
