#include "integrator/metropolis/chain_report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

namespace ajar {

namespace {
constexpr WarningKind kNoSeeds{Effect::Light, "methods have found no light to start chains from"};

MethodReport report_of(const MoveRecord& move, std::string_view name) {
  const auto proposals = static_cast<double>(move.proposals);
  MethodReport report{{"move", name},
                      {"proposals", move.proposals},
                      {"acceptance", move.acceptance()},
                      {"dark", static_cast<double>(move.dark) / proposals}};
  if (move.rays > 0) report["rays"] = static_cast<double>(move.rays) / proposals;
  if (move.lost_walks + move.one_way_walks > 0) {
    report["lost_walks"] = move.lost_walks;
    report["one_way_walks"] = move.one_way_walks;
  }
  if (move.without_density > 0) report["without_density"] = move.without_density;
  return report;
}

}  // namespace

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

MethodReport ChainReporter::report() const {
  MethodReport by_depth = MethodReport::array();
  MethodReport by_technique = MethodReport::array();
  MethodReport by_move = MethodReport::array();
  MethodReport b = MethodReport::array();
  std::uint64_t chains = 0;
  std::uint64_t longest_streak = 0;
  std::uint64_t idle = 0;
  // Groups may have different ones.
  std::vector<std::pair<const Move*, MoveRecord>> moves;
  const auto record_of = [&](const Move& move) -> MoveRecord& {
    const auto known = std::find_if(moves.begin(), moves.end(),
                                    [&](const auto& other) { return other.first == &move; });
    return known != moves.end() ? known->second : moves.emplace_back(&move, MoveRecord()).second;
  };
  for (const OfGroup& group : groups_) {
    const MethodReport depth =
        group.group_->depth > 0 ? MethodReport(group.group_->depth) : MethodReport();
    const ChainStatistics& own = group.record_.statistics;
    MoveCount all;
    for (std::size_t i = 0; i < own.moves.size(); ++i) {
      all += own.moves[i];
      record_of(group.moves_[i]) += own.moves[i];
    }
    by_depth.push_back({{"depth", depth},
                        {"chains", group.chains_},
                        {"mutations", own.steps},
                        {"acceptance", all.acceptance()}});
    const double error = std::sqrt(group.b_variance_);
    b.push_back({{"depth", depth},
                 {"b", group.b_},
                 {"standard_error", std::isfinite(error) ? MethodReport(error) : MethodReport()}});
    for (std::size_t i = 0; i < group.record_.by_technique.size(); ++i) {
      const MoveCount& count = group.record_.by_technique[i];
      if (count.proposals == 0) continue;
      const Technique technique = group.group_->choice[i];
      by_technique.push_back({{"s", technique.s},
                              {"t", technique.t},
                              {"proposals", count.proposals},
                              {"acceptance", count.acceptance()}});
    }
    chains += group.chains_;
    idle += own.idle_steps();
    longest_streak = std::max(longest_streak, own.longest_streak);
  }
  MoveCount small;
  MoveCount large;
  for (const auto& [move, record] : moves) {
    if (record.proposals == 0) continue;
    by_move.push_back(report_of(record, move->name));
    (move->independent ? large : small) += record;
  }
  MethodReport acceptance{
      {"small", small.acceptance()},  {"large", large.acceptance()},
      {"by_move", by_move},           {"by_depth", by_depth},
      {"by_technique", by_technique}, {"longest_rejection_streak", longest_streak}};
  if (idle > 0) acceptance["idle"] = idle;
  return {{"acceptance", acceptance},
          {"b", b},
          {"chains", chains},
          {"bootstrap_samples", bootstrap_samples_}};
}

}  // namespace ajar
