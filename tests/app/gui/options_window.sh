#!/bin/bash
# A game that opens the options is played again in a real window: they stay closed, as they would wait for a person.
#   options_window.sh PLAYER WORK-FOLDER
set -eu
player=$1 work=$2
rm -rf "$work" && mkdir -p "$work/project/scenes" "$work/project/scripts"
. "$(dirname "$0")/../../support/xvfb.sh"
cd "$work/project"
cat > scripts/opener.lua <<END
local Opener = script { }
function Opener:onTick(dt)
    self.ticks = (self.ticks or 0) + 1
    if self.ticks == 10 then showOptions() end
end
return Opener
END
echo '{"name": "Opener", "startScene": "scenes/a.scene.json"}' > project.json
echo '{"format": 1, "entities": [{"id": "00000000000000a1", "name": "Opener",
    "components": {"Transform": {}, "Opener": {}}}]}' > scenes/a.scene.json
fail() { echo "$1"; cat "$work/log"; exit 1; }
"$player" . --headless --frames 60 --record "$work/run.replay" > "$work/log" 2>&1 || fail "it cannot be recorded"
timeout 60 "$player" . --window 320x180 --replay "$work/run.replay" > "$work/log" 2>&1 ||
    fail "the replay fails, or it waits in the options"
echo "replayed 60 ticks"
