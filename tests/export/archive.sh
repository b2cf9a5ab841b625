#!/usr/bin/env bash
# The archives of exports: random files, made in another order, at another time, in another folder and by a user with other
# rights give the same bytes; and unpacked they are the files again.
#   archive.sh SOURCE-FOLDER WORK-FOLDER [SEED]
set -euo pipefail
source=$1 work=$2
RANDOM=${3:-1}
fail() { echo "$*"; exit 1; }
rm -rf "$work" && mkdir -p "$work"
names=("Ünï cödé 名前" plain "two words" 'quo"te' a B .hidden "folder/in/folder/x" "folder/Y" "longlonglong/$(printf 'n%.0s' {1..150})")
unset SOURCE_DATE_EPOCH
archive() {  # TARGET FOLDER NAME: of all files in the folder but note.txt, in the order in which the system lists them
    local files
    mapfile -t files < <(find "$2" -type f ! -name note.txt -printf '%P\n')
    python3 "$source/player/targets/archive.py" "$@" "${files[@]}"
}

for case in 1 2 3; do
    first=$work/$case/first/out second=$work/$case/second/elsewhere
    mkdir -p "$first" "$second"
    echo "not for players" >"$first/note.txt"
    order=()
    for name in "${names[@]}"; do
        [ $((RANDOM % 4)) != 0 ] || continue
        mkdir -p "$(dirname "$first/$name")"
        head -c $((RANDOM % 3 * RANDOM)) /dev/urandom >"$first/$name"
        [ $((RANDOM % 2)) = 0 ] || chmod 755 "$first/$name"
        order=("$name" "${order[@]}")
    done
    for name in "${order[@]}"; do (
        umask 077
        mkdir -p "$(dirname "$second/$name")"
        cat "$first/$name" >"$second/$name"
        [ ! -x "$first/$name" ] || chmod 700 "$second/$name"
        touch -d "2001-02-0$((RANDOM % 9 + 1))" "$second/$name"
    ); done
    for target in linux windows web; do
        one=$(archive "$target" "$first" "Sky Cäves")
        other=$(TZ=Asia/Tokyo LC_ALL=C archive "$target" "$second" "Sky Cäves")
        [ "$(dirname "$one")" = "$work/$case/first" ] || fail "the archive is not beside the folder: $one"
        cmp "$one" "$other" || fail "$target: the same files give other bytes"
        python3 - "$one" "$work/$case/$target" <<'PY'
import shutil, sys, zipfile
sys.argv[1].endswith(".zip") and zipfile.ZipFile(sys.argv[1]).extractall(sys.argv[2])
sys.argv[1].endswith(".zip") or shutil.unpack_archive(sys.argv[1], sys.argv[2])
PY
        inner=$work/$case/$target/"Sky Cäves"
        [ "$target" != web ] || inner=$work/$case/$target
        diff -r -x note.txt "$inner" "$first" || fail "$target: the archive does not contain the files"
        [ ! -e "$inner/note.txt" ] || fail "$target: the archive contains a file that is not of the export"
        SOURCE_DATE_EPOCH=1000000000 archive "$target" "$second" "Sky Cäves" >/dev/null
        ! cmp -s "$one" "$other" || fail "$target: SOURCE_DATE_EPOCH is not used"
    done
    for name in "${names[@]}"; do
        [ ! -x "$first/$name" ] || [ -x "$work/$case/linux/Sky Cäves/$name" ] || fail "$name is no longer a program"
    done
done
mkdir "$work/closed" && echo x >"$work/closed/x" && mkdir "$work/N-web.zip.part"
said=$(archive web "$work/closed" N 2>&1) && fail "an archive was written in the place of a folder"
[[ "$said" == *"was not written"*"check the free disk space"* ]] || fail "$said"
echo "archives: the same files, the same bytes; unpacked they are the files"
