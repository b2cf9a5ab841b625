# Sourced by tests that need a real window: starts a separate X server and configures SDL to use it.
# The server and the program whose process id the test stores in $program are stopped at the end of the test.
#   work=FOLDER; . xvfb.sh
command -v Xvfb > /dev/null && command -v xdotool > /dev/null || { echo "Xvfb or xdotool is missing: skipped"; exit 77; }
display=$work/display
Xvfb -displayfd 3 -screen 0 1280x720x24 -nolisten tcp 3> "$display" > /dev/null 2>&1 &
server=$!
trap 'kill $program $server 2> /dev/null || true' EXIT
program=
for _ in $(seq 200); do [ -s "$display" ] && break; sleep 0.05; done
export DISPLAY=:$(cat "$display") SDL_VIDEODRIVER=x11 SDL_AUDIODRIVER=dummy LIBGL_ALWAYS_SOFTWARE=1
