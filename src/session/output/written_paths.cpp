#include "session/output/written_paths.h"

#include <algorithm>
#include <filesystem>

#include "core/error.h"

namespace ajar {

namespace fs = std::filesystem;

namespace {

/// Links resolved, as far as there is anything; for files that are not there yet, too.
std::string place_of(const std::string& path) {
  std::error_code error;
  fs::path place = fs::absolute(path, error);
  if (!error) place = fs::weakly_canonical(place, error);
  return error ? path : place.lexically_normal().string();
}

bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  // Hard links, too.
  return place_of(a) == place_of(b) || fs::equivalent(a, b, error);
}

}  // namespace

void check_distinct(const std::vector<std::string>& written) {
  for (auto file = written.begin(); file != written.end(); ++file) {
    const auto same = [&](const std::string& other) { return is_same_file(*file, other); };
    if (std::any_of(written.begin(), file, same)) {
      throw UsageError(*file + ": this file would be written twice");
    }
  }
}

void check_spares(const std::vector<std::string>& written, const std::set<std::string>& read) {
  for (const std::string& file : written) {
    for (const std::string& source : read) {
      if (!is_same_file(file, source)) continue;
      throw UsageError(file + ": this would overwrite what is read; name another file");
    }
  }
}

void check_new_checkpoint(const std::string& path, const std::string& resumed_from) {
  if (!resumed_from.empty() && is_same_file(path, resumed_from)) return;
  std::error_code error;
  // An empty one, as mktemp makes it, holds nothing.
  if (!fs::is_regular_file(path, error) || fs::file_size(path, error) == 0) return;
  throw UsageError(path + ": is there already. To go on with its render: ajar resume " + path +
                   ", or add --resume " + path + "; to begin anew name another file, or remove it");
}

}  // namespace ajar
