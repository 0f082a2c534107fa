#include "session/checkpoint/checkpoint_writer.h"

#include <utility>

#include "core/archive.h"
#include "os/atomic_file.h"

namespace ajar {

CheckpointWriter::CheckpointWriter(std::string path, double every, Checkpoint base,
                                   const Integrator& integrator, RepeatedWriting::Say warn,
                                   RepeatedWriting::Say note)
    : path_(std::move(path)),
      checkpoint_(std::move(base)),
      integrator_(integrator),
      writing_("the checkpoint", every, std::move(warn), std::move(note)) {
  remove_abandoned_parts(path_);
}

bool CheckpointWriter::wants_picture(const JobState& /*state*/) { return writing_.is_due(); }

void CheckpointWriter::fill(const Film& film, const JobState& state) {
  checkpoint_.job = state;
  checkpoint_.scales = development_of(film, integrator_, state.mean_samples());
  checkpoint_.integrator_state =
      archived([&](OutputArchive& archive) { integrator_.save_state(archive); });
}

void CheckpointWriter::see_picture(const Film& film, const JobState& state) {
  if (!writing_.is_due()) return;
  writing_.attempt([&] {
    fill(film, state);
    write_checkpoint(path_, checkpoint_, film.raw());
  });
}

FinalFile CheckpointWriter::last(const Film& film, const JobState& state, bool interrupted) {
  fill(film, state);
  if (interrupted) ++checkpoint_.interruptions;
  return {"the checkpoint", path_, [this, &film](const std::string& path) {
            write_checkpoint(path, checkpoint_, film.raw());
          }};
}

}  // namespace ajar
