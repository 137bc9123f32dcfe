#!/usr/bin/env python3
"""Scores a program on the hard cases: what it answers rightly, kind by kind and pair by pair.

    score.py [--limit SECONDS] [--cases PATH]... PROGRAM [ARGUMENT]...

PROGRAM reads requests on standard input and writes answers on standard output, one a line, in their order, as `isect
query` does: {"id": ..., "result": {...}}, or {"id": ..., "error": "why"} to what it cannot be asked. Fields that it leaves
out do not count. PATH: a file or a folder, this script's if none is given. Exit status 1 where one is wrong or missing.
"""
import argparse, collections, contextlib, itertools, json, math, os, pathlib, queue, signal, subprocess, sys, tempfile, threading


def cases_in(path):
    """(row of the table, request, truth) of each case."""
    for file in sorted(path.rglob("*.json*")) if path.is_dir() else [path]:
        text = file.read_text(encoding="utf-8")
        whole = {"cases": map(json.loads, text.splitlines())} if file.suffix == ".jsonl" else json.loads(text)
        for case in whole["cases"]:
            types = ", ".join(sorted(next(iter(o)) for o in case.get("objects", [])))
            yield f"{file.stem}: {types}" if types else case.setdefault("kind", whole.get("kind")), case, case.pop("expected")


def answers(program, requests, limit):
    """The answer to each request; then, or instead of the rest, a text that says what the program did wrong."""
    asked, lines = tempfile.TemporaryFile(), queue.Queue()
    asked.writelines(json.dumps(request).encode() + b"\n" for request in requests), asked.seek(0)
    process = subprocess.Popen(program, stdin=asked, stdout=subprocess.PIPE, start_new_session=True)
    read = itertools.chain(iter(lambda: process.stdout.readline(1 << 20), b""), [None])
    threading.Thread(target=lambda: [lines.put(line) for line in read], daemon=True).start()
    try:
        for number, request in enumerate(requests):
            if (line := lines.get(timeout=limit)) is None:
                return (yield f"it ended after {number} of {len(requests)} answers")
            if (answer := json.loads(line))["id"] != request["id"]:
                return (yield f"out of order: answer {number} is not of id {request['id']}: {line[:80]!r}")
            yield answer
        if lines.get(timeout=limit) is not None:
            yield "it answers more than it was asked"
    except queue.Empty:
        yield f"it hangs: {limit:g} s without a line or its end"
    except (ValueError, TypeError, LookupError, RecursionError):
        yield f"answer {number} is no JSON of an answer: {line[:80]!r}"
    finally:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)  # and what it started


def compared(truth, given, floats, name="result"):
    """(field, whether it is right) of all fields that both have; numbers within 4 ulp, a normal's within 4 of 1."""
    number = lambda x: float(x) if type(x) in (int, float) or x in ("inf", "-inf") else None
    if isinstance(truth, dict) and isinstance(given, dict):
        for key in truth.keys() & given.keys():
            yield from compared(truth[key], given[key], floats, key)
    elif isinstance(truth, list) and isinstance(given, list) and len(truth) == len(given) > 0:
        for t, g in zip(truth, given):
            yield from compared(t, g, floats, name)
    elif isinstance(truth, (dict, list)) or (t := number(truth)) is None or (g := number(given)) is None:
        yield name, truth == given and type(truth) is type(given)
    else:
        unit = math.ulp(1.0 if name == "normal" else t)
        unit = max(unit * 2.0**29, 2.0**-149) if floats else unit
        beyond = floats and g == math.copysign(math.inf, t) and abs(t) >= 2.0**128  # what no float is
        yield name, t == g or beyond or abs(t - g) <= 4 * unit


def judged(request, truth, answer):
    """A column of the table, and the fields that are wrong."""
    if "policy" in truth:  # the input has no meaning: an error or a plain no is right
        truth = dict.fromkeys(("intersects", "hit", "ray_hit", "equal"), False)
        answer = {"result": truth, **answer}
    refuses = "error" in answer and "result" not in answer
    fields = [] if refuses else list(compared(truth, answer.get("result"), request.get("scalar") == "f32"))
    wrong = sorted({name for name, right in fields if not right})
    return "wrong" if wrong else "right" if fields else "cannot be asked", wrong


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("--limit", type=float, default=60)
    parser.add_argument("--cases", type=pathlib.Path, action="append", default=[])
    parser.add_argument("program", nargs="...")
    options = parser.parse_args()
    cases = [case for path in options.cases or [pathlib.Path(__file__).parent] for case in cases_in(path)]
    requests = [{**request, "id": number} for number, (_, request, _) in enumerate(cases)]
    table, wrong, fault = collections.defaultdict(collections.Counter), [], ""
    for case, request, answer in itertools.zip_longest(cases, requests, answers(options.program, requests, options.limit)):
        fault = answer if isinstance(answer, str) else fault
        if case:
            column, fields = judged(request, case[2], answer) if isinstance(answer, dict) else ("unanswered", [])
            table[case[0]][column] += 1
            wrong += [{"fields": fields, "asked": request, "answered": answer, "expected": case[2]}] if fields else []
    for row, counts in {**table, "all": sum(table.values(), collections.Counter())}.items():
        print(f"{row:32}", *(f"{count:6} {column}" for column, count in sorted(counts.items())))
    print(*(f"wrong: {json.dumps(w)}" for w in wrong[:20]), f"{len(wrong)} wrong. {fault}", sep="\n")
    return 1 if wrong or fault else 0


if __name__ == "__main__":
    sys.exit(main())
