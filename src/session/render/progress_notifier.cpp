#include "session/render/progress_notifier.h"

#include <utility>

namespace ajar {

ProgressNotifier::ProgressNotifier(RenderEvents& events, double every, Snapshot snapshot,
                                   PictureWriter::Develop develop)
    : events_(events),
      snapshot_(std::move(snapshot)),
      develop_(std::move(develop)),
      showing_(
          "the picture that is shown", every,
          [&events](const std::string& text) { events.trouble(text); },
          [&events](const std::string& text) { events.note(text); }) {}

bool ProgressNotifier::wants_picture(const JobState& state) {
  if (state.passes > passes_told_) events_.progress(snapshot_());
  passes_told_ = state.passes;
  is_wanted_ = showing_.is_due() || events_.wants_picture();
  return is_wanted_;
}

void ProgressNotifier::see_picture(const Film& film, const JobState& state) {
  if (is_wanted_) showing_.attempt([&] { events_.picture(develop_(film, state)); });
}

}  // namespace ajar
