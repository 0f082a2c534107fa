"""Writes the type stubs of materials, textures, lights, emissions and shapes from the library's own list:

    AJAR_LIBRARY=build/release/libajar.so PYTHONPATH=python python3 python/make_stubs.py

With --check it only says whether they are up to date."""

import pathlib
import sys
import textwrap

from ajar._catalog import catalog
from ajar._nodes import GEOMETRY, RELIEFS, default_of

KINDS = ("material", "texture", "light", "emission", "shape")


def type_of(spec):
    kind, textured = spec["type"], spec.get("textured")
    if kind == "choice":
        return "Literal[" + ", ".join(f'"{choice}"' for choice in spec["choices"]) + "]"
    if kind == "float":
        return "TexturedNumber" if textured else "Number"
    if kind == "color":
        return "TexturedColor" if textured else "Color"
    names = {"vector": "Vector", "point": "Vector", "transform": "Transform", "file": "File", "material": "Node", "text": "str"}
    return names.get(kind, kind)


def lines_of(kind, entry):
    parameters = []
    for spec in entry["parameters"]:
        if spec["type"] in GEOMETRY:
            for name in GEOMETRY[spec["type"]]:
                needed = name in ("positions", "indices", "control_points", "widths")
                parameters.append(f"{name}: ArrayLike" if needed else f"{name}: ArrayLike | None = None")
            continue
        default = default_of(spec)
        kind_of_it = type_of(spec) + (" | None" if default is None else "")
        parameters.append(f"{spec['name']}: {kind_of_it} = {default!r}")
    parameters.append("name: str = ''")
    if kind == "material":
        parameters.extend(f"{relief}: Node | None = None" for relief in RELIEFS)
    yield f"def {entry['name']}("
    yield "    *,"
    yield from (f"    {parameter}," for parameter in parameters)
    yield ") -> Node:"
    yield f'    """{entry["summary"]}."""'
    yield ""


def stub(kind):
    used = textwrap.dedent(
        f'''\
        """All models of {kind}s. Made by python/make_stubs.py from the library's own list."""

        from typing import Literal

        from ._types import ArrayLike, Color, File, Node, Number, TexturedColor, TexturedNumber, Transform, Vector
        '''
    )
    body = [line for entry in catalog(kind + "s") for line in lines_of(kind, entry)]
    return used + "\n" + "\n".join(body).rstrip("\n") + "\n"


def main():
    package = pathlib.Path(__file__).parent / "ajar"
    old = []
    for kind in KINDS:
        path = package / f"{kind}s.pyi"
        text = stub(kind)
        if "--check" not in sys.argv:
            path.write_text(text, encoding="utf-8")
        elif not path.exists() or path.read_text(encoding="utf-8") != text:
            old.append(path.name)
    if old:
        sys.exit(f"not up to date: {', '.join(old)}; make them again with python/make_stubs.py")


if __name__ == "__main__":
    main()
