#pragma once
#include "import/mitsuba/arguments.h"
#include "scene/desc/node.h"

namespace ajar::mitsuba {

/// Transform of a texture's coordinates before lookup: u' = scale · u + offset.
struct UvTransform {
  Vec2 scale{1.F, 1.F};
  Vec2 offset{0.F, 0.F};

  void set(desc::Node& texture) const;
};

/// From "to_uv" (Mitsuba 2 and 3) or "uscale", "uoffset", … (0.x). Rotation and shear are left out,
/// with a warning.
UvTransform read_uv_transform(Arguments& arguments);

}  // namespace ajar::mitsuba
