#!/usr/bin/env bash
# Exports a project for another system than this one: builds the player, makes the game and its archive, and plays the
# first second of it. Only then the folder is written, and the archive beside it.
#
#   player/targets/export.sh linux|windows|web PROJECT FOLDER EDITOR PLAYER
#
# EDITOR: plumb-editor. PLAYER: the player of this computer, with the code of the project if it has any.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
target=$1 project=$2 folder=$3 editor=$4 player=$5
first_second=(--headless --frames 60 --hash)

say() { printf 'plumb: %s\n' "$*" >&2; }
fail() { printf 'plumb: %s\n' "$*" >&2; exit 1; }
megabytes() { awk "BEGIN { printf \"%.1f\", $1 / 1e6 }"; }
hash_in() { sed -n 's/^hash: *//p'; }

# The result must play as the project does here, where something is installed that plays it.
play_first_second() {
    local wanted found status=0
    wanted=$("$player" "$project" "${first_second[@]}" 2>"$work/errors" | hash_in) ||
        fail "the project ends with an error here: $(tail -1 "$work/errors")"
    found=$("$here/play.sh" "$target" "$work/game" "$program" "${first_second[@]}" 2>/dev/null | hash_in) || status=$?
    if [ "$status" = 3 ]; then
        say "$target: not played here, because $([ "$target" = web ] && echo node || echo wine) is not installed"
    elif [ -n "$wanted" ] && [ "$found" = "$wanted" ]; then
        printf 'Played the first second: hash %s, as the project here\n' "$found"
    else
        fail "$target: after 60 ticks the exported game has the hash '$found', the project '$wanted'; please report this"
    fi
}

# Writes the folder and the archive, both or, after an error, none: a copy of the archive only needs another name then.
place() {
    local made=$1 archive=$2
    [ ! -d "$archive" ] || fail "the folder $archive is in the place of the archive; rename it"
    part=$archive.part
    mkdir -p "${archive%/*}" && cp "$made" "$part" ||
        fail "the archive $archive was not written; check the free disk space and the write permission"
    "$editor" "$project" --export "$folder" --finished "$work/game" || exit
    mv "$part" "$archive"
}

. "$here/lock.sh"
work=$cache/export  # for what is not finished yet
rm -rf "$work"
mkdir -p "$work"
part=$work/none
trap 'rm -rf "$work" "$part"' EXIT
resources=()
if [ "$target" = windows ]; then
    resources=("$root/build/windows-resources")
    "$editor" "$project" --resources "${resources[0]}"
fi
made=$("$here/prepare.sh" "$target" "$project" "${resources[@]}") || exit
report=$("$editor" "$project" --export "$work/game" --player "${made%%$'\n'*}" --licences "${made##*$'\n'}") ||
    { printf '%s\n' "$report"; exit 1; }
program=$(sed -n 's/.*start it with "\(.*\)" in this folder/\1/p' <<<"$report")
name=$(sed -n 's/^Exported "\(.*\)": .*/\1/p' <<<"$report")
play_first_second
mapfile -t written < <(sed -n 's/^Wrote //p' <<<"$report")
made=$(python3 "$here/archive.py" "$target" "$work/game" "$name" "${written[@]}")
archive=$(dirname "$(realpath -ms "$folder")")/${made##*/}
place "$made" "$archive"
printf '%s\n' "${report//"$work/game"/"$folder"}"
printf 'Packed it as %s: %s MB\n' "$archive" "$(megabytes "$(stat -c %s "$archive")")"
