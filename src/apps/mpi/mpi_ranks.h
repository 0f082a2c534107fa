#pragma once
#include <mpi.h>

#include "session/job/ranks.h"

namespace ajar {

/// The processes that mpirun has started. MPI must have been initialised; all calls are of one
/// thread.
class MpiRanks final : public Ranks {
 public:
  MpiRanks();
  ~MpiRanks() override;
  MpiRanks(const MpiRanks&) = delete;
  MpiRanks& operator=(const MpiRanks&) = delete;

  int rank() const override { return rank_; }
  int count() const override { return count_; }
  void broadcast(int from, std::span<std::byte> bytes) override;
  void sum_to_root(std::span<const std::int64_t> own, std::span<std::int64_t> whole) override;
  void sum_to_root(std::span<const double> own, std::span<double> whole) override;
  std::uint64_t maximum(std::uint64_t own) override;

 private:
  int rank_ = 0;
  int count_ = 1;
  MPI_Op saturating_sum_ = MPI_OP_NULL;
};

}  // namespace ajar
