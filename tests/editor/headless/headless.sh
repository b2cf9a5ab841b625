#!/bin/bash
# Validates a project, takes a screenshot and exports it, all without a display; the exported game must play like the
# project.
#   headless.sh EDITOR PLAYER PROJECT WORK-FOLDER
set -eu
editor=$1 player=$2 project=$3 work=$4
rm -rf "$work" && mkdir -p "$work"
unset DISPLAY WAYLAND_DISPLAY
"$editor" "$project" --validate
"$editor" "$project" --scene level1 --size 640x400 --screenshot "$work/window.png"
head -c 4 "$work/window.png" | tail -c 3 | grep -q PNG || { echo "no picture was written"; exit 1; }
"$editor" "$project" --export "$work/exported"
hash() { "$@" --headless --frames 120 --hash | tail -n 1; }
wanted=$(hash "$player" "$project")
ln -s "$work/exported/Wickwood" "$work/game"
found=$(hash "$work/game")  # through a link, as from a folder of the PATH
[ "$wanted" = "$found" ] || { echo "the project gives $wanted, the exported game $found"; exit 1; }
cp -r "$project" "$work/broken" && rm -rf "$work/broken/.plumb"
echo '{ "entities": [' > "$work/broken/scenes/level1.scene.json"
if "$editor" "$work/broken" --validate > "$work/log"; then echo "a broken scene was not found"; exit 1; fi
grep -q level1 "$work/log"
if "$editor" "$work/broken" --export "$work/none" > "$work/log" 2>&1; then echo "a broken game was exported"; exit 1; fi
[ ! -e "$work/none" ] || { echo "something was left behind"; exit 1; }
echo "validated, pictured, exported and played: $found"
