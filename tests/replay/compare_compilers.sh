#!/usr/bin/env bash
# Builds the player with every installed compiler and plays the projects' replays headless and rendered to memory; each
# replay must have one hash in all builds, and so must each golden scene of the physics library. The physics library,
# which needs no package, is also built for other processors and systems if their compilers are installed, and run in
# qemu and wine.
#   compare_compilers.sh [BUILD-FOLDER]    the folder keeps the builds for later runs
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${1:-$root/build/compilers}
replay=$root/tests/replay/platformer.replay

# project, its replay
replays='
platformer          platformer.replay
physics-playground  playground.replay
physics-playground  pinball.replay
physics-lab         lab.replay
'

# name, compiler, flags
table='
gcc-O0      g++      -O0
gcc-O3      g++      -DNDEBUG -O3
clang-O0    clang++  -O0
clang-O3    clang++  -DNDEBUG -O3
gcc-native  g++      -O3 -march=native
'

# name, CMake's names of the system and the processor, emulator that runs its programs here, compiler, flags
elsewhere='
arm-gcc     Linux    aarch64  qemu-aarch64-static  aarch64-linux-gnu-g++         -O3 -DNDEBUG
arm-clang   Linux    aarch64  qemu-aarch64-static  clang++                       --target=aarch64-linux-gnu -O3 -DNDEBUG
windows     Windows  x86_64   wine                 x86_64-w64-mingw32-g++-posix  -O3 -DNDEBUG
'
export WINEPREFIX=$build/wine WINEDEBUG=-all WINEDLLOVERRIDES='mscoree,mshtml='  # asks for no downloads

generator=()
if command -v ninja >/dev/null; then generator=(-G Ninja); fi

golden_of() { # REPLAY: the hash at its end
    awk '$1 == "check" { hash = $3 } END { print hash }' "$1"
}

build_targets() { # NAME TARGETS...
    cmake --build "$build/$1" --parallel "$(getconf _NPROCESSORS_ONLN)" --target "${@:2}"
}

build_player() { # NAME COMPILER FLAGS
    cmake -S "$root" -B "$build/$1" "${generator[@]}" -DCMAKE_CXX_COMPILER="$2" -DCMAKE_BUILD_TYPE=Release \
        -DCMAKE_CXX_FLAGS_RELEASE="$3" -DPLUMB_TESTS=ON -DPLUMB_EDITOR=OFF -DPLUMB_UNITY=ON &&
        build_targets "$1" plumb-player plumb-physics-hashes
}

# True if a program can be built for this target system and runs on this machine.
can_go() { # NAME RUNNER COMPILER FLAGS
    # shellcheck disable=SC2086
    echo '#include <vector>
        int main() { return std::vector<int>(1)[0]; }' | "$3" $4 -static -x c++ - -o "$build/$1.try" &&
        "$2" "$build/$1.try" </dev/null
}

build_physics() { # NAME SYSTEM PROCESSOR COMPILER FLAGS
    cmake -S "$root" -B "$build/$1" "${generator[@]}" -DCMAKE_SYSTEM_NAME="$2" -DCMAKE_SYSTEM_PROCESSOR="$3" \
        -DCMAKE_CXX_COMPILER="$4" -DCMAKE_CXX_FLAGS="$5" -DCMAKE_CXX_FLAGS_RELEASE= -DCMAKE_EXE_LINKER_FLAGS=-static \
        -DCMAKE_BUILD_TYPE=Release -DPLUMB_PHYSICS_ALONE=ON && build_targets "$1" plumb-physics-hashes
}

# The replay also contains the hash of every 300th tick: the player stops at the first difference.
play_replay() { # NAME
    "$build/$1/bin/plumb-player" "$root/projects/platformer" --headless --hash --replay "$replay" | sed -n 's/^hash: //p'
}

# Every project's replay, headless and rendered to memory with the physics view: the hashes must be equal.
play_projects() { # NAME
    local project file wanted hash failed=0
    while read -r project file; do
        [ -n "$project" ] || continue
        wanted=$(golden_of "$root/tests/replay/$file")
        for way in "--headless" "--window 160x90 --physics-view all"; do
            # shellcheck disable=SC2086
            hash=$(SDL_VIDEODRIVER=offscreen SDL_AUDIODRIVER=dummy LIBGL_ALWAYS_SOFTWARE=1 "$build/$1/bin/plumb-player" \
                "$root/projects/$project" $way --hash --replay "$root/tests/replay/$file" </dev/null | sed -n 's/^hash: //p')
            [ "$hash" = "$wanted" ] && continue
            echo "$1: $file with $way is $hash, not $wanted"
            failed=1
        done
    done <<<"$replays"
    return $failed
}

compare_physics() { # NAME RUNNER...
    local program hashes
    program=$(find "$build/$1/bin" -name 'plumb-physics-hashes*' 2>/dev/null || true)
    [ -n "$program" ] || return 0  # the build has reported the error
    # The hashes take seconds, but an emulated system may hang at start.
    hashes=$(timeout 600 "${@:2}" "$program" 2>"$build/$1.log" </dev/null | tr -d '\r') || { tail -n 10 "$build/$1.log"; hashes+=" (ended early)"; }
    diff <(echo "$hashes") "$root/tests/replay/physics.golden" && return 0
    echo "$1: scenes of the physics library differ"
    return 1
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
golden=$(golden_of "$replay")
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
        play_projects "$name" || failed=1
    else
        echo "$name: $hash differs from the replay's $golden ($compiler $flags)"
        failed=1
    fi
    compare_physics "$name" || failed=1
done <<<"$table"

while read -r name system processor runner compiler flags; do
    [ -n "$name" ] || continue
    if ! can_go "$name" "$runner" "$compiler" "$flags" >"$build/$name.log" 2>&1; then
        echo "$name: $compiler or $runner is not installed"
    elif ! build_physics "$name" "$system" "$processor" "$compiler" "$flags" >"$build/$name.log" 2>&1; then
        echo "$name: does not build"
        tail -n 40 "$build/$name.log"
        failed=1
    elif compare_physics "$name" "$runner"; then
        echo "$name: physics alike, with $(grep -o 'instructions: .*' "$build/$name.log") ($compiler $flags)"
    else
        failed=1
    fi
done <<<"$elsewhere"
exit $failed
