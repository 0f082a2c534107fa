#include "scene/shape/quadric_models.h"

#include <algorithm>

#include "scene/desc/declare.h"

namespace ajar {
namespace {

ParameterSpec phi_max() {
  return declare::number("phi_max", "360", "angle around z; less leaves a part out", "degrees");
}

ParameterSpec radius() { return declare::number("radius", "1", "distance from z, at most"); }

std::optional<Quadric> make_sphere(const desc::Node& node) {
  const float radius = node.number("radius");
  // Left out, the ends are those of the whole sphere.
  const auto end = [&](const char* name, float whole) {
    const float* given = std::get_if<float>(&node.get(name));
    return given == nullptr ? whole : *given;
  };
  return Quadric::sphere(radius, end("z_min", -radius), end("z_max", radius),
                         node.number("phi_max"));
}

std::optional<Quadric> make_disk(const desc::Node& node) {
  return Quadric::disk(node.number("height"), node.number("radius"), node.number("inner_radius"),
                       node.number("phi_max"));
}

std::optional<Quadric> make_cylinder(const desc::Node& node) {
  const float radius = node.number("radius");
  const float low = std::min(node.number("z_min"), node.number("z_max"));
  const float high = std::max(node.number("z_min"), node.number("z_max"));
  if (!(radius > 0.F)) return {};
  return Quadric::ruled({radius, 0.F, low}, {radius, 0.F, high}, node.number("phi_max"));
}

std::optional<Quadric> make_cone(const desc::Node& node) {
  const float radius = node.number("radius");
  if (!(radius > 0.F)) return {};
  return Quadric::ruled({radius, 0.F, 0.F}, {0.F, 0.F, node.number("height")},
                        node.number("phi_max"));
}

std::optional<Quadric> make_paraboloid(const desc::Node& node) {
  return Quadric::paraboloid(node.number("radius"), node.number("z_min"), node.number("z_max"),
                             node.number("phi_max"));
}

std::optional<Quadric> make_hyperboloid(const desc::Node& node) {
  const Vec3& p1 = node.vector("p1");
  const Vec3& p2 = node.vector("p2");
  // pbrt swaps the ends in this case, which turns the normal around.
  if (p2.z == 0.F) return Quadric::ruled(p2, p1, node.number("phi_max"));
  return Quadric::ruled(p1, p2, node.number("phi_max"));
}

}  // namespace

const std::vector<QuadricModel>& quadric_models() {
  static const char* const kSource = "Pharr et al. 2016, chapter 3";
  static const std::vector<QuadricModel> kModels{
      {{"cone",
        "a cone from the plane z = 0 to its tip",
        kSource,
        {radius(), declare::number("height", "1", "z of the tip"), phi_max()}},
       make_cone},
      {{"cylinder",
        "a cylinder around z, without lids",
        kSource,
        {radius(), declare::number("z_min", "-1", "lower end"),
         declare::number("z_max", "1", "upper end"), phi_max()}},
       make_cylinder},
      {{"disk",
        "a disk across z, with or without a hole",
        kSource,
        {declare::number("height", "0", "its z"), radius(),
         declare::number("inner_radius", "0", "radius of the hole"), phi_max()}},
       make_disk},
      {{"hyperboloid",
        "what a line makes that turns around z",
        kSource,
        {declare::point("p1", "0 0 0", "one end of the line"),
         declare::point("p2", "1 1 1", "the other end"), phi_max()}},
       make_hyperboloid},
      {{"paraboloid",
        "a bowl around z with its lowest point at the origin",
        kSource,
        {radius(), declare::number("z_min", "0", "lower end"),
         declare::number("z_max", "1", "upper end, where it has its radius"), phi_max()}},
       make_paraboloid},
      {{"sphere",
        "a sphere around the origin",
        kSource,
        {radius(), declare::number("z_min", "", "lower end; without it, the sphere's"),
         declare::number("z_max", "", "upper end; without it, the sphere's"), phi_max()}},
       make_sphere}};
  return kModels;
}

}  // namespace ajar
