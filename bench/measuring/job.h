#pragma once
#include <algorithm>
#include <chrono>
#include <memory>
#include <vector>

#include "integrator/integrator.h"
#include "measuring/variant.h"

namespace ajar::bench {

inline double seconds(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// A render of a scene, in items that can be timed.
struct Job {
  std::unique_ptr<Integrator> integrator;
  std::unique_ptr<Film> film;
  std::uint64_t items;
  std::uint64_t samples;  ///< per pixel

  Counters run(std::uint64_t first_item, std::uint64_t last_item) const {
    Counters counters;
    for (std::uint64_t i = first_item; i < last_item; ++i) {
      integrator->run_item(i, 0, samples, *film, counters);
    }
    return counters;
  }
};

/// Four samples per pixel in four replicates.
Job make_job(const Scene& scene, const Variant& variant, int max_depth);

}  // namespace ajar::bench
