#include "session/output/picture_filter.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "image/relative_error.h"
#include "post/denoise/mix_estimates.h"

namespace ajar {

namespace {

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

/// The mean of every other replicate, from that `first` one on.
std::vector<float> half_of(const Replicates& replicates, std::size_t first) {
  Replicates half;
  for (std::size_t i = first; i < replicates.size(); i += 2) half.push_back(replicates[i]);
  return replicate_mean(half);
}

const std::vector<float>& for_filters(const Picture& picture) {
  return picture.for_filters.empty() ? picture.layers.front().pixels : picture.for_filters;
}

Vec2i size_of(const Picture& picture) { return picture.crop.size() + Vec2i(1, 1); }

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
  // Memory for two estimates: four replicates each, raw and filtered; means, features and the
  // mixture.
  constexpr std::uint64_t kPictures = 28;
  return denoiser.memory_bytes(pixels) + pixels * 3 * sizeof(float) * kPictures;
}

bool PictureFilter::know_features(Vec2i size, const Denoiser::Progress& progress) {
  const std::lock_guard lock(mutex_);
  if (features_) return true;
  std::optional<Features> seen = look_(progress);
  if (!seen) return false;
  prepared_ = denoiser_->prepare(size, *seen);
  features_ = std::move(seen);
  return true;
}

Features PictureFilter::features() {
  const std::lock_guard lock(mutex_);
  return features_.value_or(Features());
}

void PictureFilter::add(Picture& picture, std::vector<float> pixels) {
  const Features known = features();
  picture.layers.push_back({kDenoisedLayer, 3, std::move(pixels)});
  if (!known.empty()) {
    picture.layers.push_back({kFeatureAlbedo, 3, known.albedo});
    picture.layers.push_back({kFeatureNormal, 3, known.normal});
  }
  picture.metadata["ajar:denoiser"] = denoiser_->name();
}

bool PictureFilter::add_layers(Picture& picture, const Denoiser::Progress& progress) {
  const Vec2i size = size_of(picture);
  Stages stages(2, progress);
  if (!know_features(size, stages.next())) return false;
  auto pixels =
      denoiser_->filter({.size = size, .colour = for_filters(picture)}, prepared_, stages.next());
  if (!pixels) return false;
  add(picture, *std::move(pixels));
  return true;
}

bool PictureFilter::add_best_layers(Picture& picture, const PictureEstimates& estimates,
                                    const Denoiser::Progress& progress) {
  if (!mixes(estimates.replicates.size())) return add_layers(picture, progress);
  const Vec2i size = size_of(picture);
  const Replicates replicates = finite_replicates(estimates.replicates);
  const Replicates others = finite_replicates(estimates.others);
  const Replicates boxes = finite_replicates(estimates.boxes);
  Stages stages(1 + (others.empty() ? 1 : 2) * (1 + replicates.size()), progress);
  if (!know_features(size, stages.next())) return false;
  const auto filtered = [&](const NoisyPicture& noisy) {
    return denoiser_->filter(noisy, prepared_, stages.next());
  };
  std::vector<BiasedEstimate> all;
  // False if `progress` ended it.
  const auto add_estimate = [&](const std::vector<float>& pixels, const Replicates& parts) {
    const std::vector<float> first = half_of(parts, 0);
    const std::vector<float> second = half_of(parts, 1);
    auto whole = filtered({.size = size, .colour = pixels, .halves = {first, second}});
    if (!whole) return false;
    BiasedEstimate& estimate = all.emplace_back();
    estimate.pixels = *std::move(whole);
    for (const std::vector<float>& part : parts) {
      auto result = filtered({.size = size, .colour = part, .roughly = true});
      if (!result) return false;
      estimate.replicates.push_back(*std::move(result));
    }
    return true;
  };
  const std::vector<float> unfiltered = finite_values(picture.layers.front().pixels);
  const bool is_first_added = boxes.empty()
                                  ? add_estimate(unfiltered, replicates)
                                  : add_estimate(finite_values(for_filters(picture)), boxes);
  if (!is_first_added) return false;
  // Independent samples alone may not have found yet what chains have.
  if (!others.empty()) {
    if (!add_estimate(replicate_mean(others), others)) return false;
    all.back().found = others;
  }
  all.push_back({without_fireflies(unfiltered, replicates, all.front().pixels), replicates});
  MixedEstimate mixed = mix_estimates(size, all, replicates);
  add(picture, std::move(mixed.pixels));
  picture.layers.push_back({kDenoisedError, 3, std::move(mixed.error)});
  return true;
}

}  // namespace ajar
