#!/usr/bin/env python3
"""No line of a CMake file is longer than 120 characters.

    cmake_lines.py [ROOT]    lists such lines; exit status 1 if there are any
"""

import pathlib
import sys

ROOT = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else __file__).resolve()
ROOT = ROOT if ROOT.is_dir() else ROOT.parents[1]
RINGS = "core viz lessons bench app tests web".split()
LONGEST = 120


def long_lines(path):
    for number, line in enumerate(path.read_text(encoding="utf-8").split("\n"), 1):
        if len(line) > LONGEST:
            yield number, len(line)


def main():
    files = [ROOT / "CMakeLists.txt", *sorted(ROOT.glob("*.cmake"))]
    for ring in RINGS:
        files += [p for p in sorted((ROOT / ring).rglob("*")) if p.name == "CMakeLists.txt" or p.suffix == ".cmake"]
    found = [f"{p.relative_to(ROOT)}:{n}: {length} characters" for p in files for n, length in long_lines(p)]
    print("\n".join(found) or f"{len(files)} files: no line is longer than {LONGEST} characters")
    return 1 if found or len(files) < 3 else 0


if __name__ == "__main__":
    sys.exit(main())
