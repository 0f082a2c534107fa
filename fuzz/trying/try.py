#!/usr/bin/env python3
"""Tries to break the program, as one would who means to: see --help. Findings are kept, with what led to them."""
import argparse
import collections
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import outcome
from mutate import mutate

INTEGRATORS = ["pt", "lt", "ibpt", "bdpt", "pssmlt", "mmlt", "mlt", "erpt", "masked", "selective"]
SMALL = ["--resolution", "16x12", "--spp", "4", "--threads", "2", "--progress", "none"]
LIGHT = {name: ["--set", "bootstrap=2000"] for name in ("pssmlt", "mmlt", "mlt", "erpt", "masked")}


class Trials:
    """Counts runs, and keeps what went wrong."""

    def __init__(self, program, finds):
        self.program, self.finds = program, finds
        self.runs = 0
        self.wrong = collections.Counter()
        self.codes = collections.Counter()

    def run(self, arguments, folder, **limits):
        self.runs += 1
        code, message, late = outcome.run([self.program] + arguments, folder, **limits)
        self.codes["late" if late else code] += 1
        return code, message, outcome.complaint(code, message, late)

    def keep(self, what, arguments, message, files):
        self.wrong[what] += 1
        if self.wrong[what] > 20:
            return
        folder = os.path.join(self.finds, "%s-%d" % (what.replace(" ", "-"), self.wrong[what]))
        os.makedirs(folder, exist_ok=True)
        for file in files:
            if os.path.isfile(file):
                shutil.copy(file, folder)
        with open(os.path.join(folder, "how.txt"), "w", errors="replace") as how:
            how.write(" ".join(arguments) + "\n" + message)
        print("%s: %s" % (what, folder), flush=True)


def scene_files(folders):
    found = []
    for folder in folders:
        for where, _, names in os.walk(folder):
            found += [os.path.join(where, n) for n in names if n.endswith(".pbrt")]
    return [f for f in sorted(found) if os.path.getsize(f) < 200000]


def try_inputs(trials, rng, scenes, work, until):
    """Changed scenes: told of, converted and rendered, by any method."""
    while time.time() < until:
        source = rng.choice(scenes)
        folder = os.path.join(work, "scene")
        shutil.rmtree(folder, ignore_errors=True)
        os.makedirs(folder)
        # What the scene refers to is beside it.
        for name in set(os.listdir(os.path.dirname(source))) - {"changed.pbrt", "pipe", "self.pbrt"}:
            os.symlink(os.path.join(os.path.dirname(source), name), os.path.join(folder, name))
        scene = os.path.join(folder, "changed.pbrt")
        with open(source, encoding="latin-1") as file:
            text = mutate(rng, file.read())
        with open(scene, "w", encoding="latin-1") as file:
            file.write(text)
        os.mkfifo(os.path.join(folder, "pipe"))
        os.symlink(scene, os.path.join(folder, "self.pbrt"))
        method = rng.choice(INTEGRATORS)
        for arguments in (["info", scene, "--json"], ["convert", scene, "out.pbrt"],
                          ["render", scene, "--integrator", method, "-o", "out.pfm"] + SMALL + LIGHT.get(method, [])):
            code, message, what = trials.run(arguments, folder)
            if not what and arguments[0] == "render" and code == 0:
                what = outcome.pfm_complaint(os.path.join(folder, "out.pfm"), text, message)
            if what:
                trials.keep(what, arguments, message, [scene])
            if code != 0:
                break


def try_kills(trials, rng, work, until):
    """Renders that are killed again and again end with the bits of one left alone."""
    while time.time() < until:
        folder = os.path.join(work, "kill")
        shutil.rmtree(folder, ignore_errors=True)
        os.makedirs(folder)
        method = rng.choice(INTEGRATORS)
        seed = str(rng.randrange(1000))
        spp = "64" if method in LIGHT else "256"
        render = ["render", "builtin:cornell", "--resolution", "48x36", "--spp", spp, "--integrator", method, "--seed",
                  seed, "--threads", "2", "--progress", "none"] + LIGHT.get(method, [])
        trials.run(render + ["-o", "alone.pfm"], folder)
        again = [trials.program] + render + ["-o", "killed.pfm", "--checkpoint", "c", "--checkpoint-every", "0.05s",
                                             "--resume", "c", "--output-every", "0.05s"]
        for _ in range(6):
            child = subprocess.Popen(again, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                     stderr=subprocess.DEVNULL)
            time.sleep(rng.uniform(0.05, 1.5))
            child.send_signal(rng.choice([signal.SIGKILL, signal.SIGKILL, signal.SIGINT, signal.SIGTERM]))
            child.wait()
            trials.runs += 1
            trials.codes[child.returncode] += 1
        code, message, what = trials.run(again[1:], folder)
        with open(os.path.join(folder, "alone.pfm"), "rb") as a, open(os.path.join(folder, "killed.pfm"), "rb") as b:
            if not what and (code != 0 or a.read() != b.read()):
                what = "other bits after kills"
        if what:
            trials.keep(what, again, message, [os.path.join(folder, n) for n in ("c", "alone.pfm", "killed.pfm")])


def try_threads(trials, rng, scenes, work, until):
    """The same bits on any number of threads."""
    while time.time() < until:
        method = rng.choice(INTEGRATORS)
        scene = rng.choice(scenes + ["builtin:cornell", "builtin:torus-in-glass", "builtin:door-ajar"])
        render = ["render", scene, "--resolution", "32x24", "--spp", "16", "--integrator", method, "--seed",
                  str(rng.randrange(1000)), "--progress", "none"] + LIGHT.get(method, [])
        pictures = []
        for threads in ("1", "2", "5"):
            code, message, what = trials.run(render + ["--threads", threads, "-o", "t%s.pfm" % threads], work,
                                             seconds=300)
            if what:
                trials.keep(what, render, message, [scene])
            if code == 0:
                with open(os.path.join(work, "t%s.pfm" % threads), "rb") as file:
                    pictures.append(file.read())
        if len(set(pictures)) > 1:
            trials.keep("other bits on other threads", render, "", [])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("--seconds", type=float, default=60, help="for each of: changed scenes, kills, threads")
    parser.add_argument("--scenes", nargs="+", required=True, help="folders with scenes to begin with")
    parser.add_argument("--finds", default="finds", help="folder for what goes wrong")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", choices=["inputs", "kills", "threads"], help="one of them")
    arguments = parser.parse_args()
    rng = random.Random(arguments.seed)
    trials = Trials(os.path.abspath(arguments.program), os.path.abspath(arguments.finds))
    scenes = scene_files([os.path.abspath(f) for f in arguments.scenes])
    with tempfile.TemporaryDirectory(prefix="ajar-try-") as work:
        for name, attempt in (("inputs", lambda until: try_inputs(trials, rng, scenes, work, until)),
                              ("kills", lambda until: try_kills(trials, rng, work, until)),
                              ("threads", lambda until: try_threads(trials, rng, scenes, work, until))):
            if arguments.only in (None, name):
                before = trials.runs
                attempt(time.time() + arguments.seconds)
                print("%s: %d runs" % (name, trials.runs - before), flush=True)
    print(json.dumps({"runs": trials.runs, "exit codes": {str(k): v for k, v in trials.codes.items()},
                      "found": dict(trials.wrong)}))
    return 1 if trials.wrong else 0


if __name__ == "__main__":
    sys.exit(main())
