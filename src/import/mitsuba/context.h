#pragma once
#include "core/warnings.h"
#include "import/mitsuba/document.h"
#include "import/mitsuba/search_path.h"
#include "scene/desc/scene_desc.h"

namespace ajar::mitsuba {

/// What every part of the importer works with.
struct Context {
  desc::SceneDesc& scene;
  const Document& document;
  SearchPath& files;
  Warnings& warnings;
};

}  // namespace ajar::mitsuba
