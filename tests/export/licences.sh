#!/usr/bin/env bash
# The licences of an exported player: all of them are there, with that of the engine, or none and an error that says which.
#   licences.sh SOURCE-FOLDER WORK-FOLDER
set -euo pipefail
source=$1 work=$2
fail() { echo "$*"; exit 1; }
[ -f /usr/share/doc/libstb-dev/copyright ] || { echo "the licences are where Debian has them"; exit 77; }
rm -rf "$work"
for file in sdl/LICENSE.txt sdl_image/LICENSE.txt sdl_mixer/LICENSE.txt zlib/README zstd/LICENSE lua/doc/readme.html epoxy/COPYING; do
    made=$work/sources/${file%%/*}-prefix/src/$file
    mkdir -p "$(dirname "$made")" && echo "that of $file" >"$made"
done
gather() { "$source/player/targets/licences.sh" linux "$work/sources" "$work/licences" >"$work/said" 2>&1; }
for time in first second; do
    gather || fail "$(cat "$work/said")"
    [ "$(echo $(ls "$work/licences"))" = \
        "epoxy.txt libstdc++.txt lua.txt nlohmann-json.txt plumb.txt sdl.txt sdl_image.txt sdl_mixer.txt stb.txt zlib.txt zstd.txt" ] ||
        fail "the $time time these are there: $(ls "$work/licences")"
    touch "$work/licences/of-an-earlier-version.txt"
done
cmp "$work/licences/plumb.txt" "$source/LICENSE"
[ "$(cat "$work/licences/zlib.txt")" = "that of zlib/README" ] || fail "another text is that of zlib"
mv "$work/sources/zlib-prefix/src/zlib/README" "$work/sources/zlib-prefix/src/zlib/LICENSE"
gather && fail "a missing licence was not noticed"
grep -qF "the licence of zlib is missing: there is no file $work/sources/zlib-prefix/src/zlib/README" "$work/said" ||
    fail "$(cat "$work/said")"
echo "licences: all or an error"
