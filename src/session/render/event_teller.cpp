#include "session/render/event_teller.h"

#include <utility>

namespace ajar {

EventTeller::EventTeller(RenderEvents& events, double every, Snapshot snapshot,
                         PictureWriter::Develop develop)
    : events_(events),
      snapshot_(std::move(snapshot)),
      develop_(std::move(develop)),
      showing_(
          "the picture that is shown", every,
          [&events](const std::string& text) { events.trouble(text); },
          [&events](const std::string& text) { events.note(text); }) {}

bool EventTeller::wants_picture(const JobState& state) {
  if (state.passes > passes_told_) events_.progress(snapshot_());
  passes_told_ = state.passes;
  return showing_.is_due();
}

void EventTeller::see_picture(const Film& film, const JobState& state) {
  if (showing_.is_due()) showing_.attempt([&] { events_.picture(develop_(film, state)); });
}

}  // namespace ajar
