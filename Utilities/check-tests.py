#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that no test was skipped that should have run. CTest counts skipped tests as passed.

Reads the file of ctest --output-junit and, for skipped cases inside Python tests, LastTest.log.
Exits with 1 and names the tests if one was skipped or not run without permission, or if fewer tests
ran than the recorded number.
"""

import argparse
import pathlib
import re
import sys
import xml.etree.ElementTree


def read_results(path):
    """{test: why it did not run, None if it ran}."""
    results = {}
    for case in xml.etree.ElementTree.parse(path).getroot().iter("testcase"):
        skipped = case.find("skipped")
        reason = None if skipped is None else skipped.get("message", "")
        if reason is None and case.get("status") in ("notrun", "disabled"):
            reason = case.get("status")
        results[case.get("name")] = reason
    return results


def read_skipped_cases(path):
    """{test: the number of its cases that Python's unittest skipped}, where there are any."""
    text = path.read_text(encoding="utf-8", errors="replace")
    blocks = re.split(r"^\d+/\d+ Testing: ", text, flags=re.MULTILINE)[1:]
    cases = {}
    for block in blocks:
        counts = re.findall(r"^OK \(.*?skipped=(\d+)", block, re.MULTILINE)
        if counts:
            cases[block.split("\n", 1)[0].strip()] = sum(map(int, counts))
    return cases


def read_minimum(path):
    lines = path.read_text(encoding="utf-8").splitlines()
    return int(" ".join(line for line in lines if not line.startswith("#")))


def find_problems(results, cases, may_skip, minimum):
    def may(name):
        return any(re.search(pattern, name) for pattern in may_skip)

    problems = [f"{name} did not run: {reason}"
                for name, reason in results.items() if reason is not None and not may(name)]
    problems += [f"{name} skipped {count} of its cases"
                 for name, count in cases.items() if not may(name)]
    # Tests that may be skipped are not missing.
    counted = sum(reason is None or may(name) for name, reason in results.items())
    if counted < minimum:
        problems.append(f"{counted} tests, where there have been {minimum}")
    return problems


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("results", type=pathlib.Path, help="what ctest --output-junit wrote")
    parser.add_argument("--log", type=pathlib.Path, help="ctest's LastTest.log of the same run")
    parser.add_argument("--minimum", type=pathlib.Path, help="a file with the kept number of tests")
    parser.add_argument("--may-skip", action="append", default=[], metavar="REGEX",
                        help="tests that this machine cannot run")
    options = parser.parse_args()
    results = read_results(options.results)
    cases = read_skipped_cases(options.log) if options.log else {}
    minimum = read_minimum(options.minimum) if options.minimum else 1
    problems = find_problems(results, cases, options.may_skip, minimum)
    ran = sum(reason is None for reason in results.values())
    print(f"{ran} of {len(results)} tests ran")
    for problem in problems:
        print(f"error: {problem}", file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
