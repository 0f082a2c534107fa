#include "post/denoise/oidn_denoiser.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace ajar {

namespace {

/// Memory that the library may take, MiB: it cuts larger pictures into tiles. Its own default.
constexpr int kMostMemory = 3000;
/// Memory of its network and its pictures; measured with 2.5.1.
constexpr std::uint64_t kBytesPerPixel = 700;

template <typename Handle>
class Owned {
 public:
  Owned(Handle handle, void (*release)(Handle)) : handle_(handle), release_(release) {}
  ~Owned() {
    if (handle_ != nullptr) release_(handle_);
  }
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  Handle get() const { return handle_; }

 private:
  Handle handle_;
  void (*release_)(Handle);
};

/// Raises std::runtime_error if something went wrong; false if it was cancelled.
bool check(const OidnLibrary& oidn, OidnLibrary::Device device) {
  const char* message = nullptr;
  const int error = oidn.get_device_error(device, &message);
  if (error == OidnLibrary::kCancelled) return false;
  if (error == OidnLibrary::kNoError) return true;
  throw std::runtime_error(
      fmt::format("Open Image Denoise ({}): {}", oidn.path, message == nullptr ? "?" : message));
}

class OidnDevice {
 public:
  explicit OidnDevice(const OidnLibrary& oidn)
      : oidn_(oidn), device_(oidn.new_device(OidnLibrary::kCpu), oidn.release_device) {
    if (device_.get() == nullptr) {
      check(oidn, nullptr);
      throw std::runtime_error(
          fmt::format("Open Image Denoise ({}): it has no device for processors", oidn.path));
    }
    // Threads are TBB's, which are not its own to pin.
    oidn.set_device_bool(device_.get(), "setAffinity", false);
    oidn.commit_device(device_.get());
    check(oidn, device_.get());
  }

  std::string version() const {
    const auto number = [&](const char* name) { return oidn_.get_device_int(device_.get(), name); };
    return fmt::format("{}.{}.{}", number("versionMajor"), number("versionMinor"),
                       number("versionPatch"));
  }

  struct Input {
    const char* name;
    const std::vector<float>* pixels;
  };
  /// Empty if `progress` ended it.
  std::optional<std::vector<float>> run(Vec2i size, std::span<const Input> inputs, bool is_radiance,
                                        int quality, const Denoiser::Progress& progress) const {
    const Owned<OidnLibrary::Filter> filter(oidn_.new_filter(device_.get(), "RT"),
                                            oidn_.release_filter);
    std::vector<float> output(3 * static_cast<std::size_t>(size.x) *
                              static_cast<std::size_t>(size.y));
    const auto set_image = [&](const char* name, const std::vector<float>& pixels) {
      if (pixels.size() != output.size()) throw std::invalid_argument("denoise: sizes do not fit");
      oidn_.set_shared_filter_image(
          filter.get(), name, const_cast<float*>(pixels.data()),  // NOLINT: inputs are only read
          OidnLibrary::kFloat3, static_cast<std::size_t>(size.x), static_cast<std::size_t>(size.y),
          0, 0, 0);
    };
    for (const Input& input : inputs) set_image(input.name, *input.pixels);
    set_image("output", output);
    if (is_radiance) {
      oidn_.set_filter_bool(filter.get(), "hdr", true);
      oidn_.set_filter_bool(filter.get(), "cleanAux", inputs.size() > 1);
    }
    oidn_.set_filter_int(filter.get(), "maxMemoryMB", kMostMemory);
    oidn_.set_filter_int(filter.get(), "quality", quality);
    if (progress) {
      oidn_.set_filter_progress_monitor_function(
          filter.get(),
          [](void* user, double done) {
            return (*static_cast<const Denoiser::Progress*>(user))(done);
          },
          const_cast<Denoiser::Progress*>(&progress));  // NOLINT: the C interface has no const
    }
    oidn_.commit_filter(filter.get());
    oidn_.execute_filter(filter.get());
    if (!check(oidn_, device_.get())) return std::nullopt;
    return output;
  }

 private:
  const OidnLibrary& oidn_;
  Owned<OidnLibrary::Device> device_;
};

/// Number of times that a picture has to be halved (below 0: doubled) for the library, which
/// computes its exposure in floats and takes values below 1e-8 as black: 0 for all usual pictures.
/// Constant 1e37 becomes 0, and constant 1e-8 blots that are 400 times as bright (2.5.1).
int halvings_for_library(const std::vector<float>& colour) {
  constexpr int kBrightest = 40;
  constexpr int kDimmest = -20;
  std::int64_t sum = 0;
  std::int64_t count = 0;
  for (const float value : colour) {
    if (value == 0.F) continue;
    sum += std::ilogb(value);
    ++count;
  }
  const int level = count == 0 ? 0 : static_cast<int>(sum / count);
  return level > kBrightest || level < kDimmest ? level : 0;
}

/// By a power of two; values too large for a float become the largest float.
void multiply(std::vector<float>& values, int exponent) {
  constexpr float kMost = std::numeric_limits<float>::max();
  for (float& value : values) value = std::clamp(std::ldexp(value, exponent), -kMost, kMost);
}

/// No value so large that a sum of a few is infinite.
void limit(std::vector<float>& values) {
  constexpr float kMost = 1e30F;
  for (float& value : values) value = std::clamp(value, -kMost, kMost);
}

}  // namespace

OidnDenoiser::OidnDenoiser(std::shared_ptr<const OidnLibrary> library)
    : library_(std::move(library)), name_("oidn " + OidnDevice(*library_).version()) {
  if (name_.starts_with("oidn 2.")) return;
  throw std::runtime_error(
      fmt::format("{}: it says that it is {}, not version 2", library_->path, name_));
}

std::uint64_t OidnDenoiser::memory_bytes(std::uint64_t pixels) const {
  return std::min(pixels * kBytesPerPixel, std::uint64_t{kMostMemory} << 20U);
}

Features OidnDenoiser::prepare(Vec2i size, Features features) const {
  if (features.empty()) return features;
  const OidnDevice device(*library_);
  const auto clean = [&](const char* name, std::vector<float>& pixels) {
    pixels = finite_values(pixels);
    // The finished picture is the same as with the best network, which takes twice as long
    // (docs/notebook/denoising.md).
    pixels = *device.run(size, std::array{OidnDevice::Input{name, &pixels}}, false,
                         OidnLibrary::kBalanced, {});
  };
  clean("albedo", features.albedo);
  clean("normal", features.normal);
  return features;
}

std::optional<std::vector<float>> OidnDenoiser::filter(const NoisyPicture& picture,
                                                       const Features& features,
                                                       const Progress& progress) const {
  const OidnDevice device(*library_);
  std::vector<float> colour = finite_values(picture.colour);
  const int halvings = halvings_for_library(colour);
  if (halvings != 0) multiply(colour, -halvings);
  limit(colour);
  std::vector<OidnDevice::Input> inputs = {{"color", &colour}};
  if (!features.empty()) {
    inputs.push_back({"albedo", &features.albedo});
    inputs.push_back({"normal", &features.normal});
  }
  const int quality = picture.roughly ? OidnLibrary::kFast : OidnLibrary::kHigh;
  auto pixels = device.run(picture.size, inputs, true, quality, progress);
  if (pixels && halvings != 0) multiply(*pixels, halvings);
  return pixels;
}

}  // namespace ajar
