// Corrupt checkpoints are refused, or can be shown, merged and rendered on. An input is a list of
// changes to a checkpoint that is made at the start, so that inputs stay valid when the format of
// checkpoints changes. Checksums are corrected.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/warnings.h"
#include "import/pbrt/pbrt_import.h"
#include "session/checkpoint/checkpoint.h"
#include "session/checkpoint/merge.h"
#include "session/output/output.h"
#include "session/render.h"
#include "session/scenes/loaded_scene.h"
#include "session/testing/checksums.h"
#include "support/private_file.h"

namespace {

using namespace ajar;

/// A matt room with a glass ball, in which all that integrators keep has something to do.
constexpr std::string_view kScene = R"(
LookAt 0 1 -3.4  0 0.8 0  0 1 0
Camera "perspective" "float fov" [45]
Film "image" "integer xresolution" [9] "integer yresolution" [6]
PixelFilter "box"
WorldBegin
AttributeBegin
  AreaLightSource "diffuse" "rgb L" [8 8 8]
  Translate 0 1.9 0
  Shape "sphere" "float radius" [0.15]
AttributeEnd
Material "matte" "rgb Kd" [0.6 0.5 0.4]
Shape "trianglemesh" "integer indices" [0 1 2 0 2 3] "point P" [-2 0 -2  2 0 -2  2 0 2  -2 0 2]
Shape "trianglemesh" "integer indices" [0 1 2 0 2 3] "point P" [-2 0 2  2 0 2  2 3 2  -2 3 2]
Material "glass"
AttributeBegin Translate 0.3 0.5 0 Shape "sphere" "float radius" [0.4] AttributeEnd
WorldEnd
)";

constexpr std::uint64_t kSamples = 8;

struct Method {
  const char* integrator;
  std::map<std::string, std::string> parameters;
};

const std::vector<Method>& methods() {
  static const std::vector<Method> kMethods = {
      {"pt", {}},
      {"mmlt", {{"step", "adaptive"}, {"m1", "1"}, {"bootstrap", "1000"}}},
      {"masked", {{"pilot-samples", "8"}, {"bootstrap", "1000"}}},
      {"selective", {{"split", "0.1"}}},
      {"selective", {{"chain", "mlt"}, {"split", "0.1"}}}};
  return kMethods;
}

/// A render that can go on, with a checkpoint of its first samples.
class Base {
 public:
  explicit Base(const Method& method) : method_(method) {
    Warnings warnings;
    scene_ = std::make_shared<LoadedScene>(
        import_pbrt_text(kScene, "fuzz.pbrt", "/nonexistent", warnings));
    const std::string path = fuzz::private_file({}, ".checkpoint");
    std::filesystem::remove(path);
    RenderRequest order = render_until(kSamples);
    order.spec.checkpoint = path;
    Render(std::move(order)).run();
    std::ifstream file(path, std::ios::binary);
    bytes_.assign(std::istreambuf_iterator<char>(file), {});
  }

  const std::vector<char>& bytes() const { return bytes_; }

  /// Resumes like `ajar render --resume`, for a few samples.
  void go_on(Checkpoint checkpoint) const {
    RenderRequest order = render_until(checkpoint.job.samples_per_pixel + 8);
    order.resumed = std::move(checkpoint);
    order.resumed_from = "fuzz.checkpoint";
    order.spec.force = true;
    Render(std::move(order)).run();
  }

 private:
  RenderRequest render_until(std::uint64_t samples) const {
    RenderRequest order;
    order.scene = "fuzz.pbrt";
    order.loaded = scene_;
    RenderSpec& spec = order.spec;
    spec.integrator = method_.integrator;
    spec.parameters = method_.parameters;
    spec.samples_per_pixel = samples;
    spec.max_depth = 5;
    spec.layers = {"standard-error"};
    // Chains that make all light do not see surfaces.
    if (std::string_view(method_.integrator) != "mmlt") spec.layers.push_back("object-id");
    order.spec.threads = 1;
    return order;
  }

  const Method& method_;
  std::shared_ptr<LoadedScene> scene_;
  std::vector<char> bytes_;
};

std::vector<Base>& bases() {
  static std::vector<Base> made = [] {
    std::vector<Base> list;
    list.reserve(methods().size());
    for (const Method& method : methods()) list.emplace_back(method);
    return list;
  }();
  return made;
}

/// Where in a file things are (checkpoint.cpp).
constexpr std::size_t kHeadBytes = 24;
constexpr std::size_t kHeader = 48;

/// Reads numbers from the input; 0 where it has ended.
class Input {
 public:
  explicit Input(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  bool empty() const { return bytes_.empty(); }
  std::size_t number(std::size_t bytes) {
    std::size_t value = 0;
    for (const std::uint8_t byte : take(bytes)) value = value << 8U | byte;
    return value;
  }
  std::span<const std::uint8_t> take(std::size_t count) {
    const auto taken = bytes_.first(std::min(count, bytes_.size()));
    bytes_ = bytes_.subspan(taken.size());
    return taken;
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

/// A change is its kind, its place in 3 bytes (from the end, if odd), and some bytes.
void change(std::vector<char>& file, Input& input) {
  const std::size_t kind = input.number(1);
  const std::size_t distance = input.number(3) % (file.size() + 1);
  const std::size_t place = (kind & 1U) != 0 ? file.size() - distance : distance;
  const std::size_t count = 1 + (kind >> 3U) % 16;
  const auto at = file.begin() + static_cast<std::ptrdiff_t>(place);
  const auto rest = static_cast<std::size_t>(file.end() - at);
  switch ((kind >> 1U) % 4) {
    case 0:
    case 1: {
      const auto bytes = input.take(std::min(count, rest));
      std::copy(bytes.begin(), bytes.end(), at);
      break;
    }
    case 2: {
      const auto bytes = input.take(count);
      file.insert(at, bytes.begin(), bytes.end());
      break;
    }
    default:
      file.erase(at, at + static_cast<std::ptrdiff_t>(std::min(count, rest)));
  }
}

struct ChangedFile {
  std::vector<char> bytes;
  Base& base;  ///< checkpoint that it came from
};
ChangedFile changed_file(std::span<const std::uint8_t> data) {
  Input input(data);
  const std::size_t which = input.number(1);
  Base& base = bases()[which / 2 % bases().size()];
  std::vector<char> file = base.bytes();
  // An odd number leaves the header to the changes, too.
  if (which % 2 == 1) {
    while (!input.empty()) change(file, input);
  } else {
    std::uint64_t head_bytes = 0;
    std::memcpy(&head_bytes, file.data() + kHeadBytes, sizeof(head_bytes));
    const auto sums_at = file.begin() + static_cast<std::ptrdiff_t>(kHeader + head_bytes);
    std::vector<char> head(file.begin() + kHeader, sums_at);
    const std::vector<char> sums(sums_at, file.end());
    while (!input.empty()) change(head, input);
    file.resize(kHeader);
    file.insert(file.end(), head.begin(), head.end());
    file.insert(file.end(), sums.begin(), sums.end());
    head_bytes = head.size();
    std::memcpy(file.data() + kHeadBytes, &head_bytes, sizeof(head_bytes));
  }
  make_checkpoint_checksums_right(std::as_writable_bytes(std::span(file)));
  return {std::move(file), base};
}

void show(Checkpoint checkpoint) {
  const Development scales = checkpoint.scales;
  const std::uint64_t samples = checkpoint.job.mean_samples();
  const double film_scale = checkpoint.render.film_scale;
  const std::vector<std::string> aovs = checkpoint.render.spec.layers;
  const Film film = film_of(checkpoint, Filter::box(), "fuzz.checkpoint");
  develop(film, scales, samples, film_scale, aovs);
}

/// With another seed, and as the two halves of one.
void merge_with_itself(const Checkpoint& checkpoint) {
  Checkpoint other = checkpoint;
  ++other.render.settings.seed;
  for (MergedRun& run : other.merged) run.seed += checkpoint.merged.size();
  show(merge({{"a", checkpoint}, {"b", std::move(other)}}, true));
  Checkpoint first = checkpoint;
  Checkpoint second = checkpoint;
  first.render.spec.share = {0, 2};
  second.render.spec.share = {1, 2};
  show(merge({{"a", std::move(first)}, {"b", std::move(second)}}, true));
}

template <typename Use>
void attempt(const Use& use) {
  try {
    use();
  } catch (const Error&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const ChangedFile file = changed_file(std::span(data, size));
  const std::string path = fuzz::private_file(
      std::span(reinterpret_cast<const std::uint8_t*>(file.bytes.data()), file.bytes.size()),
      ".checkpoint");
  if (size < 2) {
    // Unchanged: all of it must work, or there is nothing to change.
    const Checkpoint checkpoint = read_checkpoint(path);
    show(checkpoint);
    merge_with_itself(checkpoint);
    file.base.go_on(checkpoint);
    return 0;
  }
  attempt([&] {
    const Checkpoint checkpoint = read_checkpoint(path);
    attempt([&] { show(checkpoint); });
    attempt([&] { merge_with_itself(checkpoint); });
    attempt([&] { file.base.go_on(checkpoint); });
  });
  return 0;
}
