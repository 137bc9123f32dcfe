#!/usr/bin/env python3
"""Runs the steps of examples/ci/figures.yml as GitHub would, in a repository of its own: figures pass, change, are
reviewed and accepted. What needs a network (fetching actions, the image) is left out.
   figures.py ISECT ROOT SCRATCH
Exit status 77: there is no git."""
import html
import json
import os
import re
import shutil
import subprocess
import sys

isect, root, scratch = (os.path.abspath(word) for word in sys.argv[1:4])
work, summary = os.path.join(scratch, "work"), os.path.join(scratch, "summary.md")


def steps(path):
    """The `run:` lines of a workflow's jobs, in order: {job: [script]}. Enough of YAML for our own files."""
    found, job, in_jobs = {}, None, False
    lines = open(path, encoding="utf-8").read().split("\n")
    for i, line in enumerate(lines):
        if re.fullmatch(r"\w+:.*", line):
            in_jobs = line == "jobs:"
        elif in_jobs and re.fullmatch(r"  \w+:", line):
            job = line.strip()[:-1]
            found[job] = []
        elif in_jobs and (at := re.fullmatch(r"( +(?:- )?)run: (.*)", line)):
            script = at.group(2)
            if script == "|":
                deeper = len(at.group(1)) + 2
                block = []
                for below in lines[i + 1:]:
                    if below.strip() and len(below) - len(below.lstrip()) < deeper:
                        break
                    block.append(below[deeper:])
                script = "\n".join(block)
            found[job].append(script)
    return found


def must(condition, what):
    if not condition:
        sys.exit("wrong: " + what)


def git(*words, cwd=work):
    return subprocess.run(["git", "-c", "user.name=A", "-c", "user.email=a@example.org", *words], cwd=cwd, check=True,
                          capture_output=True, text=True).stdout


def run(scripts, **more):
    """Runs the steps up to the first that fails; returns the last status and all that was printed."""
    env = dict(os.environ, PATH=os.path.dirname(isect) + ":" + os.environ["PATH"], CI="true", GITHUB_ACTIONS="true",
               GITHUB_WORKSPACE=work, GITHUB_ACTOR="somebody", RUNNER_TEMP=scratch, HOME=scratch, FIGURES="figures",
               GITHUB_STEP_SUMMARY=summary, **more)
    printed = ""
    for script in scripts:
        must("${{" not in script, "a script contains an expression, whose value could be a command: " + script)
        ran = subprocess.run(["sh", "-e", "-c", script], cwd=work, env=env, capture_output=True, text=True)
        printed += ran.stdout + ran.stderr
        if ran.returncode != 0:
            return ran.returncode, printed
    return 0, printed


def preset(value):
    with open(os.path.join(work, "figures", "a.json"), "w", encoding="utf-8") as file:
        json.dump({"lesson": "intervals", "preset": "touching", "parameters": {"b_max": value},
                   "guard": [{"theme": "print", "format": "svg"}]}, file)


def ticked(page):
    """The text of accept.json when everything is ticked."""
    lists = re.findall(r'data-accept="([^"]*)"', page)
    return json.dumps({"accept": [entry for one in lists for entry in json.loads(html.unescape(one))]})


def needed_packages():
    """The packages that the image lacks for the program, as far as this system can say; it must be the image's own."""
    image = open(os.path.join(root, "examples/ci/Containerfile"), encoding="utf-8").read()
    release = "/etc/debian_version"
    tools = all(shutil.which(tool) for tool in ("readelf", "dpkg-query"))
    if not tools or not os.path.exists(release) or not open(release).read().startswith("12"):
        return []
    there = set(re.findall(r"[a-z0-9][a-z0-9.+-]+", image.split("FROM")[-1])) | {"libc6", "libgcc-s1", "libstdc++6"}
    dynamic = subprocess.run(["readelf", "-d", isect], capture_output=True, text=True, check=True).stdout
    lacking = []
    for library in re.findall(r"NEEDED.*\[(.*)\]", dynamic):
        if re.match(r"lib(a|ub|l|t)san", library):
            continue
        owners = subprocess.run(["dpkg-query", "-S", "*/" + library], capture_output=True, text=True).stdout
        packages = {line.split(":")[0] for line in owners.splitlines()}
        if packages and not packages & there:
            lacking.append(f"{library} of {sorted(packages)}")
    return lacking


if not shutil.which("git"):
    print("skipped: there is no git")
    sys.exit(77)
shutil.rmtree(scratch, ignore_errors=True)
os.makedirs(os.path.join(work, "figures"))
jobs = steps(os.path.join(root, "examples/ci/figures.yml"))
must(list(jobs) == ["check", "accept"] and len(jobs["check"]) == 1 and len(jobs["accept"]) == 3,
     f"the jobs and their steps are {jobs}")

git("init", "-q", "--bare", "origin", cwd=scratch)
git("init", "-q", "-b", "main")
preset(4)
subprocess.run([isect, "check", "--dir", "figures", "--update=missing"], cwd=work, check=True, capture_output=True)
git("add", "-A")
git("commit", "-qm", "Figures")
git("push", "-q", "-u", os.path.join(scratch, "origin"), "main")
git("remote", "add", "origin", os.path.join(scratch, "origin"))
git("fetch", "-q", "origin")
git("branch", "-q", "--set-upstream-to=origin/main")

status, printed = run(jobs["check"])
must(status == 0 and "ok: 10 pictures of 1 preset" in printed, f"good figures: the check ends with {status}: {printed}")

preset(5)
status, printed = run(jobs["check"])
must(status == 1 and printed.count("::error ") == 1, f"changed figures: the check ends with {status}: {printed}")
must(os.path.exists(os.path.join(work, "check.xml")), "there is no check.xml")
must("10 pictures and 1 trace" in open(summary, encoding="utf-8").read(), "the summary lacks the cause")
page = open(os.path.join(work, "check.html"), encoding="utf-8").read()
git("commit", "-qam", "Another figure")
git("push", "-q")

# On the service the accepting job begins with a fresh copy.
shutil.rmtree(work)
git("clone", "-q", "-b", "main", "origin", "work", cwd=scratch)
status, printed = run(jobs["accept"], ACCEPT=ticked(page))
must(status == 0 and "11 of 11 accepted" in printed, f"accepting ends with {status}: {printed}")
shutil.rmtree(work)
git("clone", "-q", "-b", "main", "origin", "work", cwd=scratch)
must(git("log", "-1", "--format=%s").strip() == "Accept reviewed figures", "nothing was pushed")
status, printed = run(jobs["check"])
must(status == 0, f"after accepting the check ends with {status}: {printed}")
other = {"file": "intervals/a/trace.json", "digest": "0123456789abcdef"}
status, printed = run(jobs["accept"], ACCEPT=json.dumps({"accept": [other]}))
must(status == 1 and "REFUSED" in printed, f"accepting something else ends with {status}: {printed}")

lacking = needed_packages()
must(not lacking, "the image lacks " + ", ".join(lacking))
shutil.rmtree(scratch)
print("all steps of examples/ci/figures.yml did what they should")
