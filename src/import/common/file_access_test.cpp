#include "import/common/file_access.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace ajar {
namespace {

TEST(FileAccess, ResolvesNamesFromTheFolderOfTheScene) {
  FileAccess files("/scenes/room", {});
  EXPECT_EQ(files.resolve("../oak.png"), "/scenes/oak.png");
  EXPECT_EQ(files.resolve_inside("wood/../oak.png"), "/scenes/room/oak.png");
  EXPECT_EQ(files.named(), (std::set<std::string>{"/scenes/oak.png", "/scenes/room/oak.png"}));
}

TEST(FileAccess, RefusesNamesThatLeadOutOfTheFolder) {
  FileAccess files("/scenes/room", {});
  for (const char* name : {"../a", "a/../../b", "..", "/etc/passwd", "/scenes/room/a"}) {
    EXPECT_THROW(files.resolve_inside(name), IoError) << name;
  }
  EXPECT_TRUE(files.named().empty());
}

TEST(FileAccess, AsksTheProviderBeforeTheDisk) {
  FileAccess files("builtin:a", [](const std::string& path) -> std::optional<std::string_view> {
    if (path == "builtin:a/b") return "text";
    return std::nullopt;
  });
  const std::string path = files.resolve_inside("b");
  EXPECT_EQ(files.load(path).view(), "text");
  EXPECT_TRUE(files.named().empty()) << "it is not on the disk";
}

}  // namespace
}  // namespace ajar
