#!/bin/bash
# plumb-new makes the same project as plumb-editor --new from every template, and never over another one.
#   new.sh PLUMB-NEW EDITOR WORK-FOLDER
set -eu
new=$1 editor=$2 work=$3
fail() { echo "$*"; exit 1; }
rm -rf "$work"
mkdir -p "$work/a" "$work/b"
templates=$("$new" --help | tr '\n' ' ' | sed 's/.*template of the project: \([a-z, ]*\) --help.*/\1/; s/,//g; s/ or / /')
[ "$(wc -w <<<"$templates")" -ge 7 ] || fail "the help lists these templates: $templates"
for template in $templates; do
    "$new" "$work/a/$template" --template "$template" | grep -qF "Created $work/a/$template" || fail "$template was not created"
    "$editor" --new "$work/b/$template" --template "$template" >/dev/null
done
diff -r "$work/a" "$work/b" || fail "the editor makes other projects"
if "$new" "$work/a/lua" >"$work/said" 2>&1; then fail "a project was created over another one"; fi
grep -q "non-empty folder" "$work/said" || fail "$(cat "$work/said")"
for wrong in "" "--template lua" "$work/c --template none" "$work/c $work/d" "$work/c --templat lua"; do
    # shellcheck disable=SC2086
    if "$new" $wrong >"$work/said" 2>&1; then fail "\"$wrong\" was accepted"; fi
    grep -q "command line: " "$work/said" || fail "\"$wrong\": $(cat "$work/said")"
done
[ ! -e "$work/c" ] || fail "a wrong command line created a project"
echo "the same projects as the editor's: $templates"
