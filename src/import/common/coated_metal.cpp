#include "import/common/coated_metal.h"

#include "scene/desc/models.h"

namespace ajar {
namespace {

constexpr WarningKind kCoatedMetal{
    Effect::Slight, "metals have a coat: light that goes to and fro between the two is shown"};
constexpr WarningKind kBeckmannBelow{
    Effect::Slight, "metals below a coat have facets of a distribution that is not supported"};

}  // namespace

desc::Node coated_metal(const desc::Node& conductor, float coat_eta, const SourceLocation& where,
                        Warnings& warnings) {
  warnings.add(kCoatedMetal, where,
               "what goes to and fro between a metal and its coat is shown here");
  if (conductor.text("distribution") == "beckmann") {
    warnings.add(kBeckmannBelow, where,
                 "the facets of a metal below a coat are those of \"ggx\" here");
  }
  desc::Node node =
      desc::material_node("coated_conductor", {{"eta", conductor.color("eta") * coat_eta},
                                               {"k", conductor.color("k") * coat_eta},
                                               {"coat_eta", coat_eta}});
  if (conductor.text("distribution") == "smooth") {
    node.set("roughness", 0.F);
  } else {
    node.set("roughness", conductor.get("roughness"));
    node.set("roughness_v", conductor.get("roughness_v"));
  }
  return node;
}

}  // namespace ajar
