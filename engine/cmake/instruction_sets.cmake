# Inner loops that are built once for each instruction set and chosen at run time (core/cpu.hpp).
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
