#!/usr/bin/env bash
# Builds what an export to another system needs: the libraries, once, and the player. Prints the path of the player, or of
# the folder of the page, and in a second line the folder with the licences of its libraries.
#
#   player/targets/prepare.sh linux|web|windows PROJECT [RESOURCES]
#
# The player contains the project's code in C++, if it has any, and for Windows the resources in the folder RESOURCES.
# The libraries are in $XDG_CACHE_HOME/plumb, for all copies of the sources; the player is in build/TARGET of this one.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
target=$1 project=$2 resources=${3-}
cache=${XDG_CACHE_HOME:-$HOME/.cache}/plumb
made=$cache/$target
libraries=$made/libraries build=$root/build/$target player=$root/build/$target-player
jobs=$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)

say() { printf 'plumb: %s\n' "$*" >&2; }
fail() { printf 'plumb: %s\n' "$*" >&2; exit 1; }

mkdir -p "$made"
[ "$target" != web ] || . "$here/web/emscripten.sh"

# The headers and libraries of an older Linux, with what the compiler of this computer wants beyond them.
make_sysroot() {
    local hash place file
    say "fetching the headers of an older Linux: 10 MB, once"
    rm -rf "$sysroot" && mkdir -p "$sysroot/include/bits" "$made/downloads"
    while read -r hash place; do
        [ "$hash" != "#" ] || continue
        file=$made/downloads/${place##*/}
        [ -f "$file" ] || { curl -fsS -o "$file.part" "http://archive.ubuntu.com/ubuntu/$place" && mv "$file.part" "$file"; } ||
            fail "cannot fetch http://archive.ubuntu.com/ubuntu/$place; check the network and run this again"
        printf '%s  %s\n' "$hash" "$file" | sha256sum -c --quiet >&2 || fail "$file: not the file that was expected; remove it"
        dpkg-deb -x "$file" "$sysroot"
    done <"$here/linux/packages.txt"
    # Links within it, instead of to this computer.
    find "$sysroot" -lname '/*' | while read -r file; do ln -sfn "$sysroot$(readlink "$file")" "$file"; done
    # Functions that its glibc does not have.
    file=$(echo '#include <bits/c++config.h>' | g++ -x c++ -E - | sed -n 's/^# 1 "\(.*c++config.h\)".*/\1/p' | head -1)
    sed -E 's/^#define (_GLIBCXX_USE_PTHREAD_(COND|MUTEX|RWLOCK)_CLOCK(WAIT|LOCK)|_GLIBCXX_HAVE_(ARC4RANDOM|GETENTROPY)) .*//' \
        "$file" >"$sysroot/include/bits/c++config.h"
    gcc -O2 -Wall -Wextra -Werror -c --sysroot="$sysroot" "$here/linux/new_glibc.c" -o "$sysroot/new_glibc.o"
}

launcher=()
command -v ccache >/dev/null && launcher=(-DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache)

# Says every tenth of a build's steps, of which it reads the lines "[STEP/STEPS] ...".
say_progress() {
    local line tenths=0 now
    while IFS= read -r line; do
        [[ "$line" =~ ^\[([0-9]+)/([0-9]+)\] ]] || continue
        now=$((BASH_REMATCH[1] * 10 / BASH_REMATCH[2]))
        # A build of few steps is soon over.
        [ "$now" -le "$tenths" ] || [ "${BASH_REMATCH[2]}" -lt 20 ] || say "$((now * 10)) %"
        tenths=$now
    done
}

# configure_and_build SOURCE BUILD TARGET OPTIONS...
configure_and_build() {
    local source=$1 build=$2 goal=$3
    shift 3
    cmake -S "$source" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
        -DCMAKE_TOOLCHAIN_FILE="$here/toolchains/$target.cmake" -DPLUMB_LIBRARIES="$libraries" \
        "$@" >"$build.log" 2>&1 || { tail -30 "$build.log" >&2; fail "configuring failed; all messages: $build.log"; }
    NINJA_STATUS='[%f/%t] ' ninja -C "$build" -j "$jobs" "$goal" 2>&1 | tee "$build.log" | say_progress ||
        { tail -30 "$build.log" >&2; fail "the build failed; all messages: $build.log"; }
}

# The program may need nothing but a glibc that is not newer than 2.27.
check_linux_player() {
    local needed newest
    needed=$(readelf -d "$1" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p' |
        grep -vxE 'lib(c|m|dl|pthread|rt)\.so\.[0-9]+|ld-linux-x86-64\.so\.2') || true
    [ -z "$needed" ] || fail "the player for linux needs libraries that a desktop may not have: $needed"
    newest=$(objdump -T "$1" | grep -oE 'GLIBC_[0-9.]+' | sed 's/GLIBC_//' | sort -uV | tail -1)
    [ "$(printf '%s\n' "$newest" 2.27 | sort -V | tail -1)" = 2.27 ] ||
        fail "the player for linux needs glibc $newest, and many desktops have 2.28; see player/targets/linux/new_glibc.c"
}

# The libraries are built anew when their list changes.
stamp=$libraries/made-from
recipes=("$here/libraries/CMakeLists.txt" "$here/libraries/plain/CMakeLists.txt" "$here/toolchains/$target.cmake"
    "$here/licences.sh")
if [ "$target" = linux ]; then
    recipes+=("$here/linux/packages.txt" "$here/linux/new_glibc.c")
    sysroot=$made/sysroot
fi
list=$(cat "${recipes[@]}" | sha256sum)
if [ "$(cat "$stamp" 2>/dev/null)" != "$list" ]; then
    say "building the libraries of the player for $target: about 3 minutes, once"
    rm -rf "$libraries" "$made/build-libraries" "$build"
    [ "$target" != linux ] || make_sysroot
    mkdir -p "$libraries/include" "$libraries/share/cmake"
    cp -r /usr/include/nlohmann /usr/include/stb "$libraries/include/"  # headers only
    cp -r /usr/share/cmake/nlohmann_json "$libraries/share/cmake/"
    (
        if [ "$target" = linux ]; then
            export PKG_CONFIG_SYSROOT_DIR=$sysroot
            export PKG_CONFIG_LIBDIR=$sysroot/usr/lib/x86_64-linux-gnu/pkgconfig:$sysroot/usr/share/pkgconfig
        fi
        configure_and_build "$here/libraries" "$made/build-libraries" all -DCMAKE_INSTALL_PREFIX="$libraries"
    )
    "$here/licences.sh" "$target" "$made/build-libraries" "$made/licences"
    printf '%s\n' "$list" >"$stamp"
    rm -rf "$made/build-libraries"
fi

[ -d "$build" ] || say "building the player for $target: about 5 minutes the first time"
mkdir -p "$build"
code=$(cmake -D PROJECT="$project" -D BUILD="$build" -P "$root/engine/cmake/code_target.cmake")
program=${code:-plumb}-player
configure_and_build "$root" "$build" "$program" -DPLUMB_TESTS=OFF -DPLUMB_EDITOR=OFF -DPLUMB_UNITY=ON -DPLUMB_EXPORTED=ON \
    -DPLUMB_GAME_RESOURCES="$resources" "${launcher[@]}"

rm -rf "$player"
mkdir "$player"
made_player=$build/exported/$program/player
if [ "$target" = web ]; then
    cp "$made_player.js" "$made_player.wasm" "$player/"
    cp "$here"/web/index.html "$here"/web/*.js "$player/"
    printf '%s\n' "$player" "$made/licences"
elif [ "$target" = windows ]; then
    x86_64-w64-mingw32-strip -o "$player/player.exe" "$made_player.exe"
    printf '%s\n' "$player/player.exe" "$made/licences"
else
    strip -o "$player/player" "$made_player"
    check_linux_player "$player/player"
    printf '%s\n' "$player/player" "$made/licences"
fi
