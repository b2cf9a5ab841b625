#!/bin/bash
# A game in a real window under Xvfb is the game that headless programs play: a replay has the same hash in both,
# and what was recorded in the window plays headless.
#   replay_window.sh PLAYER PROJECT REPLAY WORK-FOLDER
set -eu
player=$1 project=$2 replay=$3 work=$4
ticks=700  # past the change from the title to the first level, and two recorded hashes; 12 s
rm -rf "$work" && mkdir -p "$work"
. "$(dirname "$0")/../../support/xvfb.sh"
play() { "$player" "$project" --replay "$replay" --frames $ticks --hash "$@"; }
play --headless > "$work/headless" 2>&1 || { cat "$work/headless"; exit 1; }
play --physics-view all --record "$work/window.replay" > "$work/window" 2>&1 || { cat "$work/window"; exit 1; }
hash() { grep '^hash: ' "$work/$1"; }
[ "$(hash headless)" = "$(hash window)" ] || { echo "headless $(hash headless), in the window $(hash window)"; exit 1; }
"$player" "$project" --headless --replay "$work/window.replay" || { echo "what the window recorded differs"; exit 1; }
hash window
