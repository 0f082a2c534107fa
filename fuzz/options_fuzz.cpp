// Any text in the place of a value on the command line, or of rules for regions, must be one, or
// raise one of our errors. The first byte says which.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "core/error.h"
#include "integrator/integrator.h"
#include "integrator/regions/region_rules.h"
#include "session/options/option_values.h"
#include "session/preview/tcp_stream.h"

namespace {

using Reader = void (*)(const std::string&);

void read_crop(const std::string& text) {
  const ajar::Vec2i resolution(640, 480);
  const ajar::Box2i pixels =
      ajar::crop_pixels("--crop", ajar::parse_crop("--crop", text), resolution);
  const bool inside = pixels.min.x >= 0 && pixels.min.y >= 0 && pixels.min.x <= pixels.max.x &&
                      pixels.min.y <= pixels.max.y && pixels.max.x < resolution.x &&
                      pixels.max.y < resolution.y;
  if (!inside) std::abort();
}

/// Lines `KEY=VALUE`, for every integrator.
void read_parameters(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  const auto given = ajar::parse_assignments("--set", lines);
  for (const ajar::IntegratorInfo& info : ajar::integrators()) {
    try {
      info.read(given);
    } catch (const ajar::UsageError&) {
    }
  }
}

constexpr std::array<Reader, 9> kReaders = {
    [](const std::string& text) {
      if (!(ajar::parse_duration("--time", text) > 0.0)) std::abort();
    },
    [](const std::string& text) {
      const ajar::Vec2i size = ajar::parse_resolution("--resolution", text);
      if (size.x < 1 || size.y < 1) std::abort();
    },
    [](const std::string& text) { ajar::parse_depth("--depth", text); },
    read_crop,
    [](const std::string& text) {
      const ajar::WorkSlice share = ajar::parse_share("--share", text);
      if (share.index >= share.count) std::abort();
    },
    [](const std::string& text) { ajar::parse_list(text); },
    [](const std::string& text) { ajar::parse_viewer("--preview", text); },
    read_parameters,
    [](const std::string& text) { ajar::parse_region_rules(text, "fuzz.rules"); }};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    kReaders[data[0] % kReaders.size()](text);
  } catch (const ajar::Error&) {
  }
  return 0;
}
