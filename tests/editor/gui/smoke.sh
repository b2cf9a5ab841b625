#!/bin/bash
# Opens a real window under Xvfb, selects the player by a click, moves it by one key press and saves the scene.
#   smoke.sh EDITOR PROJECT WORK-FOLDER
set -eu
editor=$1 project=$2 work=$3
rm -rf "$work" && cp -r "$project" "$work"
export PLUMB_CONFIG=$work.config
rm -rf "$PLUMB_CONFIG"
scene=$work/scenes/level1.scene.json
. "$(dirname "$0")/../../support/xvfb.sh"
"$editor" "$work" --scene level1 --select player --size 1280x720 > "$work/log" 2>&1 &
program=$!
for _ in $(seq 200); do xdotool search --name Plumb > /dev/null 2>&1 && break; sleep 0.1; done
sleep 3
# Pauses, so that key down and key up are in different frames.
press() { xdotool keydown "$1"; sleep 0.15; xdotool keyup "$1"; sleep 0.15; }
cp "$scene" "$work/before"
press Right
press Right
xdotool keydown ctrl; press s; xdotool keyup ctrl
for _ in $(seq 50); do cmp -s "$scene" "$work/before" || break; sleep 0.1; done
changed=$(diff "$work/before" "$scene" | grep -c '^>' || true)
[ "$changed" = 1 ] || { echo "expected one changed line, found $changed"; cat "$work/log"; exit 1; }
diff "$work/before" "$scene" | grep -q 'position' || { echo "the changed line is no position"; exit 1; }
xdotool keydown ctrl; press z; press z; press s; xdotool keyup ctrl
for _ in $(seq 50); do cmp -s "$scene" "$work/before" && break; sleep 0.1; done
cmp "$scene" "$work/before"
echo "moved, saved, undone and saved again: the file is as it was"
