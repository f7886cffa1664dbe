# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Utilities/check-tests.py on results as CTest writes them, and on those of a CTest run here."""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCRIPT = ROOT / "Utilities" / "check-tests.py"

RESULTS = """<?xml version="1.0" encoding="UTF-8"?>
<testsuite name="Linux-c++" tests="4" failures="0" disabled="0" skipped="{skipped}" hostname="">
  <testcase name="Cxx-TestOne" classname="Cxx-TestOne" time="1" status="run">
    <system-out>fine</system-out>
  </testcase>
  <testcase name="Python-TestTwo" classname="Python-TestTwo" time="1" status="run"/>
  {third}
  {fourth}
</testsuite>
"""
RAN = '<testcase name="{0}" classname="{0}" time="1" status="run"/>'
SKIPPED = """<testcase name="{0}" classname="{0}" time="0" status="notrun">
    <skipped message="SKIP_RETURN_CODE=125"/>
  </testcase>"""
DISABLED = '<testcase name="{0}" classname="{0}" time="0" status="disabled"/>'

LOG = """Start testing: Jan 01 00:00 UTC
----------------------------------------------------------
1/4 Testing: Cxx-TestOne
1/4 Test: Cxx-TestOne
Output:
fine
<end of output>
2/4 Testing: Python-TestTwo
2/4 Test: Python-TestTwo
Output:
----------------------------------------------------------
..s
Ran 3 tests in 0.001s

{result}
<end of output>
"""

# A test that runs, one that is skipped, and one that skips two of its cases.
CTEST = """
add_test(Runs "{true}")
add_test(Cases "{python}" -c "print('OK (skipped=2)')")
add_test(Skips "{false}")
set_tests_properties(Skips PROPERTIES SKIP_RETURN_CODE 1)
"""


class TestCheckTests(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")
        return self.folder / name

    def check(self, results, *options):
        done = subprocess.run([sys.executable, SCRIPT, results, *options], capture_output=True,
                              text=True, timeout=60)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        self.assertEqual(done.returncode == 0, done.stderr == "")
        return done.stdout, done.stderr.splitlines()

    def make(self, third=RAN, fourth=RAN):
        return self.write("results.xml", RESULTS.format(
            skipped=(third != RAN) + (fourth != RAN), third=third.format("ParaView-TestThree"),
            fourth=fourth.format("Fuzz-Four")))

    def test_all_ran(self):
        minimum = self.write("minimum.txt", "# What it is.\n4\n")
        self.assertEqual(self.check(self.make(), "--minimum", minimum),
                         ("4 of 4 tests ran\n", []))

    def test_skipped(self):
        self.assertEqual(
            self.check(self.make(SKIPPED)),
            ("3 of 4 tests ran\n",
             ["error: ParaView-TestThree did not run: SKIP_RETURN_CODE=125"]))
        self.assertEqual(self.check(self.make(SKIPPED, DISABLED))[1][1:],
                         ["error: Fuzz-Four did not run: disabled"])

    def test_may_skip(self):
        minimum = self.write("minimum.txt", "4\n")
        options = ("--may-skip", "ParaView-", "--minimum", minimum)
        self.assertEqual(self.check(self.make(SKIPPED), *options), ("3 of 4 tests ran\n", []))
        self.assertEqual(self.check(self.make(SKIPPED, SKIPPED), *options)[1],
                         ["error: Fuzz-Four did not run: SKIP_RETURN_CODE=125",
                          "error: 3 tests, where there have been 4"])

    def test_minimum(self):
        minimum = self.write("minimum.txt", "5\n")
        self.assertEqual(self.check(self.make(), "--minimum", minimum)[1],
                         ["error: 4 tests, where there have been 5"])
        none = self.write("none.xml", "<testsuite/>")
        self.assertEqual(self.check(none)[1], ["error: 0 tests, where there have been 1"])

    def test_skipped_cases(self):
        for result, errors in (("OK", []), ("OK (skipped=2)", [2]),
                               ("OK (expected failures=1, skipped=12)", [12])):
            log = self.write("LastTest.log", LOG.format(result=result))
            self.assertEqual(self.check(self.make(), "--log", log)[1],
                             [f"error: Python-TestTwo skipped {n} of its cases" for n in errors])
        self.assertEqual(
            self.check(self.make(), "--log", log, "--may-skip", "TestTwo")[1], [])

    def test_ctest(self):
        """What this CTest writes is read."""
        self.write("CTestTestfile.cmake", CTEST.format(
            true=shutil.which("true"), false=shutil.which("false"), python=sys.executable))
        subprocess.run(["ctest", "--output-junit", "results.xml"], cwd=self.folder, check=True,
                       stdout=subprocess.DEVNULL, timeout=60)
        self.assertEqual(
            self.check(self.folder / "results.xml", "--log",
                       self.folder / "Testing" / "Temporary" / "LastTest.log"),
            ("2 of 3 tests ran\n", ["error: Skips did not run: SKIP_RETURN_CODE=1",
                                    "error: Cases skipped 2 of its cases"]))

    def test_kept_number(self):
        """The file that Utilities/test.sh passes is read."""
        errors = self.check(self.make(), "--minimum", ROOT / "Testing" / "minimum-tests.txt")[1]
        self.assertRegex(errors[0], r"^error: 4 tests, where there have been \d{3}$")


if __name__ == "__main__":
    unittest.main(argv=[__file__])
