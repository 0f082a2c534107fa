#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace ajar {

/// Packs pixels as half floats for the page, whose `page/decode.js` unpacks them.
///
/// Each channel is a plane. In a plane every value is replaced by the difference of its bits to
/// those of the value before (modulo 2^16, the first to 0), d, folded to 2d or −2d−1 so that small
/// differences of either sign have a high byte of zero. All low bytes of a plane come first, then
/// all high bytes; zlib packs the planes one after the other. Rounding is to nearest even; finite
/// values beyond the range become its ends, NaN and infinities stay.
std::vector<std::byte> pack_pixels(std::span<const float> pixels, int channels);

}  // namespace ajar
