#include "integrator/metropolis/chain_report.h"

#include <cmath>
#include <string>

#include "mcmc/primary/step_kind.h"

namespace ajar {

namespace {
constexpr WarningKind kNoSeeds{Effect::Light, "methods have found no light to start chains from"};
}

Warning no_seeds(std::uint64_t samples) {
  return {kNoSeeds,
          {},
          "no light was found for Markov chains in " + std::to_string(samples) +
              " tries: light that comes by way of several surfaces may be missing; see whether "
              "the lamps reach what the camera sees, allow longer paths (--depth), or let it try "
              "more often (--set bootstrap=10000000)"};
}

void ChainReporter::OfGroup::add_b(double b, double standard_error, int replicates) {
  b_ += b / replicates;
  b_variance_ += standard_error * standard_error / (static_cast<double>(replicates) * replicates);
}

void ChainReporter::OfGroup::add_chain(const ChainRecord& record) {
  ++chains_;
  record_.add(record);
}

void ChainReporter::add(const OfGroup& group) {
  const ChainStatistics& own = group.record_.statistics;
  MoveCount all;
  for (const MoveCount& move : own.moves) all += move;
  report_.depths.push_back({group.group_.depth, group.chains_, group.plain_ + own.steps,
                            all.acceptance(), group.b_, std::sqrt(group.b_variance_)});
  for (std::size_t i = 0; i < group.record_.by_technique.size(); ++i) {
    const MoveCount& count = group.record_.by_technique[i];
    if (count.proposals == 0) continue;
    report_.techniques.push_back({group.group_.choice[i], count.proposals, count.acceptance()});
  }
  whole_ += own;
}

ChainReport ChainReporter::report() const {
  ChainReport report = report_;
  MoveCount small;
  for (std::size_t i = 0; i < whole_.moves.size(); ++i) {
    const MoveCount& move = whole_.moves[i];
    if (move.proposals == 0) continue;
    report.moves.push_back({std::string(step_names()[i]), move.proposals, move.acceptance()});
    if (i == move_of(StepKind::Large)) {
      report.large_acceptance = move.acceptance();
    } else {
      small += move;
    }
  }
  report.small_acceptance = small.acceptance();
  report.longest_rejection_streak = whole_.longest_streak;
  return report;
}

}  // namespace ajar
