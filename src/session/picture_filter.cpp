#include "session/picture_filter.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "image/relative_error.h"
#include "post/denoise/mix_estimates.h"

namespace ajar {

namespace {

/// The mean of replicates `first` … `last` − 1.
std::vector<float> mean_of(const Replicates& replicates, std::size_t first, std::size_t last) {
  std::vector<float> mean(replicates[first].size());
  for (std::size_t r = first; r < last; ++r) {
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += replicates[r][i];
  }
  for (float& value : mean) value /= static_cast<float>(last - first);
  return mean;
}

/// Means of the first and of the second half of the replicates; none of less than two.
class Halves {
 public:
  explicit Halves(const Replicates& replicates) {
    if (replicates.size() < 2) return;
    first_ = mean_of(replicates, 0, replicates.size() / 2);
    second_ = mean_of(replicates, replicates.size() / 2, replicates.size());
  }
  NoisyPicture with(Vec2i size, std::span<const float> colour, bool roughly = false) const {
    return {size, colour, first_, second_, roughly};
  }

 private:
  std::vector<float> first_;
  std::vector<float> second_;
};

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

PictureFilter::PictureFilter(std::shared_ptr<const Denoiser> denoiser,
                             std::function<Features()> features)
    : denoiser_(std::move(denoiser)), look_(std::move(features)) {}

const Features& PictureFilter::features() {
  const std::lock_guard lock(mutex_);
  if (!features_) features_ = look_();
  return *features_;
}

const Features& PictureFilter::prepared(Vec2i size) {
  const Features& known = features();
  const std::lock_guard lock(mutex_);
  if (!prepared_) prepared_ = denoiser_->prepare(size, known);
  return *prepared_;
}

void PictureFilter::add(Picture& picture, std::vector<float> pixels) {
  const Features& known = features();
  picture.layers.push_back({kDenoisedLayer, 3, std::move(pixels)});
  if (!known.empty()) {
    picture.layers.push_back({kFeatureAlbedo, 3, known.albedo});
    picture.layers.push_back({kFeatureNormal, 3, known.normal});
  }
  picture.metadata["ajar:denoiser"] = denoiser_->name();
}

bool PictureFilter::add_layers(Picture& picture, const PictureEstimates& estimates,
                               const Denoiser::Progress& progress) {
  const Vec2i size = size_of(picture);
  const Halves halves(estimates.replicates);
  std::optional<std::vector<float>> pixels =
      denoiser_->filter(halves.with(size, picture.layers.front().pixels), prepared(size), progress);
  if (!pixels) return false;
  add(picture, *std::move(pixels));
  return true;
}

bool PictureFilter::add_best_layers(Picture& picture, const PictureEstimates& estimates,
                                    const Denoiser::Progress& progress) {
  if (estimates.replicates.size() < 4) return add_layers(picture, estimates, progress);
  const Vec2i size = size_of(picture);
  const Features& known = prepared(size);
  std::vector<const Replicates*> all = {&estimates.replicates};
  if (!estimates.others.empty()) all.push_back(&estimates.others);
  const auto runs = static_cast<double>(all.size() * (1 + estimates.replicates.size()));
  double done = 0.0;
  const auto filtered = [&](const std::vector<float>& pixels, const Replicates& parts,
                            bool roughly) {
    const Halves halves(parts);
    auto result = denoiser_->filter(halves.with(size, pixels, roughly), known, [&](double of_run) {
      return !progress || progress((done + of_run) / runs);
    });
    done += 1.0;
    return result;
  };
  std::vector<BiasedEstimate> results;
  for (const Replicates* replicates : all) {
    const bool is_picture = replicates == &estimates.replicates;
    auto whole = filtered(is_picture ? picture.layers.front().pixels : replicate_mean(*replicates),
                          *replicates, false);
    if (!whole) return false;
    BiasedEstimate& result = results.emplace_back();
    result.pixels = *std::move(whole);
    for (const std::vector<float>& replicate : *replicates) {
      auto part = filtered(replicate, {}, true);
      if (!part) return false;
      result.replicates.push_back(*std::move(part));
    }
  }
  results.push_back({without_fireflies(picture.layers.front().pixels, estimates.replicates,
                                       results.front().pixels),
                     estimates.replicates});
  MixedEstimate mixed = mix_estimates(size, results, estimates.replicates);
  add(picture, std::move(mixed.pixels));
  picture.layers.push_back({kDenoisedError, 3, std::move(mixed.error)});
  return true;
}

}  // namespace ajar
