# Linux with an old glibc: the compiler of this computer, the headers and libraries of an older system in PLUMB_SYSROOT
# (player/targets/linux/packages.txt). PLUMB_LIBRARIES: where player/targets/libraries is installed.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER gcc)
set(CMAKE_CXX_COMPILER g++)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES PLUMB_LIBRARIES)
get_filename_component(PLUMB_SYSROOT ${PLUMB_LIBRARIES}/../sysroot ABSOLUTE)
set(CMAKE_SYSROOT ${PLUMB_SYSROOT})
set(CMAKE_FIND_ROOT_PATH ${PLUMB_LIBRARIES} ${PLUMB_SYSROOT})
set(CMAKE_PREFIX_PATH ${PLUMB_LIBRARIES})
set(CMAKE_LIBRARY_ARCHITECTURE x86_64-linux-gnu)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(CMAKE_NO_SYSTEM_FROM_IMPORTED ON)
# Paths of sources in the program would differ between computers.
set(relative "\"-fmacro-prefix-map=${CMAKE_SOURCE_DIR}/=\"")
# include: the configuration of libstdc++ for that glibc.
set(CMAKE_C_FLAGS_INIT "${relative}")
set(CMAKE_CXX_FLAGS_INIT "\"-I${PLUMB_SYSROOT}/include\" ${relative}")
# The compiler would find the libraries of this computer first.
set(places ${PLUMB_SYSROOT}/usr/lib/x86_64-linux-gnu ${PLUMB_SYSROOT}/lib/x86_64-linux-gnu)
list(JOIN places "\" \"-L" search)
list(GET places 0 start)
# Checks of SDL link with libraries whose own libraries are not here; the player loads all of them when it runs.
set(CMAKE_EXE_LINKER_FLAGS_INIT "\"-B${start}\" \"-L${search}\" -static-libstdc++ -static-libgcc -pthread \
\"${PLUMB_SYSROOT}/new_glibc.o\" -Wl,--allow-shlib-undefined")
