#include "import/gltf/lights.h"

#include <cmath>
#include <utility>

#include "core/printable_text.h"
#include "scene/desc/models.h"

namespace ajar::gltf {
namespace {

constexpr WarningKind kLightRange{Effect::Slight,
                                  "lights have a range, beyond which they shine, too"};
constexpr WarningKind kHardSpot{Effect::Slight,
                                "spots have two cone angles that are the same: hard edges"};
constexpr const char* kExtension = "KHR_lights_punctual";

float degrees(double radians) { return static_cast<float>(radians * 180.0 / M_PI); }

desc::Node spot_node(Context& context, const Element& light, const Vec3& intensity) {
  const std::optional<Element> spot = light.find("spot");
  const double inner = spot ? spot->value_or("innerConeAngle", 0.0) : 0.0;
  const double outer = spot ? spot->value_or("outerConeAngle", M_PI / 4) : M_PI / 4;
  if (!(inner >= 0.0 && inner <= outer && outer > 0.0 && outer <= M_PI / 2 + 1e-6)) {
    spot->fail("its cone angles must be 0 <= inner <= outer <= pi/2, the outer above 0");
  }
  if (inner == outer) {
    context.warnings.add(kHardSpot, spot->where(),
                         "its cone angles are the same, though the inner must be smaller: a cone "
                         "with a hard edge stands in");
  }
  return desc::light_node("spot", {{"intensity", intensity},
                                   {"cone_angle", degrees(outer)},
                                   {"falloff_start", degrees(inner)},
                                   {"falloff", std::string("quadratic")}});
}

Vec3 strength_of(const Element& light) {
  return light.value_or("color", Vec3(1.F)) * light.value_or("intensity", 1.F);
}

desc::Node node_of(Context& context, const Element& light) {
  static const std::vector<std::string> kTypes = {"directional", "point", "spot"};
  const Element type = light.at("type");
  const std::string name = type.text();
  const Vec3 strength = strength_of(light);
  if (name == "directional") return desc::light_node("distant", {{"irradiance", strength}});
  if (name == "point") return desc::light_node("point", {{"intensity", strength}});
  if (name == "spot") return spot_node(context, light, strength);
  type.fail(unknown_name_message("type of light", printable_line(name), kTypes));
}

}  // namespace

void add_lights(Context& context, const std::vector<PlacedNode>& nodes) {
  const std::optional<Element> extension = extension_of(context.document.root, kExtension);
  const std::vector<Element> lights =
      extension ? extension->items("lights") : std::vector<Element>();
  for (const PlacedNode& placed : nodes) {
    const std::optional<Element> reference = extension_of(placed.node, kExtension);
    if (!reference || !placed.is_visible) continue;
    const Element& light = lights[reference->at("light").index(lights.size())];
    desc::Node node = light.located([&] { return node_of(context, light); });
    if (strength_of(light) == Vec3(0.F)) continue;
    desc::Light& added = context.scene.lights.emplace_back();
    added.where = light.where();
    added.node = std::move(node);
    // Spots shine along −z here and along +z there; a `distant` light comes from +z in both.
    added.to_world = without_scale(placed.to_world);
    if (added.node.is("spot")) added.to_world = turned_around(added.to_world);
    if (light.has("range")) {
      context.warnings.add(kLightRange, light.where(), "the range of this light is ignored");
    }
  }
}

}  // namespace ajar::gltf
