#!/usr/bin/env python3
"""Whether two builds of ajar make the same bits: every integrator, the built-in scenes, two seeds.

    bench/same_bits.py OLD/ajar NEW/ajar [--renamed OLD_NAME=NEW_NAME[,KEY=VALUE]...]...

Fixed counts of samples, small pictures. What differs or is refused is named; the exit code is 1 then. For changes that
must not change a picture: a refactoring, or a faster way to the same numbers.
"""
import argparse
import itertools
import json
import pathlib
import subprocess
import sys
import tempfile

# Beside the defaults of every integrator: what takes other ways through the code.
VARIANTS = [
    ("mmlt", ["camera-steps=0.2", "light-steps=0.2"]),
    ("mmlt", ["multi-try=3"]),
    ("mmlt", ["mutation=fusion", "rule=published"]),
    ("mmlt", ["seeds=filtered", "mis-large-steps=true", "techniques=ibpt"]),
    ("selective", ["chain=mlt"]),
    ("selective", ["split=1", "importance=uniform"]),
    ("masked", ["chain=pssmlt", "pilot=keep"]),
    ("masked", ["chain=erpt", "choice=exclusive"]),
]
COUNTED = ["rays", "samples", "mutations", "b", "discarded", "estimated_relative_error"]


def scenes(program):
    listed = json.loads(subprocess.check_output([program, "list", "scenes", "--json"]))
    return [scene["name"] for scene in listed["scenes"]]


def integrators(program):
    listed = json.loads(subprocess.check_output([program, "list", "integrators", "--json"]))
    return [integrator["name"] for integrator in listed["integrators"]]


def render(program, scene, integrator, settings, seed, folder):
    """The bytes of the picture, the numbers counted and the passes; or what went wrong."""
    picture, stats = folder / "picture.pfm", folder / "stats.json"
    command = [program, "render", scene, "-o", picture, "--stats", stats, "--integrator", integrator, "--spp", "4",
               "--resolution", "48x36", "--seed", str(seed), "--progress", "none"]
    for setting in settings:
        command += ["--set", setting]
    run = subprocess.run(command, capture_output=True, text=True)
    if run.returncode != 0:
        return run.returncode, run.stderr.splitlines()[-1:], 0
    told = json.loads(stats.read_text())
    return picture.read_bytes(), {name: told.get(name) for name in COUNTED}, told["passes"]


def render_alike(old, new):
    """Both, cut into the same passes: the clock cuts, and each pass of chains traces their paths once more, which rays
    count. Of a busy machine it takes several attempts."""
    for _ in range(5):
        results = old(), new()
        if results[0][2] == results[1][2]:
            break
    return results


def what_differs(old, new):
    if isinstance(new[0], int):
        return f"refused by the new build ({new[1]})"
    if old[0] != new[0]:
        return "picture"
    return ", ".join(name for name in COUNTED if old[1][name] != new[1][name])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("--renamed", action="append", default=[], metavar="OLD=NEW[,KEY=VALUE]")
    parser.add_argument("--only", default="", help="scenes whose name contains this")
    options = parser.parse_args()
    renamed = {}
    for entry in options.renamed:
        name, other = entry.split("=", 1)
        other, *settings = other.split(",")
        renamed[name] = (other, settings)

    cases = [(name, []) for name in integrators(options.old)] + VARIANTS
    differing = compared = refused = 0
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        for scene, (name, settings), seed in itertools.product(scenes(options.old), cases, (1, 2)):
            if options.only not in scene:
                continue
            other, more = renamed.get(name, (name, []))
            old, new = render_alike(lambda: render(options.old, scene, name, settings, seed, folder),
                                    lambda: render(options.new, scene, other, more + settings, seed, folder))
            compared += 1
            if isinstance(old[0], int):
                refused += 1
                print(f"refused: {scene} {name} {' '.join(settings)}: {old[1]}", flush=True)
            if old[:2] != new[:2]:
                differing += 1
                print(f"{what_differs(old, new)}: {scene} {name} {' '.join(settings)} seed {seed}", flush=True)
    print(f"{compared} renders compared, {differing} differ, {refused} refused")
    return 1 if differing or refused else 0


if __name__ == "__main__":
    sys.exit(main())
