"""Checks the documentation: `check_docs.py REPOSITORY PROGRAM`.

Every link to a file of the repository must lead somewhere, to a heading where it names one. So must every comment that
cites a page (`docs/page.md, "Heading"`). Every line of a fenced `sh` block that starts with `ajar ` must run: with few
samples and a small picture added to renders, in a folder that is thrown away.
Blocks that need files of the reader are marked `text`. Pages that the program writes must be as it would write them.
What names the version must name that of CMakeLists.txt.
"""
import difflib
import functools
import os
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "pages"))
import reference_pages  # noqa: E402

LINK = re.compile(r"\[[^\]]*\]\(([^)#\s]*)#?([^)\s]*)[^)]*\)")
CITATION = re.compile(r'(docs/[\w/-]+\.md)(?:,[\s/]*"([^"]+)")?')
HEADING = re.compile(r"^#{1,6} +(.*?)(?: +#+)? *$", re.MULTILINE)
BLOCK = re.compile(r"```(\w*)\n(.*?)```", re.DOTALL)


def documents(repository):
    for root, folders, names in os.walk(repository):
        if root == repository:
            folders[:] = [folder for folder in folders if folder not in (".git", "build", "out")]
        yield from (os.path.join(root, name) for name in sorted(names) if name.endswith(".md"))


def prose(text):
    """The page with its fenced blocks empty, so that lines keep their numbers."""
    return BLOCK.sub(lambda block: "\n" * block[0].count("\n"), text)


def anchor(heading):
    """What GitHub calls a heading in links."""
    heading = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


@functools.cache
def anchors(path):
    with open(path, encoding="utf-8") as file:
        headings = HEADING.findall(prose(file.read()))
    found = []
    for name in map(anchor, headings):
        numbered = (f"{name}-{count}" for count in range(1, len(headings)))
        found.append(name if name not in found else next(n for n in numbered if n not in found))
    return found


def missing_anchor(path, name):
    """Nothing if the page has this anchor, else what to say of it."""
    if name in anchors(path):
        return ""
    nearest = difflib.get_close_matches(name, anchors(path), 1, 0)
    return f"has no heading #{name}" + (f"; the nearest is #{nearest[0]}" if nearest else "")


def line_of(match):
    return match.string.count("\n", 0, match.start()) + 1


def broken_links(path, text):
    for link in LINK.finditer(prose(text)):
        target, name = link.groups()
        if re.match(r"[a-z]+:", target):
            continue
        file = os.path.join(os.path.dirname(path), target) if target else path
        if not os.path.exists(file):
            yield f"{path}:{line_of(link)}: the link to {target} leads nowhere"
        elif name and file.endswith(".md") and (missing := missing_anchor(file, name)):
            yield f"{path}:{line_of(link)}: {target or 'this page'} {missing}"


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
    """Pages and headings that comments cite and a reader cannot open."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    for citation in CITATION.finditer(text):
        page, heading = citation.groups()
        file = os.path.join(repository, page)
        if not os.path.exists(file):
            yield f"{path}:{line_of(citation)}: cites {page}, which does not exist"
        elif heading:
            name = anchor(re.sub(r"\s+(//+<? *)?", " ", heading))
            if missing := missing_anchor(file, name):
                yield f"{path}:{line_of(citation)}: {page} {missing}"
    for name in re.finditer(r"\b(?:METHODS|DESIGN|PEERS)\b", text):
        yield f"{path}:{line_of(name)}: cites {name[0]}, which is not in the repository"


# Where the version is written by hand beside CMakeLists.txt.
VERSIONED = {
    "CHANGELOG.md": r"^## (\d\S*)",
    "CITATION.cff": r"^version: (\S+)",
    "docs/library.md": r"find_package\(ajar (\S+)",
    "examples/render/CMakeLists.txt": r"find_package\(ajar (\S+)",
}


def other_versions(repository):
    """Files that name another version than the build; they may leave out its last number."""
    def named(file, pattern):
        with open(os.path.join(repository, file), encoding="utf-8") as text:
            found = re.search(pattern, text.read(), re.MULTILINE)
        return found[1] if found else ""

    version = named("CMakeLists.txt", r"project\(ajar VERSION (\S+)")
    for file, pattern in VERSIONED.items():
        if (name := named(file, pattern)) not in (version, version.rpartition(".")[0]):
            yield f"{os.path.join(repository, file)}: names version {name}, but the build is {version}"


def main(repository, program):
    program = os.path.abspath(program)
    problems = list(other_versions(repository))
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
