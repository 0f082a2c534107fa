#include "import/common/file_access.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/error.h"
#include "import/testing/temporary_folder.h"

namespace ajar {
namespace {

TEST(FileAccess, ResolvesNamesFromTheFolderOfTheScene) {
  Warnings warnings;
  FileAccess files("/scenes/room", {}, warnings);
  EXPECT_EQ(files.resolve("../oak.png"), "/scenes/oak.png");
  EXPECT_EQ(files.resolve_inside("wood/../oak.png"), "/scenes/room/oak.png");
  EXPECT_EQ(files.named(), (std::set<std::string>{"/scenes/oak.png", "/scenes/room/oak.png"}));
}

TEST(FileAccess, RefusesNamesThatLeadOutOfTheFolder) {
  Warnings warnings;
  FileAccess files("/scenes/room", {}, warnings);
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
    Warnings warnings;
    FileAccess files((folder.path() / base).string(), {}, warnings);
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
  Warnings warnings;
  FileAccess files(
      "builtin:a",
      [](const std::string& path) -> std::optional<std::string_view> {
        if (path == "builtin:a/b") return "text";
        return std::nullopt;
      },
      warnings);
  const std::string path = files.resolve_inside("b");
  EXPECT_EQ(files.load(path).view(), "text");
  EXPECT_TRUE(files.named().empty()) << "it is not on the disk";
}

/// A scene's folder with files, whose names are read back.
class NamesOfOtherSystems : public ::testing::Test {
 protected:
  NamesOfOtherSystems() {
    namespace fs = std::filesystem;
    fs::create_directories(folder_.path() / "Scene/Textures/New");
    for (const char* file :
         {"Textures/Wood.PNG", "Textures/New/a.png", "twin", "Twin", "b\\c.png"}) {
      std::ofstream(folder_.path() / "Scene" / file) << file;
    }
    std::ofstream(folder_.path() / "above.png") << "above";
  }
  /// The file that is found; "" if there is none.
  std::string found(const std::string& name) {
    const std::string path = files_.resolve(name, where_);
    return files_.exists(path) ? std::string(files_.load(path).view()) : "";
  }

  TemporaryFolder folder_;
  Warnings warnings_;
  FileAccess files_{(folder_.path() / "Scene").string(), {}, warnings_};
  SourceLocation where_{std::make_shared<const std::string>("room"), 3, 1};
};

TEST_F(NamesOfOtherSystems, AreResolvedWhereOnlyOneFileMatches) {
  EXPECT_EQ(found("Textures\\Wood.PNG"), "Textures/Wood.PNG");
  EXPECT_EQ(found("textures/wood.png"), "Textures/Wood.PNG");
  EXPECT_EQ(found("TEXTURES\\new\\A.PNG"), "Textures/New/a.png");
  EXPECT_EQ(found("textures\new\\a.png"), "Textures/New/a.png") << "a backslash that was an escape";
  EXPECT_EQ(found("..\\above.png"), "above");
  EXPECT_EQ(found((folder_.path() / "scene/textures/wood.png").string()), "Textures/Wood.PNG");
  EXPECT_EQ(warnings_.count(), 6U);
  const Warning first = warnings_.kept().front();
  EXPECT_EQ(first.kind.effect, Effect::None);
  EXPECT_EQ(first.where.to_string(), "room:3:1");
  EXPECT_EQ(files_.named().count((folder_.path() / "Scene/Textures/Wood.PNG").string()), 1U);
}

TEST_F(NamesOfOtherSystems, AreIgnoredWhereTheNameExistsOrSeveralMatch) {
  EXPECT_EQ(found("twin"), "twin");
  EXPECT_EQ(found("Twin"), "Twin");
  EXPECT_EQ(found("TWIN"), "");
  EXPECT_EQ(found("b\\c.png"), "b\\c.png");
  EXPECT_EQ(found("nothing\\there.png"), "");
  EXPECT_EQ(warnings_.count(), 0U);
  files_.resolve("textures/wood.png");
  EXPECT_EQ(warnings_.count(), 0U) << "nobody asked to be told";
}

TEST_F(NamesOfOtherSystems, DoNotLeadOutOfTheFolder) {
  EXPECT_EQ(files_.load(files_.resolve_inside("textures\\wood.png")).view(), "Textures/Wood.PNG");
  for (const char* name : {"..\\above.png", "textures\\..\\..\\above.png", "..\\Above.PNG"}) {
    EXPECT_THROW(files_.resolve_inside(name), IoError) << name;
  }
}

}  // namespace
}  // namespace ajar
