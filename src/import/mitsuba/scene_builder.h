#pragma once
#include "core/warnings.h"
#include "import/mitsuba/document.h"
#include "import/mitsuba/search_path.h"

namespace ajar::mitsuba {

/// Makes a scene description of a document and reads the meshes it names. Raises SceneError.
desc::SceneDesc build_scene(const Document& document, SearchPath& files, Warnings& warnings);

}  // namespace ajar::mitsuba
