#!/bin/bash
# A project with code outside of the engine's folder: made, checked, exported and played; then its code does not compile.
#   code.sh EDITOR TEMPLATE-PLAYER WORK-FOLDER
set -eu
editor=$1 player=$2 work=$3
fail() { echo "$*"; exit 1; }
# The program that the last export printed.
program() { sed -n 's/.*start it with "\(.*\)" in this folder/\1/p' "$work/export"; }
rm -rf "$work"
mkdir -p "$work"
"$editor" --new "$work/game" --template cpp | grep -q "Created $work/game" || fail "the project was not created"
"$editor" --new "$work/game" --template cpp 2>"$work/again" && fail "a project was created over another one"
grep -q "non-empty folder" "$work/again" || fail "the error does not name the reason: $(cat "$work/again")"

"$editor" "$work/game" --validate >"$work/validate" 2>&1 || fail "$(cat "$work/validate")"
grep -q "no problems\|: 0 problems" "$work/validate" || fail "$(cat "$work/validate")"

"$editor" "$work/game" --export "$work/out" >"$work/export" 2>&1 || fail "$(cat "$work/export")"
expected=$("$player" "$work/game" --headless --frames 300 --hash | grep hash)
exported=$("$work/out/$(program)" --headless --frames 300 --hash 2>"$work/warnings" | grep hash)
[ "$exported" = "$expected" ] || fail "the exported game says $exported, the template's player $expected"
[ ! -s "$work/warnings" ] || fail "$(cat "$work/warnings")"

# The editor has never built the code of this copy: the replay begins when the code is loaded.
"$player" "$work/game" --headless --frames 300 --record "$work/run.replay" >"$work/report" 2>&1 || fail "$(cat "$work/report")"
mkdir "$work/copy" && cp -r "$work/game" "$work/copy"
PLUMB_CONFIG="$work/config" SDL_VIDEODRIVER=offscreen "$editor" "$work/copy/game" --replay "$work/run.replay" >"$work/editor" 2>&1 &
window=$!
for _ in $(seq 1200); do grep -q "Tick " "$work/editor" && break; kill -0 $window 2>/dev/null || break; sleep 0.1; done
kill $window 2>/dev/null || true
grep -q "Reloaded the code" "$work/editor" || fail "the code was not built: $(cat "$work/editor")"
grep -q "Tick 180 of 300" "$work/editor" || fail "the replay was not played: $(cat "$work/editor")"

cp "$work/game/code/game.cpp" "$work/game.cpp"
sed 's|if (!back.hasHome) {|volatile int* volatile nowhere = nullptr; *nowhere = 1; if (!back.hasHome) {|' \
    "$work/game.cpp" >"$work/game/code/game.cpp"
"$editor" "$work/game" --export "$work/crash" >"$work/export" 2>&1 || fail "$(cat "$work/export")"
"$work/crash/$(program)" --headless --frames 10 >"$work/report" 2>&1 && fail "the program with the wrong access did not crash"
ended=$?
[ "$ended" = 139 ] || grep -q Sanitizer "$work/report" || fail "it ended with $ended, not by SIGSEGV: $(cat "$work/report")"
grep -Eq "^running: ComeBackSystem|Sanitizer" "$work/report" || fail "the report names no system: $(cat "$work/report")"
grep -Eq "\(.*ComeBackSystem.*\)|Sanitizer" "$work/report" || fail "the back trace names no function: $(cat "$work/report")"
cp "$work/game.cpp" "$work/game/code/game.cpp"

sed 's/module.system<ComeBackSystem, ComeBack>()/module.system<ComeBackSystem, ComeBack>({.after = "Physic"})/' \
    "$work/game.cpp" >"$work/game/code/game.cpp"
"$editor" "$work/game" --validate >"$work/position" 2>&1 && fail "a position after an unknown system was accepted"
[ "$(grep -c 'there is no system "Physic"' "$work/position")" = 1 ] || fail "not reported once: $(cat "$work/position")"
cp "$work/game.cpp" "$work/game/code/game.cpp"

grep "#include" "$work/game.cpp" >"$work/game/code/other.cpp"
echo "PLUMB_MODULE(module) { static_cast<void>(module); }" >>"$work/game/code/other.cpp"
"$editor" "$work/game" --validate >"$work/two" 2>&1 && fail "two PLUMB_MODULE were accepted"
grep -q "\[Code\] error: code: error: there are 2 PLUMB_MODULE, in game.cpp, other.cpp" "$work/two" || fail "$(cat "$work/two")"
rm "$work/game/code/other.cpp"

line=$(($(wc -l <"$work/game/code/game.cpp") + 1))
echo "int broken = ;" >>"$work/game/code/game.cpp"
"$editor" "$work/game" --validate >"$work/broken" 2>&1 && fail "code that does not compile was accepted"
grep -q "\[Code\] error: code/game.cpp:$line:14: error:" "$work/broken" || fail "no file and line: $(cat "$work/broken")"
echo "made, checked, exported, played; errors of the code have their file and remedy"
