#include "integrator/montecarlo/efficient_roulette.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/archive.h"
#include "image/visible_error.h"
#include "integrator/montecarlo/weighted_errors.h"

namespace ajar {

namespace {

bool is_positive(double value) { return value > 0.0 && std::isfinite(value); }

std::size_t pixels_of(const Box2i& crop) {
  const Vec2i size = crop.size() + Vec2i(1, 1);
  return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
}

}  // namespace

void EfficientRoulette::count(std::uint64_t rays, std::uint64_t samples) {
  rays_ += rays;
  samples_ += samples;
}

void EfficientRoulette::end_round(const ImportanceMap& importance,
                                  std::span<const double> variance) {
  known_ = {rays_, samples_};
  cells_.agree();
  light_cells_.agree();
  // Mean of visible errors: fireflies, and the border of a lamp, say little of all other pixels.
  double sum = 0.0;
  for (const double of_pixel : variance) sum += visible_error(of_pixel);
  const double mean = variance_of(sum / static_cast<double>(variance.size()));
  const double rays = static_cast<double>(rays_) / static_cast<double>(samples_);
  const double price = std::sqrt(mean / rays);
  if (!is_positive(price)) return;
  price_ = price;
  worths_.resize(pixels_of(crop_));
  const int width = crop_.size().x + 1;
  for (std::size_t i = 0; i < worths_.size(); ++i) {
    const Vec2i pixel = crop_.min + Vec2i(static_cast<int>(i) % width, static_cast<int>(i) / width);
    worths_[i] = importance(Vec2(pixel) + Vec2(0.5F, 0.5F)) / static_cast<float>(price);
  }
  cells_.end_round();
  light_cells_.end_round();
}

std::uint64_t EfficientRoulette::memory_bytes() const {
  return cells_.memory_bytes() + light_cells_.memory_bytes() + worths_.size() * sizeof(float);
}

void EfficientRoulette::save_state(OutputArchive& archive) const {
  archive(price_, worths_, rays_.load(), samples_.load());
  cells_.save_state(archive);
  light_cells_.save_state(archive);
}

void EfficientRoulette::load_state(InputArchive& archive) {
  archive(price_, worths_, known_.rays, known_.samples);
  const bool is_valid = worths_.empty()
                            ? price_ == 0.0
                            : worths_.size() == pixels_of(crop_) && is_positive(price_) &&
                                  std::all_of(worths_.begin(), worths_.end(), is_positive);
  if (!is_valid) throw std::runtime_error("corrupt checkpoint: a price of rays that cannot be");
  rays_ = known_.rays;
  samples_ = known_.samples;
  cells_.load_state(archive);
  light_cells_.load_state(archive);
}

void EfficientRoulette::export_delta(OutputArchive& archive) {
  archive(rays_.exchange(known_.rays) - known_.rays,
          samples_.exchange(known_.samples) - known_.samples);
  cells_.export_delta(archive);
  light_cells_.export_delta(archive);
}

void EfficientRoulette::import_delta(InputArchive& archive) {
  Counts delta;
  archive(delta.rays, delta.samples);
  known_.rays += delta.rays;
  known_.samples += delta.samples;
  rays_ = known_.rays;
  samples_ = known_.samples;
  cells_.import_delta(archive);
  light_cells_.import_delta(archive);
}

}  // namespace ajar
