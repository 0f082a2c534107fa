#include "integrator/selective/selective_chain.h"

#include "core/random.h"
#include "path/path_archive.h"

namespace ajar {

SelectiveChain SelectiveChain::clone(std::uint64_t number) const {
  SelectiveChain other{state, {}, weight};
  other.record.by_technique.resize(record.by_technique.size());
  other.chain().seed = hash_numbers(chain().seed, chain().step, number);
  return other;
}

std::uint64_t SelectiveChain::memory_bytes() const {
  if (const auto* numbers = std::get_if<PrimaryChain>(&state)) return numbers->memory_bytes();
  const Path& path = std::get<PathChain>(state).path;
  return sizeof(PathChain) + path.vertices.capacity() * sizeof(InnerVertex) +
         path.segments.capacity() * sizeof(Segment);
}

void save_chain(OutputArchive& archive, const Scene& scene, const SelectiveChain& chain) {
  if (const auto* numbers = std::get_if<PrimaryChain>(&chain.state)) {
    archive(*numbers);
  } else {
    const auto& own = std::get<PathChain>(chain.state);
    archive(static_cast<const Chain&>(own), own.origin);
    save_path(archive, scene, own.path);
  }
  archive(chain.record, chain.weight);
}

void load_chain(InputArchive& archive, const Scene& scene, SelectiveChain& chain) {
  if (auto* numbers = std::get_if<PrimaryChain>(&chain.state)) {
    archive(*numbers);
  } else {
    auto& own = std::get<PathChain>(chain.state);
    archive(static_cast<Chain&>(own), own.origin);
    own.path = load_path(archive, scene);
  }
  archive(chain.record, chain.weight);
}

}  // namespace ajar
