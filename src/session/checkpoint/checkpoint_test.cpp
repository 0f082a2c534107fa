#include "session/checkpoint/checkpoint.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "core/error.h"
#include "session/options/render_options.h"
#include "session/testing/checksums.h"
#include "session/version.h"

namespace ajar {
namespace {

namespace fs = std::filesystem;

class CheckpointFile : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("ajar-checkpoint-" + std::to_string(getpid()));
    fs::create_directories(folder_);
    path_ = (folder_ / "a.checkpoint").string();
    checkpoint_.version = version();
    RenderRecord& render = checkpoint_.render;
    render.scene = "builtin:cornell";
    render.scene_hash = 77;
    render.integrator = "pt";
    render.parameters = {{"sampler", "sobol"}, {"cull", "0.01"}};
    render.given = {{"sampler", "independent"}};
    render.settings.resolution = {6, 5};
    render.settings.crop = Box2i(Vec2i(1, 1), Vec2i(4, 3));
    render.settings.seed = 5;
    render.settings.replicates = 2;
    render.spec.layers = {"albedo"};
    render.spec.seconds = 3.5;
    render.spec.outputs = {"/a/b.exr"};
    render.spec.exposure = Exposure{true, 0.5F};
    checkpoint_.layers = {{.name = "direct", .magnitude = 0.3},
                          {.name = "indirect"},
                          {.name = "albedo", .has_replicates = false}};
    checkpoint_.scales.whole = {0.1, 0.1, 0.1};
    checkpoint_.scales.whole[2].pixels = std::vector<float>(4 * 3, 0.5F);
    checkpoint_.scales.replicates = {{0.2, 0.2}, {0.2, 0.2}, {}};
    checkpoint_.scales.maps = {{"noise", Plane({4, 3})}};
    checkpoint_.scales.antialias_mask.emplace(Vec2i(4, 3));
    JobState& job = checkpoint_.job;
    job.samples_per_pixel = 12;
    job.partial = PartialPass{12, 4, {1, 0, 1}, 1, 3};
    job.counters.rays = 1234;
    job.counters.rays_out_of_range = 567;
    job.counters.first_discarded = "somewhere";
    job.counters.techniques.add(3, 0.5, 0.25);
    job.relative_error = RelativeError{.value = 0.25};
    job.recent_errors = {{8, 0.3}, {12, 0.25}};
    checkpoint_.integrator_state = std::string("\0\1\2", 3);
    for (int i = 0; i < 4 * 3 * 3 * 5; ++i) sums_.push_back(i * 1234567890123LL - 7);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string write() const {
    write_checkpoint(path_, checkpoint_, sums_);
    return bytes();
  }
  std::string bytes() const {
    std::ifstream file(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  void put(const std::string& content) const {
    std::ofstream(path_, std::ios::binary | std::ios::trunc) << content;
  }
  std::string refusal() const {
    try {
      read_checkpoint(path_);
    } catch (const IoError& error) {
      return error.what();
    }
    return {};
  }

  fs::path folder_;
  std::string path_;
  Checkpoint checkpoint_;
  std::vector<std::int64_t> sums_;
};

TEST_F(CheckpointFile, KeepsEverything) {
  const std::string first = write();
  Checkpoint read = read_checkpoint(path_);
  EXPECT_EQ(read.sums, sums_);
  EXPECT_EQ(read.render.parameters, checkpoint_.render.parameters);
  EXPECT_EQ(read.render.settings.crop, checkpoint_.render.settings.crop);
  EXPECT_EQ(read.job.partial->done, checkpoint_.job.partial->done);
  EXPECT_EQ(read.job.partial->round, 1);
  EXPECT_EQ(read.job.partial->rounds, 3);
  EXPECT_EQ(read.job.counters.rays_out_of_range, 567U);
  EXPECT_EQ(read.job.counters.techniques.sums(), checkpoint_.job.counters.techniques.sums());
  EXPECT_EQ(read.integrator_state, checkpoint_.integrator_state);
  for (const RenderOption& option : render_options()) {
    EXPECT_EQ(option_json(option, read.render.spec), option_json(option, checkpoint_.render.spec))
        << option.name;
  }
  // All else: writing it again gives the same bytes.
  write_checkpoint(path_, read, read.sums);
  EXPECT_EQ(bytes(), first);
  const Film film = film_of(read, Filter::box(), path_);
  EXPECT_TRUE(std::equal(sums_.begin(), sums_.end(), film.raw().begin(), film.raw().end()));
}

TEST_F(CheckpointFile, IsRefusedWhereverItIsCutShort) {
  const std::string whole = write();
  for (std::size_t size = 0; size < whole.size(); size += size < 100 ? 1 : 37) {
    put(whole.substr(0, size));
    EXPECT_NE(refusal(), "") << size << " of " << whole.size() << " bytes";
  }
  put(whole + "x");
  EXPECT_NE(refusal(), "");
}

TEST_F(CheckpointFile, IsRefusedWhereverABitHasFlipped) {
  const std::string whole = write();
  std::mt19937 random(1);
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < 48; ++i) places.push_back(i);
  for (int i = 0; i < 300; ++i) places.push_back(random() % whole.size());
  for (const std::size_t place : places) {
    std::string damaged = whole;
    damaged[place] = static_cast<char>(damaged[place] ^ (1 << (random() % 8)));
    put(damaged);
    EXPECT_NE(refusal(), "") << "byte " << place;
  }
}

TEST_F(CheckpointFile, OfAnotherFormatNamesTheReason) {
  const std::string whole = write();
  for (const auto& [format, needed] : {std::pair{1000U, "newer version"}, {1U, "older version"}}) {
    std::string other = whole;
    std::memcpy(other.data() + 16, &format, sizeof(format));
    put(other);
    EXPECT_NE(refusal().find("damaged"), std::string::npos) << "the header has a checksum";
    // With the checksum that such an Ajar would write.
    make_checkpoint_checksums_right(std::as_writable_bytes(std::span(other)));
    put(other);
    EXPECT_NE(refusal().find(needed), std::string::npos) << refusal();
  }
}

TEST_F(CheckpointFile, OtherFilesAreNamedAsSuch) {
  put("v 0 0 0\nv 1 0 0\n" + std::string(100, 'x'));
  EXPECT_NE(refusal().find("not a checkpoint"), std::string::npos);
  put("");
  EXPECT_NE(refusal().find("not a checkpoint"), std::string::npos);
  fs::remove(path_);
  EXPECT_NE(refusal().find("no such file"), std::string::npos);
  fs::create_directory(path_);
  EXPECT_NE(refusal().find("it is a folder, and only regular files"), std::string::npos);
}

TEST_F(CheckpointFile, FilmThatDoesNotFitIsRefused) {
  write();
  Checkpoint read = read_checkpoint(path_);
  read.sums.pop_back();
  EXPECT_THROW(film_of(read, Filter::box(), path_), IoError);
  read.render.settings.crop.max.x = 1000;
  EXPECT_THROW(film_of(read, Filter::box(), path_), IoError);
}

/// A checkpoint with right checksums that this program cannot have written.
class HostileCheckpoint : public CheckpointFile {
 protected:
  template <typename Change>
  void expect_refused(const char* reason, const Change& change) {
    Checkpoint hostile = checkpoint_;
    change(hostile);
    write_checkpoint(path_, hostile, sums_);
    const std::string message = refusal();
    EXPECT_NE(message.find(path_ + ": makes no sense: "), std::string::npos) << reason << message;
    EXPECT_NE(message.find(reason), std::string::npos) << reason << " or " << message;
  }
};

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr int kLargest = std::numeric_limits<int>::max();

TEST_F(HostileCheckpoint, IsRefusedForItsRender) {
  write();
  ASSERT_EQ(refusal(), "") << "what is changed below made sense";
  using C = Checkpoint;
  const char* const size = "a picture of this size";
  expect_refused(size, [](C& c) { c.render.settings.resolution = {0, 5}; });
  expect_refused(size, [](C& c) { c.render.settings.resolution.y = kLargest; });
  const char* const crop = "its crop";
  expect_refused(crop, [](C& c) { c.render.settings.crop.max.x = kLargest; });
  expect_refused(crop, [](C& c) { c.render.settings.crop.min.x = -kLargest; });
  expect_refused(crop, [](C& c) { c.render.settings.crop.max.y = 0; });
  const char* const film = "its film";
  expect_refused(film, [](C& c) { c.render.settings.crop.min.x = 0; });
  expect_refused(film, [](C& c) {
    c.render.settings.resolution = {65536, 65536};
    c.render.settings.crop = Box2i(Vec2i(0, 0), Vec2i(65535, 65535));
    c.render.settings.replicates = kLargest;
  });
  expect_refused("no replicates", [](C& c) { c.render.settings.replicates = 0; });
  expect_refused(film, [](C& c) { c.render.settings.replicates = kLargest; });
  expect_refused("its depths", [](C& c) { c.render.settings.min_depth = 0; });
  expect_refused("its depths", [](C& c) { c.render.settings.max_depth = kLargest; });
  expect_refused("unknown integrator", [](C& c) { c.render.integrator = "magic"; });
  expect_refused("unknown parameter", [](C& c) { c.render.given["magic"] = "1"; });
  expect_refused("unknown AOV", [](C& c) { c.render.spec.layers = {"magic"}; });
  expect_refused("asked for twice", [](C& c) { c.render.spec.layers = {"albedo", "albedo"}; });
  expect_refused("its scale", [](C& c) { c.render.film_scale = kNan; });
  expect_refused("share: there is no", [](C& c) { c.render.spec.share = {0, 0}; });
  expect_refused("share: there is no", [](C& c) { c.render.spec.share = {2, 2}; });
  expect_refused("tone map", [](C& c) { c.render.spec.tone_map = "magic"; });
  expect_refused("exposure: must be", [](C& c) {
    c.render.spec.exposure = Exposure{false, std::nanf("")};
  });
  expect_refused("samples_per_pixel: must be",
                 [](C& c) { c.render.spec.samples_per_pixel = ~std::uint64_t{0}; });
  expect_refused("seconds: must be", [](C& c) { c.render.spec.seconds = kNan; });
}

TEST_F(HostileCheckpoint, IsRefusedForItsFilm) {
  using C = Checkpoint;
  expect_refused("no name of its own", [](C& c) { c.layers[2].name.clear(); });
  expect_refused("no name of its own", [](C& c) { c.layers[2].name = "direct"; });
  for (const double magnitude : {0.0, -1.0, 1e-310, 1e300, kNan}) {
    expect_refused("the magnitude", [&](C& c) { c.layers[0].magnitude = magnitude; });
  }
  expect_refused("has no replicates", [](C& c) { c.layers[1].has_replicates = false; });
  expect_refused("part of nothing", [](C& c) { c.layers[2].part_of = "magic"; });
  expect_refused("estimates nothing", [](C& c) {
    c.layers[2].has_replicates = true;
    c.layers[2].instead_of = "magic";
    c.sums.resize(c.sums.size() * 2);
  });
  expect_refused("part of nothing", [](C& c) { c.layers[2].part_of = "albedo"; });
  expect_refused("lacks a part", [](C& c) { c.layers[2].holds_identities = true; });
  expect_refused("no light", [](C& c) { c.layers[1].name = "other"; });
  expect_refused("its film", [](C& c) { c.layers.pop_back(); });
  const char* const scales = "its scales";
  expect_refused(scales, [](C& c) { c.scales.whole.pop_back(); });
  expect_refused(scales, [](C& c) { c.scales.replicates.pop_back(); });
  expect_refused(scales, [](C& c) { c.scales.replicates[1].pop_back(); });
  expect_refused(scales, [](C& c) { c.scales.replicates[2].push_back(1.0); });
  expect_refused(scales, [](C& c) { c.scales.whole[0] = kNan; });
  expect_refused(scales, [](C& c) { c.scales.whole[2].pixels.pop_back(); });
  expect_refused(scales, [](C& c) { c.scales.whole[2].pixels[1] = -1.F; });
  expect_refused("a map", [](C& c) { c.scales.maps[0].second.values.pop_back(); });
  expect_refused("a map", [](C& c) { c.scales.maps[0].second.size = {3, 4}; });
  expect_refused("its mask", [](C& c) { c.scales.antialias_mask->size = {-4, -3}; });
}

TEST_F(HostileCheckpoint, IsRefusedForItsJob) {
  using C = Checkpoint;
  const char* const partial = "cut short";
  expect_refused(partial, [](C& c) { c.job.partial->first_sample = 11; });
  expect_refused(partial, [](C& c) { c.job.partial->samples = 0; });
  expect_refused(partial, [](C& c) { c.job.partial->samples = ~std::uint64_t{0}; });
  expect_refused(partial, [](C& c) { c.job.partial->done[1] = 2; });
  expect_refused(partial, [](C& c) { c.job.partial->round = -1; });
  expect_refused(partial, [](C& c) { c.job.partial->round = 3; });
  expect_refused("its times", [](C& c) { c.job.seconds_per_sample = -1.0; });
  expect_refused("its times", [](C& c) { c.job.seconds = kNan; });
  expect_refused("its error", [](C& c) { c.job.relative_error = RelativeError{.value = kNan}; });
  expect_refused("its errors", [](C& c) { c.job.recent_errors[0].samples = 0; });
  expect_refused("its errors", [](C& c) { c.job.recent_errors[1].samples = ~std::uint64_t{0}; });
  expect_refused("so many samples", [](C& c) {
    c.job.partial.reset();
    c.job.samples_per_pixel = ~std::uint64_t{0};
  });
  expect_refused("its seeds", [](C& c) { c.merged = {{1, 8}, {2, 8}}; });
  expect_refused("its seeds", [](C& c) { c.merged = {{1, ~std::uint64_t{0}}, {2, 13}}; });
  expect_refused("a seed", [](C& c) { c.merged = {{1, 6}, {1, 6}}; });
}

TEST_F(HostileCheckpoint, IsNotBelievedWhatItClaimsToHold) {
  const std::string whole = write();
  // Where in the file the number of layers is: they begin with the name of the first.
  const std::string begin("\3\0\0\0\0\0\0\0\6\0\0\0\0\0\0\0direct", 22);
  const std::size_t place = whole.find(begin);
  ASSERT_NE(place, std::string::npos);
  for (const std::uint64_t claim : {std::uint64_t{4}, std::uint64_t{1} << 30, ~std::uint64_t{0}}) {
    std::string hostile = whole;
    std::memcpy(hostile.data() + place, &claim, sizeof(claim));
    put(hostile);
    EXPECT_NE(refusal().find("damaged"), std::string::npos) << "its checksum is the old one";
    make_checkpoint_checksums_right(std::as_writable_bytes(std::span(hostile)));
    put(hostile);
    EXPECT_NE(refusal().find("makes no sense"), std::string::npos) << claim << refusal();
  }
}

TEST_F(CheckpointFile, LargerThanTheMemoryIsRefused) {
  // Holes of a file take no room on the disk.
  std::string head = write();
  constexpr std::uint64_t kBytes = std::uint64_t{1} << 42;
  std::uint64_t head_bytes = 0;
  std::memcpy(&head_bytes, head.data() + 24, sizeof(head_bytes));
  const std::uint64_t sums = (kBytes - 48 - head_bytes) / 8;
  std::memcpy(head.data() + 32, &sums, sizeof(sums));
  make_checkpoint_checksums_right(std::as_writable_bytes(std::span(head)));
  put(head);
  fs::resize_file(path_, 48 + head_bytes + 8 * sums);
  EXPECT_NE(refusal().find("of memory"), std::string::npos) << refusal();
}

TEST_F(CheckpointFile, OfAnotherVersionNeedsForce) {
  check_resumable(checkpoint_, path_, false);
  checkpoint_.version = "0.0.1";
  EXPECT_THROW(check_resumable(checkpoint_, path_, false), UsageError);
  check_resumable(checkpoint_, path_, true);
  checkpoint_.merged = {{1, 8}, {2, 8}};
  EXPECT_THROW(check_resumable(checkpoint_, path_, true), UsageError);
}

TEST_F(CheckpointFile, OfAnotherSceneIsRefused) {
  check_scene(checkpoint_, 77, checkpoint_.layers, path_, false);
  EXPECT_THROW(check_scene(checkpoint_, 78, checkpoint_.layers, path_, false), UsageError);
  check_scene(checkpoint_, 78, checkpoint_.layers, path_, true);
  // Different layers are refused in any case.
  std::vector<LayerSpec> brighter = checkpoint_.layers;
  brighter[0].magnitude *= 1.0001;
  EXPECT_THROW(check_scene(checkpoint_, 77, brighter, path_, true), UsageError);
  brighter.pop_back();
  EXPECT_THROW(check_scene(checkpoint_, 77, brighter, path_, true), UsageError);
}

TEST_F(CheckpointFile, OfAnotherRenderIsRefusedByName) {
  const auto refusal_of = [&](auto change) {
    RenderRecord now = checkpoint_.render;
    change(now);
    try {
      check_same_render(checkpoint_.render, now, path_);
    } catch (const UsageError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal_of([](RenderRecord&) {}), "");
  EXPECT_NE(refusal_of([](RenderRecord& r) { r.settings.seed = 6; }).find("seed 5, not seed 6"),
            std::string::npos);
  EXPECT_NE(refusal_of([](RenderRecord& r) { r.parameters["cull"] = "0"; }).find("cull 0.01"),
            std::string::npos);
  for (const auto& change : {+[](RenderRecord& r) { r.integrator = "bdpt"; },
                             +[](RenderRecord& r) { r.settings.max_depth = 7; },
                             +[](RenderRecord& r) { r.settings.crop.min.x = 0; },
                             +[](RenderRecord& r) { r.settings.replicates = 4; },
                             +[](RenderRecord& r) { r.spec.layers.clear(); },
                             +[](RenderRecord& r) {
                               r.spec.share = {1, 2};
                             }}) {
    EXPECT_NE(refusal_of(change), "");
  }
}

TEST_F(CheckpointFile, PreviousOneStaysIfTheNewOneCannotBeWritten) {
  const std::string first = write();
  // A full disk: no file may become longer than this.
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit small = before;
  small.rlim_cur = 1000;
  std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  EXPECT_THROW(write_checkpoint(path_, checkpoint_, sums_), IoError);
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(bytes(), first);
  const auto files = std::distance(fs::directory_iterator(folder_), {});
  EXPECT_EQ(files, 1) << "nothing else is left behind";
}

}  // namespace
}  // namespace ajar
