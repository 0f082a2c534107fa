#include "import/mitsuba/search_path.h"

#include <algorithm>
#include <filesystem>
#include <vector>

namespace ajar::mitsuba {

void SearchPath::add(const std::string& folder) {
  if (folder.empty() || std::find(folders_.begin(), folders_.end(), folder) != folders_.end()) {
    return;
  }
  folders_.push_back(folder);
}

std::string SearchPath::find(const std::string& name) const {
  if (folders_.empty()) return name;
  std::vector<std::string> candidates = {name};
  for (const std::string& folder : folders_) {
    candidates.push_back((std::filesystem::path(folder) / name).string());
  }
  // The very name in any folder comes before another spelling of it in the first.
  for (const std::string& candidate : candidates) {
    if (files_.is_there(candidate)) return candidate;
  }
  for (const std::string& candidate : candidates) {
    if (files_.exists(files_.resolve(candidate))) return candidate;
  }
  return name;
}

}  // namespace ajar::mitsuba
