#!/usr/bin/env python3
"""Writes every mesh of the built-in scenes: python3 make_scenes.py [scene ...]

Needs Python 3 and NumPy. Deterministic: the same script writes the same bytes. The scene files
themselves (materials, lights, cameras) are written by hand, beside the meshes.
"""
import pathlib
import sys

import bathroom
import cornell
import door_ajar
import floor_lamps
import pool
import torus_in_glass
from meshlib import write

SCENES = {
    "cornell": cornell,
    "door-ajar": door_ajar,
    "torus-in-glass": torus_in_glass,
    "pool": pool,
    "floor-lamps": floor_lamps,
    "bathroom": bathroom,
}


def main():
    root = pathlib.Path(__file__).resolve().parent.parent
    names = sys.argv[1:] or list(SCENES)
    for name in names:
        folder = root / name
        folder.mkdir(exist_ok=True)
        meshes = SCENES[name].meshes()
        for old in folder.glob("*.ply"):
            if old.stem not in meshes:
                old.unlink()
        for stem, mesh in meshes.items():
            write(folder / f"{stem}.ply", mesh)
        size = sum(f.stat().st_size for f in folder.iterdir())
        print(f"{name}: {len(meshes)} meshes, {size / 1e6:.2f} MB")


if __name__ == "__main__":
    main()
