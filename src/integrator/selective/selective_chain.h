#pragma once
#include <cstdint>
#include <variant>

#include "core/archive.h"
#include "integrator/metropolis/member_chain.h"
#include "mcmc/path_space/path_chain.h"

namespace ajar {

/// One of the chains that share the light with ordinary Monte Carlo: of primary numbers, or of
/// explicit paths.
struct SelectiveChain {
  std::variant<PathChain, PrimaryChain> state;
  ChainRecord record;
  double weight = 1.0;  ///< weight of its deposits, relative to other chains (`seed_weight`)

  Chain& chain() {
    return std::visit([](auto& own) -> Chain& { return own; }, state);
  }
  const Chain& chain() const {
    return std::visit([](const auto& own) -> const Chain& { return own; }, state);
  }
  /// Where it began, for messages.
  std::uint64_t origin() const {
    return std::visit([](const auto& own) { return own.origin; }, state);
  }
  /// See `MemberChain::clone`.
  SelectiveChain clone(std::uint64_t number) const;
  /// Without its record.
  std::uint64_t memory_bytes() const;
};

/// Reading takes a chain of the same kind, whatever it is like.
void save_chain(OutputArchive& archive, const Scene& scene, const SelectiveChain& chain);
void load_chain(InputArchive& archive, const Scene& scene, SelectiveChain& chain);

/// Either of them.
template <Archive A, typename C>
void serialize_chain(A& archive, const Scene& scene, C& chain) {
  if constexpr (A::is_loading::value) {
    load_chain(archive, scene, chain);
  } else {
    save_chain(archive, scene, chain);
  }
}

}  // namespace ajar
