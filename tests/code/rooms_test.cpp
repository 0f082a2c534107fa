#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

/// Rooms are walls: allowed includes, as docs/develop/architecture.md has them, and the names of
/// formats of scene files.
namespace ajar {
namespace {

namespace fs = std::filesystem;

/// Rooms, wings of `integrator/`, and their allowed dependencies.
const std::map<std::string, std::set<std::string>>& rooms() {
  static const std::map<std::string, std::set<std::string>> kRooms = [] {
    std::map<std::string, std::set<std::string>> may{
        {"core", {}},
        {"os", {"core"}},
        {"color", {"core"}},
        {"imageio", {"core", "os"}},
        {"scene/desc", {"core"}},
        {"scene", {"core", "os", "color", "imageio", "scene/desc"}},
        {"import", {"core", "os", "color", "imageio", "scene/desc"}},
        {"image", {"core", "color"}},
        {"post", {"core", "os", "color", "imageio", "image"}},
        {"transport", {"core", "scene", "scene/desc"}},
    };
    const auto add = [&](const std::string& room, const std::string& above,
                         std::set<std::string> others) {
      others.merge(std::set<std::string>(may.at(above)));
      others.insert(above);
      may[room] = std::move(others);
    };
    add("path", "transport", {});
    // Numbers and their sources are all that chains of numbers need of transport.
    add("mcmc", "transport", {});
    add("mcmc/path_space", "path", {"mcmc"});
    add("integrator", "mcmc/path_space", {"color", "image"});
    add("integrator/montecarlo", "integrator", {});
    add("integrator/metropolis", "integrator/montecarlo", {});
    // Regions and weights that users give come from files.
    add("integrator/regions", "integrator/montecarlo", {"os", "color", "imageio"});
    for (const char* wing : {"integrator/masked", "integrator/selective"}) {
      add(wing, "integrator/metropolis", {"os", "color", "imageio", "integrator/regions"});
    }
    add("session", "integrator/selective", {"import", "post"});
    add("api", "session", {});
    may["study/report"] = {"core", "os", "color", "imageio", "image", "post"};
    may["study"] = {"core", "os", "color", "imageio", "image", "post", "session", "study/report"};
    add("api/c", "api", {"api", "study", "study/report"});
    add("apps", "session", {"study", "study/report"});
    add("apps/shared", "apps", {"apps"});
    return may;
  }();
  return kRooms;
}

/// The innermost room that a file of `src/` is in.
std::string room_of(const std::string& file) {
  std::string room;
  for (const auto& [name, may] : rooms()) {
    if (file.starts_with(name + "/") && name.size() > room.size()) room = name;
  }
  return room;
}

/// Tests, and their support code, may include more.
bool is_for_tests(const std::string& file) {
  return file.ends_with("_test.cpp") || file.find("test_support") != std::string::npos ||
         file.find("/testing/") != std::string::npos;
}

/// The list of methods is the entry for others.
bool is_exception(const std::string& file) { return file == "integrator/registry.cpp"; }

TEST(Rooms, IncludeOnlyAllowedRooms) {
  const fs::path src = fs::path(AJAR_SOURCE_DIR) / "src";
  const std::regex include("^#include \"([^\"]+)\"");
  std::size_t includes = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(src)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".h" && extension != ".cpp") continue;
    const std::string file = fs::relative(entry.path(), src).generic_string();
    const std::string room = room_of(file);
    ASSERT_NE(room, "") << file << " is in no room";
    if (is_for_tests(file)) continue;
    std::ifstream text(entry.path());
    int number = 0;
    for (std::string line; std::getline(text, line);) {
      ++number;
      std::smatch match;
      if (!std::regex_search(line, match, include)) continue;
      const std::string included = match[1];
      const std::string other = room_of(included);
      if (other.empty() || other == room || is_exception(file)) continue;
      ++includes;
      EXPECT_TRUE(rooms().at(room).contains(other))
          << file << ":" << number << ": " << room << " may not use " << other << " (" << included
          << ")";
    }
  }
  EXPECT_GT(includes, 0U) << "no include was read";
}

/// Comments count, too: a reference to a fitted number is a dependency.
TEST(Rooms, NameTheHeuristicsOnlyOfRoomsTheyMayUse) {
  const fs::path src = fs::path(AJAR_SOURCE_DIR) / "src";
  const std::regex declared(R"(struct (\w+Heuristics) )");
  std::map<std::string, std::string> owners;
  const auto text_of = [](const fs::path& path) {
    std::stringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
  };
  for (const auto& [room, may] : rooms()) {
    const std::string text = text_of(src / room / "heuristics.h");
    std::smatch match;
    if (std::regex_search(text, match, declared)) owners[match[1]] = room;
  }
  EXPECT_GT(owners.size(), 3U);
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(src)) {
    const std::string file = fs::relative(entry.path(), src).generic_string();
    if (entry.is_directory() || is_for_tests(file)) continue;
    const std::string text = text_of(entry.path());
    const std::string room = room_of(file);
    for (const auto& [name, owner] : owners) {
      if (owner == room || rooms().at(room).contains(owner)) continue;
      EXPECT_EQ(text.find(name), std::string::npos) << file << " may not know of " << name;
    }
  }
}

/// A format is its folder: all others learn of it from the registry. Comments may cite sources.
/// Meshes that several formats have beside their scenes are read in import/mesh, and may be named
/// in all of import/.
TEST(Rooms, NameNoFormatOutsideOfItsFolder) {
  const fs::path src = fs::path(AJAR_SOURCE_DIR) / "src";
  std::map<std::string, std::regex> formats;
  for (const fs::directory_entry& folder : fs::directory_iterator(src / "import")) {
    if (!fs::exists(folder.path() / "format.cpp")) continue;
    const std::string name = folder.path().filename().string();
    formats.emplace(name, "(^|[^A-Za-z])" + name + "([^A-Za-z]|$)");
  }
  EXPECT_FALSE(formats.empty());
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(src)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".h" && extension != ".cpp") continue;
    const std::string file = fs::relative(entry.path(), src).generic_string();
    if (is_for_tests(file)) continue;
    std::ifstream text(entry.path());
    int number = 0;
    for (std::string line; std::getline(text, line);) {
      ++number;
      const std::string code = line.substr(0, line.find("//"));
      for (const auto& [format, name] : formats) {
        const bool is_shared_mesh = fs::exists(src / "import" / "mesh" / (format + ".h"));
        if (file.starts_with(is_shared_mesh ? "import/" : "import/" + format + "/")) continue;
        EXPECT_FALSE(std::regex_search(code, name))
            << file << ":" << number << ": names the format " << format;
      }
    }
  }
}

}  // namespace
}  // namespace ajar
