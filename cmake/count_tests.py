"""Closes a run of CTest with one line, N passed, N failed, N skipped: `count_tests.py FOLDER STATUS`.

FOLDER has the results that GoogleTest wrote as JSON, STATUS is how CTest ended."""
import glob
import json
import sys


def main(folder, status):
    passed = failed = skipped = 0
    for path in glob.glob(folder + "/*.json"):
        with open(path, encoding="utf-8") as file:
            suites = json.load(file)["testsuites"]
        for case in (case for suite in suites for case in suite["testsuite"]):
            if case.get("failures"):
                failed += 1
            elif case.get("result") == "SKIPPED":
                skipped += 1
            elif case.get("result") == "COMPLETED":
                passed += 1
    # A test program that crashed leaves no results behind, but must not go unnoticed.
    if status != 0 and failed == 0:
        failed = 1
    print(f"{passed} passed, {failed} failed, {skipped} skipped")
    return 1 if failed or passed == 0 else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], int(sys.argv[2])))
