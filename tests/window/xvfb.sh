#!/bin/sh
# The real window with real events: a display of its own (Xvfb), keys and pointer by xdotool.
# usage: xvfb.sh ISECT WHERE FOLDER    (where.cpp's program; a folder for scratch and the screenshot)
# Exit 77: skipped, with the reason.
set -eu
isect=$1 where=$2 folder=$3
. "$(dirname "$0")/display.sh"

start show ray-sphere
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

# what a click leads to is drawn, and no further event is needed
set -- $(at "parameters")
xdotool mousemove "$1" "$2" sleep 1 mousedown 1 sleep 0.05 mouseup 1 sleep 3
shown() { import -window "$window" -crop 284x380+10+320 +repage -depth 8 gray:- | cksum; }
if command -v import >/dev/null; then
  alone=$(shown)
  xdotool mousemove_relative -- 0 1 sleep 1 mousemove_relative -- 0 -1 sleep 2
  [ "$alone" = "$(shown)" ] || { echo "FAILED: the parameters wait for another event"; exit 1; }
  echo "ok: a click alone opens the parameters"
fi

set -- $(at "handle center")
xdotool mousemove "$1" "$2" sleep 0.3 mousedown 1 sleep 0.3
xdotool mousemove $(($1 + 40)) $(($2 + 60)) sleep 0.3 mousemove $(($1 + 80)) $(($2 + 120)) sleep 0.3 mouseup 1
expect 'Ray and sphere, changed, step' "dragging the centre changes the parameters"
picture window
xdotool key ctrl+z; expect 'two roots, step' "Ctrl+Z takes the drag back"

xdotool key space; expect 'step [2-9] of' "Space plays"
xdotool key space
leave
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
size() { xdotool getwindowgeometry --shell "$window" | sed -n 's/^WIDTH=//p'; }
wide() { [ "$(size)" = "$wanted" ]; }
wanted=2700; xdotool key F11; wait_for 20 wide || { echo "FAILED: F11 makes a window of $(size)"; exit 1; }
wanted=1280; xdotool key F11; wait_for 20 wide || { echo "FAILED: F11 leads back to $(size)"; exit 1; }
echo "ok: F11 fills the screen, and leads back"
kill -TERM $program
closed() { ! kill -0 $program 2>/dev/null; }
wait_for 20 closed || { echo "FAILED: SIGTERM does not close the window"; exit 1; }
wait $program || { echo "FAILED: after SIGTERM isect ended with $?"; exit 1; }
program=
grep -q '"step": 4' "$state" || { echo "FAILED: SIGTERM loses the state"; exit 1; }
echo "ok: SIGTERM keeps the state"

rm "$state"
start show ray-sphere
xdotool key Right sleep 0.3 key Right sleep 0.3 key Right sleep 0.3 key Right
wait_for 20 grep -qs '"step": 4' "$state" || { echo "FAILED: a crash would lose the state"; exit 1; }
kill -KILL $program
wait $program 2>/dev/null || :
program=
start
expect 'Ray and sphere, two roots, step 4 of' "a crash keeps the state"
leave

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
