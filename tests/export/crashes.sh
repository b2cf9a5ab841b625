#!/usr/bin/env bash
# Exports a game that crashes, for this system and for Windows. Each crash must leave one report, which the project's
# player on this system repeats in the same tick.
#   ./plumb test --export
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
game=$root/tests/export/crash_game work=$root/build/exports/crashes
export WINEPREFIX=$root/build/exports/wine WINEDEBUG=-all WINEDLLOVERRIDES='mscoree,mshtml='
rm -rf "$work" && mkdir -p "$work"
fail() { echo "$*"; exit 1; }

start_this() { ./"$@"; }
start_windows() { wine "$@"; }

# crash SYSTEM KIND EXPECTED: the report says what is expected, and its replay crashes in the same tick.
crash() {
    local system=$1 kind=$2 expected=$3 reports=$work/$1-$2 log=$work/$1-$2.log report
    (cd "$work/$system" && PLUMB_CRASH=$kind "start_$system" "$program" --headless --frames 300 --crash-reports "../$system-$kind") \
        >"$log" 2>&1 && fail "$system, $kind: it did not crash: $(cat "$log")"
    report=$(echo "$reports"/crash-*.replay)
    [ -f "$report" ] || fail "$system, $kind: no report: $(cat "$log")"
    grep -aqF "$expected" "$report" || fail "$system, $kind: the report does not say \"$expected\": $(cat "$report")"
    grep -aqx "running crash_game::CrashingSystem\|running CrashingSystem" "$report" || fail "$system, $kind: $(cat "$report")"
    grep -aqF "$HOME" "$report" && fail "$system, $kind: the report has a path of the user"
    PLUMB_CRASH=$kind "$root/plumb" play "$game" --headless --replay "$report" >"$log" 2>&1 && fail "$system, $kind: its replay does not crash"
    grep -q "during tick 100 of 100 of the replay" "$log" || fail "$system, $kind: $(cat "$log")"
    printf '%-8s %-10s %s\n' "$system" "$kind" "$(basename "$report")"
}

systems=(this)
command -v wine >/dev/null && systems+=(windows)
for system in "${systems[@]}"; do
    to=(--to "$system")
    [ "$system" != this ] || to=()
    "$root/plumb" export "$game" "$work/$system" "${to[@]}" >"$work/export.log" 2>&1 || fail "$(tail -20 "$work/export.log")"
    program=$(sed -n 's/.*start it with "\(.*\)" in this folder/\1/p' "$work/export.log")
    crash "$system" null "a null pointer"
    crash "$system" recursion "the stack is full"
    crash "$system" division "division of integers by zero"
    crash "$system" abort "a failed assertion"
    crash "$system" exception "no such level"
    crash "$system" memory "out of memory"
done
