#include "import/mitsuba/search_path.h"

#include <algorithm>
#include <filesystem>

namespace ajar::mitsuba {

void SearchPath::add(const std::string& folder) {
  if (folder.empty() || std::find(folders_.begin(), folders_.end(), folder) != folders_.end()) {
    return;
  }
  folders_.push_back(folder);
}

std::string SearchPath::find(const std::string& name) const {
  if (folders_.empty() || files_.exists(files_.resolve(name))) return name;
  for (const std::string& folder : folders_) {
    const std::string candidate = (std::filesystem::path(folder) / name).string();
    if (files_.exists(files_.resolve(candidate))) return candidate;
  }
  return name;
}

}  // namespace ajar::mitsuba
