#!/usr/bin/env bash
# Gathers the licences of all that a player contains, a file for each library, and fails if one is missing.
#
#   player/targets/licences.sh linux|web|windows SOURCES FOLDER
#
# SOURCES: the build folder of player/targets/libraries. FOLDER is made anew.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
target=$1 sources=$2 folder=$3
debian=/usr/share/doc
source_of() { printf '%s/%s-prefix/src/%s/%s' "$sources" "$1" "$1" "$2"; }

texts=(
    "plumb:$root/LICENSE"
    "sdl:$(source_of sdl LICENSE.txt)"
    "sdl_image:$(source_of sdl_image LICENSE.txt)"
    "sdl_mixer:$(source_of sdl_mixer LICENSE.txt)"
    "zlib:$(source_of zlib README)"
    "zstd:$(source_of zstd LICENSE)"
    "lua:$(source_of lua doc/readme.html)"
    # They consist of headers alone.
    "nlohmann-json:$debian/nlohmann-json3-dev/copyright"
    "stb:$debian/libstb-dev/copyright"
)
# What the compiler of each system links with.
case $target in
    linux) texts+=("epoxy:$(source_of epoxy COPYING)" "libstdc++:$debian/gcc-$(gcc -dumpversion | cut -d. -f1)-base/copyright") ;;
    windows)
        texts+=("epoxy:$(source_of epoxy COPYING)" "libstdc++:$debian/gcc-mingw-w64-base/copyright"
            "mingw-w64 and winpthreads:$debian/mingw-w64-common/copyright")
        ;;
    web)
        texts+=("emscripten and libc++:$debian/emscripten/copyright"
            "musl:/usr/share/emscripten/system/lib/libc/musl/COPYRIGHT")
        ;;
esac

rm -rf "$folder"
mkdir -p "$folder"
for text in "${texts[@]}"; do
    cp "${text#*:}" "$folder/${text%%:*}.txt" 2>/dev/null ||
        { printf 'plumb: the licence of %s is missing: there is no file %s\n' "${text%%:*}" "${text#*:}" >&2; exit 1; }
done
