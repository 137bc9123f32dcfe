#!/usr/bin/env python3
"""Puts deliberate faults into a copy of the sources and tells which of them the checks notice.

    tests/mutation/study.py [--work DIR] [--only N,N...] [--jobs N] [--list]

All faults (tests/mutation/faults.py) are built into one program that has at most one of them at a time: the one whose
number stands in ISECT_FAULT. So one build does for all. Exit: 0 all caught; 1 one was not, or is stale (its text is not
found once where it should be), or the program without faults fails.
"""

import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from faults import FAULTS

ROOT = pathlib.Path(__file__).resolve().parents[2]


def copy_sources(to):
    """The sources into `to`, files that are the same left alone, so that a second run builds little."""
    keep = shutil.ignore_patterns(".git", "build", "build-*", "figures", "study", "*.new.png", "*.diff.png")
    with tempfile.TemporaryDirectory() as fresh:
        shutil.copytree(ROOT, f"{fresh}/isect", ignore=keep)
        apply_all(pathlib.Path(fresh) / "isect")
        for path in pathlib.Path(f"{fresh}/isect").rglob("*"):
            target = to / path.relative_to(f"{fresh}/isect")
            if path.is_dir():
                target.mkdir(parents=True, exist_ok=True)
            elif not target.exists() or target.read_bytes() != path.read_bytes():
                shutil.copyfile(path, target)
                shutil.copymode(path, target)


def applied(text, number, old, new):
    """The text with the fault in it, or None where it is stale."""
    if text.count(old) != 1:
        return None
    fault = f"isect_fault({number})"
    new = new.replace("FAULT", fault) if "FAULT" in new else f"({fault} ? ({new}) : ({old}))"
    return text.replace(old, new)


STALE = set()


def apply_all(root):
    files = {}
    for number, (_, file, old, new, _) in enumerate(FAULTS, 1):
        text = files.get(file) or (root / file).read_text()
        with_fault = applied(text, number, old, new)
        if with_fault is None:
            STALE.add(number)
        files[file] = with_fault or text
    for file, text in files.items():
        first = "#pragma once\n" if text.startswith("#pragma once\n") else ""
        (root / file).write_text(first + '#include "tests/mutation/fault.h"\n' + text[len(first):])


def build(work, jobs):
    run = lambda *command: subprocess.run(command, cwd=work, check=True, stdout=sys.stderr)
    if not (work / "build/release/build.ninja").exists():
        run("cmake", "--preset", "release")
    run("ninja", "-C", "build/release", *jobs, "isect", "test_figures", "test_lessons")


def run_with(work, number, command, **more):
    environment = dict(os.environ, ISECT_FAULT=str(number), **more)
    return subprocess.run(command, cwd=work, env=environment, capture_output=True, text=True, timeout=900)


def noticed(work, number, by):
    """By what the fault is noticed, and the first words about it; None if it is not."""
    bin_folder = "build/release/bin"
    if by == "svg":
        result = run_with(work, number, ["build/release/tests/test_figures"])
        if result.returncode == 0:
            return None
        measured = re.search(r"with expansion:\n\s*(.*)", result.stdout)
        return "agreement", measured.group(1) if measured else "failed"
    if by.startswith("words "):
        units = sorted(path.stem for path in (ROOT / "tests/lessons").glob("*_words_test.cpp"))
        tests = ",".join(["[every lesson]"] + [f"[#{unit}]" for unit in units])
        result = run_with(work, number, ["build/release/tests/test_lessons", "-#", tests], ISECT_LESSON=by.split()[1])
        if result.returncode == 0:
            return None
        failed = re.search(r"(?:FAILED:|failed.*)\n(?:.*\n){0,2}?\s*(\S.*)", result.stdout)
        return "words", failed.group(1).strip() if failed else "failed"
    lesson, *preset = by.split()
    command = [f"{bin_folder}/isect", "check", lesson, "--json"] + [w for p in preset for w in ("--preset", p)]
    result = run_with(work, number, command)
    if result.returncode == 0:
        return None
    try:
        failures = json.loads(result.stdout)["failures"]
    except json.JSONDecodeError:
        return "error", (result.stderr or result.stdout).strip()[:100]
    kinds = sorted({f["kind"] for f in failures}, reverse=True)
    first = next((f for f in failures if f["kind"] == "trace"), failures[0])
    at = f"step {first['step']}: " if "step" in first else ""
    return " + ".join(kinds), at + first["what"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--work", type=pathlib.Path, help="scratch folder; kept, so that a second run builds little")
    parser.add_argument("--only", help="numbers of faults")
    parser.add_argument("--jobs", default="", help="for ninja, such as -l3")
    parser.add_argument("--list", action="store_true", help="the faults alone")
    options = parser.parse_args()
    if options.list:
        for number, fault in enumerate(FAULTS, 1):
            print(f"{number:3} {fault[0]} ({fault[1]})")
        return 0
    work = options.work or pathlib.Path(tempfile.mkdtemp(prefix="isect-faults-"))
    work.mkdir(parents=True, exist_ok=True)
    copy_sources(work)
    build(work, options.jobs.split())

    wanted = [int(n) for n in options.only.split(",")] if options.only else range(1, len(FAULTS) + 1)
    for by in sorted({FAULTS[n - 1][4] for n in wanted}):
        found = noticed(work, 0, by)
        if found:
            print(f"without any fault, {by} fails already: {found[0]}: {found[1]}")
            return 1
    missed = []
    for number in wanted:
        what, _, _, _, by = FAULTS[number - 1]
        found = ("stale", "its text has changed") if number in STALE else noticed(work, number, by)
        if found is None or found[0] in ("stale", "error"):
            missed.append(number)
        print(f"{number:3} {what:48} {found[0] if found else 'NOT CAUGHT':16} {found[1][:110] if found else ''}", flush=True)
    print(f"{len(wanted) - len(missed)} of {len(wanted)} caught")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
