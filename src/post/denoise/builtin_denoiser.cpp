#include "post/denoise/builtin_denoiser.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

#include "core/parallel_for.h"
#include "core/spectrum.h"
#include "image/channels.h"
#include "image/plane.h"
#include "image/statistics.h"
#include "post/denoise/local_regression.h"
#include "post/heuristics.h"

namespace ajar {

namespace {

using Planes = std::vector<Plane>;
/// Lower bound of the albedo that light is divided by.
constexpr float kBlackest = 0.01F;
/// Negligible differences, relative to the picture's level.
constexpr float kDark = 0.1F;

/// Two pictures of independent samples.
struct Halves {
  Planes first;
  Planes second;
};

/// Progress of several threads.
class Work {
 public:
  /// Every level has a quarter of the pixels of the last, and is filtered twice.
  Work(std::size_t pixels, const Denoiser::Progress& progress)
      : whole_(2.0 * 4.0 / 3.0 * static_cast<double>(pixels)), progress_(progress) {}
  /// False if the work is to end.
  bool proceed(int pixels) {
    done_ += pixels;
    if (progress_ && !progress_(std::min(1.0, static_cast<double>(done_) / whole_))) {
      is_ended_ = true;
    }
    return !is_ended_;
  }
  bool is_ended() const { return is_ended_; }

 private:
  double whole_;
  const Denoiser::Progress& progress_;
  std::atomic<std::int64_t> done_ = 0;
  std::atomic<bool> is_ended_ = false;
};

Planes each(const Planes& planes, const std::function<Plane(const Plane&)>& change) {
  Planes result;
  for (const Plane& plane : planes) result.push_back(change(plane));
  return result;
}

/// `f` of the values of each pixel of planes, into a new plane.
template <typename F>
Plane pixel_by_pixel(Vec2i size, const F& f) {
  Plane result(size);
  parallel_for(size.y, [&](int y) {
    const std::size_t begin = static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x);
    for (std::size_t i = begin; i < begin + static_cast<std::size_t>(size.x); ++i) {
      result.values[i] = f(i);
    }
  });
  return result;
}

Plane luminances(const Planes& colour) {
  return pixel_by_pixel(colour.front().size, [&](std::size_t i) {
    return luminance(Spectrum(colour[0].values[i], colour[1].values[i], colour[2].values[i]));
  });
}

/// `colour` without pixels that are too bright for the surroundings in both halves.
Planes without_bright_pixels(const Planes& colour, const Planes& other) {
  const Vec2i size = colour.front().size;
  const SeparableKernel box = box_kernel(PostHeuristics::kAroundPixel);
  const auto count = static_cast<float>(box.x.size() * box.x.size());
  const Plane light = luminances(colour);
  const Plane around = filter_plane(light, box);
  const Plane other_around = filter_plane(luminances(other), box);
  const Plane scale = pixel_by_pixel(size, [&](std::size_t i) {
    const float others =
        (count * (around.values[i] + other_around.values[i]) - light.values[i]) / (2 * count - 1);
    const float most = PostHeuristics::kBrightestPixel * std::max(0.F, others);
    return light.values[i] > most ? most / light.values[i] : 1.F;
  });
  return each(colour, [&](const Plane& channel) {
    return pixel_by_pixel(size, [&](std::size_t i) { return channel.values[i] * scale.values[i]; });
  });
}

/// Filters both halves, each with the weights of the other, at one scale.
Halves regress(const Halves& halves, const Planes& features, float level, Work& work) {
  const auto seen = [&](const Plane& channel) {
    return pixel_by_pixel(channel.size, [&](std::size_t i) {
      return std::log1p(std::max(channel.values[i], 0.F) / (kDark * level));
    });
  };
  const Planes first = each(halves.first, seen);
  const Planes second = each(halves.second, seen);
  const SeparableKernel box = box_kernel(PostHeuristics::kVariancePatch);
  Planes variance;
  for (std::size_t c = 0; c < kChannels; ++c) {
    const Plane squares = pixel_by_pixel(first[c].size, [&](std::size_t i) {
      const float difference = first[c].values[i] - second[c].values[i];
      return 0.5F * difference * difference;
    });
    variance.push_back(filter_plane(squares, box));
  }
  const auto proceeds = [&](int pixels) { return work.proceed(pixels); };
  return {local_regression({halves.first, second, variance, features}, proceeds),
          local_regression({halves.second, first, variance, features}, proceeds)};
}

/// Weight of the coarse picture against the fine one, pixel by pixel: the W in [0, 1] for which
/// fine + W (coarse − fine) is nearest to the other half, over a patch. In doubt it is nearer to 1.
Plane share_of_coarse(const Halves& fine, const Halves& coarse, const Halves& noisy, float level) {
  const Vec2i size = coarse.first.front().size;
  Plane gain(size);
  Plane gain_squared(size);
  Plane change(size);
  parallel_for(size.y, [&](int y) {
    const std::size_t begin = static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x);
    for (std::size_t i = begin; i < begin + static_cast<std::size_t>(size.x); ++i) {
      for (std::size_t c = 0; c < kChannels; ++c) {
        const float d1 = fine.first[c].values[i];
        const float d2 = fine.second[c].values[i];
        const float c1 = coarse.first[c].values[i];
        const float c2 = coarse.second[c].values[i];
        const float mean = 0.25F * (d1 + d2 + c1 + c2);
        const float weight = 1.F / (kDark * kDark * level * level + mean * mean);
        gain.values[i] += weight * ((c1 - d1) * (noisy.second[c].values[i] - d1) +
                                    (c2 - d2) * (noisy.first[c].values[i] - d2));
        change.values[i] += weight * ((c1 - d1) * (c1 - d1) + (c2 - d2) * (c2 - d2));
      }
      gain_squared.values[i] = gain.values[i] * gain.values[i];
    }
  });
  const SeparableKernel box = box_kernel(PostHeuristics::kScalePatch);
  const auto count = static_cast<float>(box.x.size() * box.x.size());
  gain = filter_plane(gain, box);
  gain_squared = filter_plane(gain_squared, box);
  change = filter_plane(change, box);
  const Plane share = pixel_by_pixel(size, [&](std::size_t i) {
    const float mean = gain.values[i];
    const float variance = std::max(0.F, gain_squared.values[i] - mean * mean) / count;
    const float doubt = PostHeuristics::kScaleDoubt * std::sqrt(variance);
    const float whole = change.values[i] + doubt;
    return whole > 0.F ? std::clamp((mean + doubt) / whole, 0.F, 1.F) : 1.F;
  });
  return filter_plane(share, box_kernel(1));
}

/// The coarse light in place of that of the fine picture.
Planes replace_light(const Planes& fine, const Planes& halved_fine, const Planes& coarse,
                     const Plane& share) {
  Planes result;
  for (std::size_t c = 0; c < kChannels; ++c) {
    const Plane difference = pixel_by_pixel(share.size, [&](std::size_t i) {
      return share.values[i] * (coarse[c].values[i] - halved_fine[c].values[i]);
    });
    const Plane added = doubled(difference, fine[c].size);
    result.push_back(pixel_by_pixel(fine[c].size, [&](std::size_t i) {
      return std::max(0.F, fine[c].values[i] + added.values[i]);
    }));
  }
  return result;
}

Halves filter_level(const Halves& noisy, const Planes& features, float level, Work& work) {
  Halves fine = regress({without_bright_pixels(noisy.first, noisy.second),
                         without_bright_pixels(noisy.second, noisy.first)},
                        features, level, work);
  const Vec2i size = noisy.first.front().size;
  if (work.is_ended() || std::min(size.x, size.y) <= 2 * PostHeuristics::kRegressionWindow) {
    return fine;
  }
  const Halves halved_noisy = {each(noisy.first, halved), each(noisy.second, halved)};
  const Halves coarse = filter_level(halved_noisy, each(features, halved), level, work);
  const Halves halved_fine = {each(fine.first, halved), each(fine.second, halved)};
  const Plane share = share_of_coarse(halved_fine, coarse, halved_noisy, level);
  return {replace_light(fine.first, halved_fine.first, coarse.first, share),
          replace_light(fine.second, halved_fine.second, coarse.second, share)};
}

/// The black squares of a chessboard as one half, the white ones as the other; pixels in between
/// are the mean of those beside them.
Halves as_chessboard(const Planes& picture) {
  Halves halves{picture, picture};
  const Vec2i size = picture.front().size;
  for (std::size_t c = 0; c < kChannels; ++c) {
    for (int y = 0; y < size.y; ++y) {
      for (int x = 0; x < size.x; ++x) {
        float sum = 0.F;
        float count = 0.F;
        for (const auto& [dx, dy] : {std::pair(-1, 0), {1, 0}, {0, -1}, {0, 1}}) {
          if (x + dx < 0 || y + dy < 0 || x + dx >= size.x || y + dy >= size.y) continue;
          sum += picture[c].at(x + dx, y + dy);
          count += 1.F;
        }
        if (count > 0.F) {
          Planes& half = (x + y) % 2 == 0 ? halves.second : halves.first;
          half[c].at(x, y) = sum / count;
        }
      }
    }
  }
  return halves;
}

}  // namespace

std::uint64_t BuiltinDenoiser::memory_bytes(std::uint64_t pixels) const {
  // Two halves: noisy, cut, as seen, filtered; features; four thirds for the coarser scales.
  constexpr std::uint64_t kPlanes = 48;
  return pixels * sizeof(float) * kPlanes;
}

Features BuiltinDenoiser::prepare(Vec2i size, Features features) const {
  const std::size_t values =
      3 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  if (features.empty()) return features;
  if (features.albedo.size() != values || features.normal.size() != values) {
    throw std::invalid_argument("denoise: sizes do not fit");
  }
  return {finite_values(features.albedo), finite_values(features.normal)};
}

std::optional<std::vector<float>> BuiltinDenoiser::filter(const NoisyPicture& picture,
                                                          const Features& features,
                                                          const Progress& progress) const {
  const Vec2i size = picture.size;
  const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  if (picture.colour.size() != 3 * pixels) {
    throw std::invalid_argument("denoise: sizes do not fit");
  }
  Planes known;
  Planes reflectance(kChannels, pixel_by_pixel(size, [](std::size_t) { return 1.F; }));
  if (!features.empty()) {
    reflectance = each(planes_of(size, features.albedo), [&](const Plane& albedo) {
      return pixel_by_pixel(
          size, [&](std::size_t i) { return std::max(0.F, albedo.values[i]) + kBlackest; });
    });
    known = planes_of(size, features.albedo);
    for (Plane& plane : planes_of(size, features.normal)) known.push_back(std::move(plane));
  }
  const auto light_of = [&](std::span<const float> colour) {
    Planes light = planes_of(size, finite_values(colour));
    for (std::size_t c = 0; c < kChannels; ++c) {
      for (std::size_t i = 0; i < pixels; ++i) light[c].values[i] /= reflectance[c].values[i];
    }
    return light;
  };
  const Planes light = light_of(picture.colour);
  const auto level = static_cast<float>(median_lit(luminances(light).values));
  if (level <= 0.F) return finite_values(picture.colour);
  const bool is_halved = !picture.halves[0].empty();
  const Halves halves = is_halved ? Halves{light_of(picture.halves[0]), light_of(picture.halves[1])}
                                  : as_chessboard(light);
  Work work(pixels, progress);
  Halves filtered = filter_level(halves, known, level, work);
  if (work.is_ended()) return std::nullopt;
  for (std::size_t c = 0; c < kChannels; ++c) {
    for (std::size_t i = 0; i < pixels; ++i) {
      float& value = filtered.first[c].values[i];
      value = 0.5F * (value + filtered.second[c].values[i]) * reflectance[c].values[i];
    }
  }
  return interleaved(filtered.first);
}

}  // namespace ajar
