#pragma once
#include <string>
#include <string_view>

#include "core/error.h"
#include "core/located_json.h"
#include "core/printable_text.h"
#include "core/warnings.h"
#include "import/common/file_access.h"
#include "scene/desc/scene_desc.h"

namespace ajar::tungsten {

/// State shared by all parts of the importer.
struct Context {
  desc::SceneDesc& scene;
  Warnings& warnings;
  FileAccess& files;
};

/// The text of "type", if `json` is an object with one; else empty.
inline std::string type_of(const LocatedJson& json) {
  const bool is_object = json.is(LocatedJson::Kind::Object);
  const auto type = is_object ? json.find("type") : std::nullopt;
  return type && type->is(LocatedJson::Kind::Text) ? type->text() : "";
}

/// Bsdfs, media and textures that refer to others more than this many times in a row are refused.
inline constexpr int kDeepestReference = 64;

}  // namespace ajar::tungsten
