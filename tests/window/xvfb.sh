#!/bin/sh
# The real window with real events: a display of its own (Xvfb), keys and pointer by xdotool.
# usage: xvfb.sh ISECT WHERE FOLDER    (where.cpp's program; a folder for scratch and the screenshot)
# Exit 77: skipped, with the reason.
set -eu
isect=$1 where=$2 folder=$3

for tool in Xvfb xdotool; do
  command -v $tool >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done

rm -rf "$folder"
mkdir -p "$folder/state"
Xvfb -displayfd 3 -screen 0 1400x900x24 -nolisten tcp 3>"$folder/display" 2>"$folder/xvfb.log" &
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
start show ray-sphere
title() { xdotool getwindowname "$window"; }

# expect PATTERN WHAT: the window's title comes to match
expect() {
  matches() { title | grep -Eq "$1"; }
  wait_for 30 matches "$1" || { echo "FAILED: $2: the title is \"$(title)\""; exit 1; }
  echo "ok: $2: $(title)"
}

expect 'Ray and sphere, two roots, step 1 of' "the window opens at the first step"
xdotool key Right; expect 'step 2 of' "Right steps on"
xdotool key Right; expect 'step 3 of' "Right steps on again"
xdotool key Left; expect 'step 2 of' "Left steps back"
xdotool key End; expect 'step ([0-9]+) of \1 ' "End goes to the last step"
xdotool key Home; expect 'step 1 of' "Home goes to the first"
xdotool key 2; expect 'tangent, step 1 of' "2 loads the second preset"
xdotool key 1; expect 'two roots, step 1 of' "1 loads the first"

at() { "$where" ray-sphere 1 "$1" | tail -n 1; }
set -- $(at "preset 3")
xdotool mousemove "$1" "$2" sleep 0.3 mousedown 1 sleep 0.3 mouseup 1
expect 'miss, step 1 of' "a click on a chip loads its preset"
xdotool key 1; expect 'two roots, step 1 of' "and back"

set -- $(at "handle center")
xdotool mousemove "$1" "$2" sleep 0.3 mousedown 1 sleep 0.3
xdotool mousemove $(($1 + 40)) $(($2 + 60)) sleep 0.3 mousemove $(($1 + 80)) $(($2 + 120)) sleep 0.3 mouseup 1
expect 'Ray and sphere, changed, step' "dragging the centre changes the parameters"
if command -v import >/dev/null; then import -window "$window" "$folder/window.png"; fi
xdotool key ctrl+z; expect 'two roots, step' "Ctrl+Z takes the drag back"

xdotool key space; expect 'step [2-9] of' "Space plays"
xdotool key space
leave
state="$folder/state/isect/window.json"
grep -q '"lesson": "ray-sphere"' "$state" || { echo "FAILED: the state was not kept"; exit 1; }
echo "ok: it closes, and its state is kept"

printf '{"theme": "grey", "pla' >"$state"
start
expect 'How two sets can lie, polygons: overlapping, step 1 of' "the window opens though its state is damaged"
grep -q "window.json is damaged" "$folder/isect.log" || { echo "FAILED: it does not say what is damaged"; exit 1; }
leave
[ "$(cat "$state.damaged")" = '{"theme": "grey", "pla' ] || { echo "FAILED: the damaged state is lost"; exit 1; }
grep -q '"lesson": "relations"' "$state" || { echo "FAILED: no new state was kept"; exit 1; }
echo "ok: it says so, keeps the damaged file, and a new state beside it"
