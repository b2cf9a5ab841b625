# One target per layer. A layer can include only its own headers and those of the layers it DEPENDS on:
# a forbidden #include fails to compile with "No such file or directory".
#
#   add_layer(physics DEPENDS core math)
#
# With PLUMB_UNITY, several files of a layer are compiled as one, so their headers are read once; layers marked
# SINGLE_FILES are excluded, because their files define the same names. FAST layers are compiled with -O3.
#
# Files in folders named after a platform (posix, windows, web, or desktop for the first two) are compiled for it alone.
#
# Implementation: every layer has its own include root in the build folder, which contains one link,
# <root>/physics -> <source>/engine/physics. Linking a layer adds only its include root.

function(add_layer name)
    cmake_parse_arguments(LAYER "FAST;SINGLE_FILES" "FOLDER;ROOT_AS" "DEPENDS;LIBRARIES" ${ARGN})
    if(NOT LAYER_FOLDER)
        set(LAYER_FOLDER ${name})
    endif()
    if(NOT LAYER_ROOT_AS)
        set(LAYER_ROOT_AS ${LAYER_FOLDER})
    endif()
    set(folder ${CMAKE_CURRENT_SOURCE_DIR}/${LAYER_FOLDER})
    file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${folder}/*.hpp)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${folder}/*.cpp)
    list(FILTER headers EXCLUDE REGEX "/(${PLUMB_OTHER_PLATFORMS})/")
    list(FILTER sources EXCLUDE REGEX "/(${PLUMB_OTHER_PLATFORMS})/")

    set(root ${CMAKE_BINARY_DIR}/layers/${name})
    get_filename_component(parent ${root}/${LAYER_ROOT_AS} DIRECTORY)
    file(MAKE_DIRECTORY ${parent})
    file(CREATE_LINK ${folder} ${root}/${LAYER_ROOT_AS} RESULT linked SYMBOLIC)
    if(NOT linked EQUAL 0)
        # Windows without developer mode: all layers share one include root; only the rules test checks dependencies.
        set(root ${CMAKE_CURRENT_SOURCE_DIR})
    endif()

    # Each header must compile alone: a generated source file for each header includes only that header.
    foreach(header IN LISTS headers)
        file(RELATIVE_PATH path ${folder} ${header})
        string(REPLACE "/" "_" stem ${path})
        set(check ${CMAKE_BINARY_DIR}/header_checks/${name}/${stem}.cpp)
        file(CONFIGURE OUTPUT ${check} CONTENT "#include \"${LAYER_ROOT_AS}/${path}\"\n" @ONLY)
        list(APPEND checks ${check})
    endforeach()

    if(sources)
        add_library(${name} STATIC ${sources} ${headers})
        set(kind PUBLIC)
        set_plumb_warnings(${name})
        if(PLUMB_UNITY AND NOT LAYER_SINGLE_FILES)
            set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
        endif()
        if(LAYER_FAST AND NOT MSVC)
            target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O3>)
        endif()
        # By default gcc does not inline exported functions in position-independent code, because another library
        # could replace them at run time.
        if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
            target_compile_options(${name} PRIVATE -fno-semantic-interposition)
        endif()
    else()
        add_library(${name} INTERFACE)
        set(kind INTERFACE)
    endif()
    add_library(plumb::${name} ALIAS ${name})
    target_include_directories(${name} ${kind} $<BUILD_INTERFACE:${root}> $<INSTALL_INTERFACE:include/plumb>)
    set_target_properties(${name} PROPERTIES OUTPUT_NAME plumb_${name})
    foreach(dependency IN LISTS LAYER_DEPENDS)
        if(NOT TARGET plumb::${dependency})
            message(FATAL_ERROR "layer ${name} depends on ${dependency}, which is not defined before it; reorder the layers")
        endif()
        target_link_libraries(${name} ${kind} ${dependency})
    endforeach()
    if(sources)
        target_link_libraries(${name} PRIVATE ${LAYER_LIBRARIES})
    endif()
    if(checks AND PLUMB_TESTS)
        add_library(${name}_headers OBJECT EXCLUDE_FROM_ALL ${checks})
        target_link_libraries(${name}_headers PRIVATE ${name} ${LAYER_LIBRARIES})
        set_property(GLOBAL APPEND PROPERTY PLUMB_HEADER_CHECKS ${name}_headers)
    endif()

    # The rules test reads this list: one entry per layer, "name folder include-name dep dep ...".
    list(JOIN LAYER_DEPENDS " " dependencies)
    set_property(GLOBAL APPEND PROPERTY PLUMB_LAYERS "${name} ${folder} ${LAYER_ROOT_AS} ${dependencies}")
endfunction()
