#include "import/common/file_access.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/error.h"
#include "import/testing/temporary_folder.h"

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

TEST(FileAccess, RefusesLinksThatLeadOutOfTheFolder) {
  namespace fs = std::filesystem;
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "scene/sub");
  fs::create_directory(folder.path() / "other");
  for (const char* file : {"other/secret", "scene/sub/a.png"}) {
    std::ofstream(folder.path() / file) << "text";
  }
  fs::create_symlink("../other/secret", folder.path() / "scene/out");
  fs::create_directory_symlink("../other", folder.path() / "scene/away");
  fs::create_symlink("sub/a.png", folder.path() / "scene/in");
  fs::create_directory_symlink("scene", folder.path() / "by-link");
  for (const char* base : {"scene", "by-link", "scene/"}) {
    FileAccess files((folder.path() / base).string(), {});
    for (const char* name : {"in", "sub/a.png"}) {
      EXPECT_EQ(files.load(files.resolve_inside(name)).view(), "text") << base << " " << name;
    }
    for (const char* name : {"out", "away/secret", "away/none"}) {
      EXPECT_THROW(files.resolve_inside(name), IoError) << base << " " << name;
    }
    EXPECT_NO_THROW(files.resolve_inside("sub/none.png")) << "it is missed later";
    EXPECT_EQ(files.load(files.resolve("out")).view(), "text") << "formats that name any file";
  }
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
