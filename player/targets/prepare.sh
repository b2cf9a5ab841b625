#!/usr/bin/env bash
# Builds what an export to another system needs: the libraries, once, and the player. Prints the path of the player, or of
# the folder of the page, and in a second line the folder with the licences of its libraries.
#
#   player/targets/prepare.sh web|windows PROJECT
#
# The player contains the project's code in C++, if it has any.
# The libraries are in $XDG_CACHE_HOME/plumb, for all copies of the sources; the player is in build/TARGET of this one.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
target=$1 project=$2
cache=${XDG_CACHE_HOME:-$HOME/.cache}/plumb
made=$cache/$target
libraries=$made/libraries build=$root/build/$target player=$root/build/$target-player
jobs=$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)

say() { printf 'plumb: %s\n' "$*" >&2; }
fail() { printf 'plumb: %s\n' "$*" >&2; exit 1; }

mkdir -p "$made"
if [ "$target" = web ]; then
    # Debian freezes the cache of emscripten; a copy of it may grow.
    export EM_CACHE=$cache/emscripten EM_FROZEN_CACHE=0
    export NODE_PATH=/usr/share/nodejs  # acorn; a node that is not Debian's does not look there
    [ -d "$EM_CACHE" ] || cp -r /usr/share/emscripten/cache "$EM_CACHE"
fi
launcher=()
command -v ccache >/dev/null && launcher=(-DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache)

# configure_and_build SOURCE BUILD TARGET OPTIONS...
configure_and_build() {
    local source=$1 build=$2 goal=$3
    shift 3
    cmake -S "$source" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
        -DCMAKE_TOOLCHAIN_FILE="$here/toolchains/$target.cmake" -DPLUMB_LIBRARIES="$libraries" \
        "$@" >"$build.log" 2>&1 || { tail -30 "$build.log" >&2; fail "configuring failed; all messages: $build.log"; }
    ninja -C "$build" -j "$jobs" "$goal" >"$build.log" 2>&1 ||
        { tail -30 "$build.log" >&2; fail "the build failed; all messages: $build.log"; }
}

# The licences in the sources of the libraries, and of the parts of packages that consist of headers alone.
gather_licences() {
    local sources=$1 name file
    mkdir -p "$made/licences"
    for name in sdl:LICENSE.txt sdl_image:LICENSE.txt sdl_mixer:LICENSE.txt zlib:README zstd:LICENSE lua:doc/readme.html epoxy:COPYING; do
        file=$sources/${name%%:*}-prefix/src/${name%%:*}/${name#*:}
        [ ! -f "$file" ] || cp "$file" "$made/licences/${name%%:*}.txt"
    done
    cp /usr/share/doc/nlohmann-json3-dev/copyright "$made/licences/nlohmann-json.txt"
    cp /usr/share/doc/libstb-dev/copyright "$made/licences/stb.txt"
}

# The libraries are built anew when their list changes.
stamp=$libraries/made-from
list=$(cat "$here/libraries/CMakeLists.txt" "$here/libraries/plain/CMakeLists.txt" "$here/toolchains/$target.cmake" | sha256sum)
if [ "$(cat "$stamp" 2>/dev/null)" != "$list" ]; then
    say "building the libraries of the player for $target: about 3 minutes, once"
    rm -rf "$libraries" "$made/build-libraries" "$build"
    mkdir -p "$libraries/include" "$libraries/share/cmake"
    cp -r /usr/include/nlohmann /usr/include/stb "$libraries/include/"  # headers only
    cp -r /usr/share/cmake/nlohmann_json "$libraries/share/cmake/"
    configure_and_build "$here/libraries" "$made/build-libraries" all -DCMAKE_INSTALL_PREFIX="$libraries"
    gather_licences "$made/build-libraries"
    printf '%s\n' "$list" >"$stamp"
    rm -rf "$made/build-libraries"
fi

[ -d "$build" ] || say "building the player for $target: about 5 minutes the first time"
mkdir -p "$build"
code=$(cmake -D PROJECT="$project" -D BUILD="$build" -P "$root/engine/cmake/code_target.cmake")
program=${code:-plumb}-player
configure_and_build "$root" "$build" "$program" -DPLUMB_TESTS=OFF -DPLUMB_EDITOR=OFF -DPLUMB_UNITY=ON "${launcher[@]}"

rm -rf "$player"
mkdir "$player"
if [ "$target" = web ]; then
    cp "$build/bin/$program.js" "$player/player.js"
    cp "$build/bin/$program.wasm" "$player/player.wasm"
    cp "$here"/web/index.html "$here"/web/page.js "$player/"
    printf '%s\n' "$player" "$made/licences"
else
    x86_64-w64-mingw32-strip -o "$player/player.exe" "$build/bin/$program.exe"
    printf '%s\n' "$player/player.exe" "$made/licences"
fi
