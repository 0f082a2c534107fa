#include "apps/viewer/viewer.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <thread>

#include "apps/viewer/testing/web_client.h"
#include "imageio/read_picture.h"
#include "import/testing/temporary_folder.h"

namespace ajar::viewer {
namespace {

using nlohmann::json;
using testing::WebClient;

/// A page by hand: it has the token, and draws every frame.
class ByHand {
 public:
  explicit ByHand(const std::string& address)
      : client_(port_of(address), fmt::format("http://127.0.0.1:{}", port_of(address))) {
    send({{"type", "hello"}, {"version", 1}, {"token", address.substr(address.find('#') + 1)}});
  }
  void send(const json& message) { client_.send_text(message.dump()); }
  void send_binary(const std::string& bytes) { client_.send_binary(bytes); }
  /// The next message of a type for which `holds` is true; frames are acknowledged meanwhile, if
  /// `draws`. Null after a minute.
  template <typename Holds>
  json wait_for(const std::string& type, Holds holds) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (std::chrono::steady_clock::now() < end) {
      const auto message = client_.receive();
      if (!message) return {};
      if (!message->is_text) {
        take_frame(message->bytes);
        continue;
      }
      json parsed = json::parse(message->bytes);
      if (parsed["type"] == type && holds(parsed)) return parsed;
    }
    return {};
  }
  json wait_for(const std::string& type) {
    return wait_for(type, [](const json&) { return true; });
  }
  bool draws = true;
  int frames = 0;
  std::string layer;  ///< layer of the last frame

 private:
  static std::uint16_t port_of(const std::string& address) {
    const std::size_t colon = address.rfind(':');
    return static_cast<std::uint16_t>(std::stoi(address.substr(colon + 1)));
  }
  void take_frame(const std::string& bytes) {
    ASSERT_EQ(bytes.substr(0, 4), "AJF1");
    std::uint32_t number = 0;
    std::memcpy(&number, bytes.data() + 4, 4);
    layer = bytes.substr(28, static_cast<unsigned char>(bytes[27]));
    ++frames;
    if (draws) send({{"type", "ack"}, {"frame", number}});
  }

  WebClient client_;
};

class ViewerTest : public ::testing::Test {
 protected:
  void begin(const std::string& scene, const std::string& integrator) {
    ViewerOptions options;
    options.scene = scene;
    options.spec.integrator = integrator;
    options.spec.resolution = {48, 40};
    options.spec.max_depth = 5;
    options.folder = folder_.path();
    viewer_ = std::make_unique<Viewer>(std::move(options));
  }

  TemporaryFolder folder_;
  std::unique_ptr<Viewer> viewer_;
};

TEST_F(ViewerTest, ShowsAConvergingPicture) {
  begin("builtin:cornell", "selective");
  ByHand page(viewer_->address());
  const json welcome = page.wait_for("welcome");
  EXPECT_EQ(welcome["scene"], "builtin:cornell");
  EXPECT_FALSE(welcome["objects"].empty());
  EXPECT_FALSE(welcome["parts"]["materials"].empty());
  // A preparation's look has no other layers.
  const json state = page.wait_for("state", [&](const json& now) {
    const json& layers = now["layers"];
    return page.frames > 1 && std::find(layers.begin(), layers.end(), "object-id") != layers.end();
  });
  EXPECT_EQ(state["width"], 48);
  EXPECT_EQ(state["phase"], "rendering");
  page.send({{"type", "inspect"}, {"x", 24}, {"y", 38}});
  const json pixel = page.wait_for("pixel");
  EXPECT_EQ(pixel["object"]["name"], welcome["objects"][pixel["object"]["number"].get<int>() - 1]);
  EXPECT_EQ(pixel["values"][""].size(), 3U);
  page.send({{"type", "layer"}, {"name", "depth"}});
  page.wait_for("state", [&](const json&) { return page.layer == "depth"; });
  EXPECT_EQ(page.layer, "depth");
}

TEST_F(ViewerTest, TwoPagesSeeWhatOneChanges) {
  begin("builtin:cornell", "pt");
  ByHand one(viewer_->address());
  ByHand other(viewer_->address());
  one.wait_for("welcome");
  other.wait_for("welcome");
  one.send({{"type", "method"}, {"integrator", "bdpt"}, {"parameters", json::object()}});
  EXPECT_EQ(other.wait_for("state", [](const json& now) { return now["integrator"] == "bdpt"; })
                .value("can_undo", false),
            true);
  other.send({{"type", "undo"}});
  EXPECT_FALSE(
      one.wait_for("state", [](const json& now) { return now["integrator"] == "pt"; }).is_null());
}

TEST_F(ViewerTest, APageThatDoesNotDrawGetsOneFrame) {
  begin("builtin:cornell", "pt");
  ByHand page(viewer_->address());
  page.draws = false;
  ASSERT_FALSE(page.wait_for("welcome").is_null());
  const auto has_samples = [](const json& now) { return now["samples"].get<double>() >= 256; };
  // Another draws what there is, so there are pictures.
  ByHand other(viewer_->address());
  std::thread drawing([&] { other.wait_for("state", has_samples); });
  page.wait_for("state", has_samples);
  drawing.join();
  EXPECT_EQ(page.frames, 1);
  EXPECT_GT(other.frames, 2);
}

TEST_F(ViewerTest, RefusesNonsenseAndGoesOn) {
  begin("builtin:cornell", "selective");
  ByHand page(viewer_->address());
  page.wait_for("welcome");
  for (const char* nonsense : {"", "{", "[]", R"({"type":"dance"})", R"({"type":"ack"})",
                               R"({"type":"inspect","x":-1,"y":0})", R"({"type":"layer"})",
                               R"({"type":"save","format":"../../x"})"}) {
    page.send(json());  // not an object either
    page.send_binary(nonsense);
  }
  EXPECT_EQ(page.wait_for("note", [](const json& note) { return note["level"] == "warning"; })
                .value("level", ""),
            "warning");
  page.send({{"type", "save"}, {"format", "../../x"}});
  EXPECT_TRUE(page.wait_for("saved").contains("error"));
  page.send({{"type", "inspect"}, {"x", 1}, {"y", 1}});
  EXPECT_FALSE(page.wait_for("pixel").is_null());
}

TEST_F(ViewerTest, SavesWhatARenderWrites) {
  begin("builtin:cornell", "pt");
  ByHand page(viewer_->address());
  page.wait_for("welcome");
  page.send({{"type", "stop-at"}, {"samples", 4}});
  const json state =
      page.wait_for("state", [](const json& now) { return now["phase"] == "paused"; });
  page.send({{"type", "save"}, {"format", "exr"}});
  const json saved = page.wait_for("saved");
  ASSERT_TRUE(saved.contains("path")) << saved;
  const Picture picture = read_picture(saved["path"].get<std::string>());

  RenderRequest request;
  request.scene = "builtin:cornell";
  request.spec.integrator = "pt";
  request.spec.resolution = {48, 40};
  request.spec.max_depth = 5;
  request.spec.samples_per_pixel = static_cast<std::uint64_t>(state["samples"].get<double>());
  Render render(std::move(request));
  EXPECT_EQ(picture.layers.front().pixels, render.run().picture->layers.front().pixels);
}

TEST_F(ViewerTest, PaintedRegionsMustFit) {
  begin("builtin:cornell", "selective");
  ByHand page(viewer_->address());
  page.wait_for("welcome");
  page.send_binary(std::string("AJM1\2\0\0\0\1\0\0\0\xff\x07", 14));
  EXPECT_NE(page.wait_for("note", [](const json& note) { return note["level"] == "warning"; })
                .value("text", "")
                .find("as large"),
            std::string::npos);
  std::string mask("AJM1\x30\0\0\0\x28\0\0\0", 12);
  mask.append(48 * 40, '\x7f');
  page.send_binary(mask);
  EXPECT_FALSE(page.wait_for("state",
                             [](const json& now) {
                               return now["masked"] == true && now["phase"] == "rendering" &&
                                      now["samples"].get<double>() > 0.0;
                             })
                   .is_null());
}

TEST_F(ViewerTest, ShowsTheDenoisedPicture) {
  begin("builtin:cornell", "pt");
  ByHand page(viewer_->address());
  page.wait_for("welcome");
  page.send({{"type", "layer"}, {"name", "denoised"}});
  page.wait_for("state", [&](const json&) { return page.layer == "denoised"; });
  EXPECT_EQ(page.layer, "denoised");
}

TEST_F(ViewerTest, LooksAtAFinishedPicture) {
  Picture picture;
  picture.resolution = {2, 1};
  picture.crop = Box2i(Vec2i(0, 0), Vec2i(1, 0));
  picture.layers = {{"", 3, {1, 2, 3, 4, 5, 6}}, {"depth", 1, {7, 8}}};
  ViewerOptions options;
  options.scene = "room.exr";
  options.picture = std::make_shared<const Picture>(picture);
  viewer_ = std::make_unique<Viewer>(std::move(options));
  ByHand page(viewer_->address());
  EXPECT_EQ(page.wait_for("welcome")["layers"][1]["name"], "depth");
  page.send({{"type", "inspect"}, {"x", 1}, {"y", 0}});
  EXPECT_EQ(page.wait_for("pixel")["values"][""], json::array({4, 5, 6}));
  page.send({{"type", "pause"}});
  EXPECT_EQ(page.wait_for("note")["level"], "warning");
}

}  // namespace
}  // namespace ajar::viewer
