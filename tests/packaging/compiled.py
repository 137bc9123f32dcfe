#!/usr/bin/env python3
"""What core/README.md shows of isect/compiled.h compiles without Eigen, and the header's comment shows the same lines.

    compiled.py CXX    says what is wrong; exit status 1 if something is
"""

import pathlib
import re
import subprocess
import sys

CORE = pathlib.Path(__file__).resolve().parents[2] / "core"
SHOWN = re.compile(r"```cpp\n(#include <isect/compiled\.h>\n)\n(.*?)```", re.DOTALL)
FLAGS = ["-std=c++20", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", f"-I{CORE}", "-xc++", "-"]


def main(compiler):
    found = SHOWN.search((CORE / "README.md").read_text(encoding="utf-8"))
    if not found:
        print("core/README.md shows nothing of isect/compiled.h")
        return 1
    include, shown = found.groups()
    comment = "".join(f"//   {line}".rstrip() + "\n" for line in shown.splitlines())
    if f"//\n{comment}//\n" not in (CORE / "isect/compiled.h").read_text(encoding="utf-8"):
        print(f"isect/compiled.h does not show what core/README.md does:\n{comment}")
        return 1
    program = f"{include}int main() {{\n{shown}return meet ? 0 : 1;\n}}\n"
    return 1 if subprocess.run([compiler, *FLAGS], input=program, text=True).returncode else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
