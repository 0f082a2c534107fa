#!/usr/bin/env python3
"""Checks how comments of C++ begin: `check_comments.py FILE...`, or `check_comments.py --self-test`.

A comment begins with a noun phrase or a verb, not with a relative clause, "as" or a pronoun (docs/develop/style.md,
"Comments"). A block is a run of lines with nothing but a comment, or a comment behind code and its continuation; an empty
comment line ends it.
"""
import re
import sys

CODE = r"""(?:[^"'/]|"(?:[^"\\]|\\.)*"|'(?:[^'\\]|\\.)*'|'|/(?!/))*"""
COMMENT = re.compile(rf"^({CODE})//[/!]?(<?) ?(.*)$")
VERBS = "is|are|was|were|has|have|had|does|do|did|can|cannot|may|must|will|would|needs?|makes?|takes?|gives?|holds?|keeps?"
BEGINNING = re.compile(
    r"(?:what(?:ever)?|of|who(?:ever)?|whose|whom|that|those|which|whether|how(?:ever)?|so that|likewise|the same|"
    rf"it|they|he|she|th(?:is|ese) (?:{VERBS}))\b", re.IGNORECASE)

AS = re.compile(r"as\b", re.IGNORECASE)


def findings(lines):
    """(line number, words) of each block that begins with a word that it must not begin with."""
    column = None  # of the block that the next line may continue
    for number, line in enumerate(lines, 1):
        match = COMMENT.match(line)
        if not match or not match[3].strip():
            column = None
            continue
        code, is_behind, text = match.groups()
        continues = column is not None and not code.strip() and (is_behind or len(code) == column)
        column = len(code)
        found = BEGINNING.match(text)
        # Behind code, "as written by the user" says more of what stands before it.
        found = found or (AS.match(text) if not code.strip() else None)
        if found and not continues:
            yield number, found[0]


SAMPLE = """// A noun.
// What continues a block begins none.
///
/// Of a paragraph after an empty line.
int a;  ///< whether it is set
        ///< that continues
auto b = "// What is a text";  // "What" in quotes
int c = 1'000;  // so that
// This is wrong.
// This picture is not.

// This picture is right.

/// As it was.
int d;  ///< as it is
"""


def main(arguments):
    if arguments == ["--self-test"]:
        found = [number for number, _ in findings(SAMPLE.split("\n"))]
        problems = [] if found == [4, 5, 8, 9, 14] else [f"the self-test found lines {found}"]
    else:
        problems = []
        for path in arguments:
            with open(path, encoding="utf-8") as file:
                problems += [f'{path}:{number}: a comment begins with "{words}"' for number, words in findings(file)]
    print("\n".join(problems), end="\n" if problems else "")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
