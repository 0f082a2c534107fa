#pragma once
#include "scene/desc/scene_desc.h"

/// Studio for a model without camera and lights: a photographer's table with a large soft light
/// above it, a smaller one behind, and a dim sky.
namespace ajar {

/// The axis of a model that points up.
enum class UpAxis { Y, Z };

/// Parts that a scene defines itself.
struct SceneParts {
  bool has_camera = false;
  bool has_lights = false;  ///< lights that are no surfaces
  /// True if emissive surfaces are known to be lamps, not just parts of a picture of them.
  bool has_lamps = true;
};

/// Adds missing parts. With neither camera nor lights, all of it: emissive surfaces do not make a
/// studio. With a camera alone, lights, unless a surface is a lamp. With lights alone, a camera.
void add_studio(desc::SceneDesc& scene, const SceneParts& parts, UpAxis up);

/// Adds a light grey material with a soft gloss, for surfaces that have none.
desc::MaterialId add_neutral_material(desc::SceneDesc& scene);

/// The box in the world of all meshes, spheres, disks, cylinders and curves; empty if there are
/// none.
Imath::Box3d bounds_of_shapes(const desc::SceneDesc& scene);

}  // namespace ajar
