#include "import/mitsuba/roughness.h"

#include "core/printable_text.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kDistribution{
    Effect::Slight,
    "rough materials have facets of a distribution that is not supported: the nearest stands in"};

constexpr float kDefaultAlpha = 0.1F;

}  // namespace

void Roughness::set(desc::Node& node) const {
  node.set("roughness", alpha);
  if (alpha_v && node.has("roughness_v")) node.set("roughness_v", *alpha_v);
  if (!node.has("masking")) return;
  node.set("distribution", distribution);
  node.set("masking", std::string("separable"));
}

Roughness read_roughness(const MaterialInputs& in) {
  Roughness result;
  const desc::Value both = in.textures.number(in.arguments, "alpha", kDefaultAlpha);
  result.alpha = in.textures.find_number(in.arguments, "alpha_u").value_or(both);
  result.alpha_v = in.textures.find_number(in.arguments, "alpha_v");
  const std::string given = in.arguments.word("distribution", "beckmann");
  in.arguments.accept({"sample_visible"});
  result.distribution = given == "ggx" ? "ggx" : "beckmann";
  if (given != result.distribution) {
    in.context().warnings.add(kDistribution, in.where(),
                              "the distribution \"" + printable(given) +
                                  "\" of facets is not supported here: \"beckmann\" stands in",
                              printable(given));
  }
  return result;
}

}  // namespace ajar::mitsuba
