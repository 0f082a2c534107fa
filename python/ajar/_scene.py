"""Scenes: read from files, or made of meshes, materials and lights."""

import json
import os
import threading

import numpy

from ._errors import SceneError, UsageError
from ._library import Array, Handle, call_for_handle, call_for_json, encoded
from ._nodes import GEOMETRY, Medium, Node, calling_place, is_image, plain_value, shown, spec_of
from ._session import Session, checked_seconds
from ._transforms import look_at

_TYPES = {numpy.dtype(numpy.float32): 0, numpy.dtype(numpy.uint32): 1, numpy.dtype(numpy.uint8): 2}
_INTEGERS = ("indices",)


class Camera:
    """Where a picture is seen from: `perspective` (with the angle of the shorter side, degrees), `orthographic` (with half the
    height of what is seen) or `environment` (all around). It stands at `origin` and looks at `target`, or as `to_world` says, in
    which it looks along z."""

    __slots__ = ("model", "to_world", "settings", "where")

    def __init__(self, model="perspective", *, origin=None, target=None, up=(0, 1, 0), to_world=None, **settings):
        if to_world is None:
            to_world = look_at(origin if origin is not None else (0, 0, 0), target if target is not None else (0, 0, 1), up)
        elif origin is not None or target is not None:
            raise UsageError("a camera stands where origin and target say, or to_world: not both")
        self.model = model
        self.to_world = to_world
        self.settings = settings
        self.where = calling_place()

    def description(self):
        settings = {name: plain_value(value, name) for name, value in self.settings.items()}
        settings["model"] = plain_value(self.model, "model")
        settings["to_world"] = _matrix(self.to_world)
        return {**settings, "where": self.where}


def _matrix(value):
    try:
        matrix = numpy.asarray(value, float)
    except (TypeError, ValueError):
        raise SceneError(f"a transform is a matrix of 4 x 4 numbers, not {shown(value)}") from None
    if matrix.shape != (4, 4):
        raise SceneError(f"a transform is a matrix of 4 x 4, not of {' x '.join(map(str, matrix.shape)) or 'nothing'}")
    return plain_value(matrix, "to_world")


def _numbers(name, value):
    """An array as the library takes it."""
    try:
        array = numpy.asarray(value)
    except ValueError as error:
        raise SceneError(f"{name}: {error}") from None
    if array.dtype.kind not in "biuf":
        raise SceneError(f"{name} are numbers, not {array.dtype}")
    if not 1 <= array.ndim <= 3:
        raise SceneError(f"{name} are an array of one to three dimensions, not {array.ndim}")
    if name in _INTEGERS:
        if array.dtype.kind not in "iu":
            raise SceneError(f"{name} are whole numbers, not {array.dtype}")
        if array.size and (array.min() < 0 or array.max() > 0xFFFFFFFF):
            raise SceneError(f"{name} are from 0 on")
        array = array.astype(numpy.uint32)
    else:
        array = array.astype(numpy.float32)
    return numpy.ascontiguousarray(array)


def _image(value):
    if value.dtype == numpy.uint8:
        return numpy.ascontiguousarray(value)
    if value.dtype.kind != "f":
        raise SceneError(f"an image is an array of uint8 (as it is shown) or of floats (linear), not of {value.dtype}")
    return numpy.ascontiguousarray(value, numpy.float32)


class _Changes:
    """What is to be done to a scene, as the library takes it."""

    def __init__(self):
        self.arrays = []
        self.json = {"media": [], "textures": [], "materials": [], "shapes": [], "lights": [], "edits": []}
        self._known = {}

    def array(self, array):
        key = id(array)
        if key not in self._known:
            self.arrays.append(array)
            self._known[key] = (len(self.arrays) - 1, array)
        return self._known[key][0]

    def reference(self, node):
        """The number of a texture or a material, which comes before what refers to it."""
        if isinstance(node, str):
            return node
        if not isinstance(node, Node) or node.kind not in ("texture", "material"):
            raise SceneError(f"this is no texture or material, nor the name of one: {shown(node)}")
        if id(node) not in self._known:
            made = self.node(node)
            if node.name:
                made["name"] = node.name
            for what, texture in node.relief.items():
                made[what] = self.reference(texture)
            things = self.json[node.kind + "s"]
            things.append(made)
            self._known[id(node)] = (len(things) - 1, node)
        return self._known[id(node)][0]

    def medium(self, medium):
        if isinstance(medium, str):
            return medium
        if not isinstance(medium, Medium):
            raise TypeError(f"what is inside or outside is an ajar.Medium or the name of one, not {shown(medium)}")
        if id(medium) not in self._known:
            made = {name: plain_value(getattr(medium, name), name) for name in ("name", "sigma_a", "sigma_s", "g")}
            self.json["media"].append({**made, "where": medium.where})
            self._known[id(medium)] = (len(self.json["media"]) - 1, medium)
        return self._known[id(medium)][0]

    def node(self, node):
        return {
            "model": node.model,
            "parameters": self.parameters(node.kind, node.model, node.parameters),
            "where": node.where,
        }

    def parameters(self, kind, model, given):
        parameters = {}
        for name, value in given.items():
            spec = spec_of(kind, model, name)
            geometry = None if spec else self._geometry_of(kind, model, name)
            if geometry:
                if value is not None:
                    parameters.setdefault(geometry, {})[name] = self.array(_numbers(name, value))
            elif isinstance(value, Node):
                parameters[name] = {value.kind: self.reference(value)}
            elif is_image(spec, value):
                image = {"image": self.array(_image(value))}
                is_file = spec and spec["type"] == "file"
                parameters[name] = image if is_file else {"texture": self.reference(self._texture_of(value))}
            else:
                parameters[name] = plain_value(value, name)
        return parameters

    @staticmethod
    def _geometry_of(kind, model, name):
        """The parameter that an array is part of."""
        from ._catalog import catalog

        for entry in catalog(kind + "s"):
            for spec in entry["parameters"] if entry["name"] == model else ():
                if name in GEOMETRY.get(spec["type"], ()):
                    return spec["name"]
        return None

    def _texture_of(self, image):
        key = ("texture of", id(image))
        if key not in self._known:
            self._known[key] = (Node("texture", "image", {"file": image}), image)
        return self._known[key][0]

    def apply(self, base):
        arrays = (Array * len(self.arrays))()
        for to, array in zip(arrays, self.arrays):
            to.data = array.ctypes.data
            to.type = _TYPES[array.dtype]
            to.dimensions = array.ndim
            if not 1 <= array.ndim <= 3:
                raise SceneError(f"an array has one to three dimensions, not {array.ndim}")
            to.shape = tuple(array.shape) + (1,) * (3 - array.ndim)
        text = json.dumps({name: part for name, part in self.json.items() if part != []})
        return call_for_handle("ajar_scene_change", base, text.encode(), arrays, len(self.arrays))


class Scene:
    """A scene, for any number of renders, also at once and from several threads. What is added or edited concerns renders that
    begin afterwards."""

    def __init__(self, *, camera=None, resolution=None, name="scene"):
        self._lock = threading.RLock()
        self._handle = None
        self._pending = _Changes()
        self._pending.json["source"] = plain_value(name, "name")
        self._has_pending = True
        if camera is not None:
            self.camera = camera
        if resolution is not None:
            self.resolution = resolution

    @classmethod
    def load(cls, path):
        """Reads a scene: a file in any format that `ajar render` takes, or `builtin:NAME`."""
        scene = cls.__new__(cls)
        scene._lock = threading.RLock()
        scene._pending = None
        scene._has_pending = False
        scene._handle = Handle(call_for_handle("ajar_scene_load", encoded(path)), "ajar_scene_free")
        return scene

    def _change(self):
        if self._pending is None:
            self._pending = _Changes()
        self._has_pending = True
        return self._pending

    def _current(self):
        """The library's scene, with all that was added. What it refuses is not kept."""
        with self._lock:
            if self._has_pending:
                pending, self._pending, self._has_pending = self._pending, None, False
                base = self._handle.pointer if self._handle else None
                try:
                    self._handle = Handle(pending.apply(base), "ajar_scene_free")
                finally:
                    # Without a scene it stays an empty one.
                    if self._handle is None:
                        self._has_pending = True
                        self._pending = _Changes()
            return self._handle

    # ---- what there is

    def _information(self):
        return call_for_json("ajar_scene_information", self._current().pointer)

    def _parts(self):
        return call_for_json("ajar_scene_parts", self._current().pointer)

    @property
    def name(self):
        return self._information()["name"]

    @property
    def resolution(self):
        """Width and height of the picture that it asks for, pixels."""
        information = self._information()
        return information["width"], information["height"]

    @resolution.setter
    def resolution(self, size):
        try:
            size = tuple(size)
        except TypeError:
            raise TypeError(f"resolution: width and height, not {shown(size)}") from None
        with self._lock:
            self._change().json["film"] = {"resolution": plain_value(size, "resolution"), "where": calling_place()}

    @property
    def warnings(self):
        """What is unusual in its files, one sentence each, with its place: what matters most first."""
        return self._information()["warnings"]

    @property
    def materials(self):
        """Name, model and parameters of each."""
        return self._parts()["materials"]

    @property
    def textures(self):
        """Name, model and parameters of each."""
        return self._parts()["textures"]

    @property
    def lights(self):
        """Model and parameters of each light that comes from no surface."""
        return self._parts()["lights"]

    @property
    def shapes(self):
        """Name, model, parameters and emission of each; those of instances are not among them."""
        return self._parts()["shapes"]

    # ---- changes

    def _set_camera(self, camera):
        if not isinstance(camera, Camera):
            raise TypeError(f"a camera is an ajar.Camera, not {shown(camera)}")
        with self._lock:
            self._change().json["camera"] = camera.description()

    camera = property(fset=_set_camera, doc="Where the picture is seen from: an `ajar.Camera`. It can only be set.")

    def add(
        self,
        node,
        *,
        material=None,
        emission=None,
        to_world=None,
        name="",
        alpha=None,
        shadow_alpha=None,
        reverse_orientation=False,
        inside=None,
        outside=None,
    ):
        """Adds a shape or a light, or a material or a texture for later. `material`: one of `ajar.materials`, or the name of one
        that is there; `emission`: one of `ajar.emissions`. Materials that are shared are added once. Returns the node."""
        if not isinstance(node, Node):
            raise TypeError(f"what is added is made by ajar.shapes, lights, materials or textures, not {shown(node)}")
        with self._lock:
            changes = self._change()
            if node.kind in ("material", "texture"):
                changes.reference(node)
                return node
            made = changes.node(node)
            made["name"] = plain_value(name, "name") or node.name
            if to_world is not None:
                made["to_world"] = _matrix(to_world)
            if node.kind == "light":
                if inside is not None:
                    made["medium"] = changes.medium(inside)
                del made["name"]
                changes.json["lights"].append(made)
                return node
            if node.kind != "shape":
                raise SceneError(f"a {node.kind} is given to a shape: scene.add(ajar.shapes…, {node.kind}=…)")
            if material is not None:
                made["material"] = changes.reference(material)
            for key, texture in (("alpha", alpha), ("shadow_alpha", shadow_alpha)):
                if texture is not None:
                    made[key] = changes.reference(texture)
            if emission is not None:
                if not isinstance(emission, Node) or emission.kind != "emission":
                    raise TypeError(f"emission: what ajar.emissions make, not {shown(emission)}")
                made["emission"] = changes.node(emission)
            for key, medium in (("inside", inside), ("outside", outside)):
                if medium is not None:
                    made[key] = changes.medium(medium)
            made["reverse_orientation"] = bool(reverse_orientation)
            changes.json["shapes"].append(made)
            return node

    def edit(self, *, material=None, light=None, emission=None, shape=None, texture=None, to_world=None, **parameters):
        """Changes parameters of what is there: `edit(material="glass", eta=1.33)`, `edit(light=0, intensity=5)`,
        `edit(emission="lamp", radiance=20)` of a shape, `edit(shape="box", to_world=…)`. Things go by their names, or by their
        number in `materials`, `lights`, `shapes`, `textures`. Geometry is shared with the scene before."""
        kinds = {"material": material, "light": light, "emission": emission, "shape": shape, "texture": texture}
        if shape is not None and material is not None:
            del kinds["material"]
        given = {kind: which for kind, which in kinds.items() if which is not None}
        if len(given) != 1:
            raise UsageError("edit is told one thing to change: material, light, emission, shape or texture")
        ((kind, which),) = given.items()
        with self._lock:
            current = self._current()
            changes = _Changes()
            which = plain_value(which, kind)
            model = self._model_of(kind, which)
            node_kind = kind
            change = {"kind": kind, "which": which, "where": calling_place()}
            change["parameters"] = changes.parameters(node_kind, model, parameters)
            if shape is not None and material is not None:
                change["material"] = changes.reference(material)
            if to_world is not None:
                change["to_world"] = _matrix(to_world)
            changes.json["edits"].append(change)
            self._handle = Handle(changes.apply(current.pointer), "ajar_scene_free")

    def _model_of(self, kind, which):
        """The model of what is edited; empty where the library will say that there is no such thing."""
        if isinstance(which, bool) or not isinstance(which, (str, int)):
            raise TypeError(f"{kind}: a name, or a number from 0 on, not {shown(which)}")
        things = self._parts()["shapes" if kind == "emission" else kind + "s"]
        if isinstance(which, str):
            found = [thing for thing in things if thing["name"] == which][-1:]
        else:
            found = things[which : which + 1] if 0 <= which < len(things) else []
        if not found:
            return ""
        node = found[0].get("emission") if kind == "emission" else found[0]
        return node["model"] if node else ""

    # ---- renders

    def start(self, **settings):
        """Begins to render and returns at once: a `Session`. Settings as of `render`."""
        return Session(self._current(), settings)

    def render(self, *, progress=None, **settings):
        """Renders to the end, and returns the picture.

        time (seconds until the finished picture), spp (samples per pixel), target_error: whichever comes first; without any,
        64 samples per pixel.
        integrator: one of `ajar.list_integrators()`; all settings that are not named here are its parameters.
        seed, resolution=(width, height), scale, depth=(least, most) or most, crop=(x0, y0, x1, y1), filter="NAME:RADIUS",
        layers=["normal", …], denoise=True, False, "oidn" or "builtin", threads.
        checkpoint=FILE, checkpoint_every (seconds), resume.
        progress: called now and then with a `Progress`.

        Other threads of Python go on meanwhile; Ctrl-C ends it. A file that cannot be written, such as the checkpoint, is a
        `RuntimeWarning` that says where it is instead."""
        if progress is not None and not callable(progress):
            raise TypeError(f"progress: a function, not {shown(progress)}")
        with self.start(**settings) as session:
            while not session.wait(0.2 if progress else None):
                progress(session.progress())
            return session.picture()

    def render_iter(self, *, every=1.0, **settings):
        """Renders, and gives the picture as it is every so many seconds, the finished one last. To leave the loop ends the
        render. Settings as of `render`."""
        every = checked_seconds(every, "every")
        with self.start(**settings) as session:
            while not session.wait(every):
                picture = session.picture()
                if picture is not None:
                    yield picture
            yield session.picture()

    def __repr__(self):
        width, height = self.resolution
        return f"<ajar.Scene {self.name}, {width} x {height}>"


def load(path):
    """Reads a scene: a file in any format that `ajar render` takes, or `builtin:NAME`."""
    if not isinstance(path, (str, os.PathLike)):
        raise TypeError(f"a scene is the name of a file, or builtin:NAME, not {shown(path)}")
    return Scene.load(path)
