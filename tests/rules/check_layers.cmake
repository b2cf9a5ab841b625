cmake_minimum_required(VERSION 3.22)

# Reads the table that add_layer() wrote and fails on every #include that breaks the layer rule.
# The compiler already refuses forbidden layers; this test adds what it cannot see: paths with
# "..", third-party headers outside their one folder, and a message that says what to do.
#
#   cmake -D TABLE=build/layers.txt -P check_layers.cmake

file(STRINGS ${TABLE} lines)
foreach(line IN LISTS lines)
    separate_arguments(words UNIX_COMMAND "${line}")
    list(POP_FRONT words name folder root)
    list(APPEND known ${name})
    list(APPEND roots ${root})
    set(folder_of_${name} ${folder})
    set(root_of_${name} ${root})
    set(allowed_${name} ${root})
    foreach(dependency IN LISTS words)
        list(APPEND allowed_${name} ${allowed_${dependency}})  # above it, so already complete
    endforeach()
endforeach()

# Each third-party header lives in one folder, so that replacing a library is a change of one folder.
set(homes
    "SDL(_[a-z]+)?\\.h|engine/platform/"
    "nlohmann/|engine/reflect/"
    "epoxy/|engine/render/gl/"
    "imgui|editor/ui/"
)

set(broken 0)
macro(report text)
    message("${text}")
    math(EXPR broken "${broken} + 1")
endmacro()

foreach(name IN LISTS known)
    file(GLOB_RECURSE files ${folder_of_${name}}/*.hpp ${folder_of_${name}}/*.cpp)
    foreach(file IN LISTS files)
        file(STRINGS ${file} includes REGEX "^[ \t]*#[ \t]*include")
        foreach(include IN LISTS includes)
            string(REGEX REPLACE ".*[\"<]([^\">]+)[\">].*" "\\1" path "${include}")
            if(include MATCHES "<")
                foreach(home IN LISTS homes)
                    string(REPLACE "|" ";" home "${home}")
                    list(GET home 0 header)
                    list(GET home 1 place)
                    if(path MATCHES "^(backends/)?${header}" AND NOT file MATCHES "${place}")
                        report("${file}: <${path}> may only be included in ${place}; use that folder's own header")
                    endif()
                endforeach()
                continue()
            endif()
            if(path MATCHES "\\.\\.")
                report("${file}: \"${path}\" climbs out of its layer; write the path from the layer's name on")
                continue()
            endif()
            set(owner "")
            foreach(root IN LISTS roots)
                if("${path}" MATCHES "^${root}/")
                    set(owner ${root})
                endif()
            endforeach()
            if(NOT owner)
                report("${file}: \"${path}\" hides its layer; write \"${root_of_${name}}/...\"")
            elseif(NOT owner IN_LIST allowed_${name})
                report("${file}: ${name} may not include ${owner} (allowed: ${allowed_${name}}); move the code down, or pass the data in")
            endif()
        endforeach()
    endforeach()
endforeach()
if(broken)
    message(FATAL_ERROR "${broken} include(s) break the layer rule")
endif()
