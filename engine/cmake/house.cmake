# Settings of all targets: language standard, warnings, and flags for bit-identical floating-point results.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT EMSCRIPTEN)
    set(CMAKE_POSITION_INDEPENDENT_CODE ON)
endif()
if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release)
endif()

# Folders whose files this build leaves out, as a regular expression; see layers.cmake.
if(EMSCRIPTEN)
    set(PLUMB_OTHER_PLATFORMS "posix|windows|desktop")
elseif(WIN32)
    set(PLUMB_OTHER_PLATFORMS "posix|web")
else()
    set(PLUMB_OTHER_PLATFORMS "windows|web")
endif()
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)

# Only layers marked FAST, which loop over thousands of items, use -O3. With -O2 the others are smaller and compile
# faster.
if(CMAKE_CXX_FLAGS_RELEASE STREQUAL "-O3 -DNDEBUG")  # CMake's default
    set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
endif()
# Removes unreachable functions of the library from programs.
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang" AND CMAKE_SYSTEM_NAME STREQUAL "Linux")
    add_compile_options(-ffunction-sections -fdata-sections)
    add_link_options(-Wl,--gc-sections)
endif()

set(PLUMB_SANITIZE "" CACHE STRING "sanitizers to build with, e.g. address,undefined or thread")
if(PLUMB_SANITIZE)
    add_compile_options(-fsanitize=${PLUMB_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    add_link_options(-fsanitize=${PLUMB_SANITIZE})
    # With them g++ 12 reports members of std::regex that are initialized.
    add_compile_options($<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    # Sanitizer builds also enable the assertions of the engine and of the standard library.
    add_compile_definitions(PLUMB_ASSERTS _GLIBCXX_ASSERTIONS)
endif()
add_compile_definitions($<$<CONFIG:RelWithDebInfo>:PLUMB_ASSERTS>)

option(PLUMB_DEBUG_CODE "compile the code of projects for a debugger: ./plumb play PROJECT --debug" OFF)

option(PLUMB_FUZZ "build the fuzzers of tests/fuzz; requires clang" OFF)
if(PLUMB_FUZZ)
    add_compile_options(-fsanitize=fuzzer-no-link)
endif()

option(PLUMB_TUNABLE "let tests change the constants of physics/tuning.hpp: ./plumb accuracy --tuning" OFF)
if(PLUMB_TUNABLE)
    add_compile_options(-include ${PROJECT_SOURCE_DIR}/tests/support/tunable.hpp)
    add_compile_definitions(PLUMB_TUNABLE)
endif()

# Contraction to fused multiply-add would make results differ between CPUs, so it is disabled everywhere.
if(MSVC)
    add_compile_options(/fp:precise /utf-8 /permissive-)
else()
    add_compile_options(-ffp-contract=off -fno-fast-math)
endif()
# For WebAssembly, the SLP vectorizer of clang 14 makes another sum of a loop over two bodies (scene doublependulum of
# tests/export/accuracy_page.mjs). Behind -O2, which turns it on, so not in toolchains/web.cmake.
if(EMSCRIPTEN)
    add_compile_options(-fno-slp-vectorize)
endif()
# Despite -ffp-contract=off, gcc (at least 12) generates vfmaddsub if the flags allow FMA (-march=native). So FMA is
# disabled: in this build if the flags enable it, for users of the library always (PLUMB_NEVER_FUSED).
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64|i.86")
    set(PLUMB_NEVER_FUSED -mno-fma -mno-fma4 -mno-avx512f)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND PLUMB_NEVER_FUSED)
    include(CheckCXXSourceCompiles)
    set(CMAKE_TRY_COMPILE_CONFIGURATION ${CMAKE_BUILD_TYPE})
    check_cxx_source_compiles("
        #if !defined __FMA__ && !defined __FMA4__ && !defined __AVX512F__
        #error no fused operations
        #endif
        int main() {}" PLUMB_MACHINE_FUSES)
    unset(CMAKE_TRY_COMPILE_CONFIGURATION)
    if(PLUMB_MACHINE_FUSES)
        add_compile_options(${PLUMB_NEVER_FUSED})
    endif()
endif()

function(set_plumb_warnings target)
    if(MSVC)
        target_compile_options(${target} PRIVATE /W4)
    elseif(EMSCRIPTEN)
        # Sizes have 32 bits there, and headers of packages count as our own: player/targets/toolchains/web.cmake.
        target_compile_options(${target} PRIVATE -Wall -Wextra -Wno-missing-field-initializers -Wno-missing-braces -Werror)
    else()
        target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wold-style-cast
            -Wno-missing-field-initializers -Wno-missing-braces -Werror)
    endif()
endfunction()
