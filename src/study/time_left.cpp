#include "study/time_left.h"

namespace ajar::study {

namespace {
struct RunningMean {
  double sum = 0;
  double count = 0;
  void add(double value, double weight) {
    sum += value;
    count += weight;
  }
};

double samples_of(const StudyPlan& plan, const StudyRun& run) {
  if (run.is_reference) return 0.0;
  return static_cast<double>(plan.budgets[run.budget].samples_per_pixel.value_or(0));
}
}  // namespace

std::optional<double> seconds_left(const StudyPlan& plan, const std::vector<StudyRun>& runs,
                                   const std::vector<std::optional<RunRecord>>& records,
                                   std::size_t next) {
  RunningMean all;
  std::map<std::pair<std::size_t, std::size_t>, RunningMean> per_sample;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!records[i]) continue;
    const double seconds = records[i]->json.value("seconds", 0.0);
    all.add(seconds, 1.0);
    const double samples = samples_of(plan, runs[i]);
    if (samples > 0) per_sample[{runs[i].scene, runs[i].method}].add(seconds, samples);
  }
  double left = 0.0;
  for (std::size_t i = next; i < runs.size(); ++i) {
    if (records[i]) continue;
    const double samples = samples_of(plan, runs[i]);
    const auto known = per_sample.find({runs[i].scene, runs[i].method});
    if (runs[i].seconds) {
      left += *runs[i].seconds;
    } else if (samples > 0 && known != per_sample.end()) {
      left += samples * known->second.sum / known->second.count;
    } else if (all.count > 0) {
      left += all.sum / all.count;
    } else {
      return std::nullopt;
    }
  }
  return left;
}

}  // namespace ajar::study
