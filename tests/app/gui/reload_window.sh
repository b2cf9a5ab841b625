#!/bin/bash
# A game in a real window takes up a script, a prefab and a scene that are saved while it runs, and reports an error in
# a script without stopping.
#   reload_window.sh PLAYER WORK-FOLDER
set -eu
player=$1 work=$2
rm -rf "$work" && mkdir -p "$work/project/scenes" "$work/project/prefabs" "$work/project/scripts"
. "$(dirname "$0")/../../support/xvfb.sh"
cd "$work/project"
script() {  # TEXT: a script that says what it counts and how wide a coin is that it spawns, once a second
    cat > scripts/teller.lua.new <<END
local Teller = script { }
function Teller:onTick(dt)
    self.count = (self.count or 0) + 1
    if self.count % 60 ~= 1 then return end
    local coin = spawn("coin", vec(0, 0))
    print("$1 " .. self.count .. " width " .. coin.sprite.width)
    coin:destroy()
end
function Teller:onReload() print("reloaded") end
return Teller
END
    mv scripts/teller.lua.new scripts/teller.lua
}
prefab() {  # WIDTH
    echo '{"format": 1, "entities": [{"id": "0000000000000001", "name": "Coin",
        "components": {"Transform": {}, "Sprite": {"width": '"$1"'}}}]}' > prefabs/coin.new
    mv prefabs/coin.new prefabs/coin.prefab.json
}
echo '{"name": "Reload", "startScene": "scenes/a.scene.json"}' > project.json
echo '{"format": 1, "entities": [{"id": "00000000000000a1", "name": "Teller",
    "components": {"Transform": {}, "Teller": {}}}]}' > scenes/a.scene.json
script first; prefab 4
XDG_DATA_HOME="$work/data" XDG_CONFIG_HOME="$work/config" "$player" . --window 320x180 > "$work/log" 2>&1 &
program=$!
fail() { echo "$1"; cat "$work/log"; exit 1; }
says() {  # PATTERN
    for _ in $(seq 200); do grep -qE "$1" "$work/log" && return 0; sleep 0.1; done
    fail "the log has no line: $1"
}
says 'first 1 width 4$'
prefab 16
says 'first [0-9]+ width 16$'
script second
says 'reloaded$'
says 'second [0-9]+ width 16$'
grep -qE 'second 1 width' "$work/log" && fail "the script has lost the values of self"
echo 'local Teller = script { } function Teller:onTick( return Teller' > scripts/teller.lua
says 'scripts/teller.lua:1: '
sleep 1.5
[ "$(grep -c 'scripts/teller.lua:1: ' "$work/log")" = 1 ] || fail "the error is reported more than once"
tail -n 3 "$work/log" | grep -q second || fail "the former version does not go on"
script third
says 'third [0-9]+ width 16$'
kill -0 "$program" || fail "the game ended"
echo "took up a prefab and scripts, reported an error, went on"
