# For scripts that run emscripten, after lock.sh: . player/targets/web/emscripten.sh
# Debian freezes its cache; a copy of it may grow.
export EM_CACHE=${XDG_CACHE_HOME:-$HOME/.cache}/plumb/emscripten EM_FROZEN_CACHE=0
export NODE_PATH=/usr/share/nodejs  # acorn; a node that is not Debian's does not look there
[ -d "$EM_CACHE" ] || {
    mkdir -p "${EM_CACHE%/*}"
    rm -rf "$EM_CACHE.part"
    cp -r /usr/share/emscripten/cache "$EM_CACHE.part" && mv "$EM_CACHE.part" "$EM_CACHE"
}
