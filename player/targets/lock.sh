# For scripts that build for other systems: . player/targets/lock.sh
# They share build/ of these sources and the folder $cache, which this sets, so that one works at a time: waits until all
# others have ended. The lock lasts as long as the shell; without flock, a part of util-linux, there is none.
cache=${XDG_CACHE_HOME:-$HOME/.cache}/plumb
mkdir -p "$cache"
exec 9>"$cache/export.lock"
if command -v flock >/dev/null && ! flock -n 9; then
    printf 'plumb: waiting for another export to end\n' >&2
    flock 9
fi
