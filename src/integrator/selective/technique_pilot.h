#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "integrator/preparation_stage.h"
#include "integrator/selective/preparation.h"

namespace ajar {

/// Finds out with which techniques, and how many light subpaths per camera sample, ordinary Monte
/// Carlo has the least error in the same time: where next event estimation reaches nearly
/// everything, inner connections cost more than they bring; where lamps hide in shades, several
/// light subpaths are worth their rays.
///
/// Each of a few offers has a stage of its own, which renders some tiles of the picture; so there
/// is but one film at a time. More light subpaths are tried only where one is better than few, or
/// chains may need what they find.
/// Nothing that was rendered stays.
class TechniquePilot final : public PreparationStage {
 public:
  /// One for each offer.
  static std::vector<std::unique_ptr<TechniquePilot>> make_all(
      const SelectivePreparation& prepared);
  ~TechniquePilot() override;
  TechniquePilot(const TechniquePilot&) = delete;
  TechniquePilot& operator=(const TechniquePilot&) = delete;
  double effort() const override;
  bool serves_alone() const override { return true; }
  std::uint64_t begin() override;
  void run(std::uint64_t item, Counters& counters) override;
  void end() override;
  /// The offer of least error, once enough is known to choose it.
  const std::optional<PathFamilyDefaults>& chosen() const { return trials_->chosen; }

 private:
  class Candidate;
  /// Sums of squares over the tiles that were rendered, in units of (luminance · importance)².
  struct Errors {
    double weak = 0.0;        ///< variance of what ordinary Monte Carlo keeps
    double strong = 0.0;      ///< second moment of what is beyond the threshold
    double from_light = 0.0;  ///< second moment of finds of light subpaths
    double inner = 0.0;       ///< part of that by connections that are not to the lens
    double rays = 0.0;
    double after_equal_time() const { return (weak + strong) * rays; }
  };
  /// Shared by the stages.
  struct Trials {
    std::vector<Errors> errors;  ///< errors of the offers so far
    std::optional<PathFamilyDefaults> chosen;
  };

  TechniquePilot(const SelectivePreparation& prepared, PathFamilyDefaults offer,
                 std::shared_ptr<Trials> trials);
  /// Tests for strong paths that inner connections do not make any rarer: they are for
  /// chains.
  static bool is_for_chains(const std::vector<Errors>& found);
  /// Chooses, once enough is known for it.
  void choose() const;

  const SelectivePreparation& prepared_;
  PathFamilyDefaults offer_;
  std::shared_ptr<Trials> trials_;
  std::unique_ptr<Candidate> candidate_;
  std::vector<std::uint64_t> tiles_;
};

}  // namespace ajar
