#!/usr/bin/env python3
"""The long proof's own test: run.py in a repository of its own, with stand-ins for what it starts."""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

RUN = pathlib.Path(__file__).with_name("run.py")
COUNTED = """#!/bin/sh
echo '{"rows": [
 {"test": "ray-sphere", "method": "exact", "scalar": "double", "family": "far", "judged": 700, "false_yes": 0, "false_no": 0, "first_wrong": ""},
 {"test": "ray-sphere", "method": "yes or no", "scalar": "double", "family": "far", "judged": 700, "false_yes": WRONG, "false_no": 0, "first_wrong": "case 7"},
 {"test": "ray-sphere", "method": "exact", "scalar": "float", "family": "far", "judged": 300, "false_yes": 0, "false_no": 0, "first_wrong": ""}]}'
"""
FUZZED = """#!/bin/sh
mkdir -p build/fuzz
echo 'stat::number_of_executed_units: 42' >build/fuzz/$2.log
[ $2 != FAULTY_fuzz ]
"""
TESTED = """#!/bin/sh
while [ $1 != --output-junit ]; do shift; done
echo '<testsuite tests="9" failures="FAILED" skipped="1" disabled="1"><testcase name="a" status="run"/></testsuite>' >$2
"""


class Proof(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.root = pathlib.Path(kept.name)
        self.build = self.root / "build" / "release"
        (self.root / "tests" / "proof").mkdir(parents=True)
        (self.root / "bench").mkdir()
        shutil.copy(RUN, self.root / "tests" / "proof")
        self.program("bin/cmake", "#!/bin/sh\n")
        self.set()
        (self.root / ".gitignore").write_text("build\nbench/proof.json\n")
        self.git("init", "-q")
        self.commit()

    def program(self, path, text):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
        file.chmod(0o755)

    def set(self, wrong=0, faulty="none", failed=0):
        self.program("build/release/bin/measure/ray_sphere", COUNTED.replace("WRONG", str(wrong)))
        self.program("tests/fuzz/run.sh", FUZZED.replace("FAULTY", faulty))
        self.program("bin/ctest", TESTED.replace("FAILED", str(failed)))

    def git(self, *words):
        subprocess.run(["git", "-C", self.root, "-c", "user.name=a", "-c", "user.email=a@b", *words], check=True)

    def commit(self):
        self.git("add", "-A")
        self.git("commit", "-q", "--allow-empty", "-m", "one")

    def run_proof(self, *words):
        run = subprocess.run([sys.executable, self.root / "tests/proof/run.py", *words], cwd=self.root,
                             env=os.environ | {"PATH": f"{self.root / 'bin'}:{os.environ['PATH']}"},
                             capture_output=True, text=True)
        return run.returncode, run.stderr

    def test_all_parts_are_gathered(self):
        self.assertEqual(self.run_proof("--cases", "2500")[0], 0)
        whole = json.loads((self.root / "bench/proof.json").read_text())
        # 1,000 cases a seed: a case that two calls answer is one case, judged twice
        self.assertEqual(whole["verdicts"], {"seeds": 3, "cases": 3000, "judged": 5100, "wrong": 0, "tests": [
            {"test": "ray-sphere", "cases": 3000, "judged": 5100}]})
        self.assertEqual((whole["tests"]["run"], whole["tests"]["skipped"], whole["tests"]["wrong"]), (7, 2, 0))
        self.assertEqual(whole["fuzz"], [{"target": target, "minutes": 30, "inputs": 42, "wrong": 0}
                                         for target in ("query", "cases", "polygon")])

    def test_what_is_wrong_is_said(self):
        self.set(wrong=1)
        self.commit()
        code, said = self.run_proof("verdicts", "--cases", "2500")
        self.assertEqual(code, 1)
        self.assertIn("wrong: ray-sphere, yes or no, double: case 7", said)
        self.assertIn("seed 1: 1,000 cases, 1 wrong", said)  # and no seed after it
        self.assertNotIn("seed 2", said)
        self.set(faulty="cases", failed=2)
        self.commit()
        self.assertEqual(self.run_proof("fuzz:query")[0], 0)
        self.assertEqual(self.run_proof("fuzz")[0], 1)
        self.assertEqual(self.run_proof("tests")[0], 1)

    def test_gather_refuses_what_is_not_one_proof(self):
        code, said = self.run_proof("gather")
        self.assertEqual(code, 2)
        self.assertIn("not run yet: verdicts, tests, fuzz-query, fuzz-cases, fuzz-polygon", said)
        self.run_proof("verdicts", "fuzz", "--cases", "1")
        self.program("core/intersects.h", "true")
        self.commit()
        self.run_proof("tests")
        code, said = self.run_proof("gather")
        self.assertEqual(code, 2)
        self.assertIn("run on commits that differ in core/ or app/: verdicts on ", said)
        self.assertFalse((self.root / "bench/proof.json").exists())

    def test_tests_that_failed_are_run_again_once_mended(self):
        self.set(failed=2)
        self.commit()
        self.assertEqual(self.run_proof("tests")[0], 1)
        self.set()
        self.commit()
        self.assertEqual(self.run_proof("again")[0], 0)
        kept = json.loads((self.build / "proof/tests.json").read_text())
        self.assertEqual((kept["run"], kept["wrong"], kept["again"]), (7, 0, 7))
        head = subprocess.run(["git", "-C", self.root, "rev-parse", "HEAD"], capture_output=True, text=True).stdout
        self.assertTrue(head.startswith(kept["commit"]))
        self.program("app/main.cpp", "int main() {}")
        self.commit()
        code, said = self.run_proof("again")
        self.assertEqual(code, 2)
        self.assertIn("core/ or app/ has changed since", said)

    def test_a_change_beside_what_is_proved_needs_no_new_proof(self):
        self.run_proof("verdicts", "fuzz", "--cases", "1")
        self.commit()
        self.run_proof("tests")
        self.assertEqual(self.run_proof("gather")[0], 0)

    def test_changes_without_a_commit_and_unknown_parts_are_refused(self):
        (self.root / "new").write_text("new")
        code, said = self.run_proof("tests")
        self.assertEqual(code, 2)
        self.assertIn("changes that no commit has", said)
        code, said = self.run_proof("everything")
        self.assertEqual(code, 2)
        self.assertIn("unknown PART everything; there are: verdicts tests", said)


if __name__ == "__main__":
    unittest.main()
