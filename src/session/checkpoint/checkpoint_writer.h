#pragma once
#include <string>

#include "session/checkpoint/checkpoint.h"
#include "session/job/pass_observer.h"
#include "session/output/repeated_writing.h"

namespace ajar {

/// Writes a checkpoint every now and then.
class CheckpointWriter final : public PassObserver {
 public:
  /// `base`: all that does not change while rendering. The integrator must outlive this.
  CheckpointWriter(std::string path, double every, Checkpoint base, const Integrator& integrator,
                   RepeatedWriting::Say warn, RepeatedWriting::Say note);

  bool wants_picture(const JobState& state) override;
  void see_picture(const Film& film, const JobState& state) override;

  /// The last one, of the film as it is now; both must outlive it.
  FinalFile last(const Film& film, const JobState& state, bool interrupted);

 private:
  void fill(const Film& film, const JobState& state);

  std::string path_;
  Checkpoint checkpoint_;
  const Integrator& integrator_;
  RepeatedWriting writing_;
};

}  // namespace ajar
