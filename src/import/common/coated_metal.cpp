#include "import/common/coated_metal.h"

#include "scene/desc/models.h"

namespace ajar {

desc::Node coated_metal(const desc::Node& conductor, float coat_eta) {
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
