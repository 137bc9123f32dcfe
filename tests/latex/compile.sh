#!/bin/sh
# compile.sh ISECT FOLDER: figures, captions and handouts of all lessons go through pdflatex and lualatex.
# Exit 77 where LaTeX is not installed.
set -eu
isect=$1
work=$2

for program in pdflatex lualatex; do
  if ! command -v "$program" >/dev/null; then
    echo "skipped: no $program; on Debian: apt install texlive-latex-base texlive-pictures texlive-luatex"
    exit 77
  fi
done

rm -rf "$work"
mkdir -p "$work"
cd "$work"
"$isect" render --all --preset all --step 1-3 --format tikz --width 6cm --out figures >/dev/null 2>&1

for lesson in ray-sphere crossings obb-obb; do
  "$isect" handout "$lesson" >/dev/null
done

{
  printf '%s\n' '\documentclass[10pt]{article}' '\usepackage{tikz}' '\begin{document}'
  find figures -name '*.tikz' | sort | awk 'NR % 11 == 1 { print "\\input{" $0 "}\\par" }'
  sed -n 's/^ *"caption_tex": "\(.*\)",$/\1\\par/p' figures/manifest.json | sed 's/\\\\/\\/g; s/\\n/ /g; s/\\"/"/g' | sort -u
  printf '%s\n' '\end{document}'
} >all.tex

for program in pdflatex lualatex; do
  for text in all.tex handouts/*/*/handout.tex; do
    if ! (cd "$(dirname "$text")" && "$program" -interaction=nonstopmode -halt-on-error "$(basename "$text")") \
      >"$program.out" 2>&1; then
      echo "$program: $text: $(grep -A3 '^!' "$program.out" | head -8)"
      exit 1
    fi
  done
done
