#pragma once
#include <map>
#include <string>

#include "import/tungsten/textures.h"

namespace ajar::tungsten {

/// The places of primitives, which others refer to by name.
using PrimitivePlaces = std::map<std::string, Mat4, std::less<>>;

/// An even light of radiance 1 from all around, which Tungsten gives to scenes without any.
void add_default_light(Context& context, const SourceLocation& where);

/// Reads a primitive that is a light and no shape: "infinite_sphere", "infinite_sphere_cap",
/// "skydome" or "point". False if `type` is none of these.
bool read_light(Context& context, TextureReader& textures, const ObjectReader& object,
                const std::string& type, const Mat4& transform, const PrimitivePlaces& places);

}  // namespace ajar::tungsten
