#include "transport/efficiency_cells.h"

#include <algorithm>
#include <atomic>
#include <cereal/types/utility.hpp>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/archive.h"
#include "transport/heuristics.h"

namespace ajar {

namespace {

/// Kinds of vertices apart in a leaf: six sides that surfaces face, media, and surfaces that are
/// specular.
constexpr std::uint32_t kKinds = 8;
constexpr std::uint32_t kInMedium = 6;
constexpr std::uint32_t kSpecular = 7;

/// Levels of the octree.
constexpr int kLevels = 16;
constexpr float kPlaces = 1U << kLevels;
constexpr std::uint32_t kChildren = 8;
/// The first levels, where a place is looked up at once.
constexpr int kLevelsInTable = 4;

std::size_t table_index(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  return x | y << kLevelsInTable | z << 2 * kLevelsInTable;
}

/// Light that counts for no more, in units of the picture's, so that sums stay in range: a billion
/// samples fit.
constexpr double kMostLight = 256.0;
constexpr double kSquareQuanta = 0x1p22;

void add_to(std::int64_t& sum, std::int64_t value) {
  std::atomic_ref(sum).fetch_add(value, std::memory_order_relaxed);
}

std::uint32_t kind_of(const PathVertex& vertex) {
  if (vertex.in_medium) return kInMedium;
  if (!vertex.bsdf.connectible()) return kSpecular;
  const Vec3 n = face_forward(vertex.bsdf.ng(), vertex.wo);
  const Vec3 size(std::abs(n.x), std::abs(n.y), std::abs(n.z));
  // In this form, nothing has to be guessed by a processor.
  const int side = size.y > size.x ? 1 : 0;
  const int axis = size.z > std::max(size.x, size.y) ? 2 : side;
  return static_cast<std::uint32_t>(2 * axis) + (n[axis] < 0.F ? 1U : 0U);
}

}  // namespace

void EfficiencyCells::Moments::add(std::int64_t square_quanta, std::uint64_t own_rays) {
  add_to(samples, 1);
  if (square_quanta != 0) add_to(squares, square_quanta);
  if (own_rays != 0) add_to(rays, static_cast<std::int64_t>(own_rays));
}

EfficiencyCells::Moments& EfficiencyCells::Moments::operator+=(const Moments& other) {
  samples += other.samples;
  squares += other.squares;
  rays += other.rays;
  return *this;
}

EfficiencyCells::Moments& EfficiencyCells::Moments::operator-=(const Moments& other) {
  samples -= other.samples;
  squares -= other.squares;
  rays -= other.rays;
  return *this;
}

void EfficiencyCells::Moments::divide_by(int power_of_two) {
  samples >>= power_of_two;
  squares >>= power_of_two;
  rays >>= power_of_two;
}

EfficiencyCells::EfficiencyCells(const Box3& bounds, double magnitude)
    : low_(bounds.min),
      magnitude_(magnitude),
      nodes_(1),
      worths_(kKinds),
      sums_(kKinds),
      known_(kKinds) {
  const Vec3 size = bounds.size();
  for (int axis = 0; axis < 3; ++axis) scale_[axis] = size[axis] > 0.F ? kPlaces / size[axis] : 0.F;
  list_places();
}

void EfficiencyCells::list_places() {
  table_.resize(std::size_t{1} << 3 * kLevelsInTable);
  constexpr std::uint32_t kAcross = 1U << kLevelsInTable;
  for (std::uint32_t z = 0; z < kAcross; ++z) {
    for (std::uint32_t y = 0; y < kAcross; ++y) {
      for (std::uint32_t x = 0; x < kAcross; ++x) {
        std::uint32_t node = 0;
        for (int level = kLevelsInTable - 1; level >= 0 && nodes_[node].children != 0; --level) {
          node = nodes_[node].children +
                 ((x >> level & 1U) | (y >> level & 1U) << 1U | (z >> level & 1U) << 2U);
        }
        table_[table_index(x, y, z)] = node;
      }
    }
  }
}

std::uint32_t EfficiencyCells::find(const PathVertex& vertex) const {
  // Binary digits of a place are its way through the tree.
  std::array<std::uint32_t, 3> place{};
  for (int axis = 0; axis < 3; ++axis) {
    place[static_cast<std::size_t>(axis)] = static_cast<std::uint32_t>(
        std::clamp((vertex.p[axis] - low_[axis]) * scale_[axis], 0.F, kPlaces - 1.F));
  }
  constexpr int kBelow = kLevels - kLevelsInTable;
  const Node* node =
      &nodes_[table_[table_index(place[0] >> kBelow, place[1] >> kBelow, place[2] >> kBelow)]];
  for (int level = kBelow - 1; node->children != 0; --level) {
    const auto digit = [&](std::size_t axis) { return place[axis] >> level & 1U; };
    node = &nodes_[node->children + (digit(0) | digit(1) << 1U | digit(2) << 2U)];
  }
  return node->cells + kind_of(vertex);
}

void EfficiencyCells::add(std::uint32_t cell, bool specular, double light, std::uint64_t rays) {
  const double relative = std::min(light / magnitude_, kMostLight);
  if (!(relative >= 0.0)) return;
  sums_[cell][specular ? 1 : 0].add(std::llrint(relative * relative * kSquareQuanta), rays);
}

EfficiencyCells::Worth EfficiencyCells::worth_of(const Sums& sums) const {
  const auto root = [&](const Moments& moments) {
    if (moments.samples < TransportHeuristics::kFewestSamplesOfCell) return 0.F;
    const auto n = static_cast<double>(moments.samples);
    // Half a quantum: 0 says that nothing is known.
    const double squares = std::max(static_cast<double>(moments.squares), 0.5) / kSquareQuanta / n;
    const double rays = std::max(static_cast<double>(moments.rays) / n, 1.0 / n);
    return static_cast<float>(magnitude_ * std::sqrt(squares / rays));
  };
  return {root(sums[0]), root(sums[1])};
}

void EfficiencyCells::refine() {
  // Children are added at the end, and looked at in their turn.
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].children != 0 || nodes_[i].level == kLevels) continue;
    const std::uint32_t first = nodes_[i].cells;
    std::int64_t samples = 0;
    for (std::uint32_t k = 0; k < kKinds; ++k) {
      for (const Moments& moments : sums_[first + k]) samples += moments.samples;
    }
    if (samples < TransportHeuristics::kMostSamplesOfLeaf) continue;
    if (worths_.size() + (kChildren - 1) * kKinds > TransportHeuristics::kMostCells) return;
    nodes_[i].children = static_cast<std::uint32_t>(nodes_.size());
    for (std::uint32_t k = 0; k < kKinds; ++k) {
      for (Moments& moments : sums_[first + k]) moments.divide_by(3);
    }
    for (std::uint32_t child = 0; child < kChildren; ++child) {
      const std::uint32_t level = nodes_[i].level + 1;
      if (child == 0) {
        nodes_.push_back({0, first, level});
        continue;
      }
      nodes_.push_back({0, static_cast<std::uint32_t>(worths_.size()), level});
      for (std::uint32_t k = 0; k < kKinds; ++k) {
        worths_.push_back(worths_[first + k]);
        sums_.push_back(sums_[first + k]);
      }
    }
  }
}

void EfficiencyCells::end_round() {
  std::transform(sums_.begin(), sums_.end(), worths_.begin(),
                 [this](const Sums& sums) { return worth_of(sums); });
  refine();
  list_places();
  for (Sums& sums : sums_) {
    for (Moments& moments : sums) moments.divide_by(1);
  }
  agree();
}

std::uint64_t EfficiencyCells::memory_bytes() const {
  return table_.size() * sizeof(std::uint32_t) + nodes_.size() * sizeof(Node) +
         worths_.size() * sizeof(Worth) + (sums_.size() + known_.size()) * sizeof(Sums);
}

void EfficiencyCells::save_state(OutputArchive& archive) const { archive(nodes_, worths_, sums_); }

bool EfficiencyCells::is_tree() const {
  std::size_t children = 1;
  std::size_t leaves = 0;
  for (const Node& node : nodes_) {
    if (node.children == 0) {
      ++leaves;
      if (node.cells % kKinds != 0 || node.cells + kKinds > worths_.size()) return false;
      continue;
    }
    // In the order in which they were divided, each child once, and no deeper than places go.
    if (node.children <= static_cast<std::size_t>(&node - nodes_.data())) return false;
    if (node.children + kChildren > nodes_.size()) return false;
    for (std::uint32_t c = 0; c < kChildren; ++c) {
      if (nodes_[node.children + c].level != node.level + 1) return false;
    }
    children += kChildren;
  }
  return nodes_.front().level == 0 && children == nodes_.size() &&
         leaves * kKinds == worths_.size() && sums_.size() == worths_.size() &&
         std::all_of(nodes_.begin(), nodes_.end(),
                     [](const Node& node) { return node.level <= kLevels; });
}

void EfficiencyCells::load_state(InputArchive& archive) {
  archive(nodes_, worths_, sums_);
  const auto is_root = [](float value) { return value >= 0.F && std::isfinite(value); };
  if (nodes_.empty() || !is_tree() ||
      !std::all_of(worths_.begin(), worths_.end(),
                   [&](const Worth& worth) { return is_root(worth[0]) && is_root(worth[1]); })) {
    throw std::runtime_error("corrupt checkpoint: cells of roulette that cannot be");
  }
  known_ = sums_;
  list_places();
}

void EfficiencyCells::export_delta(OutputArchive& archive) {
  std::vector<std::pair<std::uint32_t, Sums>> delta;
  for (std::uint32_t cell = 0; cell < sums_.size(); ++cell) {
    Sums own = sums_[cell];
    for (std::size_t i = 0; i < own.size(); ++i) own[i] -= known_[cell][i];
    if (!own[0].empty() || !own[1].empty()) delta.emplace_back(cell, own);
  }
  sums_ = known_;
  archive(delta);
}

void EfficiencyCells::import_delta(InputArchive& archive) {
  std::vector<std::pair<std::uint32_t, Sums>> delta;
  archive(delta);
  for (const auto& [cell, sums] : delta) {
    Sums& own = sums_.at(cell);
    for (std::size_t i = 0; i < own.size(); ++i) own[i] += sums[i];
  }
  known_ = sums_;
}

}  // namespace ajar
