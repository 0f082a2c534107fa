#include "session/output/stats_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace ajar {
namespace {

RenderStatistics example() {
  RenderStatistics s;
  s.render.scene = "room.pbrt";
  s.render.integrator = "pt";
  s.render.parameters["sampler"] = "sobol";
  s.render.settings.seed = 7;
  s.render.settings.resolution = {640, 480};
  s.render.settings.crop = Box2i(Vec2i(0, 0), Vec2i(639, 479));
  s.result.seconds = 2.0;
  s.result.counters.rays = 1000;
  s.result.counters.discarded_nan = 3;
  s.result.counters.rays_out_of_range = 40;
  s.preparation.rays_out_of_range = 2;
  s.result.counters.first_discarded = "pixel (3, 4), sample 5";
  s.result.relative_error = RelativeError{.value = 0.01};
  s.result.stopped_by = StopReason::Interrupted;
  s.warning_count = 300;
  s.warnings = {"a", "b"};
  s.report = std::make_shared<const MethodReport>(
      MethodReport{{"chains", 5}, {"seed", "what is said already stays"}});
  return s;
}

TEST(Statistics, HaveEveryKeyOfTheManual) {
  const auto json = to_json(example());
  for (const char* key :
       {"integrator", "parameters", "seed", "threads", "resolution", "seconds", "cpu_seconds",
        "rays", "rays_per_second", "samples", "mutations", "mutations_per_second",
        "chain_cpu_seconds", "chains", "estimated_relative_error", "peak_memory_bytes", "warnings",
        "discarded", "interrupted"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  for (const char* key : {"load", "build", "prepare", "render"}) {
    EXPECT_TRUE(json.at("seconds").contains(key)) << key;
  }
  for (const char* key : {"nan", "infinite", "negative", "rays_out_of_range", "first"}) {
    EXPECT_TRUE(json.at("discarded").contains(key)) << key;
  }
}

TEST(Statistics, SayWhatHappened) {
  const auto json = to_json(example());
  EXPECT_EQ(json.at("rays_per_second"), 500.0);
  EXPECT_EQ(json.at("warnings"), 300);
  EXPECT_EQ(json.at("warning_messages").size(), 2U);
  EXPECT_EQ(json.at("discarded").at("nan"), 3);
  EXPECT_EQ(json.at("discarded").at("rays_out_of_range"), 42);
  EXPECT_EQ(json.at("discarded").at("first"), "pixel (3, 4), sample 5");
  EXPECT_EQ(json.at("interrupted"), true);
  EXPECT_EQ(json.at("resolution"), (nlohmann::ordered_json{640, 480}));
  EXPECT_EQ(json.at("crop"), (nlohmann::ordered_json{0, 0, 640, 480}));
  EXPECT_EQ(json.at("chains"), 5) << "what the method tells";
  EXPECT_EQ(json.at("seed"), 7);
}

TEST(Statistics, WhatIsNotANumberIsNull) {
  RenderStatistics s = example();
  s.result.relative_error = RelativeError{.value = std::nan("")};
  EXPECT_TRUE(to_json(s).at("estimated_relative_error").is_null());
  s.result.relative_error.reset();
  s.result.seconds = 0.0;
  EXPECT_TRUE(to_json(s).at("estimated_relative_error").is_null());
  EXPECT_EQ(to_json(s).at("rays_per_second"), 0.0);
}

TEST(Metadata, HasEveryParameter) {
  const auto metadata = to_metadata(example());
  EXPECT_EQ(metadata.at("ajar:parameter:sampler"), "sobol");
  EXPECT_EQ(metadata.at("ajar:seed"), "7");
  EXPECT_EQ(metadata.at("ajar:integrator"), "pt");
  EXPECT_EQ(metadata.at("ajar:estimated_relative_error"), "0.01");
}

}  // namespace
}  // namespace ajar
