#!/usr/bin/env python3
"""What score.py says of a program that is right, and of programs that err, die, hang, rave or lose the order.

    score_test.py ISECT
"""

import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).parent

# Two balls as many a program asks: wrong where a square overflows, vanishes or is rounded.
NAIVE = """
import json, sys
for line in sys.stdin:
    r = json.loads(line)
    if r.get("kind") != "sphere_sphere":
        print(json.dumps({"id": r["id"], "error": "only balls"}))
        continue
    c1, r1, c2, r2 = r["c1"], float(r["r1"]), r["c2"], float(r["r2"])
    try:
        meet = sum((float(p) - float(q)) ** 2 for p, q in zip(c1, c2)) <= (r1 + r2) ** 2
    except OverflowError:
        meet = False
    print(json.dumps({"id": r["id"], "result": {"intersects": meet}}))
"""
ECHO = "import json, sys\nfor i, line in enumerate(sys.stdin): %s"


def scored(program, *options):
    """The exit status and the lines of the table."""
    run = subprocess.run([sys.executable, HERE / "score.py", *options, *program], capture_output=True, text=True, timeout=500)
    return run.returncode, run.stdout.splitlines()


def of_python(text, *options):
    return scored([sys.executable, "-c", text], "--cases", HERE / "sphere_sphere.json", "--limit", "2", *options)


def expect(condition, what, told):
    if not condition:
        sys.exit(f"{what}\n" + "\n".join(told))


def main():
    status, told = scored([sys.argv[1], "query"])
    expect(status == 0 and told[-1] == "0 wrong. ", "isect query is right", told)
    expect(all(line.split()[-1] == "right" for line in told[:-1]), "and can be asked everything", told)

    status, told = of_python(NAIVE)
    # A sum that overflows, vanishes or is rounded; and no ball where a radius is negative or no number.
    expect(status == 1 and told[-1] == "14 wrong. " and told[0].split() == ["sphere_sphere", "71", "right", "14", "wrong"],
           "naive balls are wrong 14 times", told)
    hard = ("vanishes", "different points", "empty ball", "1e-300 beside", "decimal", "scale", "touch", "invalid")
    expect(all(any(h in line for h in hard) for line in told if line.startswith("wrong:")), "where it is hard", told)
    status, told = scored([sys.executable, "-c", NAIVE], "--cases", HERE / "capsule_capsule.json")
    expect(status == 0 and "67 cannot be asked" in told[0], "what cannot be asked is not wrong", told)

    for text, what in {
        "": "it ended after 0 of 85",
        "print('{\"id\": 0, \"error\": \"\"}')": "it ended after 1 of 85",
        "import time; time.sleep(60)": "it hangs: 2 s",
        "import subprocess; subprocess.Popen(['sleep', '60'])": "it hangs: 2 s",
        "print('Hello')": "answer 0 is no JSON",
        "print('[' * 100000)": "answer 0 is no JSON",
        "print(7)": "answer 0 is no JSON",
        "import sys; sys.stdout.buffer.write(bytes(3000000))": "answer 0 is no JSON",
        ECHO % "print(json.dumps({'id': 84 - i, 'error': ''}))": "out of order",
        ECHO % "print(json.dumps({'id': i, 'error': ''}) * (1 + i // 84))": "answer 84 is no JSON",
        ECHO % "print('\\n'.join([json.dumps({'id': i, 'error': ''})] * (1 + i // 84)))": "it answers more than it was asked",
    }.items():
        status, told = of_python(text)
        expect(status == 1 and what in told[-1], f"{text}: {what}", told)
    status, told = of_python(ECHO % "print(line, end='')")
    expect(status == 1 and told[-1] == "80 wrong. ", "neither a result nor an error is wrong", told)


if __name__ == "__main__":
    main()
