#include "import/obj/materials.h"

#include "core/printable_text.h"
#include "import/common/studio.h"
#include "import/obj/surface_reader.h"

namespace ajar::obj {
namespace {

constexpr WarningKind kUnknownMaterial{Effect::Surface,
                                       "materials are not known: a light grey stands in"};

}  // namespace

const Surface& Materials::of(const std::string& material, const SourceLocation& where) {
  const auto [place, is_new] = made_.try_emplace(material);
  if (!is_new) return place->second;
  if (const Description* description = library_.find(material)) {
    place->second = SurfaceReader(*description, scene_, files_, warnings_).read();
    return place->second;
  }
  if (!material.empty()) {
    warnings_.add(kUnknownMaterial, where,
                  unknown_name_message("material", printable_line(material), library_.names()) +
                      "; a light grey stands in",
                  printable_line(material));
  }
  place->second.material = add_neutral_material(scene_);
  return place->second;
}

}  // namespace ajar::obj
