#!/usr/bin/env python3
"""Every file that names the version of isect names that of core/version.cmake, and the day of the release is one.

    versions.py    lists what differs; exit status 1 if something does
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
VERSION = {
    "core/version.cmake": r"ISECT_VERSION (\S+)\)",
    "core/README.md": r"isect-(\S+)\.tar\.gz",
    "CHANGELOG.md": r"^## \[([0-9.]+)\]",
    "CITATION.cff": r"^version: (\S+)",
    "conanfile.py": r'^    version = "(.*)"',
    "vcpkg.json": r'"version": "(.*)"',
    "core/ports/isect/vcpkg.json": r'"version": "(.*)"',
}
DAY = {"CHANGELOG.md": r"^## \[[0-9.]+\] - (\S+)", "CITATION.cff": r"^date-released: (\S+)"}


def named(patterns):
    found = {}
    for file, pattern in patterns.items():
        match = re.search(pattern, (ROOT / file).read_text(encoding="utf-8"), re.MULTILINE)
        found[file] = match[1] if match else "nothing"
    return found


def main():
    status = 0
    for what in named(VERSION), named(DAY):
        if len(set(what.values())) > 1 or "nothing" in what.values():
            print("\n".join(f"{file}: {name}" for file, name in what.items()))
            status = 1
    return status


if __name__ == "__main__":
    sys.exit(main())
