#!/usr/bin/env bash
# Exports for other systems, with the player of this computer in the place of theirs: folder and archive are written
# together, after the game was played, or neither is; and one export waits for the other.
#   placing.sh SOURCE-FOLDER EDITOR PLAYER WORK-FOLDER
set -euo pipefail
source=$1 editor=$2 player=$3 work=$4
fail() { echo "$*"; exit 1; }
rm -rf "$work"
targets="$work/a checkout/player/targets"
mkdir -p "$targets"
export XDG_CACHE_HOME="$work/cache of a user" PREPARED="$work/prepared" LOG="$work/log" PLAYER="$player"
cp "$source"/player/targets/{export.sh,lock.sh,archive.py} "$targets/"
cat >"$targets/prepare.sh" <<'SH'
#!/bin/bash
echo begin >>"$LOG"
mkdir -p "$PREPARED/licences" && cp "$PLAYER" "$PREPARED/player"
sleep "${SLOW:-0}"
echo end >>"$LOG"
printf '%s\n' "$PREPARED/player" "$PREPARED/licences"
SH
printf '#!/bin/bash\n[ -z "${FOUND-}" ] || { echo "hash: $FOUND"; exit; }\nexec "$2/$3" "${@:4}"\n' >"$targets/play.sh"
printf '#!/bin/bash\necho "there is no level" >&2\nexit 1\n' >"$work/broken-player"
chmod +x "$targets"/*.sh "$work/broken-player"
"$editor" --new "$work/my game" --template empty >/dev/null
export_to() { "$targets/export.sh" linux "$work/my game" "$work/out/$1" "$editor" "${2:-$player}" >"$work/said" 2>&1; }
archive="$work/out/my game-linux.tar.xz"
refused() {  # TEXT: it was said, and nothing was written
    grep -qF -e "$1" "$work/said" || fail "\"$1\" is not in: $(cat "$work/said")"
    [ ! -e "$work/out/game" ] && [ ! -f "$archive" ] && [ ! -e "$archive.part" ] || fail "$1: written were $(ls "$work/out")"
}

FOUND=1234 export_to game && fail "a game that plays otherwise was exported"
refused "the exported game has the hash '1234'"
export_to game "$work/broken-player" && fail "a project that does not play was exported"
refused "the project ends with an error here: there is no level"
mkdir -p "$archive"
export_to game && fail "there is a folder in the place of the archive"
refused "is in the place of the archive"
rmdir "$archive"
mkdir -p "$work/out/other" && echo mine >"$work/out/other/thesis.txt"
export_to other && fail "a folder with other content was written to"
refused "the folder has other content: thesis.txt"
[ "$(ls -A "$work/out/other")" = thesis.txt ] || fail "the folder is not as it was: $(ls -A "$work/out/other")"

export_to game || fail "$(cat "$work/said")"
for line in "Played the first second: hash " "MB in $work/out/game; start it with \"my game\"" "Packed it as $archive: "; do
    grep -qF -e "$line" "$work/said" || fail "\"$line\" is not in: $(cat "$work/said")"
done
mkdir "$work/unpacked" && tar -xf "$archive" -C "$work/unpacked"
diff -r "$work/unpacked/my game" "$work/out/game" || fail "the archive does not contain the files of the folder"
[ -x "$work/out/game/my game" ] || fail "the program is not there: $(ls "$work/out/game")"
[ ! -e "$XDG_CACHE_HOME/plumb/export" ] || fail "what was not finished stays"

if command -v flock >/dev/null; then
    : >"$LOG"
    SLOW=0.5 export_to first & first=$!
    SLOW=0.5 export_to second & second=$!
    wait "$first" && wait "$second" || fail "$(cat "$work/said")"
    [ "$(echo $(cat "$LOG"))" = "begin end begin end" ] || fail "both worked at a time: $(cat "$LOG")"
fi
echo "folder and archive are written together or not at all"
