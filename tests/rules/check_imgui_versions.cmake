cmake_minimum_required(VERSION 3.22)

# What differs between versions of ImGui stands in the files for it, so that the rest of the editor is written once.
#
#   cmake -D ROOT=. -P check_imgui_versions.cmake

set(allowed editor/ui/ui_compat.hpp editor/ui/ui_compat.cpp editor/ui/platform_feed.cpp editor/ui/imgui_renderer.cpp)
file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/editor/*.?pp ${ROOT}/tests/editor/*.?pp)
set(asking 0)
set(broken 0)
foreach(file IN LISTS files)
    file(STRINGS ${ROOT}/${file} found REGEX "IMGUI_VERSION")
    if(NOT found)
        continue()
    endif()
    math(EXPR asking "${asking} + 1")
    if(NOT file IN_LIST allowed)
        message("${file} asks for the version of ImGui; put what differs into editor/ui/ui_compat.hpp")
        math(EXPR broken "${broken} + 1")
    endif()
endforeach()
if(asking EQUAL 0)
    message(FATAL_ERROR "no file asks for the version of ImGui; this rule would check nothing")
endif()
if(broken)
    message(FATAL_ERROR "${broken} file(s) ask for the version of ImGui")
endif()
