#pragma once
#include "scene/desc/scene_desc.h"

namespace ajar {

/// Raises SceneError, with its location, if something refers to a texture, material, medium or
/// object that the description does not have.
void validate_references(const desc::SceneDesc& description);

/// Gives shapes without a material a diffuse gray one.
void add_default_material(desc::SceneDesc& description);

}  // namespace ajar
