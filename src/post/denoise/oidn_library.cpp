#include "post/denoise/oidn_library.h"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <mutex>
#include <system_error>

#include "post/denoise/library_file.h"

namespace ajar {

namespace {

namespace fs = std::filesystem;

constexpr const char* kName = "libOpenImageDenoise.so.2";

fs::path from_environment(const char* name) {
  const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe)
  return value == nullptr ? fs::path() : fs::path(value);
}

fs::path cache_folder() {
  if (const fs::path cache = from_environment("XDG_CACHE_HOME"); cache.is_absolute()) return cache;
  const fs::path home = from_environment("HOME");
  return home.empty() ? fs::path() : home / ".cache";
}

/// The folders in `folder`, sorted; none if it cannot be read.
std::vector<fs::path> folders_in(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code not_a_folder;
    if (entry->is_directory(not_a_folder)) found.push_back(entry->path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// Libraries in packages of Python that are called after it, such as pyoidn/oidn/lib.
void add_packages(const fs::path& packages, std::vector<fs::path>& places) {
  for (const fs::path& package : folders_in(packages)) {
    if (package.filename().string().find("oidn") == std::string::npos) continue;
    for (const char* inside : {"oidn/lib", "lib", "."}) {
      const fs::path file = package / inside / kName;
      std::error_code error;
      if (fs::exists(file, error)) places.push_back(file.lexically_normal());
    }
  }
}

void add_python_packages(const fs::path& prefix, std::vector<fs::path>& places) {
  if (prefix.empty()) return;
  for (const fs::path& python : folders_in(prefix / "lib")) {
    if (!python.filename().string().starts_with("python3")) continue;
    for (const char* packages : {"site-packages", "dist-packages"}) {
      add_packages(python / packages, places);
    }
  }
}

/// Where the packages are that the library with this code is in, as site-packages/ajar/lib/
/// libajar.so; empty if it is elsewhere.
fs::path own_packages() {
  Dl_info found{};
  if (dladdr(reinterpret_cast<const void*>(&own_packages), &found) == 0) return {};  // NOLINT
  const fs::path folder = fs::path(found.dli_fname).parent_path();
  if (folder.filename() != "lib" || folder.parent_path().filename() != "ajar") return {};
  return folder.parent_path().parent_path();
}

template <typename Function>
bool take(void* library, const char* name, Function& function) {
  // POSIX: what dlsym returns for a function is one.
  function = reinterpret_cast<Function>(dlsym(library, name));  // NOLINT
  return function != nullptr;
}

bool take_all(void* library, OidnLibrary& oidn) {
  return take(library, "oidnNewDevice", oidn.new_device) &&
         take(library, "oidnSetDeviceBool", oidn.set_device_bool) &&
         take(library, "oidnSetDeviceInt", oidn.set_device_int) &&
         take(library, "oidnGetDeviceInt", oidn.get_device_int) &&
         take(library, "oidnCommitDevice", oidn.commit_device) &&
         take(library, "oidnGetDeviceError", oidn.get_device_error) &&
         take(library, "oidnReleaseDevice", oidn.release_device) &&
         take(library, "oidnNewFilter", oidn.new_filter) &&
         take(library, "oidnSetSharedFilterImage", oidn.set_shared_filter_image) &&
         take(library, "oidnSetFilterBool", oidn.set_filter_bool) &&
         take(library, "oidnSetFilterInt", oidn.set_filter_int) &&
         take(library, "oidnSetFilterProgressMonitorFunction",
              oidn.set_filter_progress_monitor_function) &&
         take(library, "oidnCommitFilter", oidn.commit_filter) &&
         take(library, "oidnExecuteFilter", oidn.execute_filter) &&
         take(library, "oidnReleaseFilter", oidn.release_filter);
}

/// Folders in which the system's loader looks, but for those that only its cache knows.
std::vector<fs::path> loader_folders() {
  std::vector<fs::path> folders;
  void* program = dlopen(nullptr, RTLD_LAZY);
  Dl_serinfo size{};
  if (program != nullptr && dlinfo(program, RTLD_DI_SERINFOSIZE, &size) == 0) {
    std::vector<std::max_align_t> memory(size.dls_size / sizeof(std::max_align_t) + 1);
    auto* list = reinterpret_cast<Dl_serinfo*>(memory.data());  // NOLINT: it grows beyond its end
    *list = size;
    if (dlinfo(program, RTLD_DI_SERINFO, list) == 0) {
      for (unsigned i = 0; i < list->dls_cnt; ++i) {
        folders.emplace_back(list->dls_serpath[i].dls_name);  // NOLINT
      }
    }
  }
  folders.emplace_back("/usr/local/lib");
  return folders;
}

/// Why the library, or one of its parts beside it, cannot be loaded, one sentence; empty if nothing
/// speaks against it.
std::string complaint_about(const fs::path& place) {
  if (const std::string complaint = library_complaint(place); !complaint.empty()) {
    return place.string() + ": " + complaint;
  }
  std::error_code error;
  for (fs::directory_iterator entry(place.parent_path(), error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    const bool is_part = name.starts_with("libOpenImageDenoise_core.so") ||
                         name.starts_with("libOpenImageDenoise_device_cpu.so");
    std::error_code ignored;
    if (!is_part || !fs::exists(entry->path(), ignored)) continue;
    const std::string complaint = library_complaint(entry->path());
    if (!complaint.empty()) return entry->path().string() + ": " + complaint;
  }
  return {};
}

/// Null, and more `trouble` if there is a file, if it is of no use.
std::shared_ptr<const OidnLibrary> load(const fs::path& place, std::string& trouble) {
  const auto fail = [&](const std::string& why) {
    trouble += (trouble.empty() ? "" : "; ") + why;
    return nullptr;
  };
  const bool has_folder = place.has_parent_path();
  std::error_code error;
  if (has_folder && !fs::exists(fs::symlink_status(place, error))) return nullptr;
  if (has_folder) {
    if (const std::string complaint = complaint_about(place); !complaint.empty()) {
      return fail(complaint);
    }
  }
  // Never closed: its threads may outlive their user.
  void* library = dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    const char* why = dlerror();  // NOLINT(concurrency-mt-unsafe): once per process
    if (!has_folder) return nullptr;
    return fail(place.string() + ": " + (why == nullptr ? "cannot be loaded" : why));
  }
  auto oidn = std::make_shared<OidnLibrary>();
  oidn->path = place.string();
  if (!take_all(library, *oidn)) {
    return fail(place.string() + ": has not the functions of version 2");
  }
  return oidn;
}

}  // namespace

std::vector<fs::path> oidn_places() {
  if (const fs::path given = from_environment("AJAR_OIDN"); !given.empty()) {
    std::error_code error;
    return {fs::is_directory(given, error) ? given / kName : fs::absolute(given, error)};
  }
  std::vector<fs::path> places;
  if (const fs::path packages = own_packages(); !packages.empty()) add_packages(packages, places);
  if (const fs::path cache = cache_folder(); !cache.empty()) {
    places.push_back(cache / "ajar" / "oidn" / "lib" / kName);
  }
  const std::size_t before = places.size();
  for (const fs::path& folder : loader_folders()) {
    std::error_code error;
    if (fs::exists(fs::symlink_status(folder / kName, error))) places.push_back(folder / kName);
  }
  // By its name alone it cannot be checked before it is loaded.
  if (places.size() == before) places.emplace_back(kName);
  for (const char* variable : {"VIRTUAL_ENV", "CONDA_PREFIX"}) {
    add_python_packages(from_environment(variable), places);
  }
  if (const fs::path home = from_environment("HOME"); !home.empty()) {
    add_python_packages(home / ".local", places);
  }
  add_python_packages("/usr/local", places);
  add_python_packages("/usr", places);
  return places;
}

std::shared_ptr<const OidnLibrary> find_oidn(std::string* trouble) {
  static std::once_flag once;
  static std::shared_ptr<const OidnLibrary> found;
  static std::string troubles;
  std::call_once(once, [] {
    for (const fs::path& place : oidn_places()) {
      found = load(place, troubles);
      if (found) return;
    }
    if (!troubles.empty() || from_environment("AJAR_OIDN").empty()) return;
    troubles = oidn_places().front().string() + ": it is not there";
  });
  if (trouble != nullptr) *trouble = troubles;
  return found;
}

}  // namespace ajar
