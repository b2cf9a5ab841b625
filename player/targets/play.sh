#!/usr/bin/env bash
# Plays an exported game on this computer: a page in node, a program for Windows in wine. Fails with 3 if what plays it is
# not installed.
#
#   player/targets/play.sh this|linux|windows|web FOLDER PROGRAM OPTIONS...
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
target=$1 folder=$2 program=$3
shift 3
case $target in
    web)
        command -v node >/dev/null || { echo "node is not installed" >&2; exit 3; }
        exec node "$here/play_in_node.js" "$folder" "$@"
        ;;
    windows)
        command -v wine >/dev/null || { echo "wine is not installed" >&2; exit 3; }
        export WINEPREFIX=${XDG_CACHE_HOME:-$HOME/.cache}/plumb/wine WINEDEBUG=-all WINEDLLOVERRIDES='mscoree,mshtml='
        mkdir -p "${WINEPREFIX%/*}"
        cd "$folder"
        # Processes of wine stay for a while, and would hold what was inherited open, locks included.
        wine "$program" "$@" 3>&- 4>&- 5>&- 6>&- 7>&- 8>&- 9>&- | tr -d '\r'
        ;;
    *) exec "$folder/$program" "$@" ;;
esac
