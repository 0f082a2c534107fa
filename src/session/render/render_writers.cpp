#include "session/render/render_writers.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "core/error.h"
#include "session/output/stats_json.h"

namespace ajar {

RenderWriters::RenderWriters(const RenderRequest& request, const Integrator& integrator,
                             std::optional<Checkpoint> base, std::unique_ptr<Preview> preview,
                             PictureWriter::Develop develop, RenderEvents& events)
    : spec_(request.spec), events_(events), preview_(std::move(preview)) {
  const auto trouble = [&events](const std::string& text) { events.trouble(text); };
  const auto note = [&events](const std::string& text) { events.note(text); };
  if (!spec_.checkpoint.empty() && base) {
    checkpoint_ = std::make_unique<CheckpointWriter>(spec_.checkpoint, spec_.checkpoint_every,
                                                     *std::move(base), integrator, trouble, note);
  }
  if (!spec_.outputs.empty()) {
    pictures_ = std::make_unique<PictureWriter>(
        spec_.outputs, spec_.output_every.value_or(RenderRequest::kNever), request.picture_requests,
        spec_.display(), std::move(develop), trouble, note);
  }
}

std::vector<PassObserver*> RenderWriters::observers() const {
  std::vector<PassObserver*> observers;
  for (PassObserver* observer :
       {static_cast<PassObserver*>(checkpoint_.get()), static_cast<PassObserver*>(pictures_.get()),
        static_cast<PassObserver*>(preview_.get())}) {
    if (observer != nullptr) observers.push_back(observer);
  }
  return observers;
}

void RenderWriters::show_last(const RenderJob& job) {
  if (preview_) preview_->show_last(job.film(), job.state());
}

void RenderWriters::write_last(const RenderJob& job, bool with_checkpoint,
                               const InterruptCount& interrupts, RenderOutcome& outcome) {
  std::vector<FinalFile> files;
  with_checkpoint = with_checkpoint && checkpoint_;
  if (with_checkpoint) {
    files.push_back(checkpoint_->last(job.film(), job.state(), outcome.interrupted));
  }
  for (FinalFile& file : picture_files(*outcome.picture, spec_.outputs, outcome.display)) {
    files.push_back(std::move(file));
  }
  Patience patience(interrupts, [this](const std::string& text) { events_.trouble(text); });
  outcome.files = write_final_files(files, &patience);
  for (std::size_t i = with_checkpoint ? 1 : 0; i < outcome.files.size(); ++i) {
    const std::string& path = outcome.files[i].path;
    if (!path.empty()) outcome.statistics.outputs.push_back(path);
  }
  outcome.statistics.peak_memory_bytes = peak_memory_bytes();
  outcome.statistics_error = write_statistics(outcome.statistics, spec_.statistics);
}

std::string write_statistics(const RenderStatistics& statistics, const std::string& path) {
  if (path.empty()) return {};
  try {
    write_json(to_json(statistics), path);
    return {};
  } catch (const IoError& error) {
    return error.what();
  }
}

}  // namespace ajar
