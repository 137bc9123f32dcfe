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

# As PDF by isect itself; slides with two pictures of 5,000 facets within seconds.
"$isect" handout ray-sphere --step 1-6 --format pdf --out pdfs >/dev/null 2>said.txt
"$isect" quiz crossings --format pdf --out pdfs >/dev/null 2>>said.txt
"$isect" deck ray-sphere --step 3-5 --overlays --dark --format pdf --out pdfs >/dev/null
"$isect" deck hour.json --overlays --beamer-theme Madrid --format pdf --out pdfs >/dev/null
awk 'BEGIN { n = 50
  for (i = 0; i < n; i++) for (j = 0; j < n; j++) { a = 6.2831853 * i / n; b = 6.2831853 * j / n
    printf "v %.5f %.5f %.5f\n", (2 + 0.8 * cos(b)) * cos(a), 0.8 * sin(b), (2 + 0.8 * cos(b)) * sin(a) }
  for (i = 0; i < n; i++) for (j = 0; j < n; j++) { k = (i + 1) % n; l = (j + 1) % n
    printf "f %d %d %d\nf %d %d %d\n", n*i+j+1, n*i+l+1, n*k+l+1, n*i+j+1, n*k+l+1, n*k+j+1 } }' >fine.obj
printf '%s\n' '{"objects": [{"mesh": "M", "file": "fine.obj"}, {"ray": "r", "origin": [-4, 0.5, 0], "dir": [1, 0, 0.1]}], "ask": [["r", "M"]]}' \
  >fine.json
"$isect" deck fine.json >/dev/null
if ! (cd decks/scene/fine && ls ./*-faces.pdf && timeout 20 pdflatex -interaction=batchmode deck.tex) >/dev/null; then
  echo "pdflatex: slides with a mesh of 5,000 facets take more than 20 s, or do not compile"
  exit 1
fi
for pdf in pdfs/ray-sphere/two-roots/handout.pdf pdfs/crossings/*/quiz.pdf pdfs/ray-sphere/two-roots/deck.pdf pdfs/hour/deck.pdf; do
  if [ "$(head -c 5 "$pdf")" != "%PDF-" ]; then
    echo "$pdf is no PDF"
    exit 1
  fi
done

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
