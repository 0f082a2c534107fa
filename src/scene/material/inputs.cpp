#include "scene/material/inputs.h"

#include <algorithm>
#include <iterator>

#include "scene/desc/models.h"

namespace ajar {
namespace {

constexpr WarningKind kForwardMix{
    Effect::Surface, "mixes refer to materials that do not come before them: grey is used"};

ParameterSpec roughness_scale() {
  return choice_parameter(
      "roughness_scale", {"alpha", "log", "square"},
      "what roughness is: the facets' alpha, a number from 0 to 1 that alpha follows by its "
      "logarithm, or alpha's square");
}

RoughnessScale scale_of(std::string_view name) {
  if (name == "log") return RoughnessScale::Log;
  return name == "square" ? RoughnessScale::Square : RoughnessScale::Alpha;
}

/// Gray for missing materials.
const Material& fallback() {
  static const auto kGray = [] {
    const desc::Material diffuse{.name = "", .where = {}, .node = desc::material_node("diffuse")};
    Warnings none;
    return make_material(diffuse, {}, {}, none);
  }();
  return *kGray;
}

}  // namespace

ParameterSpec coat_depth_input() {
  return declare::textured_color(
      "coat_depth", "0", "optical thickness of the coat, along the normal: how much it absorbs");
}

ParameterSpec coat_transmission_input() {
  return choice_parameter(
      "coat_transmission", {"whole", "smooth", "single", "lossy", "lossy_sum"},
      "how much light a rough coat lets through: all that it does not reflect; as much as a smooth "
      "one; only what meets one facet, while the rest is turned back to the base; or is lost, "
      "inside as well; or so, by the sum that Mitsuba 3 takes inside. Smooth and single ones do "
      "not blur what is below");
}

CoatPass coat_pass(const desc::Node& node) {
  const std::string& name = node.text("coat_transmission");
  if (name == "smooth") return CoatPass::Smooth;
  if (name == "single") return CoatPass::Single;
  if (name == "lossy") return CoatPass::Lossy;
  return name == "lossy_sum" ? CoatPass::LossySum : CoatPass::Whole;
}

ParameterSpec index_input() {
  return declare::textured_number("eta", "1.5", "index of refraction inside, relative to outside",
                                  20.0);
}

std::vector<ParameterSpec> isotropic_roughness_inputs(std::string value) {
  return {declare::textured_number("roughness", std::move(value), "roughness of the facets", 1.0),
          roughness_scale()};
}

std::vector<ParameterSpec> roughness_inputs(std::string value) {
  return {declare::textured_number("roughness", std::move(value),
                                   "roughness of the facets, or that along u", 1.0),
          declare::textured_number(
              "roughness_v", "", "roughness along v; without it, the same in all directions", 1.0),
          roughness_scale()};
}

std::vector<ParameterSpec> facet_inputs(std::vector<std::string> others) {
  std::vector<std::string> distributions = {"ggx", "beckmann"};
  std::move(others.begin(), others.end(), std::back_inserter(distributions));
  return {
      choice_parameter("distribution", std::move(distributions),
                       "distribution of the facets' normals; a smooth surface has none"),
      choice_parameter("masking", {"joint", "separable"},
                       "whether facets hide each other from both sides together or by each side "
                       "alone, which is darker at grazing angles")};
}

FacetModel facet_model(const desc::Node& node, std::string_view distribution) {
  const bool is_separable = node.text("masking") == "separable";
  if (node.text(distribution) == "beckmann") {
    return is_separable ? FacetModel::BeckmannSeparable : FacetModel::Beckmann;
  }
  return is_separable ? FacetModel::GgxSeparable : FacetModel::Ggx;
}

float microfacet_alpha(RoughnessScale scale, float roughness) {
  switch (scale) {
    case RoughnessScale::Log:
      return roughness_to_alpha(roughness);
    case RoughnessScale::Square:
      return std::sqrt(std::max(roughness, 0.F));
    case RoughnessScale::Alpha:
      break;
  }
  return roughness;
}

const Material& MaterialInputs::material(std::string_view name) const {
  const auto* reference = std::get_if<desc::MaterialRef>(&node().get(name));
  const int id = reference == nullptr ? desc::kNone : reference->id;
  if (id >= 0 && static_cast<std::size_t>(id) < made_.size()) {
    return *made_[static_cast<std::size_t>(id)];
  }
  warn(kForwardMix, "mix refers to a material that does not come before it: grey is used");
  return fallback();
}

RoughnessSlot::RoughnessSlot(const MaterialInputs& inputs)
    : RoughnessSlot(inputs, "roughness", "roughness_v") {}

RoughnessSlot::RoughnessSlot(const MaterialInputs& inputs, std::string_view name_u,
                             std::string_view name_v)
    : scale_(scale_of(inputs.node().text("roughness_scale"))) {
  const desc::Node& node = inputs.node();
  const desc::Value& u = node.get(name_u);
  const desc::Value* v = node.has(name_v) ? &node.get(name_v) : &u;
  if (std::holds_alternative<std::monostate>(*v)) v = &u;
  u_ = inputs.slot_of(u);
  v_ = inputs.slot_of(*v);
  smooth_ = u_.is_black() && v_.is_black();
  if (u_.is_constant()) u_ = TextureSlot(Spectrum(alpha(u_.eval_float({}))));
  if (v_.is_constant()) v_ = TextureSlot(Spectrum(alpha(v_.eval_float({}))));
  isotropic_ =
      u == *v || (u_.is_constant() && v_.is_constant() && u_.eval_float({}) == v_.eval_float({}));
}

}  // namespace ajar
