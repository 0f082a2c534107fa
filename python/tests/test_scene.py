import inspect
import pathlib
import tempfile
import unittest

import numpy
from support import SMALL

import ajar

GROUND = numpy.array([[-2, 0, -2], [2, 0, -2], [2, 0, 2], [-2, 0, 2]])
FACES = numpy.array([[0, 2, 1], [0, 3, 2]])
CAMERA = {"origin": (0.5, 2, 5), "target": (0, 0.4, 0), "fov": 40}
SIZE = {"integrator": "pt", "spp": 8}

# The same as `room` makes. pbrt's LookAt is left-handed: mirrored, it is ours.
PBRT = """
Scale -1 1 1
LookAt 0.5 2 5  0 0.4 0  0 1 0
Camera "perspective" "float fov" 40
Film "image" "integer xresolution" 24 "integer yresolution" 18
PixelFilter "box"
Integrator "path" "integer maxdepth" 99
WorldBegin
LightSource "point" "rgb I" [3 3 3] "point from" [0 3 1]
Material "matte" "rgb Kd" [0.8 0.1 0.1]
Shape "trianglemesh" "integer indices" [0 2 1 0 3 2] "point P" [-2 0 -2  2 0 -2  2 0 2  -2 0 2]
AttributeBegin
  Translate 0 0.5 0
  Rotate 30 0 1 0
  Material "glass" "float eta" 1.4
  Shape "sphere" "float radius" 0.5
AttributeEnd
AttributeBegin
  Translate 1 1.5 0
  Material "matte" "rgb Kd" [0 0 0]
  AreaLightSource "diffuse" "rgb L" [5 4 3]
  Shape "sphere" "float radius" 0.1
AttributeEnd
WorldEnd
"""


def room():
    scene = ajar.Scene(camera=ajar.Camera(**CAMERA), resolution=(24, 18))
    scene.add(ajar.lights.point(intensity=3), to_world=ajar.translate(0, 3, 1))
    red = ajar.materials.diffuse(reflectance=(0.8, 0.1, 0.1), name="red")
    scene.add(ajar.shapes.mesh(positions=GROUND, indices=FACES), material=red, name="ground")
    scene.add(
        ajar.shapes.sphere(radius=0.5),
        to_world=ajar.translate(0, 0.5, 0) @ ajar.rotate(30, (0, 1, 0)),
        material=ajar.materials.dielectric(eta=1.4, name="glass"),
        name="ball",
    )
    scene.add(
        ajar.shapes.sphere(radius=0.1),
        to_world=ajar.translate(1, 1.5, 0),
        material=ajar.materials.diffuse(reflectance=0),
        emission=ajar.emissions.area(radiance=(5, 4, 3)),
        name="lamp",
    )
    return scene


class Code(unittest.TestCase):
    def test_makes_the_scene_that_a_file_makes(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "scene.pbrt"
            path.write_text(PBRT)
            theirs = ajar.load(path).render(**SIZE).pixels
        ours = room().render(**SIZE).pixels
        self.assertGreater(ours.mean(), 0.01)
        numpy.testing.assert_allclose(ours, theirs, rtol=1e-4, atol=1e-5)

    def test_edits_what_is_there(self):
        scene = room()
        before = scene.render(**SIZE)
        self.assertEqual([material["name"] for material in scene.materials], ["red", "glass", ""])
        self.assertEqual(scene.materials[0]["parameters"]["reflectance"], [0.8, 0.1, 0.1])
        self.assertEqual(scene.shapes[2]["emission"]["parameters"]["radiance"], [5, 4, 3])
        running = scene.start(time=600, integrator="pt")
        scene.edit(material="red", reflectance=(0.1, 0.8, 0.1))
        scene.edit(light=0, intensity=(1, 2, 3))
        scene.edit(emission="lamp", radiance=0)
        scene.edit(shape="ball", radius=0.25, to_world=ajar.translate(0, 0.25, 0))
        after = scene.render(**SIZE)
        self.assertFalse(numpy.array_equal(before.pixels, after.pixels))
        running.stop()
        self.assertTrue(running.wait())
        # To and fro.
        scene.edit(material=0, reflectance=(0.8, 0.1, 0.1))
        scene.edit(light=0, intensity=3)
        scene.edit(emission=2, radiance=(5, 4, 3))
        scene.edit(shape=1, radius=0.5, to_world=ajar.translate(0, 0.5, 0) @ ajar.rotate(30, (0, 1, 0)))
        numpy.testing.assert_array_equal(scene.render(**SIZE).pixels, before.pixels)
        with self.assertRaisesRegex(ajar.SceneError, r"test_scene\.py:\d+: .*did you mean \"red\""):
            scene.edit(material="rad", reflectance=1)
        with self.assertRaisesRegex(ajar.SceneError, "reflectance"):
            scene.edit(material="red", reflectance="bright")
        with self.assertRaisesRegex(ajar.SceneError, "emits no light"):
            scene.edit(emission="ball", radiance=2)
        with self.assertRaises(ajar.UsageError):
            scene.edit(material="red", light=0)
        numpy.testing.assert_array_equal(scene.render(**SIZE).pixels, before.pixels)

    def test_edits_scenes_of_files(self):
        scene = ajar.load("builtin:cornell")
        before = scene.render(**SMALL).pixels
        scene.add(ajar.lights.point(intensity=1), to_world=ajar.translate(0, 0, 0))
        scene.camera = ajar.Camera(origin=(278, 273, -800), target=(278, 273, 0), fov=60)
        self.assertFalse(numpy.array_equal(scene.render(**SMALL).pixels, before))
        names = [material["name"] for material in scene.materials]
        scene.edit(material=0, **{"reflectance": 0.9} if "reflectance" in scene.materials[0]["parameters"] else {})
        self.assertEqual([material["name"] for material in scene.materials], names)

    def test_takes_images_of_arrays(self):
        scene = room()
        checker = numpy.indices((4, 4)).sum(axis=0) % 2
        as_shown = numpy.repeat((checker * 255).astype(numpy.uint8)[:, :, None], 3, axis=2)
        linear = checker.astype(numpy.float32)
        pictures = []
        for image in (as_shown, linear, ajar.textures.image(file=linear), numpy.stack([linear] * 3, 2)):
            painted = ajar.Scene(camera=ajar.Camera(origin=(0, 4, 0.01), target=(0, 0, 0), fov=40), resolution=(24, 18))
            painted.add(ajar.lights.environment(radiance=1))
            painted.add(
                ajar.shapes.mesh(positions=GROUND, indices=FACES, uvs=[[0, 0], [1, 0], [1, 1], [0, 1]]),
                material=ajar.materials.diffuse(reflectance=image),
            )
            pictures.append(painted.render(**SIZE).pixels)
        for picture in pictures[1:]:
            numpy.testing.assert_array_equal(picture, pictures[0])
        self.assertGreater(pictures[0][6:12, 8:16].std(), 0.1)
        sky = numpy.zeros((8, 16, 3), numpy.float32)
        sky[:4] = 1
        scene.add(ajar.lights.environment(image=sky))
        bright = scene.render(**SIZE)
        self.assertGreater(bright.pixels.mean(), room().render(**SIZE).pixels.mean())
        with scene.start(**SIZE) as session:
            session.wait()
            self.assertFalse([warning for warning in session.warnings if "magenta" in warning])
        with self.assertRaisesRegex(ajar.SceneError, "uint8.*floats"):
            scene.add(ajar.shapes.sphere(), material=ajar.materials.diffuse(reflectance=checker))
        with self.assertRaisesRegex(ajar.SceneError, "rows x columns"):
            scene.add(ajar.shapes.sphere(), material=ajar.materials.diffuse(reflectance=numpy.zeros((2, 2, 5))))
            scene.render(**SIZE)

    def test_tells_what_is_wrong_and_where(self):
        place = r"test_scene\.py:\d+: "
        with self.assertRaisesRegex(ajar.SceneError, 'did you mean "reflectance"'):
            ajar.materials.diffuse(reflectanse=1)
        with self.assertRaisesRegex(ajar.SceneError, "fov.*must be between"):
            ajar.lights.projection(fov=200)
        with self.assertRaisesRegex(ajar.SceneError, "reflectance.*a number"):
            ajar.materials.diffuse(reflectance="red")
        with self.assertRaises(TypeError):
            ajar.materials.diffuse(reflectance=object())
        with self.assertRaises(AttributeError):
            ajar.materials.difuse  # noqa: B018
        with self.assertRaisesRegex(ajar.SceneError, "cannot be a light"):
            ajar.materials.diffuse(reflectance=ajar.lights.point())
        with self.assertRaisesRegex(ajar.SceneError, "no direction"):
            ajar.Camera(origin=(1, 1, 1), target=(1, 1, 1))

        def refused(node, message, **options):
            scene = ajar.Scene()
            with self.assertRaisesRegex(ajar.SceneError, message):
                scene.add(node, **options)
                scene.render(**SMALL)

        refused(ajar.shapes.mesh(positions=GROUND, indices=[[0, 1, 4]]), place)
        refused(ajar.shapes.mesh(positions=GROUND, indices=[[0, 1, -4]]), "from 0 on")
        refused(ajar.shapes.mesh(positions=GROUND, indices=[[0.0, 1, 2]]), "whole numbers")
        refused(ajar.shapes.mesh(positions=GROUND[:, :2], indices=FACES), place + ".*N x 3")
        refused(ajar.shapes.mesh(positions=GROUND * numpy.nan, indices=FACES), place)
        refused(ajar.shapes.mesh(positions=GROUND, indices=FACES, normals=GROUND[:2]), "2 normals")
        refused(ajar.shapes.sphere(), "unknown material", material="red")
        refused(ajar.shapes.sphere(), "4 x 4", to_world=numpy.eye(3))
        refused(ajar.emissions.area(), "given to a shape")
        with self.assertRaisesRegex(ajar.SceneError, "below 180"):
            ajar.Scene(camera=ajar.Camera(fov=190)).render(**SMALL)
        with self.assertRaisesRegex(ajar.SceneError, 'unknown member "fow"; did you mean "fov"'):
            ajar.Scene(camera=ajar.Camera(fow=19)).render(**SMALL)

    def test_has_functions_for_all_models(self):
        for kind in ("materials", "textures", "lights", "emissions", "shapes"):
            module = getattr(ajar, kind)
            self.assertTrue(module.__all__)
            for name in module.__all__:
                self.assertTrue(getattr(module, name).__doc__)
                self.assertTrue(inspect.signature(getattr(module, name)).parameters)
        self.assertEqual(inspect.signature(ajar.materials.dielectric).parameters["eta"].default, 1.5)
        self.assertIn("selective", ajar.list_integrators())
        self.assertIn("builtin:cornell", ajar.list_scenes())
        self.assertIn("normal", ajar.list_aovs())

    def test_shares_materials_and_keeps_cameras(self):
        scene = ajar.Scene(resolution=(24, 18))
        glass = ajar.materials.dielectric(name="glass")
        frosted = ajar.materials.mix(first=glass, second=ajar.materials.diffuse(), amount=0.3, name="frosted")
        for material in (glass, frosted, "glass", frosted):
            scene.add(ajar.shapes.sphere(), material=material)
        fog = ajar.Medium(sigma_s=(0.1, 0.1, 0.1), name="fog")
        scene.add(ajar.shapes.sphere(radius=9), material=ajar.materials.interface(), inside=fog)
        self.assertEqual([material["name"] for material in scene.materials], ["glass", "", "frosted", ""])
        self.assertEqual([shape["material"] for shape in scene.shapes], [0, 2, 0, 2, 3])
        for camera in (
            ajar.Camera("orthographic", origin=(0, 0, -9), target=(0, 0, 0), half_height=2),
            ajar.Camera("environment", to_world=numpy.eye(4)),
        ):
            scene.camera = camera
            scene.render(spp=1, integrator="pt")
        self.assertEqual(scene.resolution, (24, 18))


if __name__ == "__main__":
    unittest.main()
