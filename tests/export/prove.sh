#!/usr/bin/env bash
# Exports the sample projects for each system and plays what comes out: the same hash as that of the project here after 600
# ticks. Pages are played by node, programs for Windows by wine. Then exports the first one once more, to another folder and
# as if it were another day: folder and archive have the same bytes. Then a game that crashes, see crashes.sh.
#   ./plumb test --export
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$root/build/exports
rm -rf "$work" && mkdir -p "$work"
fail() { echo "$*"; exit 1; }
options=(--headless --frames 600 --hash)
hash_in() { grep '^hash'; }
projects=(platformer physics-playground physics-lab arena)

export_to() {  # SYSTEM PROJECT FOLDER
    local to=(--to "$1")
    [ "$1" != this ] || to=()
    "$root/plumb" export "$2" "$3" "${to[@]}" >"$3.log" 2>&1 || fail "$(tail -20 "$3.log")"
}
size() { du -bc "$@" | tail -1 | awk '{ printf "%.2f", $1 / 1e6 }'; }

# The link of a recorded game, made here, must end in the same state there: the player fails if it does not.
declare -A recorded=([platformer]=platformer [physics-playground]=playground [physics-lab]=lab [arena]=arena)
check_link() {
    local link
    link=$("$root/plumb" play "$2" --headless --replay "$root/tests/replay/${recorded[$2]}.replay" --print-link 2>/dev/null |
        sed -n 's/^link: //p')
    [ -n "$link" ] || fail "no link of the recorded game of $2"
    "$root/player/targets/play.sh" "$1" "$3" "$4" --headless --hash --link "$link" >/dev/null 2>&1 || fail "$2 for $1 does not end in the state of its link"
}

systems=(this linux)
command -v node >/dev/null && systems+=(web)
command -v wine >/dev/null && systems+=(windows)
printf '%-22s %-8s %8s %9s %11s  %s\n' project system "MB" "pack MB" "archive MB" hash
for project in "${projects[@]}"; do
    wanted=$("$root/plumb" play "$project" "${options[@]}" 2>/dev/null | hash_in)
    for system in "${systems[@]}"; do
        out=$work/$project/$system
        mkdir -p "${out%/*}"
        export_to "$system" "$project" "$out"
        program=$(sed -n 's/.*start it with "\(.*\)" in this folder/\1/p' "$out.log")
        found=$("$root/player/targets/play.sh" "$system" "$out" "$program" "${options[@]}" 2>/dev/null | hash_in) ||
            fail "$project for $system printed no hash"
        [ "$found" = "$wanted" ] || fail "$project for $system: $found, the project: $wanted"
        check_link "$system" "$project" "$out" "$program"
        archive=$(sed -n 's/^Packed it as \(.*\): .*/\1/p' "$out.log")
        [ "$system" = this ] || [ -s "$archive" ] || fail "$project for $system has no archive"
        printf '%-22s %-8s %8s %9s %11s  %s\n' "$project" "$system" "$(size "$out")" "$(size "$out/game.pack")" \
            "$([ -z "$archive" ] || size "$archive")" "${found#hash: }"
    done
done

# The player is linked anew for the second export; faketime, if it is here, makes it another day.
later=()
command -v faketime >/dev/null && later=(faketime -f +3d)
for system in "${systems[@]:1}"; do
    rm -rf "$root/build/$system/exported"
    first=$work/${projects[0]}/$system again=$work/again/$system
    mkdir -p "$work/again"
    "${later[@]}" "$root/plumb" export "${projects[0]}" "$again" --to "$system" >"$again.log" 2>&1 || fail "$(tail -20 "$again.log")"
    diff -r "$first" "$again" || fail "a second export for $system has other files"
    archive=$(sed -n 's/^Packed it as \(.*\): .*/\1/p' "$first.log")
    cmp "$archive" "$work/again/$(basename "$archive")" || fail "a second archive for $system has other bytes"
    echo "$system: a second export has the same bytes${later:+, three days later}"
done

"$root/tests/export/crashes.sh"
