#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace ajar {

/// Open Image Denoise 2 as it is found on this machine: functions of its C interface, of which each
/// is named as there (oidn.h without the prefix), loaded at run time so that nothing depends on it.
struct OidnLibrary {
  using Device = struct DeviceImpl*;
  using Filter = struct FilterImpl*;
  using Monitor = bool (*)(void* user, double done);

  // Values of the interface's enumerations that are used.
  static constexpr int kCpu = 1;
  static constexpr int kFloat3 = 3;
  static constexpr int kFast = 4;
  static constexpr int kBalanced = 5;
  static constexpr int kHigh = 6;
  static constexpr int kNoError = 0;
  static constexpr int kCancelled = 6;

  Device (*new_device)(int type) = nullptr;
  void (*set_device_bool)(Device, const char* name, bool value) = nullptr;
  void (*set_device_int)(Device, const char* name, int value) = nullptr;
  int (*get_device_int)(Device, const char* name) = nullptr;
  void (*commit_device)(Device) = nullptr;
  int (*get_device_error)(Device, const char** message) = nullptr;
  void (*release_device)(Device) = nullptr;
  Filter (*new_filter)(Device, const char* type) = nullptr;
  void (*set_shared_filter_image)(Filter, const char* name, void* pixels, int format,
                                  std::size_t width, std::size_t height, std::size_t offset,
                                  std::size_t pixel_stride, std::size_t row_stride) = nullptr;
  void (*set_filter_bool)(Filter, const char* name, bool value) = nullptr;
  void (*set_filter_int)(Filter, const char* name, int value) = nullptr;
  void (*set_filter_progress_monitor_function)(Filter, Monitor, void* user) = nullptr;
  void (*commit_filter)(Filter) = nullptr;
  void (*execute_filter)(Filter) = nullptr;
  void (*release_filter)(Filter) = nullptr;

  std::string path;  ///< where it was found
};

/// Search path, in this order: the file or folder that the environment variable AJAR_OIDN names
/// (then nowhere else), packages of Python beside the one that this code is part of, the cache
/// folder into which `./dev setup` unpacks it, the system's loader, packages of Python. Files that
/// are no complete library for this machine are skipped before anything of them is loaded.
std::vector<std::filesystem::path> oidn_places();

/// The first that can be loaded, once per process; null if there is none. `trouble`: why each that
/// was found could not be used, one sentence; may be null.
std::shared_ptr<const OidnLibrary> find_oidn(std::string* trouble = nullptr);

}  // namespace ajar
