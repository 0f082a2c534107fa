#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "core/vector.h"
#include "import/tungsten/object_reader.h"

namespace ajar::tungsten {

/// One copy of a primitive: turned and moved, never scaled.
struct Placed {
  int master = 0;  ///< index into the list of masters
  Mat4 to_world;
};

/// The copies that a list or a file describes. Files that cannot be read and places that are none
/// are warnings.
std::vector<Placed> read_placed(const Context& context, const LocatedJson& json);

/// Reads Tungsten's file of instances: their number, a flag (1: places are rounded), a box, their
/// places, and the index of the master of each. Nothing if the data ends too early.
std::optional<std::vector<Placed>> read_instance_file(std::string_view bytes);

}  // namespace ajar::tungsten
