#!/usr/bin/env bash
# Exports a project for another system than this one: builds the player, writes the folder and the archive beside it, and
# plays the first second of the result.
#
#   player/targets/export.sh linux|windows|web PROJECT FOLDER EDITOR PLAYER
#
# EDITOR: plumb-editor. PLAYER: the player of this computer, with the code of the project if it has any.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
target=$1 project=$2 folder=$3 editor=$4 player=$5
first_second=(--headless --frames 60 --hash)

say() { printf 'plumb: %s\n' "$*" >&2; }
fail() { printf 'plumb: %s\n' "$*" >&2; exit 1; }
megabytes() { awk "BEGIN { printf \"%.1f\", $1 / 1e6 }"; }
hash_in() { sed -n 's/^hash: *//p'; }

# The result must play as the project does here, where something is installed that plays it.
play_first_second() {
    local wanted found status=0
    wanted=$("$player" "$project" "${first_second[@]}" 2>/dev/null | hash_in)
    found=$("$here/play.sh" "$target" "$folder" "$program" "${first_second[@]}" 2>/dev/null | hash_in) || status=$?
    if [ "$status" = 3 ]; then
        say "$target: not played here, because $([ "$target" = web ] && echo node || echo wine) is not installed"
    elif [ -n "$wanted" ] && [ "$found" = "$wanted" ]; then
        printf 'Played the first second: hash %s, as the project here\n' "$found"
    else
        fail "$target: after 60 ticks the exported game has the hash '$found', the project '$wanted'; please report this"
    fi
}

resources=()
if [ "$target" = windows ]; then
    resources=("$here/../../build/windows-resources")
    "$editor" "$project" --resources "${resources[0]}"
fi
made=$("$here/prepare.sh" "$target" "$project" "${resources[@]}") || exit
report=$("$editor" "$project" --export "$folder" --player "${made%%$'\n'*}" --licences "${made##*$'\n'}") ||
    { printf '%s\n' "$report"; exit 1; }
printf '%s\n' "$report"
program=$(sed -n 's/.*start it with "\(.*\)" in this folder/\1/p' <<<"$report")
name=$(sed -n 's/^Exported "\(.*\)": .*/\1/p' <<<"$report")
play_first_second
# The folder may have other files, which are not for players.
mapfile -t written < <(sed -n 's/^Wrote //p' <<<"$report")
archive=$(python3 "$here/archive.py" "$target" "$folder" "$name" "${written[@]}")
printf 'Packed it as %s: %s MB\n' "$archive" "$(megabytes "$(stat -c %s "$archive")")"
