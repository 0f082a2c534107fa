#include "integrator/montecarlo/sample_rates.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/archive.h"
#include "core/random.h"
#include "core/random_use.h"
#include "image/visible_error.h"
#include "integrator/montecarlo/heuristics.h"

namespace ajar {

namespace {

constexpr int kCellSize = MonteCarloHeuristics::kRateCell;
constexpr double kMost = MonteCarloHeuristics::kMostRate;

}  // namespace

SampleRates::SampleRates(const Box2i& crop, int replicates, std::uint64_t seed)
    : crop_(crop), replicates_(static_cast<std::uint64_t>(replicates)) {
  const std::uint64_t own = hash_numbers(seed, RandomUse::SampleRates);
  const Vec2i size = crop.size() + Vec2i(1, 1);
  cells_ = (size + Vec2i(kCellSize - 1, kCellSize - 1)) / kCellSize;
  grid_.resize(static_cast<std::size_t>(cells_.x) * static_cast<std::size_t>(cells_.y));
  pixels_.resize(grid_.size());
  for (int y = crop.min.y; y <= crop.max.y; ++y) {
    for (int x = crop.min.x; x <= crop.max.x; ++x) {
      pixels_[cell_of({x, y})] += 1.0;
      starts_.push_back(to_unit_float(static_cast<std::uint32_t>(hash_numbers(own, x, y) >> 32U)));
    }
  }
}

double SampleRates::start_of(Vec2i pixel, std::uint64_t replicate) const {
  // Replicates are evenly spread, so that all together have as many as they should.
  const double start = static_cast<double>(starts_[pixel_at(crop_, Vec2(pixel))]) +
                       static_cast<double>(replicate) / static_cast<double>(replicates_);
  return start < 1.0 ? start : start - 1.0;
}

std::size_t SampleRates::cell_of(Vec2i pixel) const {
  const Vec2i cell = (pixel - crop_.min) / kCellSize;
  return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(cells_.x) +
         static_cast<std::size_t>(cell.x);
}

SampleRates::Batch SampleRates::batch(Vec2i pixel, std::uint64_t replicate,
                                      std::uint64_t round) const {
  const Cell& cell = grid_[cell_of(pixel)];
  const double start = start_of(pixel, replicate);
  const auto count = [&](std::uint64_t rounds) {
    return static_cast<std::uint64_t>(upto(cell, rounds) + start);
  };
  return {count(round), count(round + 1), static_cast<float>(1.0 / cell.rate)};
}

double SampleRates::mean(const std::vector<double>& cells) const {
  double sum = 0.0;
  double pixels = 0.0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    sum += cells[i] * pixels_[i];
    pixels += pixels_[i];
  }
  return sum / pixels;
}

std::vector<double> SampleRates::means(const std::vector<double>& pixels) const {
  std::vector<double> sums(grid_.size());
  std::size_t i = 0;
  for (int y = crop_.min.y; y <= crop_.max.y; ++y) {
    for (int x = crop_.min.x; x <= crop_.max.x; ++x) sums[cell_of({x, y})] += pixels[i++];
  }
  for (std::size_t cell = 0; cell < sums.size(); ++cell) sums[cell] /= pixels_[cell];
  return sums;
}

std::vector<double> SampleRates::with_neighbours(const std::vector<double>& cells) const {
  std::vector<double> result(cells.size());
  const auto at = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(cells_.x) +
           static_cast<std::size_t>(x);
  };
  for (int y = 0; y < cells_.y; ++y) {
    for (int x = 0; x < cells_.x; ++x) {
      double sum = 0.0;
      double pixels = 0.0;
      for (int v = std::max(0, y - 1); v <= std::min(cells_.y - 1, y + 1); ++v) {
        for (int u = std::max(0, x - 1); u <= std::min(cells_.x - 1, x + 1); ++u) {
          sum += cells[at(u, v)] * pixels_[at(u, v)];
          pixels += pixels_[at(u, v)];
        }
      }
      result[at(x, y)] = sum / pixels;
    }
  }
  return result;
}

void SampleRates::adjust(std::span<const double> variance, Guesses guesses, std::uint64_t samples) {
  const std::uint64_t rounds = samples / replicates_;
  if (rounds == 0) return;
  guesses_ = std::move(guesses);
  for (Cell& cell : grid_) {
    cell.before = upto(cell, rounds);
    cell.inverse += static_cast<double>(rounds - since_) / cell.rate;
  }
  since_ = rounds;
  std::vector<double> errors(variance.size());
  std::transform(variance.begin(), variance.end(), errors.begin(), visible_error);
  std::vector<double> of_cells = means(errors);
  for (std::size_t i = 0; i < grid_.size(); ++i) {
    // Error of one camera sample, up to a common factor.
    of_cells[i] /= visible_error(grid_[i].inverse);
  }
  std::vector<double> rates = with_neighbours(of_cells);
  std::transform(rates.begin(), rates.end(), rates.begin(), samples_for);
  const auto make_mean_one = [&] {
    const double all = mean(rates);
    for (double& rate : rates) rate = all > 0.0 && std::isfinite(all) ? rate / all : 1.0;
  };
  make_mean_one();
  for (double& rate : rates) rate = std::clamp(rate, 1.0 / kMost, kMost);
  make_mean_one();
  for (std::size_t i = 0; i < grid_.size(); ++i) grid_[i].rate = rates[i];
  light_weight_ = static_cast<float>(1.0 / mean(rates));
}

SampleRates::Guess SampleRates::guess(Vec2i pixel) const {
  const std::size_t index = 3 * pixel_at(crop_, Vec2(pixel));
  const auto color = [&](const std::vector<float>& layer) {
    return layer.empty() ? Spectrum() : Spectrum(layer[index], layer[index + 1], layer[index + 2]);
  };
  return {color(guesses_.direct), color(guesses_.indirect)};
}

std::uint64_t SampleRates::memory_bytes() const {
  return grid_.size() * (sizeof(Cell) + sizeof(double)) +
         (starts_.size() + guesses_.direct.size() + guesses_.indirect.size()) * sizeof(float);
}

void SampleRates::save_state(OutputArchive& archive) const {
  archive(since_, light_weight_, static_cast<std::uint64_t>(grid_.size()), guesses_.direct,
          guesses_.indirect);
  for (const Cell& cell : grid_) archive(cell.before, cell.inverse, cell.rate);
}

void SampleRates::load_state(InputArchive& archive, std::uint64_t samples) {
  std::uint64_t cells = 0;
  archive(since_, light_weight_, cells, guesses_.direct, guesses_.indirect);
  const auto fits = [&](const std::vector<float>& guesses) {
    return (guesses.empty() || guesses.size() == 3 * starts_.size()) &&
           std::all_of(guesses.begin(), guesses.end(), [](float v) { return std::isfinite(v); });
  };
  if (since_ > samples / replicates_ || !(light_weight_ > 0.F && std::isfinite(light_weight_))) {
    throw std::runtime_error("rates of samples of another time");
  }
  if (cells != grid_.size() || !fits(guesses_.direct) || !fits(guesses_.indirect)) {
    throw std::runtime_error("rates of samples of another picture");
  }
  for (Cell& cell : grid_) {
    archive(cell.before, cell.inverse, cell.rate);
    // Clamped rates are then divided by their mean, which is within the same bounds.
    constexpr double kBeyond = kMost * kMost;
    const double most = kBeyond * static_cast<double>(since_);
    if (!(cell.rate * kBeyond >= 1.0 && cell.rate <= kBeyond && cell.before >= 0.0 &&
          cell.before <= most && cell.inverse >= 0.0 && cell.inverse <= most)) {
      throw std::runtime_error("corrupt checkpoint: invalid rate of samples");
    }
  }
}

}  // namespace ajar
