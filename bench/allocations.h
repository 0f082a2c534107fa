#pragma once
#include <cstdint>

namespace ajar::bench {

/// Heap allocations made by this program so far, on all threads (operator new is replaced in
/// allocations.cpp).
std::uint64_t allocations();

}  // namespace ajar::bench
