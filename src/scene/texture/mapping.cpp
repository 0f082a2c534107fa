#include "scene/texture/mapping.h"

#include <algorithm>
#include <cmath>

#include "scene/desc/declare.h"

namespace ajar {

TextureMapping::TextureMapping(const desc::Node& node) : mapping_(mapping_of(node)) {}

TextureMapping::Mapping TextureMapping::mapping_of(const desc::Node& node) {
  const std::string& kind = node.text("mapping");
  if (kind == "spherical") return Spherical{node.transform("world_to_texture")};
  if (kind == "cylindrical") {
    return Cylindrical{node.transform("world_to_texture"), node.text("height") == "cosine"};
  }
  if (kind == "planar") {
    return Planar{node.vector("axis_u"), node.vector("axis_v"), node.number("offset_u"),
                  node.number("offset_v")};
  }
  const double angle = double{node.number("rotation")} * M_PI / 180.0;
  return Uv{node.number("scale_u"),
            node.number("scale_v"),
            static_cast<float>(std::cos(angle)),
            static_cast<float>(std::sin(angle)),
            node.number("offset_u"),
            node.number("offset_v")};
}

Vec2 TextureMapping::map_position(const Vec3& p) const {
  if (const auto* m = std::get_if<Spherical>(&mapping_)) {
    const Vec3 d = transform_point(m->world_to_texture, p);
    const float theta = std::atan2(std::hypot(d.x, d.y), d.z);
    const float phi = std::atan2(d.y, d.x);
    return {theta * kInvPi, (phi < 0.F ? phi + 2.F * kPi : phi) * (0.5F * kInvPi)};
  }
  if (const auto* m = std::get_if<Cylindrical>(&mapping_)) {
    const Vec3 d = transform_point(m->world_to_texture, p);
    const float size = m->is_direction ? length(d) : 1.F;
    return {(kPi + std::atan2(d.y, d.x)) * (0.5F * kInvPi), size > 0.F ? d.z / size : 0.F};
  }
  const auto& m = std::get<Planar>(mapping_);
  return {m.ds + dot(p, m.vs), m.dt + dot(p, m.vt)};
}

std::vector<ParameterSpec> mapping_parameters() {
  using declare::only_for;
  return {choice_parameter("mapping", {"uv", "spherical", "cylindrical", "planar"},
                           "from the surface's coordinates, or from its place"),
          only_for("mapping", {"uv"}, declare::number("scale_u", "1", "repetitions along u")),
          only_for("mapping", {"uv"}, declare::number("scale_v", "1", "repetitions along v")),
          only_for("mapping", {"uv"},
                   declare::number("rotation", "0", "of (u, v), from u to v, before the offset",
                                   "degrees")),
          only_for("mapping", {"uv", "planar"}, declare::number("offset_u", "0", "added to u")),
          only_for("mapping", {"uv", "planar"}, declare::number("offset_v", "0", "added to v")),
          only_for("mapping", {"planar"},
                   declare::vector("axis_u", "1 0 0", "u is the place times this")),
          only_for("mapping", {"planar"},
                   declare::vector("axis_v", "0 1 0", "v is the place times this")),
          only_for("mapping", {"cylindrical"},
                   choice_parameter("height", {"cosine", "place"},
                                    "v is the cosine to the axis, or how far along it")),
          only_for("mapping", {"spherical", "cylindrical"}, texture_space())};
}

ParameterSpec texture_space() {
  return declare::transform("world_to_texture", "from the world into the texture's own space");
}

}  // namespace ajar
