"""Runs fuzz targets from their corpus, each for so many seconds: `run.py BUILD SECONDS [TARGET]`.

What is new stays in BUILD/found, crashes too: the corpus is under version control."""
import os
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent


def targets():
    return sorted(path.name.removesuffix("_fuzz.cpp") for path in HERE.glob("*_fuzz.cpp"))


def finds(build, name, seconds):
    """True if a target found something."""
    found = build / "found"
    (found / name).mkdir(parents=True, exist_ok=True)
    print(f"dev: {name} for {seconds} s", file=sys.stderr)
    # oneTBB and Embree are not instrumented; cmake/lsan.supp says what is silenced and why.
    environment = dict(os.environ, UBSAN_OPTIONS="print_stacktrace=1:halt_on_error=1",
                       LSAN_OPTIONS=f"suppressions={HERE.parent}/cmake/lsan.supp:print_suppressions=0")
    command = [build / "fuzz" / f"ajar_{name}_fuzz", found / name, HERE / "corpus" / name, f"-max_total_time={seconds}",
               "-timeout=60", "-rss_limit_mb=2048", f"-artifact_prefix={found / name}-", "-print_final_stats=1"]
    return subprocess.run(command, env=environment, check=False).returncode != 0


def main(build, seconds, only=None):
    failed = [name for name in ([only] if only else targets()) if finds(build, name, seconds)]
    if failed:
        sys.exit(f"dev: found something with: {' '.join(failed)}; the inputs are {build}/found/TARGET-*")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve(), *sys.argv[2:])
