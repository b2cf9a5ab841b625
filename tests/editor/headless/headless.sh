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
"$work/exported/Wickwood" --help > "$work/log"
grep -q "^usage: Wickwood \[options\]" "$work/log" || { echo "the help is not of the game"; cat "$work/log"; exit 1; }
! grep -qE "PROJECT|^ *--(scene|benchmark)" "$work/log" || { echo "the help has options of the engine"; exit 1; }
mkdir "$work/alone" && cp "$work/exported/Wickwood" "$work/alone/"
if (cd "$work/.." && "$work/alone/Wickwood") > "$work/log" 2>&1; then echo "a game without its pack started"; exit 1; fi
grep -q "Wickwood: game.pack is missing beside the program: unpack the whole archive" "$work/log" || { cat "$work/log"; exit 1; }
wanted=$(hash "$player" "$project")
ln -s "$work/exported/Wickwood" "$work/game"
found=$(hash "$work/game")  # through a link, as from a folder of the PATH
[ "$wanted" = "$found" ] || { echo "the project gives $wanted, the exported game $found"; exit 1; }
cp -r "$project" "$work/broken" && rm -rf "$work/broken/.plumb"
echo '{ "entities": [' > "$work/broken/scenes/level1.scene.json"
if "$editor" "$work/broken" --validate > "$work/log"; then echo "a broken scene was not found"; exit 1; fi
grep -q level1 "$work/log"
refused() {  # FILE TEXT: the project with this file is not exported
    rm -rf "$work/broken" && cp -r "$project" "$work/broken" && rm -rf "$work/broken/.plumb"
    mkdir -p "$(dirname "$work/broken/$1")" && printf '%s' "$2" > "$work/broken/$1"
    if "$editor" "$work/broken" --export "$work/none" > "$work/log" 2>&1; then echo "exported with $1: $2"; exit 1; fi
    grep -q "nothing was exported: fix the 1 problem first.* --validate" "$work/log" || { cat "$work/log"; exit 1; }
    [ ! -e "$work/none" ] || { echo "something was left behind"; exit 1; }
}
refused scenes/level1.scene.json '{ "entities": ['
refused prefabs/odd.prefab.json '{'
refused scenes/odd.scene.json '{"format": 1, "effects": {}, "layers": [], "entities": [{"id": "0000000000000001",
    "components": {"Transfrom": {}}}]}'
rm -rf "$work/broken" && cp -r "$project" "$work/broken" && rm -rf "$work/broken/.plumb"
sed -i 's/"name"/"nmae": 1, "name"/' "$work/broken/project.json"
"$editor" "$work/broken" --export "$work/warned" > "$work/log" 2>&1 || { echo "a warning stopped the export"; cat "$work/log"; exit 1; }
grep -q "nmae.*no such key" "$work/log"
echo "validated, pictured, exported and played: $found"
