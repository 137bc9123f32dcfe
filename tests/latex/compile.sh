#!/bin/sh
# compile.sh ISECT FOLDER: figures, captions, strips, handouts, decks and quizzes go through pdflatex and lualatex, but
# most handouts and decks through lualatex in a long run (ISECT_LONG=1) only.
# Exit 77 where LaTeX is not installed.
set -eu
isect=$1
work=$2

for program in pdflatex lualatex; do
  if ! command -v "$program" >/dev/null; then
    echo "skipped: no $program; on Debian: apt install texlive-latex-base texlive-latex-recommended texlive-pictures" \
      "texlive-luatex"
    exit 77
  fi
done

rm -rf "$work"
mkdir -p "$work"
cd "$work"
"$isect" render --all --preset all --step 1-3 --format tikz --width 6cm --out figures >/dev/null 2>&1

for lesson in ray-sphere crossings obb-obb; do
  "$isect" handout "$lesson" >/dev/null
  "$isect" deck "$lesson" >/dev/null
  "$isect" strip "$lesson" --step 1-4 --columns 2 --format tikz --width 12cm --out figures >/dev/null 2>&1
done
"$isect" strip ray-sphere --preset two-roots,tangent,miss --captions --format tikz --width 14cm \
  --out figures >/dev/null 2>&1

printf '%s\n' '{"title": "Rays & balls: 50 % of an hour", "stops": [' \
  '{"lesson": "ray-sphere", "preset": "tangent", "steps": "3-6", "note": "Where does it *end*? #1_a\nAnd *t*^2?"},' \
  '{"lesson": "crossings", "steps": "2-4"}, {"scene": "a disc.json"},' \
  '{"lesson": "ray-sphere", "steps": "closing", "parameters": {"radius": 1.25}}]}' >hour.json
printf '%s\n' '{"objects": [{"sphere": "A", "center": [0, 0], "radius": 2}, {"point": "p", "at": [1, 1]}], "ask": [["p", "A"]]}' \
  >'a disc.json'
for kind in handout deck quiz; do "$isect" $kind hour.json >/dev/null; done
"$isect" quiz crossings >/dev/null

{
  printf '%s\n' '\documentclass[10pt]{article}' '\usepackage{tikz}' '\begin{document}'
  find figures -name '*.tikz' | sort | awk 'NR % 11 == 1 || /strip/ { print "\\input{" $0 "}\\par" }'
  sed -n 's/^ *"caption_tex": "\(.*\)",$/\1\\par/p' figures/manifest.json | sed 's/\\\\/\\/g; s/\\n/ /g; s/\\"/"/g' | sort -u
  printf '%s\n' '\end{document}'
} >all.tex

# Both programs at once, each in a copy of its own.
compile() {
  mkdir "$1"
  cp -r all.tex figures handouts decks quizzes "$1"
  cd "$1"
  lesson=*
  [ "$1" = pdflatex ] || [ "${ISECT_LONG:-}" = 1 ] || lesson=ray-sphere
  for text in all.tex handouts/$lesson/*/handout.tex decks/$lesson/*/deck.tex handouts/hour/handout.tex decks/hour/deck.tex \
    quizzes/hour/quiz.tex quizzes/crossings/*/quiz.tex; do
    if ! (cd "$(dirname "$text")" && "$1" -interaction=nonstopmode -halt-on-error "$(basename "$text")") >log.txt 2>&1; then
      echo "$1: $text: $(grep -A3 '^!' log.txt | head -8)"
      return 1
    fi
  done
}
(compile pdflatex) &
pdf=$!
status=0
(compile lualatex) || status=1
wait "$pdf" || status=1
exit "$status"
