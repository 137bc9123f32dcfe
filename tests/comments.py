#!/usr/bin/env python3
"""No comment begins with words that hide what it is about: "Of ...", "Those ...", "The same for ...".

    comments.py [ROOT]    lists such comments; exit status 1 if there are any
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else __file__).resolve()
ROOT = ROOT if ROOT.is_dir() else ROOT.parents[1]
RINGS = "core viz lessons bench app tests web".split()
COMMENT = re.compile(r"^\s*//")
HIDDEN = re.compile(r"^\s*///?\s+((Of|Those|That of|Nor|None of|As|Also)\b"
                    r"|The same( (of|for|as|at|in|on|to|by|from|with|where|when|if|but)\b|[.,;:]))")


def openings(path):
    before = ""
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if COMMENT.match(line) and not COMMENT.match(before) and HIDDEN.match(line):
            yield number, line.strip()
        before = line


def main():
    files = [p for ring in RINGS for p in sorted((ROOT / ring).rglob("*")) if p.suffix in (".h", ".cpp")]
    found = [f"{p.relative_to(ROOT)}:{n}: {text}" for p in files for n, text in openings(p)]
    print("\n".join(found) or f"{len(files)} files: every comment says first what it is about")
    return 1 if found or not files else 0


if __name__ == "__main__":
    sys.exit(main())
