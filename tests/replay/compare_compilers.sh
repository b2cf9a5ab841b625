#!/usr/bin/env bash
# Plays the platformer's replay with the player as every installed compiler builds it, and wants one hash; and the
# golden scenes of the physics library, one hash each.
#   compare_compilers.sh [BUILD-FOLDER]    the folder keeps the builds for the next time
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${1:-$root/build/compilers}
replay=$root/tests/replay/platformer.replay

# name, compiler, flags
table='
gcc-O0      g++      -O0
gcc-O3      g++      -O3 -DNDEBUG
clang-O0    clang++  -O0
clang-O3    clang++  -O3 -DNDEBUG
gcc-native  g++      -O3 -march=native
'

build_player() { # NAME COMPILER FLAGS
    local generator=()
    if command -v ninja >/dev/null; then generator=(-G Ninja); fi
    cmake -S "$root" -B "$build/$1" "${generator[@]}" -DCMAKE_CXX_COMPILER="$2" -DCMAKE_BUILD_TYPE=Release \
        -DCMAKE_CXX_FLAGS_RELEASE="$3" -DPLUMB_TESTS=ON -DPLUMB_EDITOR=OFF &&
        cmake --build "$build/$1" --parallel "$(getconf _NPROCESSORS_ONLN)" --target plumb-player plumb-physics-hashes
}

# The replay also holds the hash of every 300th tick: the player stops at the first that differs.
play_replay() { # NAME
    "$build/$1/bin/plumb-player" "$root/projects/platformer" --headless --hash --replay "$replay" | sed -n 's/^hash: //p'
}

# Where the build has no program, it has said so.
compare_physics() { # NAME
    [ -x "$build/$1/bin/plumb-physics-hashes" ] || return 0
    "$build/$1/bin/plumb-physics-hashes" | diff - "$root/tests/replay/physics.golden" >&2 ||
        { echo "$1: scenes of the physics library differ"; return 1; }
}

play_gallery() { # NAME: ten seconds of every scene of the playground
    local scene wanted hash failed=0
    while read -r scene wanted; do
        hash=$("$build/$1/bin/plumb-player" "$root/projects/physics-playground" --scene "$scene" --headless --frames 600 \
            --hash </dev/null | sed -n 's/^hash: //p')
        [ "$hash" = "$wanted" ] && continue
        echo "$1: $scene of the playground is $hash, not $wanted"
        failed=1
    done <"$root/tests/replay/playground.hashes"
    return $failed
}

if command -v ccache >/dev/null; then export CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER:-ccache}; fi
golden=$(awk '$1 == "check" { hash = $3 } END { print hash }' "$replay")
mkdir -p "$build"
failed=0
while read -r name compiler flags; do
    [ -n "$name" ] || continue
    if ! command -v "$compiler" >/dev/null; then
        echo "$name: $compiler is not installed"
    elif ! build_player "$name" "$compiler" "$flags" >"$build/$name.log" 2>&1; then
        echo "$name: does not build"
        tail -n 40 "$build/$name.log"
        failed=1
    elif hash=$(play_replay "$name") && [ "$hash" = "$golden" ]; then
        echo "$name: $hash ($compiler $flags)"
        play_gallery "$name" || failed=1
    else
        echo "$name: $hash differs from the replay's $golden ($compiler $flags)"
        failed=1
    fi
    compare_physics "$name" || failed=1
done <<<"$table"
exit $failed
