#!/usr/bin/env bash
# Exports the sample projects for each system and plays what comes out: the same hash as that of the project here after 600
# ticks. Pages are played by node, programs for Windows by wine.
# Then a game that crashes, see crashes.sh.
#   ./plumb test --export
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$root/build/exports
export WINEPREFIX=$work/wine WINEDEBUG=-all WINEDLLOVERRIDES='mscoree,mshtml='
rm -rf "$work" && mkdir -p "$work"
fail() { echo "$*"; exit 1; }
options=(--headless --frames 600 --hash)
played() { "$@" "${options[@]}" 2>/dev/null | tr -d '\r' | grep '^hash'; }

play_this() { played "$1"/"$2"; }
play_web() { played node "$root/tests/export/play_in_node.js" "$1"; }
play_windows() { (cd "$1" && played wine "$2"); }

systems=(this)
command -v node >/dev/null && systems+=(web)
command -v wine >/dev/null && systems+=(windows)
printf '%-22s %-8s %8s %9s  %s\n' project system "MB" "pack MB" hash
for project in platformer physics-playground physics-lab arena; do
    wanted=$("$root/plumb" play "$project" "${options[@]}" 2>/dev/null | grep '^hash')
    for system in "${systems[@]}"; do
        out=$work/$project-$system
        to=(--to "$system")
        [ "$system" != this ] || to=()
        "$root/plumb" export "$project" "$out" "${to[@]}" >"$out.log" 2>&1 || fail "$(tail -20 "$out.log")"
        program=$(sed -n 's/.*start it with "\(.*\)" in this folder/\1/p' "$out.log")
        found=$(play_$system "$out" "$program") || fail "$project for $system printed no hash"
        [ "$found" = "$wanted" ] || fail "$project for $system: $found, the project: $wanted"
        size() { du -bc "$@" | tail -1 | awk '{ printf "%.2f", $1 / 1e6 }'; }
        printf '%-22s %-8s %8s %9s  %s\n' "$project" "$system" "$(size "$out")" "$(size "$out/game.pack")" "${found#hash: }"
    done
done
"$root/tests/export/crashes.sh"
