#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/method_report.h"
#include "integrator/integrator.h"
#include "integrator/metropolis/member_chain.h"

namespace ajar {

/// Warning that none of so many bootstrap samples found light to start chains from.
Warning no_seeds(std::uint64_t samples);

/// Adds up how chains fared, group by group.
class ChainReporter {
 public:
  /// The chains of all replicates whose paths are of one group, which must outlive this.
  class OfGroup {
   public:
    /// `moves`: of the kernel that the chains run with.
    OfGroup(const PathGroup& group, std::span<const Move> moves) : group_(&group), moves_(moves) {}
    /// Adds the estimate of b in one of so many replicates.
    void add_b(double b, double standard_error, int replicates);
    void add_chain(const ChainRecord& record);
    /// Adds a finished chain.
    void add_retired(const ChainRecord& record) { record_.add(record); }

   private:
    friend class ChainReporter;
    const PathGroup* group_;
    std::span<const Move> moves_;
    ChainRecord record_;
    std::uint64_t chains_ = 0;
    double b_ = 0.0;
    double b_variance_ = 0.0;
  };

  explicit ChainReporter(std::uint64_t bootstrap_samples) : bootstrap_samples_(bootstrap_samples) {}
  void add(OfGroup group) { groups_.push_back(std::move(group)); }
  /// `acceptance` by size of step, move (with what moves cost, as far as kernels know), depth and
  /// technique, `b` by depth, `chains`, `bootstrap_samples`.
  MethodReport report() const;

 private:
  std::uint64_t bootstrap_samples_;
  std::vector<OfGroup> groups_;
};

}  // namespace ajar
