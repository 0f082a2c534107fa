#pragma once
#include "scene/desc/scene_desc.h"
#include "session/render/render_request.h"

/// Checks whether the files of a render can be written, before it takes any time.
namespace ajar {

/// Before anything is loaded. Raises UsageError for names that cannot be, such as two of one file,
/// and IoError where no file can be made.
void check_files(const RenderRequest& request);

/// Once the scene is loaded. Names the pictures if they are to have names by default. Raises, too,
/// UsageError for files over what is read.
void complete_files(RenderRequest& request, const desc::SceneDesc& description);

}  // namespace ajar
