#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

namespace ajar {

/// The processes that render one picture together, usually on several machines. All of them call
/// the same functions in the same order; each call waits for the others where it must.
class Ranks {
 public:
  virtual ~Ranks() = default;
  virtual int rank() const = 0;  ///< from 0, the root
  virtual int count() const = 0;
  bool is_root() const { return rank() == 0; }

  /// The bytes of one of them, to all.
  virtual void broadcast(int from, std::span<std::byte> bytes) = 0;
  /// Sums of what all ranks have in the same place, to the root; `whole` is untouched elsewhere.
  /// Whole numbers end at the largest and smallest there are, instead of going round.
  virtual void sum_to_root(std::span<const std::int64_t> own, std::span<std::int64_t> whole) = 0;
  virtual void sum_to_root(std::span<const double> own, std::span<double> whole) = 0;
  /// The largest value that any rank has, to all.
  virtual std::uint64_t maximum(std::uint64_t own) = 0;
};

}  // namespace ajar
