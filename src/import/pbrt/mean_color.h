#pragma once
#include "import/pbrt/writer_images.h"
#include "scene/desc/scene_desc.h"

namespace ajar::pbrt {

/// Mean colour of a texture, for pbrt's lamps, which have one colour: that of its images, and of
/// patterns half of each part.
Vec3 mean_color(const desc::SceneDesc& scene, ImageWriter& images, desc::TextureId id);

}  // namespace ajar::pbrt
