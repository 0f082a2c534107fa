#pragma once
#include "core/warnings.h"
#include "scene/desc/node.h"

namespace ajar {

/// The metal `conductor`, a node of that model with colours as its indices, under a clear, smooth
/// coat of the index `coat_eta`. Formats that lay a coat on any material give the metal the
/// reflectance that it has in air, so its indices grow with that of the coat. What differs from
/// them is a warning at `where`: light goes to and fro between the two, and facets are GGX's.
desc::Node coated_metal(const desc::Node& conductor, float coat_eta, const SourceLocation& where,
                        Warnings& warnings);

}  // namespace ajar
