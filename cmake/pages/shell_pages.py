#!/usr/bin/env python3
"""Man pages and completions of the shell: `shell_pages.py PROGRAM FOLDER`.

Writes into FOLDER, from what PROGRAM says of itself, man1/ajar.1 and man1/ajar-COMMAND.1, bash/ajar, zsh/_ajar and
fish/ajar.fish. The build runs it, and `cmake --install` puts each where its reader looks for it.
"""
import os
import sys

import program_help

# Values of options of the program itself; those of renders are in `ajar list options`.
WORDS = {"--progress": ["auto", "plain", "json", "none"]}


def names(program, kind):
    return [entry["name"] for entry in program.listed[kind]]


def values_of(program, flag):
    """Words that an option may have; none where anything else goes, such as a file or a number."""
    if flag == "--set":
        return sorted({p["name"] + "=" for i in program.listed["integrators"] for p in i["parameters"]})
    choices = {option["flag"]: option["choices"] for option in program.listed["options"]}
    return choices.get(flag) or WORDS.get(flag, [])


def places_of(program, command):
    """Words that arguments by place may be, beside files."""
    if command.name == "list":
        return list(program.listed)
    if any(option.synopsis.startswith("SCENE") for option in command.options):
        return names(program, "scenes")
    return []


# ---------------------------------------------------------------- man pages


def roff(text):
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return "\\&" + text if text.startswith((".", "'")) else text


def man_page(program, name, summary, synopsis, sections, also):
    lines = [f'.TH "{name.upper()}" "1" "" "{program.version}" "Ajar"', ".SH NAME", f"{roff(name)} \\- {roff(summary)}",
             ".SH SYNOPSIS", f".B {roff(synopsis)}"]
    for section in sections:
        lines.append(f'.SH "{roff(section.heading).upper()}"')
        for option in section.options:
            lines += [".TP", f".B {roff(option.synopsis)}", roff(option.meaning) or "\\&"]
    lines.append(".SH EXIT STATUS")
    for code, meaning in program.exit_codes:
        lines += [".TP", f".B {code}", roff(meaning)]
    lines += [".SH SEE ALSO", ", ".join(f"\\fB{roff(page)}\\fR(1)" for page in also)]
    return "\n".join(lines) + "\n"


def man_pages(program):
    all_names = ["ajar"] + [f"ajar-{command.name}" for command in program.commands]
    commands = program_help.Section("commands", [program_help.Option(c.name, c.summary) for c in program.commands])
    yield "ajar.1", man_page(program, "ajar", program.summary, "ajar COMMAND [OPTIONS]", [commands], all_names[1:])
    for command in program.commands:
        name = f"ajar-{command.name}"
        yield f"{name}.1", man_page(program, name, command.summary, command.usage, command.sections,
                                    [other for other in all_names if other != name])


# ---------------------------------------------------------------- completions


def bash(program):
    cases = []
    for command in program.commands:
        flags = [flag for option in command.options for flag in option.flags]
        values = []
        for option in command.options:
            if not option.takes_value or not option.flags:
                continue
            words = values_of(program, option.flags[-1])
            reply = f"COMPREPLY=($(compgen -W '{' '.join(words)}' -- \"$word\"))" if words else "_ajar_files"
            values.append(f"        {'|'.join(option.flags)}) {reply}; return ;;")
        after = "\n".join(values)
        inner = f'      case "$previous" in\n{after}\n      esac\n' if values else ""
        cases.append(f"    {command.name})\n{inner}"
                     f"      _ajar_words '{' '.join(flags)}' '{' '.join(places_of(program, command))}' ;;")
    commands = " ".join(command.name for command in program.commands)
    return f"""# Completion of ajar for bash.
_ajar_files() {{ COMPREPLY=($(compgen -f -- "$word")); }}

# _ajar_words OPTIONS PLACES: options where one begins, else places and files.
_ajar_words() {{
  if [[ "$word" == -* ]]; then
    COMPREPLY=($(compgen -W "$1" -- "$word"))
  else
    COMPREPLY=($(compgen -W "$2" -- "$word") $(compgen -f -- "$word"))
  fi
}}

_ajar() {{
  local word previous
  # builtin:NAME and NAME=VALUE are single words here.
  if declare -F _get_comp_words_by_ref >/dev/null; then
    _get_comp_words_by_ref -n := -c word -p previous
  else
    word="${{COMP_WORDS[COMP_CWORD]}}"
    previous="${{COMP_WORDS[COMP_CWORD - 1]}}"
  fi
  if ((COMP_CWORD == 1)); then
    COMPREPLY=($(compgen -W '{commands} --help --version' -- "$word"))
    return
  fi
  case "${{COMP_WORDS[1]}}" in
{chr(10).join(cases)}
  esac
  if declare -F __ltrim_colon_completions >/dev/null; then __ltrim_colon_completions "$word"; fi
}}
complete -o filenames -o nosort -F _ajar ajar
"""


def quoted(text):
    return text.replace("'", "'\\''")


def zsh(program):
    def specification(option):
        words = values_of(program, option.flags[-1])
        text = option.meaning
        for character in "\\[]:":
            text = text.replace(character, "\\" + character)
        value = ""
        if option.takes_value:
            value = f": :({' '.join(words)})" if words else ": :_files"
        flags = option.flags[0] if len(option.flags) == 1 else "{" + ",".join(option.flags) + "}"
        return f"        {flags}'[{quoted(text)}]{quoted(value)}'"

    commands = "\n".join(f"    '{c.name}:{quoted(c.summary)}'" for c in program.commands)
    cases = []
    for command in program.commands:
        lines = [specification(option) for option in command.options if option.flags]
        lines.append(f"        '*: :_ajar_places {' '.join(places_of(program, command))}'".replace("builtin:", "builtin\\:"))
        cases.append(f"    {command.name})\n      _arguments \\\n" + " \\\n".join(lines) + "\n      ;;")
    return f"""#compdef ajar
# Completion of ajar for zsh.
_ajar_places() {{
  compadd -- ${{argv:#-*}}
  _files
}}

_ajar() {{
  local -a commands
  commands=(
{commands}
  )
  if ((CURRENT == 2)); then
    _describe command commands
    return
  fi
  local command=$words[2]
  shift words
  ((CURRENT--))
  case $command in
{chr(10).join(cases)}
  esac
}}
_ajar "$@"
"""


def fish(program):
    lines = ["# Completion of ajar for fish.", "complete -c ajar -n __fish_use_subcommand -f"]
    for command in program.commands:
        lines.append(f"complete -c ajar -n __fish_use_subcommand -a {command.name} -d '{fish_quoted(command.summary)}'")
        inside = f"complete -c ajar -n '__fish_seen_subcommand_from {command.name}'"
        for place in places_of(program, command):
            lines.append(f"{inside} -a '{place}'")
        for option in command.options:
            if not option.flags:
                continue
            flags = " ".join(f"-l {f[2:]}" if f.startswith("--") else f"-s {f[1:]}" for f in option.flags)
            words = values_of(program, option.flags[-1])
            value = f" -x -a '{' '.join(words)}'" if words else " -r" if option.takes_value else ""
            lines.append(f"{inside} {flags}{value} -d '{fish_quoted(option.meaning)}'")
    return "\n".join(lines) + "\n"


def fish_quoted(text):
    return text.replace("\\", "\\\\").replace("'", "\\'")


def main(path, folder):
    program = program_help.Program(os.path.abspath(path))
    files = {f"man1/{name}": text for name, text in man_pages(program)}
    files |= {"bash/ajar": bash(program), "zsh/_ajar": zsh(program), "fish/ajar.fish": fish(program)}
    for name, text in files.items():
        target = os.path.join(folder, name)
        os.makedirs(os.path.dirname(target), exist_ok=True)
        with open(target, "w", encoding="utf-8") as file:
            file.write(text)


if __name__ == "__main__":
    main(*sys.argv[1:])
