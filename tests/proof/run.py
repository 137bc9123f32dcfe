#!/usr/bin/env python3
"""The long proof: many times the cases of an ordinary run, all on one commit. The report tells what came of it.

    tests/proof/run.py [PART...] [--cases N] [--minutes N] [--jobs N] [--build DIR] [--out FILE]

Parts; all but `again` and `pairs`, if none is named, one after the other:

    verdicts   the exact calls of every suite against its oracle in rational arithmetic, N cases in all (100 million)
    tests      every test with ISECT_LONG=1, N at a time (1)
    again      those that failed, once they were mended: for a test that asked too much; not part of all
    pairs      a million pairs of objects of random scenes, judged by rationals; not part of all
    fuzz       each fuzz target for N minutes (30); fuzz:query, fuzz:cases or fuzz:polygon is one of them
    gather     what the parts found, written to FILE (bench/proof.json), if all are there and of one commit, or of commits
               that differ in neither core/ nor app/

All of it takes some three hours of processor time. Parts may run side by side. What they found is kept under DIR/proof
(DIR is build/release), with the commit that it is of. Exit: 0 all is well; 1 something was wrong; 2 the sources have
changes that no commit has, or a part is missing.
"""

import argparse
import collections
import datetime
import json
import os
import pathlib
import re
import subprocess
import sys
import time
import xml.etree.ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
TARGETS = ["query", "cases", "polygon"]


def commit():
    def git(*words):
        return subprocess.run(["git", "-C", ROOT, *words], check=True, capture_output=True, text=True).stdout.strip()

    if changed := git("status", "--porcelain"):
        sys.exit(refused(f"changes that no commit has; commit them first:\n{changed}"))
    return git("rev-parse", "HEAD")[:12]


def refused(why):
    print(f"proof: {why}", file=sys.stderr)
    return 2


def said(what):
    print(f"proof: {what}", file=sys.stderr, flush=True)


def verdicts(build, cases):
    """Rounds over all suites, each with a seed of its own, until there are as many cases as asked for."""
    subprocess.run(["cmake", "--build", build, "--target", "measure"], check=True, stdout=sys.stderr)
    programs = sorted((build / "bin" / "measure").iterdir())
    found, seed, wrong = collections.Counter(), 0, []
    judged = collections.Counter()
    while found.total() < cases and not wrong:
        seed += 1
        for program in programs:
            run = subprocess.run([program, "--verdicts", "--seed", str(seed)], check=True, stdout=subprocess.PIPE,
                                 stderr=subprocess.DEVNULL, text=True)
            drawn = {}  # a family is drawn once, however many exact calls answer it
            for row in json.loads(run.stdout)["rows"]:
                test = row["test"].split(",")[0]
                drawn[row["test"], row["scalar"], row["family"]] = test, row["judged"]
                judged[test] += row["judged"]
                if row["false_yes"] + row["false_no"]:
                    wrong.append(f"{row['test']}, {row['method']}, {row['scalar']}: {row['first_wrong']}")
            for test, count in drawn.values():
                found[test] += count
        said(f"seed {seed}: {found.total():,} cases, {len(wrong)} wrong")
    for line in wrong:
        said(f"wrong: {line}")
    tests = [{"test": test, "cases": found[test], "judged": judged[test]} for test in found]
    return {"seeds": seed, "cases": found.total(), "judged": judged.total(), "wrong": len(wrong), "tests": tests}


def same_program(one, other):
    """Whether two commits differ in neither core/ nor app/."""
    differ = ["git", "-C", ROOT, "diff", "--quiet", one, other, "--", "core", "app"]
    return subprocess.run(differ).returncode == 0


def tests(build, jobs, *options):
    subprocess.run(["cmake", "--build", build], check=True, stdout=sys.stderr)
    told = build / "proof" / "tests.xml"
    start = time.monotonic()
    subprocess.run(["ctest", "--test-dir", build, "-j", str(jobs), "--output-junit", told, "--timeout", "7200",
                    "--output-on-failure", *options], env=os.environ | {"ISECT_LONG": "1"}, stdout=sys.stderr)
    suite = xml.etree.ElementTree.parse(told).getroot()
    failed, skipped = int(suite.get("failures")), int(suite.get("skipped")) + int(suite.get("disabled"))
    for case in suite.iter("testcase"):
        if case.get("status") not in ("run", "notrun", "disabled"):
            said(f"failed: {case.get('name')}")
    return {"run": int(suite.get("tests")) - skipped, "skipped": skipped, "wrong": failed,
            "seconds": round(time.monotonic() - start)}


def again(build, jobs, kept, of):
    before = json.loads((kept / "tests.json").read_text())
    if not same_program(before["commit"], of):
        sys.exit(refused(f"core/ or app/ has changed since the tests were run on {before['commit']}; run them all"))
    now = tests(build, jobs, "--rerun-failed")
    if now["run"] < before["wrong"]:
        sys.exit(refused(f"{before['wrong']} tests had failed, and {now['run']} were run"))
    return before | {"wrong": now["wrong"], "again": before.get("again", 0) + now["run"],
                     "seconds": before["seconds"] + now["seconds"], "commit": of}


def pairs(build):
    subprocess.run(["cmake", "--build", build, "--target", "scene_pairs"], check=True, stdout=sys.stderr)
    run = subprocess.run([build / "tests" / "scene_pairs"], env=os.environ | {"ISECT_LONG": "1"},
                         stdout=subprocess.PIPE, text=True)
    sys.stderr.write(run.stdout)
    asked, wrong, undecided = map(int, re.search(r"^all +(\d+) +(\d+) +(\d+)$", run.stdout, re.MULTILINE).groups())
    return {"asked": asked, "wrong": wrong + undecided}


def fuzz(target, minutes):
    program = f"{target}_fuzz"
    log = ROOT / "build" / "fuzz" / f"{program}.log"
    run = subprocess.run([ROOT / "tests/fuzz/run.sh", str(60 * minutes), program])
    inputs = re.search(r"number_of_executed_units: *(\d+)", log.read_text())
    return {"target": target, "minutes": minutes, "inputs": int(inputs[1]) if inputs else 0,
            "wrong": int(run.returncode != 0)}


def gather(kept, out):
    names = ["verdicts", "tests", *(f"fuzz-{target}" for target in TARGETS)]
    files = {name: kept / f"{name}.json" for name in names}
    if missing := [name for name in names if not files[name].exists()]:
        return refused(f"not run yet: {', '.join(missing)}")
    found = {name: json.loads(file.read_text()) for name, file in files.items()}
    commits = {name: part.pop("commit") for name, part in found.items()}
    if not all(same_program(commits["tests"], of) for of in commits.values()):
        return refused("run on commits that differ in core/ or app/: " +
                       ", ".join(f"{name} on {of}" for name, of in commits.items()))
    last = max(file.stat().st_mtime for file in files.values())
    whole = {"commit": commits["tests"], "date": datetime.date.fromtimestamp(last).isoformat(),
             "verdicts": found["verdicts"], "tests": found["tests"],
             "fuzz": [found[f"fuzz-{target}"] for target in TARGETS]}
    out.write_text(json.dumps(whole, indent=1) + "\n")
    return 0


def main():
    known = ["verdicts", "tests", *(f"fuzz:{t}" for t in TARGETS), "gather"]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("parts", nargs="*", metavar="PART")
    parser.add_argument("--cases", type=int, default=100_000_000)
    parser.add_argument("--minutes", type=int, default=30)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "bench" / "proof.json")
    args = parser.parse_args()
    parts = [p for part in args.parts or known for p in (known[2:-1] if part == "fuzz" else [part])]
    if unknown := [p for p in parts if p not in [*known, "again", "pairs"]]:
        parser.error(f"unknown PART {unknown[0]}; there are: {' '.join(known)} fuzz again pairs")

    kept, wrong = args.build / "proof", 0
    of = commit() if parts != ["gather"] else None
    kept.mkdir(parents=True, exist_ok=True)
    for part in parts:
        if part == "gather":
            return gather(kept, args.out) or int(wrong > 0)
        said(part)
        if part == "verdicts":
            found = verdicts(args.build, args.cases)
        elif part == "tests":
            found = tests(args.build, args.jobs)
        elif part == "again":
            part, found = "tests", again(args.build, args.jobs, kept, of)
        elif part == "pairs":
            found = pairs(args.build)
        else:
            found = fuzz(part.removeprefix("fuzz:"), args.minutes)
        wrong += found["wrong"]
        (kept / f"{part.replace(':', '-')}.json").write_text(json.dumps({"commit": of} | found))
    return int(wrong > 0)


if __name__ == "__main__":
    sys.exit(main())
