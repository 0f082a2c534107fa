#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

/// Fitted numbers have one place in each room, and say where they come from
/// (docs/develop/style.md, "Constants"). Constants only: a literal in the midst of an expression is
/// for readers to find.
namespace ajar {
namespace {

namespace fs = std::filesystem;

/// Folders whose constants are looked at, with all that is in them.
const std::vector<std::string>& rooms_looked_at() {
  static const std::vector<std::string> kRooms = {"image",          "post",      "scene/light",
                                                  "scene/emission", "transport", "path",
                                                  "mcmc",           "session",   "integrator"};
  return kRooms;
}

const std::vector<std::string>& rooms_with_heuristics() {
  static const std::vector<std::string> kRooms = {"image",
                                                  "post",
                                                  "transport",
                                                  "path",
                                                  "session",
                                                  "mcmc/primary",
                                                  "mcmc/path_space",
                                                  "integrator/montecarlo",
                                                  "integrator/metropolis",
                                                  "integrator/regions",
                                                  "integrator/selective"};
  return kRooms;
}

/// Constants of a file that are numbers, and were not fitted.
struct Unfitted {
  const char* reason;
  std::set<std::string> names;
};

const std::multimap<std::string, Unfitted>& unfitted() {
  static const std::multimap<std::string, Unfitted> kUnfitted = {
      {"image/compare_blocks.cpp", {"limit of a type", {"kLargestZ"}}},
      {"post/density_map.cpp",
       {"drawing",
        {"kOctaves", "kGap", "kBar", "kGlyphWidth", "kGlyphHeight", "kLabelLength", "kShortest"}}},
      {"post/exposure.cpp", {"what displays show", {"kMiddleGrey", "kWhite", "kBlack"}}},
      {"post/exposure.cpp", {"limit of a type", {"kBrightest"}}},
      {"post/exposure.h", {"limit of a parameter", {"kMostStops"}}},
      {"image/film.cpp", {"fixed point", {"kFractionBits", "kContributionLimit"}}},
      {"image/filter.cpp", {"sizes of tables, precision", {"kCells", "kGuides", "kSteps"}}},
      {"image/filter.h", {"limit of a parameter", {"kMaxRadius"}}},
      {"image/channels.h", {"channels", {"kChannels"}}},
      {"image/flip.cpp",
       {"published metric",
        {"kPi", "kColorExponent", "kFeatureExponent", "kColorShare", "kErrorShare", "kFeatureWidth",
         "kAchromatic", "kRedGreen", "kBlueYellow", "kWidest", "kDelta"}}},
      {"image/flip.h", {"published metric", {"kFlipPixelsPerDegree"}}},
      {"image/hdr_flip.cpp", {"published metric", {"kTarget"}}},
      {"image/identities.h", {"votes of a pixel, part of a file's layers", {"kSamples"}}},
      {"image/metrics.h", {"definition of a metric", {"kSmapeEpsilon", "kRelativeMseEpsilon"}}},
      {"integrator/regions/impulse_noise.cpp", {"size of an array", {"kLargestWindow"}}},
      {"integrator/selective/optimal_thresholds.cpp",
       {"end of an iteration that descends", {"kMostRounds"}}},
      {"integrator/selective/brightness_pilot.cpp",
       {"work items of a pilot", {"kBrightnessItems"}}},
      {"transport/efficiency_cells.cpp",
       {"kinds of vertices, and an octree",
        {"kKinds", "kInMedium", "kSpecular", "kChildren", "kLevelsInTable", "kAcross"}}},
      {"transport/efficiency_cells.cpp", {"precision of places", {"kLevels", "kPlaces"}}},
      {"transport/efficiency_cells.cpp", {"fixed point", {"kMostLight", "kSquareQuanta"}}},
      {"integrator/regions/region_rules.cpp", {"length of a message", {"kMostNamesShown"}}},
      {"image/relative_error.h", {"scales that statistics have", {"kErrorScales"}}},
      {"image/ssim.cpp",
       {"published metric",
        {"kRadius", "kSigma", "kMeanConstant", "kVarianceConstant", "kWindow"}}},
      {"image/smoothed_reference.cpp", {"limit of a type", {"kMost"}}},
      {"post/denoise/builtin_denoiser.cpp",
       {"rounding, memory", {"kBlackest", "kDark", "kPlanes"}}},
      {"post/denoise/local_regression.cpp",
       {"lanes of a processor, sizes of arrays, rounding",
        {"kWidth", "kHeight", "kMostSlopes", "kLevels", "kLeastVariance", "kSide", "kScale"}}},
      {"post/denoise/oidn_denoiser.cpp",
       {"default of the library, and what it takes",
        {"kMostMemory", "kBytesPerPixel", "kBrightest", "kDimmest", "kMost"}}},
      {"post/denoise/oidn_library.h",
       {"enumerations of the library",
        {"kCpu", "kFloat3", "kFast", "kBalanced", "kHigh", "kNoError", "kCancelled"}}},
      {"scene/emission/area.cpp", {"precision of an estimate", {"kPoints", "kLeast"}}},
      {"scene/light/aim.h",
       {"bound of a variance, beside it is what half and double do", {"kAimed"}}},
      {"scene/light/aim.h",
       {"rounding; an angle, beside it is why", {"kNarrowest", "kRounding", "kSine60"}}},
      {"scene/light/bounding_disk.h", {"rounding", {"kRounding"}}},
      {"scene/light/light_sampler.h",
       {"bound of a variance, beside it is what half and double do", {"kByPower"}}},
      {"scene/light/light_tree.cpp",
       {"derived, beside it is how; rounding; marks no node",
        {"kSoftening", "kRounding", "kNone"}}},
      {"scene/light/light_tree.cpp",
       {"how a tree is cut, and how deep trails can say", {"kBins", "kBalancedDepth"}}},
      {"scene/light/light_tree.h",
       {"lanes of a processor, bits of a word", {"kWidth", "kLeaf", "kTwoSided", "kTrailBits"}}},
      {"scene/light/map.cpp", {"limit of a parameter, of a type", {"kMaxSide", "kLargest"}}},
      {"scene/light/map.h", {"precision of an estimate", {"kLeastPoints"}}},
      {"scene/light/spot_light.cpp", {"precision of an integral", {"kSteps"}}},
      {"scene/light/sky_light.cpp", {"precision of a table", {"kWidth", "kHeight"}}},
      {"transport/path_sampler.h",
       {"limit of a parameter, size of an array", {"kMaxLightSubpaths"}}},
      {"transport/segment.cpp", {"end of what rounding could repeat for ever", {"kMaxInterfaces"}}},
      {"transport/segment.h", {"all lanes alike", {"kAnyLane"}}},
      {"transport/technique_set.h", {"marks a rule", {"kAny"}}},
      {"transport/technique_set.h", {"limit of a parameter", {"kMaxNextEventCount"}}},
      {"path/verify.cpp", {"rounding", {"kDirection", "kOnFilm", "kRelative"}}},
      {"session/checkpoint/checkpoint.cpp", {"number of a format", {"kCheckpointFormat"}}},
      {"session/checkpoint/checkpoint_check.cpp",
       {"limit of a parameter, of a type", {"kMostEdges", "kLargestMagnitude"}}},
      {"session/options/filter_option.cpp", {"limit of a parameter", {"kRadius"}}},
      {"integrator/integrator.h", {"limit of a parameter", {"kMostUncounted"}}},
      {"session/output/final_files.cpp",
       {"patience of whoever waits for room", {"kSecondsUntilRetry", "kSecondsBetweenWords"}}},
      {"session/job/interrupts.cpp", {"exit code", {"kExitInterrupted"}}},
      {"session/options/limits.h",
       {"limit of a parameter",
        {"kMaxResolution", "kResolution", "kCropEdge", "kScale", "kSamples", "kSeconds",
         "kRelativeError", "kDepth", "kThreads", "kPixelsPerDegree"}}},
      {"session/render/memory_estimate.cpp", {"counted in the program", {"kPictureCopies"}}},
      {"session/options/option_values.h", {"limit of a parameter", {"kMostShares"}}},
      {"session/options/render_options.h",
       {"flags", {"kRender", "kResume", "kMerge", "kDenoise", "kView", "kScene"}}},
      {"integrator/integrator.h", {"flag", {"kPerReplicate"}}},
      {"session/output/picture_filter.cpp",
       {"counted in the program", {"kPictures", "kReplicates", "kFilterings"}}},
      {"session/output/picture_filter.cpp",
       {"sizes of what is measured", {"kLeastSide", "kCorner"}}},
      {"session/output/picture_range.cpp", {"limit of a type", {"kDimmestMean", "kMakesLarge"}}},
      {"session/preview/preview.cpp", {"size of a message", {"kRegionSize"}}},
      {"session/preview/tcp_stream.cpp",
       {"patience with a network", {"kPollMilliseconds", "kConnectPolls", "kDrainedAtOnce"}}},
      {"session/preview/tev_packets.cpp",
       {"numbers of a protocol", {"kCreateImage", "kUpdateImage"}}},
      {"session/render/resolved_render.h",
       {"defaults of parameters", {"kDefaultSamples", "kReplicates"}}},
      {"mcmc/path_space/inverse_probability.h", {"precision of a type", {"kNegligible"}}},
      {"mcmc/path_space/manifold_connection.cpp", {"rounding", {"kRounding"}}},
      {"mcmc/path_space/specular_photons.cpp", {"bits of an integer", {"kLevels", "kCells"}}},
      {"mcmc/path_space/perturbation_law.h", {"rounding", {"kRounding"}}},
      {"mcmc/primary/chain_numbers.h", {"streams", {"kStreams"}}},
      {"mcmc/primary/chain_source.h", {"index", {"kRasterBlock"}}},
      {"mcmc/primary/gaussian_mutation.cpp", {"the same as uniform beyond", {"kWidest"}}},
      {"mcmc/primary/gaussian_mutation.cpp", {"lanes of a processor", {"kPairs"}}},
      {"mcmc/primary/kelemen_mutation.cpp", {"lanes of a processor", {"kLanes"}}},
      {"mcmc/primary/plane_moves.h", {"neighbours of a pixel", {"kNeighbours"}}},
      {"mcmc/primary/several_tries.cpp", {"names randomness", {"kFirst"}}},
      {"mcmc/primary/step_kind.h", {"unit of integers", {"kStepUnits"}}},
      {"mcmc/primary/step_sizes.h", {"what the grid can add", {"kLargest"}}},
      {"integrator/division.h", {"definition of direct light", {"kDirectDepth"}}},
      {"integrator/sample_block.h", {"size of an item", {"kSamplesPerBlock"}}},
      {"integrator/technique_shares.h", {"size of an array", {"kMaxVertices"}}},
      {"integrator/montecarlo/blind_spots.cpp",
       {"edges of paths that are named", {"kSeenMirror", "kCaustic"}}},
      {"integrator/montecarlo/path_family.cpp", {"size of an item", {"kTileSize"}}},
      {"integrator/montecarlo/path_family.cpp", {"limit of a type", {"kMaxPathEdges"}}},
      {"integrator/montecarlo/technique_layers.h", {"names of layers", {"kMaxDepth"}}},
      {"integrator/metropolis/path_target.cpp", {"rounding", {"kEnd"}}},
      {"integrator/selective/chain_check.cpp", {"limit of a type", {"kMostSamples"}}},
      {"integrator/selective/sample_allocation.cpp", {"rounding", {"kRounding"}}},
      {"integrator/selective/preparation.cpp", {"rounding", {"kRounding"}}},
      {"integrator/selective/preparation.h", {"1 over another", {"kMostMutations"}}},
      {"integrator/selective/chain_fraction.cpp", {"statistics that decide nothing", {"kCell"}}},
      {"integrator/selective/config.cpp", {"number of replicates", {"kTwoHalves"}}},
      {"integrator/selective/division_pilot.cpp", {"number of replicates", {"kReplicates"}}},
      {"integrator/selective/technique_pilot.cpp", {"number of items", {"kTrialItems"}}},
  };
  return kUnfitted;
}

std::string text_of(const fs::path& path) {
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// Constants of a source text that begin with a number.
std::vector<std::string> number_constants(const std::string& text) {
  static const std::regex kConstant(
      R"(\bconstexpr\s[^=;(){}]*?\b(k[A-Z]\w*)\s*(?:=\s*\{*|\{+)\s*[-+]?\.?\d)");
  std::vector<std::string> names;
  for (std::sregex_iterator match(text.begin(), text.end(), kConstant), end; match != end;
       ++match) {
    names.push_back((*match)[1]);
  }
  return names;
}

fs::path source_folder() { return fs::path(AJAR_SOURCE_DIR) / "src"; }

/// Files of a room that programs are made of, beside its heuristics.h; those in its folders, too.
std::vector<fs::path> files_of(const std::string& room) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry :
       fs::recursive_directory_iterator(source_folder() / room)) {
    const std::string name = entry.path().filename().string();
    const bool is_of_tests = name.ends_with("_test.cpp") ||
                             name.find("test_support") != std::string::npos ||
                             entry.path().parent_path().filename() == "testing";
    if (name == "heuristics.h" || is_of_tests) continue;
    if (name.ends_with(".h") || name.ends_with(".cpp")) files.push_back(entry.path());
  }
  return files;
}

/// A constant of a heuristics.h, and the comment above it.
struct FittedNumber {
  std::string name;
  std::string comment;
};

std::vector<FittedNumber> heuristics_of(const std::string& text) {
  static const std::regex kDeclared(R"(static constexpr [^=]*?\b(k[A-Z]\w*) =)");
  std::vector<FittedNumber> found;
  std::string comment;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t start = line.find("///");
    if (start != std::string::npos) {
      comment += line.substr(start + 3);
      continue;
    }
    std::smatch match;
    if (std::regex_search(line, match, kDeclared)) found.push_back({match[1], comment});
    comment.clear();
  }
  return found;
}

TEST(Heuristics, FindsConstantsInAnyNotation) {
  EXPECT_EQ(number_constants("constexpr double kA = 0.5;"), std::vector<std::string>{"kA"});
  EXPECT_EQ(number_constants("static constexpr std::array<int, 2>\n  kA = {1, 2};"),
            std::vector<std::string>{"kA"});
  EXPECT_EQ(number_constants("inline constexpr float kA{-.5F};"), std::vector<std::string>{"kA"});
  EXPECT_TRUE(number_constants("constexpr double kA = SelectiveHeuristics::kB;").empty());
  EXPECT_TRUE(number_constants("constexpr int f(int kA) { return 2; }").empty());
  EXPECT_TRUE(number_constants("constexpr Walk kA{.mode = Mode::kB};").empty());
}

TEST(Heuristics, AreInTheirFilesOnly) {
  std::set<std::pair<std::string, std::string>> excused;
  for (const auto& [file, numbers] : unfitted()) {
    for (const std::string& name : numbers.names) excused.emplace(file, name);
  }
  std::set<std::pair<std::string, std::string>> met;
  for (const std::string& room : rooms_looked_at()) {
    for (const fs::path& path : files_of(room)) {
      const std::string file = fs::relative(path, source_folder()).generic_string();
      for (const std::string& name : number_constants(text_of(path))) {
        met.emplace(file, name);
        EXPECT_TRUE(excused.contains({file, name}))
            << file << ": " << name
            << " belongs into the room's heuristics.h if it was fitted, else among the exceptions "
               "here";
      }
    }
  }
  for (const auto& [file, name] : excused) {
    EXPECT_TRUE(met.contains({file, name})) << "no longer there: " << name << " of " << file;
  }
}

TEST(Heuristics, HaveUnitRangeAndSourceAndAreUsed) {
  for (const std::string& room : rooms_with_heuristics()) {
    const std::string text = text_of(source_folder() / room / "heuristics.h");
    std::string uses;
    for (const fs::path& path : files_of(room)) uses += text_of(path);
    const std::vector<FittedNumber> heuristics = heuristics_of(text);
    EXPECT_FALSE(heuristics.empty()) << room;
    for (const FittedNumber& heuristic : heuristics) {
      for (const char* told : {"Unit: ", "Range: ", "Source: "}) {
        EXPECT_NE(heuristic.comment.find(told), std::string::npos)
            << room << ": " << heuristic.name << " does not say its " << told;
      }
      EXPECT_TRUE(std::regex_search(uses, std::regex("Heuristics::" + heuristic.name + "\\b")))
          << room << ": nothing uses " << heuristic.name;
    }
  }
}

}  // namespace
}  // namespace ajar
