#include "measuring/reference_store.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "core/error.h"

namespace ajar::bench {
namespace {

class ReferenceStoreTest : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() /
              ("ajar-reference-store-" + std::to_string(getpid())) / "new";
    key_ = {"room", {2, 1}, 8, "box", "bdpt:heuristic=balance", 0x1234};
  }
  void TearDown() override { std::filesystem::remove_all(folder_.parent_path()); }

  std::filesystem::path folder_;
  ReferenceKey key_;
  const ReferencePart part_{
      {1.F, 2.F, 3.F, 4.F, 5.F, 6.F}, {.1F, .2F, .3F, .4F, .5F, .6F}, 12, 3.5};
};

TEST_F(ReferenceStoreTest, BeginsEmpty) {
  const ReferenceStore store(folder_, key_);
  EXPECT_EQ(store.count(), 0U);
  EXPECT_TRUE(store.load().empty());
}

TEST_F(ReferenceStoreTest, KeepsWhatIsAdded) {
  ReferenceStore(folder_, key_).add(part_);
  ReferencePart other = part_;
  other.samples = 20;
  ReferenceStore(folder_, key_).add(other);
  const std::vector<ReferencePart> parts = ReferenceStore(folder_, key_).load();
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].picture, part_.picture);
  EXPECT_EQ(parts[0].standard_error, part_.standard_error);
  EXPECT_EQ(parts[0].samples, 12U);
  EXPECT_EQ(parts[0].cpu_seconds, 3.5);
  EXPECT_EQ(parts[1].samples, 20U);
}

TEST_F(ReferenceStoreTest, KeepsReferencesApart) {
  ReferenceStore(folder_, key_).add(part_);
  const auto changed = [this](auto change) {
    ReferenceKey key = key_;
    change(key);
    return ReferenceStore(folder_, key).count();
  };
  EXPECT_EQ(changed([](ReferenceKey&) {}), 1U);
  EXPECT_EQ(changed([](ReferenceKey& key) { key.scene = "hall"; }), 0U);
  EXPECT_EQ(changed([](ReferenceKey& key) { key.resolution = {1, 2}; }), 0U);
  EXPECT_EQ(changed([](ReferenceKey& key) { key.depth = 9; }), 0U);
  EXPECT_EQ(changed([](ReferenceKey& key) { key.filter = "scene"; }), 0U);
  EXPECT_EQ(changed([](ReferenceKey& key) { key.variant = "pt"; }), 0U);
  EXPECT_EQ(changed([](ReferenceKey& key) { key.scene_hash = 1; }), 0U);
}

TEST_F(ReferenceStoreTest, DamagedFilesAreNamed) {
  ReferenceStore(folder_, key_).add(part_);
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    if (entry.path().extension() == ".json") std::ofstream(entry.path()) << "{";
  }
  EXPECT_THROW(ReferenceStore(folder_, key_).load(), IoError);
}

}  // namespace
}  // namespace ajar::bench
