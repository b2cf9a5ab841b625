#!/bin/bash
# A game in a real window under Xvfb must equal the headless game: a replay has the same hash in both, and a recording
# made in the window can be replayed headless. During the recording the window loses the focus, which pauses the game
# for a second.
#   replay_window.sh REPLAY TICKS WORK-FOLDER TITLE PROGRAM [PROJECT]
set -eu
replay=$1 ticks=$2 work=$3 title=$4
shift 4
game=("$@")
rm -rf "$work" && mkdir -p "$work"
. "$(dirname "$0")/../../support/xvfb.sh"
fail() { echo "$1"; shift; [ $# = 0 ] || cat "$@"; exit 1; }
play() { "${game[@]}" --replay "$replay" --frames "$ticks" --hash "$@"; }
play --headless > "$work/headless" 2>&1 || fail "headless it fails" "$work/headless"

play --physics-view all --record "$work/window.replay" > "$work/window" 2>&1 &
program=$!
window=
for _ in $(seq 200); do window=$(xdotool search --name "$title" 2> /dev/null | head -1) && [ -n "$window" ] && break; sleep 0.05; done
[ -n "$window" ] || fail "no window appeared" "$work/window"
xdotool windowfocus "$window" 2> /dev/null; sleep 0.7
xdotool windowfocus "$(xdotool search --maxdepth 0 --name '' 2> /dev/null | head -1)" 2> /dev/null || true
sleep 1
xdotool windowfocus "$window" 2> /dev/null
wait "$program" || fail "in the window it fails" "$work/window"
program=
hash() { grep '^hash: ' "$work/$1"; }
[ "$(hash headless)" = "$(hash window)" ] || fail "headless $(hash headless), in the window $(hash window)"
"${game[@]}" --headless --replay "$work/window.replay" > "$work/again" 2>&1 ||
    fail "what the window recorded differs" "$work/again"
hash window
