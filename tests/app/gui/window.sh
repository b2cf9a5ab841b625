#!/bin/bash
# Plays in a real window under Xvfb: resizes it, shows the physics view, removes the focus and restores it, and crashes.
# (Full screen needs a window manager, which Xvfb does not have.)
#   window.sh PLAYER PROJECT WORK-FOLDER
set -eu
player=$1 project=$2 work=$3
rm -rf "$work" && mkdir -p "$work"
. "$(dirname "$0")/../../support/xvfb.sh"
"$player" "$project" --scene level1 --window 640x360 --frames 600 --screenshot "$work/last.png" > "$work/log" 2>&1 &
program=$!
fail() { echo "$1"; cat "$work/log"; exit 1; }
window=
for _ in $(seq 200); do window=$(xdotool search --name Wickwood 2> /dev/null | head -1) && [ -n "$window" ] && break; sleep 0.1; done
[ -n "$window" ] || fail "no window appeared"
size() { xdotool getwindowgeometry --shell "$window" | sed -n 's/^WIDTH=\(.*\)/\1/p;s/^HEIGHT=\(.*\)/x\1/p' | tr -d '\n'; }
becomes() {  # SIZE: waits until the window has it
    for _ in $(seq 100); do [ "$(size)" = "$1" ] && return 0; sleep 0.05; done
    fail "the window is $(size), not $1"
}
becomes 640x360
xdotool windowfocus "$window"; sleep 0.3
xdotool windowsize "$window" 700 500
becomes 700x500
xdotool key F3; sleep 0.3; xdotool key --clearmodifiers ctrl+4; sleep 0.3
grep -q "Physics view on" "$work/log" || fail "F3 did not show the physics"
# Without the focus the game pauses: 600 ticks take 10 s, and the window is still open long afterwards.
other=$(xdotool search --maxdepth 0 --name '' 2> /dev/null | head -1)
xdotool windowfocus "${other:-1}" 2> /dev/null || true
sleep 12
kill -0 "$program" 2> /dev/null || fail "it went on playing without the focus"
xdotool windowfocus "$window"
for _ in $(seq 300); do kill -0 "$program" 2> /dev/null || break; sleep 0.1; done
kill -0 "$program" 2> /dev/null && fail "it did not go on when the focus came back"
wait "$program" || fail "it ended with an error"
program=
# The screenshot has the size of the window, 700x500: bytes 16 to 23 of the PNG.
[ "$(od -An -tu1 -j16 -N8 "$work/last.png" | tr -s ' ')" = " 0 0 2 188 0 0 1 244" ] || fail "the picture is not 700x500"
# A crash leaves a report in the game's data folder, which plays to its end.
XDG_DATA_HOME="$work/data" "$player" "$project" --scene level1 > "$work/log" 2>&1 &
program=$!
for _ in $(seq 200); do grep -q "FPS:" "$work/log" && break; sleep 0.1; done
kill -SEGV "$program"
wait "$program" && fail "the signal did not end it"
program=
report=$(echo "$work"/data/Wickwood/crash-*.replay)
[ -f "$report" ] || fail "it left no report"
grep -qaF "$HOME" "$report" && fail "the report has a path of the user"
"$player" "$project" --headless --replay "$report" > "$work/log" 2>&1 || fail "the report cannot be played"
grep -q "It has not crashed again" "$work/log" || fail "the report is not played to its end"
echo "resized, showed the physics, paused without the focus, left a report of its crash"
