#!/bin/bash
# Links in a real window under Xvfb: at its end a replay says that the state is the recorded one, and the game goes on live;
# a key takes over before that. The link of either run ends in the same state as the run.
# A link without a tick begins the game.
#   link_window.sh REPLAY TICKS WORK-FOLDER TITLE PROGRAM [PROJECT]
set -eu
replay=$1 ticks=$2 work=$3 title=$4
shift 4
game=("$@")
rm -rf "$work" && mkdir -p "$work"
. "$(dirname "$0")/../../support/xvfb.sh"
fail() { echo "$1"; shift; [ $# = 0 ] || cat "$@"; exit 1; }
line() { sed -n "s/^$2: //p" "$work/$1"; }
"${game[@]}" --headless --replay "$replay" --frames "$ticks" --print-link > "$work/recorded" 2>&1 || fail "no link" "$work/recorded"
link=$(line recorded link)

# play_window NAME TICKS: plays the link in a window up to a tick
play_window() {
    "${game[@]}" --link "https://example.org/game/$link" --frames "$2" --hash --print-link > "$work/$1" 2>&1 &
    program=$!
    window=
    for _ in $(seq 200); do window=$(xdotool search --name "$title" 2> /dev/null | head -1) && [ -n "$window" ] && break; sleep 0.05; done
    [ -n "$window" ] || fail "no window appeared" "$work/$1"
    xdotool windowfocus "$window" 2> /dev/null; sleep 0.5
}
check() {
    "${game[@]}" --headless --link "$(line "$1" link)" --hash > "$work/$1-again" 2>&1 || fail "the link of $1 differs" "$work/$1-again"
    [ "$(line "$1" hash)" = "$(line "$1-again" hash)" ] || fail "the hash of $1 differs" "$work/$1" "$work/$1-again"
}

play_window ended $((ticks + 90))
wait "$program" || fail "the window fails" "$work/ended"
program=
grep -q 'The replay has ended: the state is the recorded one' "$work/ended" || fail "it does not say the result" "$work/ended"
check ended

play_window taken $((ticks + 90))
xdotool keydown --window "$window" Left; sleep 0.4; xdotool keyup --window "$window" Left
wait "$program" || fail "the window fails" "$work/taken"
program=
grep -q 'You play from tick' "$work/taken" || fail "a key does not take over" "$work/taken"
! grep -q 'The replay has ended' "$work/taken" || fail "the replay went on" "$work/taken"
check taken

# A link without a tick is a game that begins.
"${game[@]}" --headless --frames 0 --print-link > "$work/recorded" 2>&1 || fail "no link" "$work/recorded"
link=$(line recorded link)
play_window none 90
[ "$(xdotool getwindowname "$window")" = "$title" ] || fail "the window is named as that of a replay"
wait "$program" || fail "the window fails" "$work/none"
program=
! grep -q 'Replaying' "$work/none" || fail "nothing is replayed" "$work/none"
line taken hash
