#include "post/antialias.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/parallel_for.h"
#include "core/spectrum.h"
#include "post/heuristics.h"

namespace ajar {

namespace {

constexpr int kLongestSearch = PostHeuristics::kLongestStair;

Plane luma_of(Vec2i size, std::span<const float> pixels) {
  Plane luma(size);
  for (std::size_t i = 0; i < luma.values.size(); ++i) {
    luma.values[i] = luminance(Spectrum(pixels[3 * i], pixels[3 * i + 1], pixels[3 * i + 2]));
  }
  return luma;
}

/// Luma at a pixel; beyond the border that of the border.
float luma_at(const Plane& luma, Vec2i p) {
  return luma.at(std::clamp(p.x, 0, luma.size.x - 1), std::clamp(p.y, 0, luma.size.y - 1));
}

/// Neighbour that is blended into a pixel, and its weight.
struct Blend {
  Vec2i neighbour{0, 0};
  float share = 0.F;
};

bool has_contrast(const Plane& luma, Vec2i p) {
  float low = luma_at(luma, p);
  float high = low;
  for (const Vec2i& offset : {Vec2i(1, 0), Vec2i(-1, 0), Vec2i(0, 1), Vec2i(0, -1)}) {
    const float value = luma_at(luma, p + offset);
    low = std::min(low, value);
    high = std::max(high, value);
  }
  return high - low >= std::max(PostHeuristics::kSmallestContrast,
                                PostHeuristics::kSmallestRelativeContrast * high);
}

/// Curvature of luma in direction `across`, over three rows that lie side by side along `along`.
float bend(const Plane& luma, Vec2i p, Vec2i across, Vec2i along) {
  const auto second_difference = [&](Vec2i q) {
    return std::abs(luma_at(luma, q - across) - 2.F * luma_at(luma, q) + luma_at(luma, q + across));
  };
  return 2.F * second_difference(p) + second_difference(p - along) + second_difference(p + along);
}

/// Where a stair ends.
struct StairEnd {
  float distance;  ///< pixels, from the middle of the pixel
  float change;    ///< change of the luma on the edge; 0 if no end was found
};

/// Follows the edge between `p` and `p + across` in steps of `along`.
StairEnd follow_edge(const Plane& luma, Vec2i p, Vec2i across, Vec2i along, float edge_luma,
                     float least_change) {
  for (int i = 1; i <= kLongestSearch; ++i) {
    const Vec2i q = p + along * i;
    const float change = 0.5F * (luma_at(luma, q) + luma_at(luma, q + across)) - edge_luma;
    if (std::abs(change) >= least_change) return {static_cast<float>(i) - 0.5F, change};
  }
  return {static_cast<float>(kLongestSearch), 0.F};
}

Blend find_blend(const Plane& luma, Vec2i p) {
  if (!has_contrast(luma, p)) return {};
  const Vec2i right(1, 0);
  const Vec2i down(0, 1);
  const bool horizontal = bend(luma, p, down, right) >= bend(luma, p, right, down);
  const Vec2i along = horizontal ? right : down;
  Vec2i across = horizontal ? down : right;

  const float own = luma_at(luma, p);
  const auto step_to = [&](Vec2i offset) { return luma_at(luma, p + offset) - own; };
  if (std::abs(step_to(-across)) > std::abs(step_to(across))) across = -across;
  const float step = step_to(across);
  const float edge_luma = own + 0.5F * step;
  const float least_change = PostHeuristics::kEndOfStair * std::abs(step);
  if (!(least_change > 0.F)) return {};

  const StairEnd before = follow_edge(luma, p, across, -along, edge_luma, least_change);
  const StairEnd after = follow_edge(luma, p, across, along, edge_luma, least_change);
  const StairEnd& nearer = before.distance < after.distance ? before : after;
  // The line through the stairs reaches into this pixel if the luma beyond the nearer end changes
  // toward that across the edge; else it reaches into the pixel there.
  if (nearer.change * step <= 0.F) return {};
  return {p + across, 0.5F - nearer.distance / (before.distance + after.distance)};
}

}  // namespace

std::vector<float> antialias(Vec2i size, std::span<const float> pixels, const Plane& mask) {
  if (mask.size != size || pixels.size() != 3 * mask.values.size()) {
    throw std::invalid_argument("antialiasing: picture and mask are of different sizes");
  }
  std::vector<float> result(pixels.begin(), pixels.end());
  const Plane luma = luma_of(size, pixels);
  const auto first_value = [&](Vec2i p) {
    return 3 * (static_cast<std::size_t>(p.y) * static_cast<std::size_t>(size.x) +
                static_cast<std::size_t>(p.x));
  };
  parallel_for(size.y, [&](int y) {
    for (int x = 0; x < size.x; ++x) {
      const float allowed = mask.at(x, y);
      if (!(allowed > 0.F)) continue;
      // Beyond the border luma is the same, so the neighbour across an edge is in the picture.
      const Blend blend = find_blend(luma, {x, y});
      const float share = std::min(allowed, 1.F) * blend.share;
      if (share <= 0.F) continue;
      const std::size_t own = first_value({x, y});
      const std::size_t other = first_value(blend.neighbour);
      for (std::size_t c = 0; c < 3; ++c) {
        result[own + c] += share * (pixels[other + c] - pixels[own + c]);
      }
    }
  });
  return result;
}

}  // namespace ajar
