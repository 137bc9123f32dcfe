# What a test of the real window needs: a display of its own (Xvfb), and hands on it (xdotool). Read by the scripts beside
# it after they have set `isect` and `folder`.

for tool in Xvfb xdotool; do
  command -v $tool >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done

rm -rf "$folder"
mkdir -p "$folder/state"
Xvfb -displayfd 3 -screen 0 2700x1700x24 -nolisten tcp -noreset 3>"$folder/display" 2>"$folder/xvfb.log" &
server=$!
program=
trap 'kill $program $server 2>/dev/null || :' EXIT

# wait_for SECONDS COMMAND...: until the command succeeds
wait_for() {
  tries=$(($1 * 10)); shift
  while ! "$@"; do
    tries=$((tries - 1))
    [ $tries -gt 0 ] || return 1
    sleep 0.1
  done
}
wait_for 20 test -s "$folder/display" || { echo "skipped: Xvfb does not start"; cat "$folder/xvfb.log"; exit 77; }
export DISPLAY=":$(cat "$folder/display")"
export XDG_STATE_HOME="$folder/state" LIBGL_ALWAYS_SOFTWARE=1
unset WAYLAND_DISPLAY
state="$folder/state/isect/window.json"

find_window() { window=$(xdotool search --onlyvisible --name ' – isect$' 2>/dev/null | head -n 1) && [ -n "$window" ]; }
# start ARGS...: isect with these, until its window is there
start() {
  (cd "$folder" && exec "$isect" "$@") 2>"$folder/isect.log" &
  program=$!
  wait_for 60 find_window || { echo "FAILED: no window"; cat "$folder/isect.log"; exit 1; }
  xdotool windowmove "$window" 0 0 windowfocus "$window" mousemove 700 700
}
# leave: Ctrl+Q, until the program has ended well
leave() {
  xdotool key ctrl+q
  closed() { ! kill -0 $program 2>/dev/null; }
  wait_for 20 closed || { echo "FAILED: Ctrl+Q does not close the window"; exit 1; }
  wait $program || { echo "FAILED: isect ended with $?"; cat "$folder/isect.log"; exit 1; }
  program=
}
title() { xdotool getwindowname "$window"; }

# expect PATTERN WHAT: the window's title comes to match
expect() {
  matches() { title | grep -Eq "$1"; }
  wait_for 30 matches "$1" || { echo "FAILED: $2: the title is \"$(title)\""; exit 1; }
  echo "ok: $2: $(title)"
}
# picture NAME: what the window shows now, as a file in the folder
picture() {
  if command -v import >/dev/null; then import -window "$window" "$folder/$1.png"; fi
}
