#!/usr/bin/env python3
"""Checks man pages and completions of the shell: `shell_pages_test.py PROGRAM`.

Bash completes for real; zsh, fish and groff where they are installed.
"""
import glob
import os
import shutil
import subprocess
import sys
import tempfile

import shell_pages

BASH = """
source "$1"
shift
COMP_WORDS=("$@")
COMP_CWORD=$(($# - 1))
_ajar
printf '%s\\n' "${COMPREPLY[@]}"
"""
# What is typed, and words that must be among the answers, or must not (!).
TYPED = [
    (["ajar", ""], ["render", "info", "--help"]),
    (["ajar", "re"], ["render", "resume", "!info"]),
    (["ajar", "render", "--int"], ["--integrator", "!--spp"]),
    (["ajar", "render", "--integrator", ""], ["pt", "selective", "!--spp"]),
    (["ajar", "render", "--integrator", "b"], ["bdpt", "!pt"]),
    (["ajar", "render", "--denoise", ""], ["auto", "none"]),
    (["ajar", "render", "--set", "large"], ["large-step="]),
    (["ajar", "render", "builtin:co"], ["builtin:cornell", "!builtin:pool"]),
    (["ajar", "list", "mat"], ["materials"]),
]


def wrong_answers(typed, expected, answers):
    for word in expected:
        if word.startswith("!") == (word.lstrip("!") in answers):
            yield f"{' '.join(typed)!r}: {word} expected, of {answers}"


def main(program):
    problems = []
    with tempfile.TemporaryDirectory() as folder:
        shell_pages.main(program, folder)

        def run(*command):
            result = subprocess.run(command, capture_output=True, text=True, cwd=folder)
            if result.returncode != 0 or result.stderr:
                problems.append(f"{' '.join(command)[:80]}: {result.returncode} {result.stderr}")
            return result.stdout.split("\n")

        for typed, expected in TYPED:
            problems += wrong_answers(typed, expected, run("bash", "-c", BASH, "bash", "bash/ajar", *typed))
        if shutil.which("fish"):
            for typed, expected in TYPED:
                line = " ".join(typed)
                answers = run("fish", "--no-config", "-c", f"source fish/ajar.fish; complete -C '{line}'")
                expected = [word for word in expected if word.lstrip("!").startswith("--") <= line.endswith("-int")]
                problems += wrong_answers(typed, expected, [answer.split("\t")[0] for answer in answers])
        else:
            print("fish is not here: its completions are not tried")
        if shutil.which("zsh"):
            run("zsh", "-n", "zsh/_ajar")
        else:
            print("zsh is not here: its completions are not read")
        if shutil.which("groff"):
            for page in glob.glob(os.path.join(folder, "man1", "*.1")):
                run("groff", "-Kutf8", "-man", "-ww", "-Tutf8", page)
        else:
            print("groff is not here: man pages are not set")
        pages = os.listdir(os.path.join(folder, "man1"))
        if "ajar.1" not in pages or "ajar-render.1" not in pages:
            problems.append(f"man pages are missing: {pages}")
    for problem in problems:
        print(problem, file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
