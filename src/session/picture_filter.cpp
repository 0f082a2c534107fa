#include "session/picture_filter.h"

#include <utility>

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

}  // namespace

PictureFilter::PictureFilter(std::shared_ptr<const Denoiser> denoiser,
                             std::function<Features()> features)
    : denoiser_(std::move(denoiser)), look_(std::move(features)) {}

const Features& PictureFilter::features() {
  const std::lock_guard lock(mutex_);
  if (!features_) features_ = look_();
  return *features_;
}

bool PictureFilter::add_layers(Picture& picture, const Replicates& replicates,
                               const Denoiser::Progress& progress) {
  const Features& known = features();
  const Vec2i size = picture.crop.size() + Vec2i(1, 1);
  {
    const std::lock_guard lock(mutex_);
    if (!prepared_) prepared_ = denoiser_->prepare(size, known);
  }
  std::vector<float> first;
  std::vector<float> second;
  if (replicates.size() > 1) {
    first = mean_of(replicates, 0, replicates.size() / 2);
    second = mean_of(replicates, replicates.size() / 2, replicates.size());
  }
  std::optional<std::vector<float>> pixels =
      denoiser_->filter({size, picture.layers.front().pixels, first, second}, *prepared_, progress);
  if (!pixels) return false;
  picture.layers.push_back({kDenoisedLayer, 3, *std::move(pixels)});
  if (!known.empty()) {
    picture.layers.push_back({kFeatureAlbedo, 3, known.albedo});
    picture.layers.push_back({kFeatureNormal, 3, known.normal});
  }
  picture.metadata["ajar:denoiser"] = denoiser_->name();
  return true;
}

}  // namespace ajar
