
#include "scene/material/inputs.h"
#include "scene/material/registry.h"

namespace ajar {
namespace {

/// No surface at all, only a change of medium.
class Interface final : public Material {
 public:
  explicit Interface(bool counted) { adds_edge = counted; }
  void add_lobes(const SurfacePoint&, const Spectrum&, Bsdf&) const override {}
  int max_lobes() const override { return 0; }
  bool is_interface() const override { return true; }
};

}  // namespace

MaterialModel interface_material() {
  return {{.name = "interface",
           .summary = "no surface: only separates media",
           .source = "",
           .parameters = {declare::flag("counted", "adds an edge to paths that cross it")}},
          [](const MaterialInputs& in) -> std::unique_ptr<Material> {
            return std::make_unique<Interface>(in.node().flag("counted"));
          }};
}

}  // namespace ajar
