#!/bin/sh
# A whole lesson in the real window by keyboard alone: no pointer is moved after the window has opened.
# usage: keyboard.sh ISECT WHERE FOLDER    (where.cpp's program; a folder for scratch, the pictures and the record)
# Exit 77: skipped, with the reason.
set -eu
isect=$1 where=$2 folder=$3
. "$(dirname "$0")/display.sh"

# press KEYS...: one after the other, each seen by a frame of its own
press() { for key; do xdotool key "$key" sleep 0.12; done; }
write() { xdotool type --delay 60 "$1"; sleep 0.4; }
# downs WIDGET [STEP]: how often Down leads there from nothing, the parameters being open
downs() { "$where" ray-sphere "${2:-1}" "$1" downs | tail -n 1; }
# hold WIDGET: lets go of what the keyboard holds, then goes there
hold() {
  press Escape
  for _ in $(seq "$(downs "$1")"); do press Down; done
}
step() { title | sed 's/.*step \([0-9]*\) of.*/\1/'; }
last() { title | sed 's/.* of \([0-9]*\) .*/\1/'; }
# kept WHAT: the state on leaving has this line
kept() { grep -Eq "$1" "$state" || { echo "FAILED: $2: the state has no $1"; cat "$state"; exit 1; }; echo "ok: $2"; }

start
picture 01-start
expect 'How two sets are related' "the first lesson opens"
press ctrl+o; sleep 0.5
write 'ray ball'
picture 02-picker
press Return
expect 'Ray and sphere, two roots, step 1 of' "the picker is searched, and Enter opens the row that looks chosen"

steps=$(last)
answered=0
while [ "$(step)" != "$steps" ]; do
  now=$(step)
  press Right
  on() { [ "$(step)" != "$now" ]; }
  wait_for 1 on && continue
  answered=$((answered + 1))
  picture "03-question-$answered"
  press a
  wait_for 1 on || press a  # the first showed the choices of a question that asks for a number
  wait_for 1 on || press BackSpace b c d Return  # both were letters of an order
  wait_for 5 on || { echo "FAILED: at step $now neither Right nor an answer goes on"; exit 1; }
  picture "03-answer-$answered"
done
[ "$answered" -ge 2 ] || { echo "FAILED: only $answered questions were asked"; exit 1; }
echo "ok: $steps steps, $answered questions answered"
picture 04-end

press Home
expect 'two roots, step 1 of' "Home goes to the first step"
press F6 F6 Return; sleep 0.3  # the first of the lesson's panel: its parameters
picture 05-parameters
hold 'parameter radius'
press Return; sleep 0.3
write '1,25'
picture 06-typing
press Return
expect 'changed, step 1 of' "a number is typed"
press ctrl+z; expect 'two roots, step 1 of' "Ctrl+Z takes it back"
press ctrl+y; expect 'changed, step 1 of' "Ctrl+Y does it again"

press 1; expect 'two roots, step 1 of' "1 loads the first preset"
hold 'handle center'
press shift+Up shift+Up shift+Right
expect 'changed, step 1 of' "Shift and the arrows move the held handle"
picture 07-handle

hold method
press Return; sleep 0.3
press Down Down Return; sleep 0.3
picture 08-method
hold theme
press Return; sleep 0.3
picture 09-theme
press Escape w; sleep 0.5
picture 10-map
press v; sleep 0.5
picture 11-panes
press v; sleep 0.3
press s; sleep 0.5
picture 12-save
press Return
saved() { [ -n "$(find "$folder/figures" -name '*.png' 2>/dev/null)" ]; }
wait_for 10 saved || { echo "FAILED: no figure was saved"; exit 1; }
echo "ok: a figure is saved: $(cd "$folder" && find figures -type f | sort | tr '\n' ' ')"
press F1; sleep 0.4
picture 13-keys
press Escape
leave
kept '"theme": "screen"' "the theme was changed"
kept '"method": "(quadratic|half-b)' "the method was changed"
kept '"finished": true' "the lesson counts as read"
[ "$(grep -c 'ray-sphere' "$state")" -ge 2 ] || { echo "FAILED: no answers were kept"; exit 1; }
echo "ok: a whole lesson by keyboard alone"

# A playlist by a presenter's two buttons, in a lecture and outside; then once more from where it was left.
cat >"$folder/hour.json" <<'END'
{"stops": [{"lesson": "intervals", "preset": "touching", "steps": "1-2"},
           {"scene": "gone.json"},
           {"lesson": "sphere-sphere", "preset": "touching", "steps": "4-5"}]}
END
start show hour.json
expect '^1 of 3: Interval and interval, .*step 1 of' "a playlist opens at its first stop"
grep -q 'hour.json: stop 2, line 2: scene: ' "$folder/isect.log" || { echo "FAILED: stop 2 is not told"; exit 1; }
press Tab Next; sleep 0.3
picture 14-playlist-question
press Next
expect '^1 of 3: .*step 2 of' "Page Down asks, and goes on"
press Next
expect '^2 of 3: ' "a stop that can't be opened has its turn"
picture 15-stop-that-is-gone
press Next
expect '^3 of 3: Sphere and sphere, .*step 3 of' "and is gone past, to the question of the next stop's first step"
picture 16-playlist-asks
press Tab n
expect '^3 of 3: .*step 4 of' "N goes on outside a lecture, too"
press j; sleep 0.4
picture 17-stops
press Escape Prior
expect '^2 of 3: ' "Page Up goes back"
leave
kept '"stop": 2' "where the playlist was left is kept"
start show hour.json
expect '^2 of 3: ' "the playlist opens where it was left"
press Prior
expect '^1 of 3: Interval and interval, .*step 2 of' "Page Up leads to the end of the stop before"
leave
