#include "import/pbrt/writer_substitutes.h"

#include <algorithm>
#include <cmath>

namespace ajar::pbrt {
namespace {

/// pbrt-v3's substrate has a gloss where ours has an index of refraction: that along the normal.
void add_gloss(const desc::Node& coated, Substitutes& result) {
  constexpr float kEtaOfVarnish = 1.5F;
  const float* eta = std::get_if<float>(&coated.get("eta"));
  const float index = eta == nullptr ? kEtaOfVarnish : std::max(*eta, 1.F);
  const float ratio = (index - 1.F) / (index + 1.F);
  const Vec3* tint = std::get_if<Vec3>(&coated.get("coat_reflectance"));
  result["coat"] = result["coat_reflectance"] = result["eta"] = desc::Value();
  result["glossy_reflectance"] = (tint == nullptr ? Vec3(1.F) : *tint) * (ratio * ratio);
}

/// An index of 1 and the extinction that reflects `r` along the normal: r = k² / (4 + k²).
void add_index(const Vec3& reflectance, Substitutes& result) {
  Vec3 k;
  for (int i = 0; i < 3; ++i) {
    const float r = std::clamp(reflectance[i], 0.F, 0.9999F);
    k[i] = 2.F * std::sqrt(r / (1.F - r));
  }
  result["eta"] = Vec3(1.F);
  result["k"] = k;
  result["reflectance"] = desc::Value();
}

/// Other maps than squares, where pbrt would map the roughness: resolved to α.
void add_alpha(const desc::Node& node, Substitutes& result) {
  const bool is_uneven =
      node.has("roughness_v") && !std::holds_alternative<std::monostate>(node.get("roughness_v"));
  const float* u = std::get_if<float>(&node.get("roughness"));
  const float* v = is_uneven ? std::get_if<float>(&node.get("roughness_v")) : u;
  if (u == nullptr || v == nullptr) return;
  const bool is_square = node.text("roughness_scale") == "square";
  const bool is_smooth = node.is("conductor") && node.text("distribution") == "smooth";
  if (!is_square && !is_smooth) return;
  const auto alpha = [&](float roughness) {
    return is_smooth ? 0.F : std::sqrt(std::max(roughness, 0.F));
  };
  result["roughness"] = alpha(*u);
  if (node.has("roughness_v")) result["roughness_v"] = alpha(*v);
  result["roughness_scale"] = std::string("alpha");
}

}  // namespace

Substitutes substitutes_of_material(const desc::Node& material) {
  Substitutes result;
  if (material.is("coated_diffuse") && material.text("coat") == "dielectric") {
    add_gloss(material, result);
  }
  if (material.is("conductor")) {
    if (const Vec3* reflectance = std::get_if<Vec3>(&material.get("reflectance"))) {
      add_index(*reflectance, result);
    }
  }
  if (material.has("roughness_scale")) add_alpha(material, result);
  return result;
}

}  // namespace ajar::pbrt
