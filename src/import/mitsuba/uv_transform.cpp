#include "import/mitsuba/uv_transform.h"

#include <cmath>

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kTurned{
    Effect::Surface,
    "textures are turned or sheared by \"to_uv\", which is not supported: straight"};

}  // namespace

void UvTransform::set(desc::Node& texture) const {
  texture.set("scale_u", scale.x);
  texture.set("scale_v", scale.y);
  texture.set("offset_u", offset.x);
  texture.set("offset_v", offset.y);
}

UvTransform read_uv_transform(Arguments& arguments) {
  UvTransform result;
  if (const std::optional<Mat4> to_uv = arguments.transform("to_uv")) {
    const Mat4& m = *to_uv;
    result.scale = Vec2(static_cast<float>(m[0][0]), static_cast<float>(m[1][1]));
    // Mitsuba 3 takes 9 numbers for a matrix in space, too, whose third column moves no plane.
    result.offset = Vec2(static_cast<float>(m[3][0]), static_cast<float>(m[3][1]));
    constexpr double kNothing = 1e-6;
    if (std::abs(m[0][1]) > kNothing || std::abs(m[1][0]) > kNothing) {
      arguments.context().warnings.add(
          kTurned, arguments.where(),
          "\"to_uv\" turns or shears this texture, which is not supported: it stays straight");
    }
  }
  const float scale = arguments.number("uvscale", 1.F);
  result.scale *= Vec2(arguments.number("uscale", scale), arguments.number("vscale", scale));
  result.offset += Vec2(arguments.number("uoffset", 0.F), arguments.number("voffset", 0.F));
  return result;
}

}  // namespace ajar::mitsuba
