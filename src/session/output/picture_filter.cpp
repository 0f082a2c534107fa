#include "session/output/picture_filter.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "image/relative_error.h"
#include "integrator/montecarlo/scene_features.h"
#include "post/denoise/mix_estimates.h"
#include "session/job/resources.h"

namespace ajar {

namespace {

/// Replicates of a film, as `mixes` wants them.
constexpr std::size_t kReplicates = 4;
/// Filterings of one estimate: of the whole, and of halves.
constexpr std::size_t kFilterings = 3;

// Corners of a picture by which the time of filtering it is measured.

/// Pixels, the shorter of two corners.
constexpr int kLeastSide = 16;
/// The longer one is a square of such a part of the picture's longer side.
constexpr int kCorner = 8;

/// Several steps of a work, which take as long as one another, as one.
class Stages {
 public:
  Stages(std::size_t count, const Denoiser::Progress& progress)
      : count_(static_cast<double>(count)), progress_(progress) {}
  /// Progress of the step that begins.
  Denoiser::Progress next() {
    return [this, before = begun_++](double done) {
      return !progress_ || progress_((static_cast<double>(before) + done) / count_);
    };
  }

 private:
  double count_;
  const Denoiser::Progress& progress_;
  std::size_t begun_ = 0;
};

Replicates finite_replicates(const Replicates& replicates) {
  Replicates result;
  for (const std::vector<float>& replicate : replicates) {
    result.push_back(finite_values(replicate));
  }
  return result;
}

/// The means of every other replicate, as `BiasedEstimate` has parts.
Replicates halves_of(const Replicates& replicates) {
  Replicates halves;
  for (const std::size_t first : {0U, 1U}) {
    Replicates half;
    for (std::size_t i = first; i < replicates.size(); i += 2) half.push_back(replicates[i]);
    halves.push_back(replicate_mean(half));
  }
  return halves;
}

const std::vector<float>& for_filters(const Picture& picture) {
  return picture.for_filters.empty() ? picture.layers.front().pixels : picture.for_filters;
}

Vec2i size_of(const Picture& picture) { return picture.crop.size() + Vec2i(1, 1); }

double pixels_of(Vec2i size) { return static_cast<double>(size.x) * static_cast<double>(size.y); }

/// Filters the picture and its halves, and mixes. Empty if `stages` ended it.
std::optional<MixedEstimate> filter_and_mix(const Denoiser& denoiser, const Features& features,
                                            const Picture& picture,
                                            const PictureEstimates& estimates, Stages& stages) {
  const Vec2i size = size_of(picture);
  const Replicates replicates = finite_replicates(estimates.replicates);
  std::vector<BiasedEstimate> all;
  // False if it was ended.
  const auto add_estimate = [&](const std::vector<float>& pixels, const Replicates& parts) {
    const Replicates halves = halves_of(parts);
    auto whole = denoiser.filter({.size = size, .colour = pixels, .halves = {halves[0], halves[1]}},
                                 features, stages.next());
    if (!whole) return false;
    BiasedEstimate& estimate = all.emplace_back();
    estimate.pixels = *std::move(whole);
    for (const std::vector<float>& half : halves) {
      auto result =
          denoiser.filter({.size = size, .colour = half, .roughly = true}, features, stages.next());
      if (!result) return false;
      estimate.parts.push_back(*std::move(result));
    }
    return true;
  };
  const std::vector<float> unfiltered = finite_values(picture.layers.front().pixels);
  const bool is_first_added =
      estimates.boxes.empty()
          ? add_estimate(unfiltered, replicates)
          : add_estimate(finite_values(for_filters(picture)), finite_replicates(estimates.boxes));
  if (!is_first_added) return std::nullopt;
  // Independent samples alone may not have found yet what chains have.
  if (!estimates.others.empty()) {
    Replicates others = finite_replicates(estimates.others);
    if (!add_estimate(replicate_mean(others), others)) return std::nullopt;
    all.back().found = std::move(others);
  }
  all.push_back({.pixels = without_fireflies(unfiltered, replicates, all.front().pixels),
                 .parts = replicates,
                 .is_smooth = false});
  return mix_estimates(size, all, replicates);
}

}  // namespace

std::optional<double> denoised_error(const Picture& picture) {
  const auto error =
      std::find_if(picture.layers.begin(), picture.layers.end(),
                   [](const Picture::Layer& layer) { return layer.name == kDenoisedError; });
  if (error == picture.layers.end()) return std::nullopt;
  const std::vector<float>& pixels = shown_layer(picture).pixels;
  std::vector<float> off_by_it(pixels.size());
  std::transform(pixels.begin(), pixels.end(), error->pixels.begin(), off_by_it.begin(),
                 std::plus<>());
  return relative_error(off_by_it, pixels);
}

PictureFilter::PictureFilter(std::shared_ptr<const Denoiser> denoiser, Look look)
    : denoiser_(std::move(denoiser)), look_(std::move(look)) {}

std::uint64_t PictureFilter::memory_bytes(const Denoiser& denoiser, std::uint64_t pixels) {
  // Memory for two estimates: four replicates each, two halves raw and filtered; means, features
  // and the mixture.
  constexpr std::uint64_t kPictures = 28;
  return denoiser.memory_bytes(pixels) + pixels * 3 * sizeof(float) * kPictures;
}

std::shared_ptr<const PictureFilter::Known> PictureFilter::know(
    Vec2i size, std::uint32_t rays, const Denoiser::Progress& progress) {
  const std::lock_guard lock(mutex_);
  if (known_ && known_->rays == rays) return known_;
  std::optional<Features> seen = look_(rays, progress);
  if (!seen) return nullptr;
  Features prepared = denoiser_->prepare(size, *seen);
  known_ = std::make_shared<const Known>(Known{rays, *std::move(seen), std::move(prepared)});
  return known_;
}

bool PictureFilter::know_features(Vec2i size, const Denoiser::Progress& progress) {
  return know(size, feature_rays(0), progress) != nullptr;
}

Features PictureFilter::features() {
  const std::lock_guard lock(mutex_);
  return known_ ? known_->features : Features();
}

void PictureFilter::add(Picture& picture, const Known& known, std::vector<float> pixels) const {
  picture.layers.push_back({kDenoisedLayer, 3, std::move(pixels)});
  if (!known.features.empty()) {
    picture.layers.push_back({kFeatureAlbedo, 3, known.features.albedo});
    picture.layers.push_back({kFeatureNormal, 3, known.features.normal});
  }
  picture.metadata["ajar:denoiser"] = denoiser_->name();
}

bool PictureFilter::add_layers(Picture& picture, const Denoiser::Progress& progress) {
  const Vec2i size = size_of(picture);
  Stages stages(2, progress);
  // Features of a passing picture need not be the best.
  const auto known = know(size, feature_rays(0), stages.next());
  if (!known) return false;
  auto pixels = denoiser_->filter({.size = size, .colour = for_filters(picture)}, known->prepared,
                                  stages.next());
  if (!pixels) return false;
  add(picture, *known, *std::move(pixels));
  return true;
}

bool PictureFilter::add_best_layers(Picture& picture, const PictureEstimates& estimates,
                                    const Denoiser::Progress& progress) {
  if (!mixes(estimates.replicates.size())) return add_layers(picture, progress);
  Stages stages(1 + (estimates.others.empty() ? 1 : 2) * kFilterings, progress);
  const auto known = know(size_of(picture), feature_rays(estimates.samples), stages.next());
  if (!known) return false;
  auto mixed = filter_and_mix(*denoiser_, known->prepared, picture, estimates, stages);
  if (!mixed) return false;
  add(picture, *known, std::move(mixed->pixels));
  picture.layers.push_back({kDenoisedError, 3, std::move(mixed->error)});
  return true;
}

double PictureFilter::expected_seconds(Vec2i size, bool has_others) const {
  const auto seconds_of = [&](Vec2i corner) {
    Picture picture;
    picture.crop = Box2i({0, 0}, corner - Vec2i(1, 1));
    std::vector<float> chequered(3 * static_cast<std::size_t>(pixels_of(corner)));
    for (std::size_t i = 0; i < chequered.size(); ++i) chequered[i] = i % 2 == 0 ? 1.F : 0.5F;
    const Replicates replicates(kReplicates, chequered);
    picture.layers.push_back({"", 3, chequered});
    const Stopwatch clock;
    const Features features = denoiser_->prepare(corner, {chequered, chequered});
    const Denoiser::Progress goes_on;
    Stages stages(1, goes_on);
    filter_and_mix(*denoiser_, features, picture,
                   {replicates, has_others ? replicates : Replicates()}, stages);
    return clock.seconds();
  };
  const auto corner_of_side = [&](int side) {
    return Vec2i(std::min(side, size.x), std::min(side, size.y));
  };
  // Time that does not grow with the picture, once all that is loaded once has been.
  const Vec2i least = corner_of_side(kLeastSide);
  seconds_of(least);
  const double seconds = seconds_of(least);
  // Networks fill up the sides of pictures to multiples of the least.
  const int side = std::max(2, std::max(size.x, size.y) / (kCorner * kLeastSide) + 1) * kLeastSide;
  const Vec2i corner = corner_of_side(side);
  const double more_pixels = pixels_of(corner) - pixels_of(least);
  if (more_pixels <= 0.0) return seconds;
  const double more_seconds = std::max(0.0, seconds_of(corner) - seconds);
  return seconds + more_seconds / more_pixels * (pixels_of(size) - pixels_of(least));
}

}  // namespace ajar
