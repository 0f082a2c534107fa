"""Ajar renders the light that other renderers miss.

    import ajar
    scene = ajar.load("builtin:torus-in-glass")
    scene.render(time=20, denoise=True).save("torus.png")

docs/python.md shows the rest.
"""

from . import emissions, lights, materials, shapes, textures
from ._catalog import list_aovs, list_integrators, list_scenes
from ._comparing import Comparison, compare
from ._errors import Error, FileError, SceneError, Stopped, UsageError
from ._library import version as _version
from ._nodes import Medium, Node
from ._picture import Picture, open_picture
from ._scene import Camera, Scene, load
from ._session import Progress, Session
from ._studying import Study, study
from ._transforms import look_at, rotate, scale, translate

__version__ = _version()

__all__ = [
    "Camera",
    "Comparison",
    "Error",
    "FileError",
    "Medium",
    "Node",
    "Picture",
    "Progress",
    "Scene",
    "SceneError",
    "Session",
    "Stopped",
    "Study",
    "UsageError",
    "compare",
    "emissions",
    "lights",
    "list_aovs",
    "list_integrators",
    "list_scenes",
    "load",
    "look_at",
    "materials",
    "open_picture",
    "rotate",
    "scale",
    "shapes",
    "study",
    "textures",
    "translate",
]
