#!/bin/bash
# The script plumb, with a cmake and a ninja that only note what they are asked for and "build" programs that print their
# arguments: what it checks before a build, what it builds, and what it prints.
#   plumb.sh SOURCE-FOLDER PLAYER EDITOR WORK-FOLDER
set -eu
source=$1 player=$2 editor=$3 work=$4
fail() { echo "$*"; exit 1; }
expect() { grep -qF -e "$1" "$work/said" || fail "\"$1\" is not in: $(cat "$work/said")"; }
refuse() { ! grep -qF -e "$1" "$work/said" || fail "\"$1\" is in: $(cat "$work/said")"; }
# Runs the script of the folder $tree; its output and the calls of cmake and ninja are in said and asked.
plumb() { : >"$work/asked"; "$tree/plumb" "$@" >"$work/said" 2>&1; }
built() { sed -n 's/^ninja -C [^ ]* -j [0-9]* //p' "$work/asked"; }

rm -rf "$work"
tree=$work/first
mkdir -p "$work/bin" "$tree/build" "$tree/projects/mine" "$tree/projects/codegame"
for file in plumb engine/app/player_options.cpp editor/model/project/editor_options.cpp editor/new_main.cpp; do
    mkdir -p "$(dirname "$tree/$file")"
    cp "$source/$file" "$tree/$file"
done
touch "$tree/projects/mine/project.json" "$tree/projects/codegame/main.cpp"
touch -d '+1 hour' "$tree/build/.packages-play"  # all packages are installed

# So are those that exports need.
printf '#!/bin/bash\necho ii\n' >"$work/bin/dpkg-query"
printf '#!/bin/bash\necho "apt-get $*" >>"$ASKED"; exit 1\n' >"$work/bin/apt-get"
cat >"$work/bin/cmake" <<'SH'
#!/bin/bash
echo "cmake $*" >>"$ASKED"
[ "$1" = -S ] || exit 0
mkdir -p "$4"
echo "CMAKE_HOME_DIRECTORY:INTERNAL=$2" >"$4/CMakeCache.txt"
touch "$4/build.ninja"
SH
cat >"$work/bin/ninja" <<'SH'
#!/bin/bash
echo "ninja $*" >>"$ASKED"
echo "[1/1] compiling"
mkdir -p "$2/bin"
for target in "${@:5}"; do
    printf '#!/bin/bash\necho "program %s: $*"\n' "$target" >"$2/bin/$target"
    [ "$target" != plumb-new ] ||
        echo '[ "$1" = --help ] || { mkdir -p "$1/code" && touch "$1/code/game.cpp"; }' >>"$2/bin/$target"
    chmod +x "$2/bin/$target"
done
SH
chmod +x "$work"/bin/*
export ASKED=$work/asked PATH="$work/bin:$PATH"

# An unknown option is an error before anything is built.
for command in "play mine --headles" "play --frame=3" "edit mine --export-to x" "new other --templat cpp"; do
    # shellcheck disable=SC2086
    plumb $command && fail "$command was accepted"
    expect "there is no option --"
    expect "./plumb ${command%% *} --help lists them"
    [ ! -s "$work/asked" ] || fail "$command asked for: $(cat "$work/asked")"
done

# The page of the accuracy lab is written to a new folder only: nothing of another one is replaced.
mkdir -p "$work/site/lab"
echo mine >"$work/site/index.html"
plumb accuracy --web "$work/site" && fail "a folder with other files was accepted"
expect "has files that are none of this page"
plumb accuracy --web && fail "a page without a folder was accepted"
expect "name a folder for the page"
[ "$(cat "$work/site/index.html")" = mine ] && [ -z "$(built)" ] || fail "accuracy --web asked for: $(cat "$work/asked")"

# Without a program there is no help; with one there is, and nothing is built.
plumb play --help
expect "program plumb-player: "
expect "(the first time takes some minutes)"
[ "$(built)" = plumb-player ] || fail "play --help built $(built)"
plumb play mine --help
expect "program plumb-player: --help"
[ ! -s "$work/asked" ] || fail "the second --help asked for: $(cat "$work/asked")"

# A game in code has its own program, its help, and no options about scenes.
plumb play codegame --scene x && fail "a game in code was given a scene"
expect "there is no option --scene"
[ ! -s "$work/asked" ] || fail "play codegame --scene asked for: $(cat "$work/asked")"
plumb play codegame --help
expect "program codegame: --help"
[ "$(built)" = codegame ] || fail "play codegame --help built $(built)"
plumb play codegame --help --seed 3
[ "$(grep -v '^plumb: ' "$work/said")" = "program codegame: --help" ] || fail "the help is: $(cat "$work/said")"
[ ! -s "$work/asked" ] || fail "the second --help of a game asked for: $(cat "$work/asked")"
plumb play codegame --seed 3
[ "$(tail -1 "$work/said")" = "program codegame: --seed 3" ] || fail "the game was started so: $(cat "$work/said")"

# Every option of the programs is known, and passed on.
for option in $("$player" --help | grep -o '^  --[a-z-]*'); do
    plumb play mine "$option" x || fail "$option: $(cat "$work/said")"
    [ "$option" = --help ] || expect "program plumb-player: $tree/projects/mine $option x"
done
plumb play mine
expect "building plumb-player"
refuse "the first time"
for option in $("$editor" --help | grep -o '^  --[a-z-]*'); do
    plumb edit mine "$option=x" || fail "$option: $(cat "$work/said")"
done

# A program that was built before names the closest option.
cp "$player" "$tree/build/release/bin/plumb-player"
plumb play mine --headles && fail "--headles was accepted"
expect "did you mean --headless?"
[ ! -s "$work/asked" ] || fail "--headles asked for: $(cat "$work/asked")"

# The editor exports with the player, so both are built.
plumb export mine "$work/out"
expect "program plumb-editor: $tree/projects/mine --export $work/out"
[ "$(built)" = "plumb-editor plumb-player" ] || fail "export built $(built)"
# For another system a script does it, with both; for all systems to a folder each, and one that fails stops no other.
mkdir -p "$tree/player/targets"
printf '#!/bin/bash\necho "export: $*"\n[ "$1" != "$FAILS" ]\n' >"$tree/player/targets/export.sh"
chmod +x "$tree/player/targets/export.sh"
bin=$tree/build/release/bin
FAILS="" plumb export mine "$work/out" --to linux
expect "export: linux $tree/projects/mine $work/out $bin/plumb-editor $bin/plumb-player"
[ "$(built)" = "plumb-editor plumb-player" ] || fail "export --to linux built $(built)"
FAILS=windows plumb export mine "$work/all" --to all && fail "a failed export was not reported"
for target in linux windows web; do expect "export: $target $tree/projects/mine $work/all/$target $bin/plumb-editor"; done
expect "not exported: windows; the messages above say why"
plumb export mine && fail "an export to nowhere was accepted"
expect "./plumb export PROJECT FOLDER"
plumb export mine "$work/out" --to amiga && fail "an export to an unknown system was accepted"
expect "there is no target amiga; write linux, windows, web or all"
plumb export mine "$work/out" --from web && fail "--from was accepted"
expect "[--to linux|windows|web|all]"
[ ! -s "$work/asked" ] || fail "a refused export asked for: $(cat "$work/asked")"
plumb export codegame "$work/out" && fail "a game without a project file was exported"
expect "codegame is a game in code"

# A new project needs little to be built, and the output has the next steps; --help makes none.
plumb new --help
expect "program plumb-new: --help"
for words in "foo --help" "foo --template lua --help" "--help foo" "foo --help=x"; do
    # shellcheck disable=SC2086
    plumb new $words
    expect "program plumb-new: --help"
    refuse "plays it"
    [ ! -e "$tree/projects/foo" ] || fail "new $words made a project"
done
plumb new && fail "a project without a name was made"
expect "name the new project"
plumb new other --template cpp
[ "$(built)" = plumb-new ] || fail "new built $(built)"
expect "program plumb-new: $tree/projects/other --template cpp"
expect "$tree/plumb play other"
expect "$tree/plumb edit other"
expect "$tree/projects/other/code/game.cpp"
plumb new "$work/else where"
expect "play $(printf '%q' "$work/else where")"

# What it prints can be pasted into a shell, from a folder with blanks too.
tree="$work/engine of mine"
cp -r "$work/first" "$tree"
touch -d '+1 hour' "$tree/build/.packages-play"
plumb new "$work/my game"
next=$(sed -n 's/^  \(.*[^ ]\)  *plays it$/\1/p' "$work/said")
eval "$next" >"$work/said" 2>&1 || fail "$next: $(cat "$work/said")"
expect "program plumb-player: $work/my game"
tree=$work/first

# A build folder that was copied with its sources is made anew, once; one seen through a link is not.
ln -s "$tree" "$work/link"
tree=$work/link
plumb play mine
refuse "was made for"
tree=$work/second
cp -r "$work/first" "$tree"
touch -d '+1 hour' "$tree/build/.packages-play"
plumb play mine
expect "build/release was made for the sources in $work/first, not for those here: making it anew"
grep -q "^cmake -S $tree -B $tree/build/release " "$work/asked" || fail "it was not configured: $(cat "$work/asked")"
plumb play mine
refuse "was made for"
echo "options are checked before builds; help, export, new and a copied build folder work"
