#pragma once
#include "core/warnings.h"
#include "import/gltf/document.h"

namespace ajar::gltf {

/// Warns of extensions in use that are not read. Raises SceneError if the file cannot do without
/// one that is not read, such as compressed meshes.
void check_extensions(const Element& root, Warnings& warnings);

/// Warns of an extension that is there, unless it is read or changes nothing.
void warn_of_extension(const std::string& name, const SourceLocation& where, Warnings& warnings);

}  // namespace ajar::gltf
