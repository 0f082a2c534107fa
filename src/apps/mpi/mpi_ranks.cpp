#include "apps/mpi/mpi_ranks.h"

#include <algorithm>
#include <limits>

namespace ajar {

namespace {

/// Elements of one message: their number is an int, and a film has more.
constexpr std::size_t kMostElements = std::size_t{1} << 24;

void add_saturated(void* in, void* inout, int* length, MPI_Datatype* /*type*/) {
  const auto* const a = static_cast<const std::int64_t*>(in);
  auto* const b = static_cast<std::int64_t*>(inout);
  for (int i = 0; i < *length; ++i) {
    if (__builtin_add_overflow(a[i], b[i], &b[i])) {
      b[i] = a[i] < 0 ? std::numeric_limits<std::int64_t>::min()
                      : std::numeric_limits<std::int64_t>::max();
    }
  }
}

template <typename Number>
void reduce(std::span<const Number> own, std::span<Number> whole, MPI_Datatype type, MPI_Op op) {
  for (std::size_t first = 0; first < own.size(); first += kMostElements) {
    const std::size_t count = std::min(kMostElements, own.size() - first);
    MPI_Reduce(own.data() + first, whole.empty() ? nullptr : whole.data() + first,
               static_cast<int>(count), type, op, 0, MPI_COMM_WORLD);
  }
}

}  // namespace

MpiRanks::MpiRanks() {
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &count_);
  MPI_Op_create(&add_saturated, 1, &saturating_sum_);
}

MpiRanks::~MpiRanks() { MPI_Op_free(&saturating_sum_); }

void MpiRanks::broadcast(int from, std::span<std::byte> bytes) {
  while (!bytes.empty()) {
    const std::size_t count = std::min(kMostElements, bytes.size());
    MPI_Bcast(bytes.data(), static_cast<int>(count), MPI_BYTE, from, MPI_COMM_WORLD);
    bytes = bytes.subspan(count);
  }
}

void MpiRanks::sum_to_root(std::span<const std::int64_t> own, std::span<std::int64_t> whole) {
  reduce(own, whole, MPI_INT64_T, saturating_sum_);
}

void MpiRanks::sum_to_root(std::span<const double> own, std::span<double> whole) {
  reduce(own, whole, MPI_DOUBLE, MPI_SUM);
}

std::uint64_t MpiRanks::maximum(std::uint64_t own) {
  std::uint64_t largest = 0;
  MPI_Allreduce(&own, &largest, 1, MPI_UINT64_T, MPI_MAX, MPI_COMM_WORLD);
  return largest;
}

}  // namespace ajar
