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
expect 'How two sets are related, polygons: overlapping, step 1 of' "the window opens though its state is damaged"
grep -q "window.json is damaged" "$folder/isect.log" || { echo "FAILED: it does not say what is damaged"; exit 1; }
leave
[ "$(cat "$state.damaged")" = '{"theme": "grey", "pla' ] || { echo "FAILED: the damaged state is lost"; exit 1; }
grep -q '"lesson": "relations"' "$state" || { echo "FAILED: no new state was kept"; exit 1; }
echo "ok: it says so, keeps the damaged file, and a new state beside it"

# spent: hundredths of a second of processor time so far
spent() { sed 's/.*) //' "/proc/$program/stat" | awk '{ print $12 + $13 }'; }
rm -f "$state"
start show ray-sphere --step 3
sleep 2
before=$(spent); sleep 3; after=$(spent)
[ $((after - before)) -le 3 ] || { echo "FAILED: at rest it takes $((after - before)) hundredths of 3 s"; exit 1; }
xdotool key space sleep 3  # play comes to a question, and waits
before=$(spent); sleep 3; after=$(spent)
[ $((after - before)) -le 3 ] || { echo "FAILED: at a question it takes $((after - before)) hundredths of 3 s"; exit 1; }
expect 'step 3 of' "play waits at a question, and takes no time"
xdotool key Right; expect 'step 4 of' "Right goes on"
xdotool key F11 sleep 1
size() { xdotool getwindowgeometry --shell "$window" | sed -n 's/^WIDTH=//p'; }
[ "$(size)" = 2700 ] || { echo "FAILED: F11 makes a window of $(size)"; exit 1; }
xdotool key F11 sleep 1
[ "$(size)" = 1280 ] || { echo "FAILED: F11 leads back to $(size)"; exit 1; }
echo "ok: F11 fills the screen, and leads back"
kill -TERM $program
closed() { ! kill -0 $program 2>/dev/null; }
wait_for 20 closed || { echo "FAILED: SIGTERM does not close the window"; exit 1; }
wait $program || { echo "FAILED: after SIGTERM isect ended with $?"; exit 1; }
program=
grep -q '"step": 4' "$state" || { echo "FAILED: SIGTERM loses the state"; exit 1; }
echo "ok: SIGTERM keeps the state"

if command -v xprop >/dev/null; then
  xprop -root -f RESOURCE_MANAGER 8s -set RESOURCE_MANAGER 'Xft.dpi: 192'
  for run in 1 2 3; do
    start
    sleep 1
    [ "$(size)" = 2560 ] || { echo "FAILED: at 192 dpi run $run opens $(size) pixels"; exit 1; }
    leave
    grep -q '"width": 1280' "$state" || { echo "FAILED: run $run at 192 dpi kept $(grep width "$state")"; exit 1; }
  done
  echo "ok: at 192 dpi the window has one size, run after run"
fi
sed -i 's/"width": [0-9]*/"width": -2147483649/' "$state"
start
sleep 1
[ "$(size)" -le 2700 ] || { echo "FAILED: it opens $(size) pixels"; exit 1; }
leave
echo "ok: a width that no screen has is not taken"
