# Inner loops that are compiled for several instruction sets, one of which is selected at run time (core/cpu.hpp).
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    if(MSVC)
        set(plumb_avx2 /arch:AVX2)
    else()
        set(plumb_avx2 -mavx2)
    endif()
    set_source_files_properties(physics/kernels_avx2.cpp TARGET_DIRECTORY physics
        PROPERTIES COMPILE_OPTIONS ${plumb_avx2})
else()
    set_source_files_properties(physics/kernels_avx2.cpp TARGET_DIRECTORY physics
        PROPERTIES HEADER_FILE_ONLY ON)
endif()

# On processors with SIMD the scalar kernels serve only as a reference, for programs that link physics_scalar.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64|aarch64|arm64|ARM64" OR EMSCRIPTEN)
    get_target_property(sources physics SOURCES)
    list(FILTER sources EXCLUDE REGEX kernels_scalar)
    set_target_properties(physics PROPERTIES SOURCES "${sources}")
    add_library(physics_scalar STATIC EXCLUDE_FROM_ALL physics/kernels_scalar.cpp)
    target_link_libraries(physics_scalar PUBLIC physics)
    set_plumb_warnings(physics_scalar)
else()
    add_library(physics_scalar INTERFACE)
    target_link_libraries(physics_scalar INTERFACE physics)
endif()
