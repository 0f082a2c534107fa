#include "session/checkpoint.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "core/error.h"
#include "session/version.h"

namespace ajar {
namespace {

namespace fs = std::filesystem;

class CheckpointFile : public testing::Test {
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
    render.settings.resolution = {6, 5};
    render.settings.crop = Box2i(Vec2i(1, 1), Vec2i(4, 3));
    render.settings.seed = 5;
    render.settings.replicates = 2;
    render.aovs = {"albedo"};
    checkpoint_.budget.seconds = 3.5;
    checkpoint_.outputs = {"/a/b.exr"};
    checkpoint_.layers = {{.name = "direct", .magnitude = 0.3},
                          {.name = "indirect"},
                          {.name = "albedo", .has_replicates = false}};
    JobState& job = checkpoint_.job;
    job.samples_per_pixel = 12;
    job.partial = PartialPass{12, 4, {1, 0, 1}};
    job.counters.rays = 1234;
    job.counters.first_discarded = "somewhere";
    job.counters.techniques.add(3, 0.5, 0.25);
    job.relative_error = 0.25;
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
  EXPECT_EQ(read.job.counters.techniques.sums(), checkpoint_.job.counters.techniques.sums());
  EXPECT_EQ(read.integrator_state, checkpoint_.integrator_state);
  EXPECT_EQ(read.budget.seconds, 3.5);
  EXPECT_FALSE(read.budget.samples_per_pixel.has_value());
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
    // With the checksum that such an Ajar would write: CRC-32 of the first 40 bytes.
    std::uint32_t checksum = 0xFFFFFFFFU;
    for (std::size_t i = 0; i < 40; ++i) {
      checksum ^= static_cast<unsigned char>(other[i]);
      for (int bit = 0; bit < 8; ++bit) {
        checksum = (checksum >> 1U) ^ ((checksum & 1U) != 0 ? 0xEDB88320U : 0U);
      }
    }
    const std::uint64_t stored = checksum ^ 0xFFFFFFFFU;
    std::memcpy(other.data() + 40, &stored, sizeof(stored));
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
  EXPECT_NE(refusal().find("not a file"), std::string::npos);
}

TEST_F(CheckpointFile, FilmThatDoesNotFitIsRefused) {
  checkpoint_.layers.pop_back();
  write();
  Checkpoint read = read_checkpoint(path_);
  EXPECT_THROW(film_of(read, Filter::box(), path_), IoError);
  read.render.settings.crop.max.x = 1000;
  EXPECT_THROW(film_of(read, Filter::box(), path_), IoError);
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
  // What looks different is refused in any case.
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
                             +[](RenderRecord& r) { r.aovs.clear(); },
                             +[](RenderRecord& r) {
                               r.share = {1, 2};
                             }}) {
    EXPECT_NE(refusal_of(change), "");
  }
}

TEST_F(CheckpointFile, PreviousOneStaysIfTheNewOneCannotBeWritten) {
  const std::string first = write();
  // As on a full disk: no file may become longer than this.
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
