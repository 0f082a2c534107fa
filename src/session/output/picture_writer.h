#pragma once
#include <functional>
#include <string>
#include <vector>

#include "session/job/interrupts.h"
#include "session/job/pass_observer.h"
#include "session/options/display.h"
#include "session/output/output.h"
#include "session/output/repeated_writing.h"

namespace ajar {

/// Writes the picture as it is every now and then, and when it is asked for by a signal.
class PictureWriter final : public PassObserver {
 public:
  /// The picture that goes into files.
  using Develop = std::function<Picture(const Film& film, const JobState& state)>;

  /// `every`: seconds; infinite for signals only. `requests` may be null.
  PictureWriter(std::vector<std::string> paths, double every, const InterruptCount* requests,
                Display display, Develop develop, RepeatedWriting::Say warn,
                RepeatedWriting::Say note);

  bool wants_picture(const JobState& state) override;
  void see_picture(const Film& film, const JobState& state) override;

 private:
  int requested() const { return requests_ == nullptr ? 0 : requests_->load(); }

  std::vector<std::string> paths_;
  const InterruptCount* requests_;
  int answered_ = 0;  ///< requests
  Display display_;
  Develop develop_;
  RepeatedWriting writing_;
  RepeatedWriting::Say note_;
};

}  // namespace ajar
