#include "image/film.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace ajar {

namespace {
constexpr int kFractionBits = 24;
/// Largest single contribution, in quanta.
constexpr double kContributionLimit = 0x1p54;
/// Sums at or beyond this take no more: 2^8 threads can be past the check at once without overflow.
constexpr std::int64_t kSumLimit = std::int64_t{1} << 62;

/// `sum` · `ratio`, a power of two: exactly, if that is a whole number within the limit.
std::int64_t scaled_sum(std::int64_t sum, double ratio) {
  if (ratio == 1.0) return sum;
  sum = std::clamp(sum, -kSumLimit, kSumLimit);
  if (ratio < 1.0) {
    const int shift = std::min(-std::ilogb(ratio), 62);
    // Rounded to nearest, the same for both signs.
    const std::int64_t half = std::int64_t{1} << (shift - 1);
    return sum < 0 ? -((-sum + half) >> shift) : (sum + half) >> shift;
  }
  const int shift = std::min(std::ilogb(ratio), 62);
  const std::int64_t most = kSumLimit >> shift;
  return std::clamp(sum, -most, most) * (std::int64_t{1} << shift);
}

std::int64_t saturated_sum(std::int64_t a, std::int64_t b) {
  return std::clamp(std::clamp(a, -kSumLimit, kSumLimit) + std::clamp(b, -kSumLimit, kSumLimit - 1),
                    -kSumLimit, kSumLimit);
}
}  // namespace

std::vector<LayerSpec> light_layers(double magnitude) {
  return {{.name = "direct", .magnitude = magnitude}, {.name = "indirect", .magnitude = magnitude}};
}

void add_box_layers(std::vector<LayerSpec>& layers, const Filter& filter) {
  if (filter.is_box_of_pixel()) return;
  std::vector<LayerSpec> boxes;
  for (const LayerSpec& layer : layers) {
    if (!layer.is_light() && layer.instead_of.empty()) continue;
    boxes.push_back(
        {.name = layer.name + ".box", .magnitude = layer.magnitude, .box_of = layer.name});
  }
  layers.insert(layers.end(), boxes.begin(), boxes.end());
}

Film::Film(Vec2i resolution, const Box2i& crop, const Filter& filter, int replicates,
           std::vector<LayerSpec> layers)
    : resolution_(resolution),
      crop_(crop),
      width_(crop.max.x - crop.min.x + 1),
      height_(crop.max.y - crop.min.y + 1),
      replicates_(replicates),
      filter_(filter),
      layers_(std::move(layers)) {
  if (width_ <= 0 || height_ <= 0 || crop.min.x < 0 || crop.min.y < 0 ||
      crop.max.x >= resolution.x || crop.max.y >= resolution.y) {
    throw std::invalid_argument("Film: the crop is empty or not inside the image");
  }
  if (replicates < 1) throw std::invalid_argument("Film: needs at least one replicate");
  const std::size_t plane =
      static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * 3;
  std::size_t size = 0;
  for (const LayerSpec& spec : layers_) {
    if (!(spec.magnitude > 0.0) || !std::isfinite(spec.magnitude)) {
      throw std::invalid_argument("Film: layer " + spec.name + " needs a positive magnitude");
    }
    const int exponent = std::ilogb(spec.magnitude) - kFractionBits;
    storage_.push_back({size, spec.has_replicates ? plane : 0, std::ldexp(1.0, -exponent),
                        std::ldexp(1.0, exponent), -1});
    if (!spec.box_of.empty()) {
      const int base = layer(spec.box_of);
      const int own = static_cast<int>(storage_.size()) - 1;
      if (base < 0 || base >= own) {
        throw std::invalid_argument("Film: layer " + spec.name + " belongs to none before it");
      }
      storage_[static_cast<std::size_t>(base)].box = own;
    }
    size += plane * static_cast<std::size_t>(spec.has_replicates ? replicates : 1);
  }
  sums_.assign(size, 0);
}

int Film::layer(std::string_view name) const {
  const auto found = std::find_if(layers_.begin(), layers_.end(),
                                  [&](const LayerSpec& spec) { return spec.name == name; });
  return found == layers_.end() ? -1 : static_cast<int>(found - layers_.begin());
}

std::size_t Film::index(const Storage& storage, int replicate, int x, int y) const {
  const auto column = static_cast<std::size_t>(x - crop_.min.x);
  const auto row = static_cast<std::size_t>(y - crop_.min.y);
  return storage.first + storage.stride * static_cast<std::size_t>(replicate) +
         (row * static_cast<std::size_t>(width_) + column) * 3;
}

bool Film::add_at(std::size_t first_channel, double per_quantum, const Spectrum& value) {
  const std::array<double, 3> quanta = {static_cast<double>(value[0]) * per_quantum,
                                        static_cast<double>(value[1]) * per_quantum,
                                        static_cast<double>(value[2]) * per_quantum};
  std::int64_t* sums = sums_.data() + first_channel;
  for (int c = 0; c < 3; ++c) {
    // Written so that NaN fails. The load may be out of date by a few contributions, which the
    // distance between the limits allows for.
    if (!(std::abs(quanta[c]) <= kContributionLimit)) return false;
    const std::int64_t sum = std::atomic_ref(sums[c]).load(std::memory_order_relaxed);
    if (sum >= kSumLimit || sum <= -kSumLimit) return false;
  }
  for (int c = 0; c < 3; ++c) {
    std::atomic_ref(sums[c]).fetch_add(std::llrint(quanta[c]), std::memory_order_relaxed);
  }
  return true;
}

bool Film::add(int layer, int replicate, Vec2i pixel, const Spectrum& value) {
  assert(crop_.intersects(pixel));
  if (value.is_black()) return true;
  const Storage& storage = storage_[static_cast<std::size_t>(layer)];
  return add_at(index(storage, replicate, pixel.x, pixel.y), storage.per_quantum, value);
}

bool Film::splat(int layer, int replicate, const Vec2& raster, const Spectrum& value) {
  if (value.is_black()) return true;
  if (!value.is_finite() || !std::isfinite(raster.x) || !std::isfinite(raster.y)) return false;
  const Storage& storage = storage_[static_cast<std::size_t>(layer)];
  const bool complete = splat_filtered(storage, replicate, raster, value);
  if (storage.box < 0) return complete;
  const Storage& box = storage_[static_cast<std::size_t>(storage.box)];
  const bool differs = splat_filtered(box, replicate, raster, value * -1.F);
  return splat_to_pixel(box, replicate, raster, value) && differs && complete;
}

bool Film::splat_to_pixel(const Storage& storage, int replicate, const Vec2& raster,
                          const Spectrum& value) {
  // Held against the crop before they are integers, which might not hold them.
  const Vec2 pixel(std::floor(raster.x), std::floor(raster.y));
  const Vec2 low(crop_.min);
  const Vec2 high(crop_.max);
  if (pixel.x < low.x || pixel.y < low.y || pixel.x > high.x || pixel.y > high.y) return true;
  return add_at(index(storage, replicate, static_cast<int>(pixel.x), static_cast<int>(pixel.y)),
                storage.per_quantum, value);
}

bool Film::splat_filtered(const Storage& storage, int replicate, const Vec2& raster,
                          const Spectrum& value) {
  // Pixel j is reached if raster − (j + 0.5) is in [−r, r). In double precision these bounds are
  // exact for box filters, so that each position belongs to exactly one pixel of a 1 px box.
  struct Span {
    int first, last;
  };
  const auto reach = [&](double x, double r, int low, int high) -> Span {
    const double first = std::floor(x - 0.5 - r) + 1.0;
    const double last = std::floor(x - 0.5 + r);
    return {static_cast<int>(std::clamp(first, static_cast<double>(low), high + 1.0)),
            static_cast<int>(std::clamp(last, low - 1.0, static_cast<double>(high)))};
  };
  const Vec2 radius = filter_.radius();
  const Span xs = reach(raster.x, radius.x, crop_.min.x, crop_.max.x);
  const Span ys = reach(raster.y, radius.y, crop_.min.y, crop_.max.y);

  std::array<float, 2 * static_cast<int>(Filter::kMaxRadius) + 2> columns;
  for (int x = xs.first; x <= xs.last; ++x) {
    columns[static_cast<std::size_t>(x - xs.first)] =
        filter_.eval_axis(0, raster.x - (static_cast<float>(x) + 0.5F));
  }
  bool complete = true;
  for (int y = ys.first; y <= ys.last; ++y) {
    const Spectrum row = value * filter_.eval_axis(1, raster.y - (static_cast<float>(y) + 0.5F));
    std::size_t place = index(storage, replicate, xs.first, y);
    for (int x = xs.first; x <= xs.last; ++x, place += 3) {
      complete &=
          add_at(place, storage.per_quantum, row * columns[static_cast<std::size_t>(x - xs.first)]);
    }
  }
  return complete;
}

float Film::coverage(const Vec2& raster) const {
  const Vec2 radius = filter_.radius();
  const auto along = [&](int axis, float at, float reach, int low, int high) {
    const int first = std::max(low, static_cast<int>(std::floor(at - 0.5F - reach)));
    const int last = std::min(high, static_cast<int>(std::floor(at - 0.5F + reach)) + 1);
    float sum = 0.F;
    for (int j = first; j <= last; ++j) {
      const float offset = at - (static_cast<float>(j) + 0.5F);
      if (offset >= -reach && offset < reach) sum += filter_.eval_axis(axis, offset);
    }
    return sum;
  };
  return along(0, raster.x, radius.x, crop_.min.x, crop_.max.x) *
         along(1, raster.y, radius.y, crop_.min.y, crop_.max.y);
}

std::vector<float> Film::develop_range(const Storage& storage, int first, int count,
                                       const DevelopScale& scale) const {
  const std::size_t pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  if (!scale.pixels.empty() && scale.pixels.size() != pixels) {
    throw std::invalid_argument("Film: a scale of another number of pixels");
  }
  std::vector<float> image(3 * pixels);
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    const double factor = scale.at(pixel);
    for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) {
      double total = 0.0;
      for (int r = first; r < first + count; ++r) {
        const std::int64_t sum =
            sums_[storage.first + storage.stride * static_cast<std::size_t>(r) + i];
        // A saturated sum depends on the order of the contributions: not shown.
        total += static_cast<double>(std::clamp(sum, -kSumLimit, kSumLimit));
      }
      image[i] = static_cast<float>(total * storage.quantum * factor);
    }
  }
  return image;
}

void Film::add_layers(const Film& other, std::span<const std::string> except) {
  if (other.crop_.min != crop_.min || other.crop_.max != crop_.max ||
      other.replicates_ != replicates_) {
    throw std::invalid_argument("film: films of different sizes cannot be added");
  }
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    const std::string& name = layers_[i].name;
    const int theirs = other.layer(name);
    const auto is_excepted = [&](const std::string& of) {
      return std::find(except.begin(), except.end(), of) != except.end();
    };
    if (theirs < 0 || is_excepted(name) || is_excepted(layers_[i].box_of)) continue;
    const Storage& to = storage_[i];
    const Storage& from = other.storage_[static_cast<std::size_t>(theirs)];
    if (from.quantum != to.quantum || from.stride != to.stride) {
      throw std::invalid_argument("film: layers of one name do not fit");
    }
    const std::size_t pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    const std::size_t count =
        3 * pixels * (layers_[i].has_replicates ? static_cast<std::size_t>(replicates_) : 1);
    for (std::size_t k = 0; k < count; ++k) sums_[to.first + k] += other.sums_[from.first + k];
  }
}

std::vector<float> Film::develop(int layer, const DevelopScale& scale) const {
  const auto i = static_cast<std::size_t>(layer);
  return develop_range(storage_.at(i), 0, layers_[i].has_replicates ? replicates_ : 1, scale);
}

std::vector<float> Film::develop_replicate(int layer, int replicate,
                                           const DevelopScale& scale) const {
  const auto i = static_cast<std::size_t>(layer);
  if (!layers_.at(i).has_replicates || replicate < 0 || replicate >= replicates_) {
    throw std::invalid_argument("Film: layer " + layers_[i].name + " has no such replicate");
  }
  return develop_range(storage_[i], replicate, 1, scale);
}

void Film::add(const Film& other) {
  const auto fits = [](const LayerSpec& a, const LayerSpec& b) {
    return a.name == b.name && a.has_replicates == b.has_replicates &&
           a.holds_identities == b.holds_identities;
  };
  if (resolution_ != other.resolution_ || crop_ != other.crop_ ||
      sums_.size() != other.sums_.size() ||
      !std::equal(layers_.begin(), layers_.end(), other.layers_.begin(), other.layers_.end(),
                  fits)) {
    throw std::invalid_argument("Film: another size, or other layers");
  }
  for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
    const std::size_t first = storage_[layer].first;
    const std::size_t last = layer + 1 < layers_.size() ? storage_[layer + 1].first : sums_.size();
    // A power of two.
    const double ratio = other.storage_[layer].quantum * storage_[layer].per_quantum;
    for (std::size_t i = first; i < last; ++i) {
      if (layers_[layer].holds_identities && sums_[i] != 0) continue;
      sums_[i] = saturated_sum(sums_[i], scaled_sum(other.sums_[i], ratio));
    }
  }
}

void Film::take_raw(std::vector<std::int64_t> sums) {
  if (sums.size() != sums_.size()) throw std::invalid_argument("Film: another number of sums");
  sums_ = std::move(sums);
}

void Film::clear() { std::fill(sums_.begin(), sums_.end(), 0); }

}  // namespace ajar
