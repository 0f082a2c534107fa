#pragma once
#include "core/warnings.h"
#include "import/gltf/document.h"

namespace ajar::gltf {

/// Warns of all members of objects that glTF 2.0 and the extensions that are read do not have, with
/// the nearest name that they have, and of extensions that are there though "extensionsUsed" does
/// not list them. Animations and skins are not looked into.
void check_members(const Element& root, Warnings& warnings);

}  // namespace ajar::gltf
