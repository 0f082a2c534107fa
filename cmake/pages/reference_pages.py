#!/usr/bin/env python3
"""The pages of docs/reference/ that the program writes itself: `cmake/pages/reference_pages.py PROGRAM FOLDER`.

Writes them into FOLDER from what PROGRAM says of itself: `ajar list --json`, `ajar --help` and `ajar COMMAND --help`.
check_docs.py compares: a parameter, model, option or layer that is added or changed shows in the reference, or the
check fails.
"""
import json
import os
import sys

import program_help

HEAD = "<!-- Written by cmake/pages/reference_pages.py from the program: change what it says there. -->\n"


def in_cell(text):
    return text.replace("|", "\\|").replace("\n", " ").strip()


def code(text):
    return f"`{in_cell(text)}`" if text else ""


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


# ---------------------------------------------------------------- parameters of integrators and models


def shortest(number):
    """As `number_text` of the program has it."""
    is_whole = number == int(number) and abs(number) < 2**53
    return f"{number:.0f}" if is_whole else f"{number:g}"


def values_of(parameter):
    """What a parameter may be."""
    choices = ", ".join(code(choice) for choice in parameter.get("choices", []))
    if parameter["type"] == "choice":
        return choices
    words = parameter["type"]
    low, high = parameter.get("minimum"), parameter.get("maximum")
    if low is not None and high is not None:
        words += f", {shortest(low)} to {shortest(high)}"
    elif low is not None:
        words += f", ≥ {shortest(low)}"
    elif high is not None:
        words += f", ≤ {shortest(high)}"
    if parameter["unit"]:
        words += f" ({parameter['unit']})"
    if parameter.get("textured"):
        words += ", textured"
    if choices:
        words += f", or {choices}"
    return words


def meaning_of(parameter):
    if "depends_on" not in parameter:
        return in_cell(parameter["help"])
    matters = " or ".join(code(f"{parameter['depends_on']}={value}") for value in parameter["matters_for"])
    return f"{in_cell(parameter['help'])} (with {matters})"


def parameter_table(parameters):
    rows = [(code(p["name"]), values_of(p), code(p["default"]), meaning_of(p)) for p in parameters]
    return table(("parameter", "values", "default", "meaning"), rows)


def parameters_of(model):
    basic = [p for p in model["parameters"] if not p["expert"]]
    expert = [p for p in model["parameters"] if p["expert"]]
    text = ""
    if basic:
        text += parameter_table(basic) + "\n"
    if expert:
        text += "For experts:\n\n" + parameter_table(expert) + "\n"
    return text


def same_parameters(model, other):
    """Of a model that has those of another one, perhaps with other defaults."""
    text = f"Parameters: those of [{other['name']}](#{other['name']})"
    differing = [f"`{p['name']}={p['default']}`" for p, q in zip(model["parameters"], other["parameters"])
                 if p["default"] != q["default"]]
    return text + (", by default with " + ", ".join(differing) if differing else "") + ".\n"


def model_page(title, about, models):
    """A section for each model. One with the parameters of an earlier one refers to it."""
    text = f"{HEAD}# {title}\n\n{about}\n"
    seen = {}
    for model in models:
        text += f"\n## {model['name']}\n\n{model['summary'][0].upper() + model['summary'][1:]}."
        text += f" Source: {model['source']}.\n\n" if model["source"] else "\n\n"
        key = json.dumps([{**p, "default": ""} for p in model["parameters"]])
        if not model["parameters"]:
            text += "No parameters.\n"
        elif key in seen:
            text += same_parameters(model, seen[key])
        else:
            seen[key] = model
            text += parameters_of(model).rstrip("\n") + "\n"
    return text


# ---------------------------------------------------------------- commands


def command_page(program):
    text = f"{HEAD}# Commands\n\nWhat `ajar --help` and `ajar COMMAND --help` print.\n\n"
    text += table(("command", "what it does"),
                  [(f"[`ajar {command.name}`](#ajar-{command.name})", in_cell(command.summary))
                   for command in program.commands])
    for command in program.commands:
        text += f"\n## ajar {command.name}\n\n    {command.usage}\n"
        for section in command.sections:
            rows = [(code(option.synopsis), in_cell(option.meaning)) for option in section.options]
            text += f"\n{section.heading}:\n\n" + table(("option", "meaning"), rows)
    return text + "\n## Exit codes\n\n" + table(("code", "meaning"), program.exit_codes)


def settings_page(options):
    rows = [(code(o["name"]), code(o["flag"] or ""), in_cell(o["summary"]), in_cell(o["default"]),
             "yes" if o["decides_picture"] else "", "yes" if o["kept_by_checkpoints"] else "")
            for o in options if o["in_settings"]]
    return (f"{HEAD}# Settings\n\nWhat programs can ask of a render: members of `Settings` in C++ and of the JSON in C, and "
            "what they are on the command line.\n\n"
            + table(("setting", "option", "meaning", "default", "decides the bits", "kept by checkpoints"), rows))


# ---------------------------------------------------------------- all pages


def pages(path):
    program = program_help.Program(path)
    listed = program.listed
    named = {"materials": "Materials", "textures": "Textures", "shapes": "Shapes"}
    result = {
        "commands.md": command_page(program),
        "integrators.md": model_page(
            "Integrators", "Methods of rendering, for `--integrator NAME`, and their parameters, for `--set NAME=VALUE`.",
            listed["integrators"]),
        "lights.md": model_page(
            "Lights", "Lights of their own, and at the end what surfaces emit. Names as in `ajar info --json`.",
            listed["lights"] + listed["emissions"]),
        "layers.md": f"{HEAD}# Layers\n\nFor `--aov NAME,…`.\n\n" + table(
            ("layer", "what it shows"), [(code(a["name"]), in_cell(a["summary"])) for a in listed["aovs"]]),
        "settings.md": settings_page(listed["options"]),
        "counters.md": f"{HEAD}# Counters\n\nNumbers of events in `--stats`; a dot leads into an object.\n\n" + table(
            ("counter", "counts"), [(code(c["name"]), in_cell(c["summary"])) for c in listed["counters"]]),
        "scenes.md": f"{HEAD}# Built-in scenes\n\n`ajar render NAME` renders one.\n\n" + table(
            ("scene", "what it shows"), [(code(s["name"]), in_cell(s["summary"])) for s in listed["scenes"]]),
    }
    for kind, title in named.items():
        result[f"{kind}.md"] = model_page(
            title, f"What a scene's {kind} can be, whatever its format calls them. What is *textured* may be a texture.",
            listed[kind])
    return result


def stale_pages(program, folder):
    for name, text in pages(program).items():
        path = os.path.join(folder, name)
        if not os.path.exists(path) or open(path, encoding="utf-8").read() != text:
            yield f"{path}: not what the program says; python3 cmake/pages/reference_pages.py PROGRAM docs/reference"


def main(program, folder):
    for name, text in pages(os.path.abspath(program)).items():
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(text)


if __name__ == "__main__":
    main(*sys.argv[1:])
