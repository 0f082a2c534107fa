#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/vector.h"
#include "image/plane.h"

namespace ajar {

/// Shape and material seen by a pixel: numbers as in the layers "object-id" and "material-id", from
/// 1; 0 is "nothing there".
struct PixelIdentity {
  std::uint32_t object = 0;
  std::uint32_t material = 0;
  bool operator==(const PixelIdentity&) const = default;
};

/// A picture cut into regions.
struct Regions {
  Vec2i size{0, 0};
  std::vector<std::uint32_t> labels;        ///< region of each pixel, row by row
  std::vector<PixelIdentity> identities;    ///< identity of each region
  std::vector<std::uint32_t> pixel_counts;  ///< size of each region; above 0
  std::size_t count() const { return identities.size(); }
};

/// Regions: connected sets of pixels that show the same object with the same material, numbered
/// from 0 in the order in which their first pixels come, row by row. Background pixels form
/// regions, too.
///
/// Pixels are connected through their edges, not their corners: two surfaces can cross at a corner,
/// and each would be in one piece there while cutting the other; and what touches in a point alone
/// is seen as two things. Raises std::invalid_argument if there is not one identity per pixel.
///
/// Source: Frolov, "Selective application of Metropolis Light Transport for hard sampling
/// illumination phenomena", who does not say which neighbours count.
Regions connected_regions(Vec2i size, std::span<const PixelIdentity> identities);

/// A picture of values per region, one for each; else std::invalid_argument.
Plane fill_regions(const Regions& regions, std::span<const float> values);

}  // namespace ajar
