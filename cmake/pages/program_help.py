"""What the program says of itself: `ajar list --json`, `ajar --help` and `ajar COMMAND --help`, taken apart."""
import dataclasses
import json
import re
import subprocess


@dataclasses.dataclass
class Option:
    """A line of a help: an option, or an argument by place."""
    synopsis: str  # "-o,--output FILE ..."
    meaning: str

    @property
    def flags(self):
        """["-o", "--output"]; empty for an argument by place."""
        first = self.synopsis.split(" ")[0]
        return first.split(",") if first.startswith("-") else []

    @property
    def takes_value(self):
        words = self.synopsis.split(" ")
        return len(words) > 1 and words[1] not in ("Excludes:", "Needs:")


@dataclasses.dataclass
class Section:
    heading: str
    options: list


@dataclasses.dataclass
class Command:
    name: str
    summary: str
    usage: str
    sections: list

    @property
    def options(self):
        return [option for section in self.sections for option in section.options]


LINE = re.compile(r"  (\S.*?)(?:   *(\S.*))?$")


def sections_of(help_text):
    """In the order of the help."""
    sections = []
    for line in help_text.split("\n"):
        if re.match(r"\S.*:$", line):
            sections.append(Section(line[:-1], []))
        elif sections and line.startswith("    ") and sections[-1].options:
            option = sections[-1].options[-1]
            option.meaning = (option.meaning + " " + line.strip()).strip()
        elif sections and line.startswith("  "):
            synopsis, meaning = LINE.match(line).groups()
            sections[-1].options.append(Option(synopsis, meaning or ""))
    return [section for section in sections if section.options]


class Program:
    """Raises subprocess.CalledProcessError if `path` does not answer."""

    def __init__(self, path):
        def say(*arguments):
            return subprocess.run([path, *arguments], check=True, capture_output=True, text=True).stdout

        self.listed = json.loads(say("list", "--json"))  # kind: [{name, summary, …}]
        self.version = say("--version").strip()
        general = say("--help")
        self.summary = general.split("\n")[0]
        self.exit_codes = [tuple(entry.strip().split(" ", 1))
                           for entry in re.search(r"Exit codes: (.*)\.", general).group(1).split(", ")]
        self.commands = []
        for line in next(s for s in sections_of(general) if s.heading == "Subcommands").options:
            text = say(line.synopsis, "--help")
            usage = re.search(r"Usage: (.*)", text).group(1)
            self.commands.append(Command(line.synopsis, line.meaning, usage, sections_of(text)))
