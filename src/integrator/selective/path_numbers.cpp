#include "integrator/selective/path_numbers.h"

#include <algorithm>

#include "core/random.h"
#include "core/random_use.h"

namespace ajar {

PathNumbers::PathNumbers(SampleSource& source, const OutlierPath& path) {
  const auto record = [&](Stream stream, int vertices, int repeat) {
    for (int vertex = 0; vertex < vertices; ++vertex) {
      for (std::size_t slot = 0; slot < kBlockSize; ++slot) {
        numbers_.push_back(source.get({stream, vertex, static_cast<Slot>(slot), repeat}));
      }
    }
  };
  numbers_.reserve(static_cast<std::size_t>(path.technique.s + path.technique.t) * kBlockSize);
  record(Stream::Camera, path.technique.t, 0);
  record(Stream::Light, path.technique.s, path.light_subpath);
}

bool PathNumbers::fit(const OutlierPath& path) const {
  const auto [s, t] = path.technique;
  return s >= 0 && t >= 0 &&
         numbers_.size() ==
             (static_cast<std::size_t>(s) + static_cast<std::size_t>(t)) * kBlockSize &&
         std::all_of(numbers_.begin(), numbers_.end(),
                     [](float number) { return number >= 0.F && number < 1.F; });
}

PrimaryChain PathNumbers::start_chain(const SelectivePreparation& prepared, const PathGroup& group,
                                      const OutlierPath& path) const {
  PrimaryChain chain(group.shape, hash_numbers(path.key(), RandomUse::Chain), path.key(), 0.0);
  ChainNumbers& to = chain.numbers;
  auto from = numbers_.begin();
  const auto copy = [&](Stream stream, int vertices) {
    for (int vertex = 0; vertex < vertices; ++vertex) {
      const std::size_t index = to.block_of({stream, vertex, Slot::BsdfDirectionX});
      std::copy_n(from, kBlockSize, to.block(index).begin());
      from += kBlockSize;
      to.set_stamp(index, to.now(stream));
    }
  };
  copy(Stream::Camera, path.technique.t);
  copy(Stream::Light, path.technique.s);
  if (path.technique.t > 1) {
    const auto camera = to.block(to.block_of({Stream::Camera, 0, kEmissionDirection}));
    const Vec2 u = prepared.view.place(path.raster);
    camera[static_cast<std::size_t>(kEmissionDirection)] = u.x;
    camera[static_cast<std::size_t>(kEmissionDirection) + 1] = u.y;
  }
  const SampleAddress choice(Stream::Connection, 0, kTechniqueChoice);
  const std::size_t index = to.block_of(choice);
  ChainNumbers::fill_fresh(to.block(index), choice, path.key());
  float& number = to.block(index)[static_cast<std::size_t>(kTechniqueChoice)];
  number = group.choice.number_of(path.technique, number);
  to.set_stamp(index, to.now(Stream::Connection));
  return chain;
}

}  // namespace ajar
