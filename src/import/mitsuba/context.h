#pragma once
#include <set>

#include "core/warnings.h"
#include "import/mitsuba/document.h"
#include "import/mitsuba/search_path.h"
#include "scene/desc/scene_desc.h"

namespace ajar::mitsuba {

/// State shared by all parts of the importer.
struct Context {
  desc::SceneDesc& scene;
  const Document& document;
  SearchPath& files;
  Warnings& warnings;
  /// Null events add to the depth of a path or not: as the integrator has it where that is limited,
  /// else as in ours, by which only boundaries of media do not.
  bool counts_boundaries = false;
  bool counts_straight = true;
  /// Elements whose `Arguments` are in use now, and those whose arguments were reported.
  std::set<const Element*> open = {};
  std::set<const Element*> reported = {};
};

}  // namespace ajar::mitsuba
