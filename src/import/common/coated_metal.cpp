#include "import/common/coated_metal.h"

#include "scene/desc/models.h"

namespace ajar {
namespace {

constexpr WarningKind kEvenAbsorption{
    Effect::Slight,
    "coats of metals absorb light, and one of the two is rough: from all sides alike"};

}  // namespace

desc::Node coated_metal(const desc::Node& conductor, const MetalCoat& coat,
                        const SourceLocation& where, Warnings& warnings) {
  desc::Node node =
      desc::material_node("coated_conductor", {{"eta", conductor.color("eta") * coat.eta},
                                               {"k", conductor.color("k") * coat.eta},
                                               {"coat_eta", coat.eta},
                                               {"coat_depth", coat.depth},
                                               {"bounces", 1},
                                               {"masking", conductor.text("masking")}});
  const bool is_smooth = conductor.text("distribution") == "smooth";
  if (is_smooth) {
    node.set("roughness", 0.F);
  } else {
    for (const char* name : {"roughness", "roughness_v", "distribution"}) {
      node.set(name, conductor.get(name));
    }
  }
  if (coat.depth != Vec3(0.F) && (coat.is_rough || !is_smooth)) {
    warnings.add(kEvenAbsorption, where,
                 "the coat of this metal absorbs as much light from all sides here");
  }
  return node;
}

}  // namespace ajar
