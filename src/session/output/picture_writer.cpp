#include "session/output/picture_writer.h"

#include <fmt/format.h>

#include <utility>

#include "session/output/write_picture.h"

namespace ajar {

PictureWriter::PictureWriter(std::vector<std::string> paths, double every,
                             const InterruptCount* requests, Display display, Develop develop,
                             RepeatedWriting::Say warn, RepeatedWriting::Say note)
    : paths_(std::move(paths)),
      requests_(requests),
      display_(display),
      develop_(std::move(develop)),
      writing_("the picture", every, std::move(warn), note),
      note_(std::move(note)) {}

bool PictureWriter::wants_picture(const JobState& /*state*/) {
  return writing_.is_due() || requested() > answered_;
}

void PictureWriter::see_picture(const Film& film, const JobState& state) {
  const bool asked = requested() > answered_;
  if (!asked && !writing_.is_due()) return;
  answered_ = requested();
  const bool written = writing_.attempt([&] {
    const Picture picture = develop_(film, state);
    const DisplayOptions display = display_.of(picture);
    for (const std::string& path : paths_) write_picture(path, picture, display);
  });
  if (asked && written) {
    note_(fmt::format("wrote the picture with {} samples per pixel", state.samples_per_pixel));
  }
}

}  // namespace ajar
