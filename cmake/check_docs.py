"""Checks the documentation: `check_docs.py REPOSITORY PROGRAM`.

Every link to a file of the repository must lead somewhere, and every line of a fenced `sh` block that starts with `ajar `
must run: with few samples and a small picture added to renders, in a folder that is thrown away.
Blocks that need files of the reader are marked `text`. Pages that the program writes must be as it would write them.
"""
import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "pages"))
import reference_pages  # noqa: E402

LINK = re.compile(r"\[[^\]]*\]\(([^)#\s]+)[^)]*\)")
BLOCK = re.compile(r"```(\w*)\n(.*?)```", re.DOTALL)


def documents(repository):
    for root, folders, names in os.walk(repository):
        if root == repository:
            folders[:] = [folder for folder in folders if folder not in (".git", "build", "out")]
        yield from (os.path.join(root, name) for name in sorted(names) if name.endswith(".md"))


def broken_links(path, text):
    for target in LINK.findall(BLOCK.sub("", text)):
        if re.match(r"[a-z]+:", target):
            continue
        if not os.path.exists(os.path.join(os.path.dirname(path), target)):
            yield f"{path}: the link to {target} leads nowhere"


def commands(text):
    for language, body in BLOCK.findall(text):
        if language == "sh":
            for line in body.replace("\\\n", " ").split("\n"):
                line = line.split(" #")[0].strip()
                if line.startswith("ajar "):
                    yield line


def quick(command):
    if not command.startswith("ajar render"):
        return command
    command = re.sub(r"--(spp|time|target-error|resolution|scale)[ =]\S+", "", command)
    return command + " --spp 1 --resolution 32x24 --progress none"


def failing_commands(path, text, program, folder):
    environment = dict(os.environ, PATH=os.path.dirname(program) + os.pathsep + os.environ["PATH"])
    for command in commands(text):
        result = subprocess.run(quick(command), shell=True, cwd=folder, env=environment,
                                capture_output=True, text=True)
        print(("ok     " if result.returncode == 0 else "FAILED ") + command)
        if result.returncode != 0:
            yield f"{path}: `{command}` ends with {result.returncode}: {result.stderr.strip()}"


def sources(repository):
    for folder in ("src", "tests", "bench", "fuzz", "include", "examples"):
        for root, _, names in os.walk(os.path.join(repository, folder)):
            for name in names:
                if name.endswith((".h", ".cpp", ".py")):
                    yield os.path.join(root, name)


def broken_citations(repository, path):
    """Pages that comments cite and a reader cannot open."""
    with open(path, encoding="utf-8") as file:
        lines = file.read().splitlines()
    for number, line in enumerate(lines, 1):
        for page in re.findall(r"docs/[\w/-]+\.md", line):
            if not os.path.exists(os.path.join(repository, page)):
                yield f"{path}:{number}: cites {page}, which does not exist"
        for name in re.findall(r"\b(?:METHODS|DESIGN|PEERS)\b", line):
            yield f"{path}:{number}: cites {name}, which is not in the repository"


def main(repository, program):
    program = os.path.abspath(program)
    problems = []
    for path in sources(repository):
        problems += broken_citations(repository, path)
    with tempfile.TemporaryDirectory() as folder:
        for path in documents(repository):
            with open(path, encoding="utf-8") as file:
                text = file.read()
            problems += broken_links(path, text)
            problems += failing_commands(path, text, program, folder)
    problems += reference_pages.stale_pages(program, os.path.join(repository, "docs", "reference"))
    for problem in problems:
        print(problem, file=sys.stderr)
    print(f"documentation: {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2]))
