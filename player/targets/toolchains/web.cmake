# WebAssembly by Debian's emscripten. PLUMB_LIBRARIES: where player/targets/libraries is installed.
include(/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES PLUMB_LIBRARIES)
set(CMAKE_FIND_ROOT_PATH ${PLUMB_LIBRARIES})
set(CMAKE_PREFIX_PATH ${PLUMB_LIBRARIES})
# Its include paths come first, so those of packages must not be system paths, which would be searched later.
set(CMAKE_NO_SYSTEM_FROM_IMPORTED ON)
# Paths of sources in the program would differ between computers.
set(flags "-msimd128 -msse2 \"-fmacro-prefix-map=${CMAKE_SOURCE_DIR}/=\"")
set(CMAKE_C_FLAGS_INIT "${flags}")
set(CMAKE_CXX_FLAGS_INIT "${flags} -include \"${CMAKE_CURRENT_LIST_DIR}/../../../engine/core/web/missing_std.hpp\"")
set(LUA_MATH_LIBRARY m)  # FindLua asks for it, and cannot find what is a part of the C library
