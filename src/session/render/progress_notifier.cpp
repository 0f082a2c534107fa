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
  return showing_.is_due();
}

void ProgressNotifier::see_picture(const Film& film, const JobState& state) {
  if (showing_.is_due()) showing_.attempt([&] { events_.picture(develop_(film, state)); });
}

}  // namespace ajar
