cmake_minimum_required(VERSION 3.22)

# The simulation gives the same bits everywhere, so it may not use what differs between machines,
# compilers or runs. Each line: a pattern, and what to use instead.
#
#   cmake -D ROOT=. -P check_determinism.cmake

set(simulation ecs physics scene gameplay script)
set(denied
    "std::(sin|cos|tan|asin|acos|atan|atan2|exp|exp2|log|log2|log10|pow|cbrt|hypot)f?\\(|math/portable.hpp has the same bits on every machine"
    "std::unordered_|a sorted vector or the store's own index: the order of an unordered container is an accident"
    "std::(rand|srand|random_device|mt19937|uniform_|normal_|shuffle)|core/random.hpp has the same numbers everywhere"
    "std::chrono|ticks: the simulation knows no clock"
    "wallSeconds|ticks: the simulation knows no clock"
    "std::hash<|core/hash.hpp"
    "std::fma[fl]?\\(|a * b + c: fused results differ between CPUs"
    "long double|double or float: long double differs between compilers"
    "reinterpret_cast<(std::)?uintptr_t>|an id: addresses differ between runs"
)
# Allowed where nothing of the simulation depends on it; each with its reason.
set(allowed
    "engine/scene/files/scene_reader.hpp"  # its table is only looked up, never walked
    "engine/scene/files/scene_reader.cpp"
    "engine/script/values/name_table.hpp"  # the same: rows are found by the address of a text, in no order
)

set(broken 0)
set(count 0)
foreach(layer IN LISTS simulation)
    file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/engine/${layer}/*.?pp)
    foreach(file IN LISTS files)
        math(EXPR count "${count} + 1")
        if(file IN_LIST allowed)
            continue()
        endif()
        foreach(line IN LISTS denied)
            string(FIND "${line}" "|" cut REVERSE)
            string(SUBSTRING "${line}" 0 ${cut} pattern)
            math(EXPR cut "${cut} + 1")
            string(SUBSTRING "${line}" ${cut} -1 instead)
            file(STRINGS ${ROOT}/${file} found REGEX "${pattern}")
            foreach(hit IN LISTS found)
                string(STRIP "${hit}" hit)
                if(NOT hit MATCHES "^//")
                    message("${file}: ${hit}\n  differs between machines or runs; use ${instead}")
                    math(EXPR broken "${broken} + 1")
                endif()
            endforeach()
        endforeach()
    endforeach()
endforeach()
if(count EQUAL 0)
    message(FATAL_ERROR "no source of the simulation was found below ${ROOT}; this rule would check nothing")
endif()
if(broken)
    message(FATAL_ERROR "${broken} line(s) endanger determinism")
endif()
