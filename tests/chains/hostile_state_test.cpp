// Corrupt states of an integrator in a checkpoint are refused, or can be rendered on.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <map>
#include <ostream>
#include <random>
#include <string>

#include "core/archive.h"
#include "session/job/preparation.h"
#include "session/job/render_job.h"
#include "session/render/resolved_render.h"
#include "support/methods.h"
#include "support/render.h"
#include "support/small_scenes.h"

namespace ajar {
namespace {

constexpr std::uint64_t kSamples = 8;

struct Method {
  std::string name;
  std::string integrator;
  std::map<std::string, std::string> parameters;
};

/// Everything that methods keep: chains, seeds, prices; and maps of visits.
std::vector<Method> methods() {
  std::vector<Method> methods;
  for (const std::string& name :
       test::methods_but(test::those_without_chains("it keeps nothing, see below"))) {
    methods.push_back({test::name_for_tests(name), name, {{"bootstrap", "1000"}}});
    if (name == "selective") {
      methods.back().parameters = {{"split", "0.1"}};
    }
  }
  methods.push_back({"paths", "selective", {{"chain", "mlt"}, {"split", "0.1"}}});
  methods.push_back({"maps", "mmlt", {{"step", "adaptive"}, {"m1", "1"}, {"bootstrap", "1000"}}});
  return methods;
}

void PrintTo(const Method& method, std::ostream* out) { *out << method.name; }

class HostileState : public ::testing::TestWithParam<Method> {
 protected:
  HostileState() : scene_(test::scene_from(test::small_scene("GlassAndMetal").text)) {
    settings_ = settings_for(*scene_);
    settings_.max_depth = 5;
    const IntegratorInfo& info = find_integrator(GetParam().integrator);
    integrator_ = info.make(*scene_, settings_, info.read(GetParam().parameters));
    prepare(*integrator_);
    film_.emplace(film_for(*scene_, settings_, *integrator_));
    render(kSamples, {});
    good_ = archived([&](OutputArchive& archive) { integrator_->save_state(archive); });
  }
  void render(std::uint64_t samples, std::optional<JobState> resumed) {
    RenderJobOptions options;
    options.budget.samples_per_pixel = samples;
    options.threads = 2;
    options.resumed = std::move(resumed);
    RenderJob job(*integrator_, *film_, std::move(options));
    job.run();
    state_ = job.state();
  }
  void load(const std::string& bytes) {
    unarchive(bytes, [&](InputArchive& archive) { integrator_->load_state(archive, kSamples); });
  }
  /// False if it is refused.
  bool can_go_on(const std::string& bytes) {
    try {
      load(bytes);
    } catch (const std::exception&) {
      return false;
    }
    render(2 * kSamples, before_);
    return true;
  }

  std::unique_ptr<Scene> scene_;
  RenderSettings settings_;
  std::unique_ptr<Integrator> integrator_;
  std::optional<Film> film_;
  JobState state_;
  JobState before_ = state_;
  std::string good_;
};

template <typename Value>
std::string bytes_of(Value value) {
  std::string bytes(sizeof(value), '\0');
  std::memcpy(bytes.data(), &value, sizeof(value));
  return bytes;
}

TEST(KeptState, IsEmptyWithoutChains) {
  const auto scene = test::scene_from(test::small_scene("Room").text);
  for (const auto& [name, reason] : test::those_without_chains("they keep some")) {
    const IntegratorInfo& info = find_integrator(name);
    EXPECT_FALSE(info.make(*scene, settings_for(*scene), info.read({}))->keeps_state()) << name;
  }
}

TEST_P(HostileState, IsRefusedOrCanBeRenderedOn) {
  before_ = state_;
  ASSERT_NO_THROW(load(good_));
  const std::vector<std::string> values = {bytes_of(~std::uint64_t{0}),
                                           bytes_of(std::uint64_t{0}),
                                           bytes_of(std::uint64_t{1} << 40U),
                                           bytes_of(std::numeric_limits<double>::quiet_NaN()),
                                           bytes_of(std::numeric_limits<double>::infinity()),
                                           bytes_of(-1.0),
                                           bytes_of(1e300),
                                           bytes_of(1e-300),
                                           bytes_of(std::numeric_limits<float>::quiet_NaN()),
                                           bytes_of(1.F),
                                           bytes_of(-1.F),
                                           bytes_of(std::uint32_t{0x7fffffff}),
                                           std::string("\x01", 1),
                                           std::string("\x00", 1),
                                           std::string("\x80", 1)};
  std::mt19937 random(3);
  int refused = 0;
  for (int i = 0; i < 150; ++i) {
    // Most of it is the numbers of chains: the parts before and after them are hit as often.
    const std::size_t end = i % 2 == 0 ? good_.size() : std::min<std::size_t>(good_.size(), 600);
    const std::size_t from_begin = random() % end;
    const std::string& value = values[random() % values.size()];
    const std::size_t place = i % 4 == 3 ? good_.size() - 1 - from_begin : from_begin;
    std::string bad = good_;
    bad.replace(place, std::min(value.size(), bad.size() - place), value, 0,
                std::min(value.size(), bad.size() - place));
    SCOPED_TRACE(std::to_string(i) + " at " + std::to_string(place));
    bool went_on = false;
    ASSERT_NO_THROW(went_on = can_go_on(bad));
    refused += went_on ? 0 : 1;
  }
  EXPECT_GT(refused, 15);
  for (std::size_t size = 0; size < good_.size(); size += 1 + good_.size() / 50) {
    EXPECT_THROW(load(good_.substr(0, size)), std::exception) << size;
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, HostileState, ::testing::ValuesIn(methods()),
                         [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace ajar
