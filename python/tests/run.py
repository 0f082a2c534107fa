"""Runs the tests of the Python package against a build: `run.py LIBRARY PYTHON [RESULTS.json]`.

PYTHON has what they need (requirements.txt); if it is not there they are skipped. Results are written as GoogleTest has them, for
the summary of `./dev test`."""

import json
import os
import pathlib
import subprocess
import sys
import time
import unittest

HERE = pathlib.Path(__file__).resolve().parent


class Recorder(unittest.TextTestResult):
    """Keeps what became of each test."""

    def __init__(self, *arguments, **named):
        super().__init__(*arguments, **named)
        self.cases = []
        self._begun = 0.0

    def startTest(self, test):
        super().startTest(test)
        self._begun = time.time()
        self._trouble = []
        self._skipped = None

    def stopTest(self, test):
        super().stopTest(test)
        case = {"name": test.id(), "time": f"{time.time() - self._begun:.3f}s"}
        case["result"] = "COMPLETED" if self._skipped is None else "SKIPPED"
        if self._trouble:
            case["failures"] = [{"failure": text} for text in self._trouble]
        self.cases.append(case)

    def addError(self, test, err):
        super().addError(test, err)
        if hasattr(self, "_trouble"):
            self._trouble.append(self.errors[-1][1])

    def addFailure(self, test, err):
        super().addFailure(test, err)
        self._trouble.append(self.failures[-1][1])

    def addSubTest(self, test, subtest, err):
        super().addSubTest(test, subtest, err)
        if err is not None:
            self._trouble.append(str(err[1]))

    def addSkip(self, test, reason):
        super().addSkip(test, reason)
        self._skipped = reason


def write(results, cases):
    if results:
        pathlib.Path(results).write_text(json.dumps({"testsuites": [{"name": "python", "testsuite": cases}]}))


def run(results):
    suite = unittest.defaultTestLoader.discover(str(HERE), pattern="test_*.py")
    outcome = unittest.TextTestRunner(resultclass=Recorder, verbosity=2).run(suite)
    write(results, outcome.cases)
    return 0 if outcome.wasSuccessful() else 1


def main():
    library, python, *rest = sys.argv[1:]
    results = rest[0] if rest else ""
    gtest = os.environ.get("GTEST_OUTPUT", "")
    if not results and gtest.startswith("json:"):
        target = gtest.removeprefix("json:")
        results = target + "python.json" if target.endswith("/") else target
    if os.environ.get("AJAR_TESTING_PYTHON") == "1":
        return run(results)
    if not os.path.exists(python):
        print(f"skipped: there is no {python}, which `./dev test` makes where Python's registry can be reached")
        write(results, [{"name": "python", "result": "SKIPPED"}])
        return 77
    environment = dict(os.environ, AJAR_TESTING_PYTHON="1", AJAR_LIBRARY=library, PYTHONPATH=str(HERE.parent))
    return subprocess.run([python, __file__, library, python, results], env=environment, check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
