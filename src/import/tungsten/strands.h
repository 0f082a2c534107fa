#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/desc/shape_data.h"

namespace ajar::tungsten {

/// Content of a file of curves: nodes of uniform quadratic B-splines.
struct Strands {
  std::vector<std::uint32_t> counts;  ///< number of nodes of each curve
  std::vector<Vec3> nodes;            ///< curve by curve
  std::vector<float> radii;           ///< one per node
};

/// Reads a file of the ending `.fiber` or `.hair`. Raises SceneError, with `name` as its file, for
/// other endings, for damaged files, and for numbers that are not finite.
///
/// `.fiber` is Tungsten's own, little endian: eight bytes of signature, a version, then attributes,
/// each with its name, type and length. Read are `num_vertices` (curves, 16 bits), `position` and
/// `width` (nodes, floats); the latter two repeat their last value. `.hair` is Cem Yuksel's ("HAIR
/// Model Files"). Tungsten takes widths of both as radii.
Strands read_strands(std::string_view bytes, const std::string& name);

/// Options of a primitive for its curves.
struct StrandTreatment {
  std::optional<float> radius;  ///< in place of those of the file
  bool tapers = false;          ///< to the end of each curve
};
/// Curves of fewer than three nodes have no part that can be seen.
desc::Curves curves_of(const Strands& strands, const StrandTreatment& treatment);

}  // namespace ajar::tungsten
