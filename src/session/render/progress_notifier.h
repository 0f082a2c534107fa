#pragma once
#include <cstdint>
#include <functional>

#include "session/output/picture_writer.h"
#include "session/render/render_events.h"

namespace ajar {

/// Tells a listener of each pass, and shows it the picture every now and then.
class ProgressNotifier final : public PassObserver {
 public:
  using Snapshot = std::function<RenderSnapshot()>;

  /// `every`: seconds between pictures; infinite for none. `events` must outlive this.
  ProgressNotifier(RenderEvents& events, double every, Snapshot snapshot,
                   PictureWriter::Develop develop);

  bool wants_picture(const JobState& state) override;
  void see_picture(const Film& film, const JobState& state) override;

 private:
  RenderEvents& events_;
  Snapshot snapshot_;
  PictureWriter::Develop develop_;
  RepeatedWriting showing_;
  std::uint64_t passes_told_ = 0;
  bool is_wanted_ = false;  ///< after the last pass
};

}  // namespace ajar
