#include "integrator/selective/selective_settings.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/error.h"
#include "integrator/regions/crop_weights.h"
#include "integrator/selective/heuristics.h"
#include "os/file_extension.h"
#include "os/regular_file.h"

namespace ajar {

namespace {

bool is_image(const std::string& path) {
  constexpr std::array kExtensions = {".exr", ".png", ".jpg", ".jpeg",
                                      ".pfm", ".hdr", ".tif", ".tiff"};
  const std::string extension = file_extension(path);
  return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

std::string read_text(const std::string& path) {
  try {
    const FileBytes file = read_file(path);
    std::string text(file.view());
    if (text.find('\0') == std::string::npos) return text;
  } catch (const IoError& error) {
    throw IoError(std::string("regions: ") + error.what());
  }
  throw IoError("regions: " + path +
                " is neither an image (.exr, .png, .jpg, .pfm, .hdr, .tif) nor a text file");
}

}  // namespace

std::vector<ParameterSpec> SelectiveSettings::parameters() {
  std::vector<ParameterSpec> specs = {
      choice_parameter(
          "division", {"regions", "everywhere"},
          "how the light is divided: path by path and by regions of the picture, as a "
          "pilot finds; or alike everywhere, which leaves all that follows from regions "
          "out (presets mmlt+ and pssmlt+)"),
      choice_parameter("chain", {"auto", "mmlt", "pssmlt", "mlt", "erpt"},
                       "the Markov chains: mmlt, of one path; pssmlt, of one camera and light "
                       "subpath; mlt, of explicit paths; erpt: those of mlt, begun anew again and "
                       "again by what ordinary Monte Carlo has found since; auto: mlt for paths "
                       "that no connection makes (a lamp seen by way of glass, a matte surface "
                       "and glass), mmlt for the others"),
      choice_parameter("preset", {"none", "published", "lambertian-out", "mmlt+", "pssmlt+"},
                       "published: everything as in the paper; lambertian-out: no chains where "
                       "the material is matte (for omc=lt); mmlt+ and pssmlt+: division=everywhere "
                       "with these chains")};
  std::vector<ParameterSpec> of_regions = {
      choice_parameter(
          "objective", {"filtered", "raw"},
          "which picture is to have the least error: the one that a filter makes, to which clumps "
          "of chains do more harm than noise, or the one that is rendered"),
      {.name = "omc",
       .type = ParameterType::Text,
       .default_value = kOpen,
       .unit = "",
       .help =
           "techniques of ordinary Monte Carlo. Like those of the chains (techniques): light is "
           "divided path by path; others: by regions alone. auto: those of the chains; if they are "
           "not given either, ibpt or bdpt, as a pilot finds",
       .choices = {}},
      choice_parameter(
          "map", {"optimal", "binary"},
          "how the pilot decides about regions: for least predicted error, or as published "
          "(Frolov)"),
      choice_parameter(
          "choice", {"mix", "exclusive"},
          "whether chains share the light of a pixel with ordinary Monte Carlo or make all or "
          "nothing of it"),
      choice_parameter(
          "pilot", {"cross", "discard", "keep"},
          "samples that the map is made from: cross: they stay, and either half of the "
          "replicates has the map of the other (needs 4 replicates, else discard); discard; "
          "keep: biased, as published"),
      {.name = "pilot-samples",
       .type = ParameterType::Int,
       .default_value = "0",
       .unit = "samples",
       .help = "of the pilot, per pixel; 0: 4 for map=optimal, up to 16 of a small picture; 16 for "
               "map=binary",
       .choices = {},
       .minimum = 0,
       .maximum = 4096}};
  of_regions.push_back(number_parameter(
      "threshold", "0.5", "binary: noise from which on a region has chains (T)", 1.0));
  of_regions.push_back(number_parameter(
      "epsilon", "0.1", "binary: what chains make of the other regions' light (ε)", 1.0));
  of_regions.push_back({.name = "window",
                        .type = ParameterType::Int,
                        .default_value = "3",
                        .unit = "pixels",
                        .help = "window of the noise: 3 or 5",
                        .choices = {},
                        .minimum = 3,
                        .maximum = 5});
  of_regions.push_back(choice_parameter(
      "samples", {"adaptive", "uniform"},
      "camera samples of ordinary Monte Carlo: more where replicates show more noise, as many as a "
      "picture's samples per pixel on average; or the same everywhere"));
  of_regions.push_back(choice_parameter(
      "roulette", {"efficient", "usual"},
      "Russian roulette of ordinary Monte Carlo: rays that will bring little for their price, as "
      "pilot and render find it, are traced by chance only; or by throughput alone, as in ibpt and "
      "bdpt"));
  of_regions.push_back(
      {.name = "regions",
       .type = ParameterType::Text,
       .default_value = "",
       .unit = "",
       .help = "what the user decides: a text file of rules (object or material, name, "
               "auto|omc|chain|weight), or an image of the chains' share of each pixel",
       .choices = {}});
  of_regions.push_back(
      choice_parameter("edges", {"none", "antialias"},
                       "smooth the stairs that the map leaves at the edges of objects, in .png "
                       "and .jpg"));
  for (ParameterSpec& spec : of_regions) {
    spec.depends_on = "division";
    spec.matters_for = {"regions"};
    specs.push_back(std::move(spec));
  }
  return specs;
}

std::map<std::string, std::string> SelectiveSettings::apply_preset(
    std::map<std::string, std::string> given) {
  const auto value_of = [&](const std::string& name) {
    const auto value = given.find(name);
    return value == given.end() ? std::string() : value->second;
  };
  const std::string preset = value_of("preset");
  std::map<std::string, std::string> values;
  if (preset == "published") {
    values = {{"omc", "ibpt"},        {"map", "binary"},         {"pilot", "keep"},
              {"split", "0"},         {"importance", "uniform"}, {"mutation", "kelemen"},
              {"samples", "uniform"}, {"roulette", "usual"}};
    // How numbers move, of which chains of explicit paths have none.
    if (value_of("chain") == "mlt") values.erase("mutation");
  } else if (preset.ends_with("+")) {
    values = {{"division", "everywhere"}, {"chain", preset.substr(0, preset.size() - 1)}};
  }
  // As in the method of that name: chains that soon end need not reach all paths.
  if (value_of("chain") == "erpt") values["bidirectional"] = "0";
  given.insert(values.begin(), values.end());
  return given;
}

SelectiveSettings SelectiveSettings::read(const Parameters& parameters,
                                          const RenderSettings& settings) {
  SelectiveSettings result;
  if (parameters.get_text("objective") == "raw") result.objective = Objective::Raw;
  if (parameters.get_text("map") == "binary") result.map = Map::Binary;
  const std::string& pilot = parameters.get_text("pilot");
  result.pilot = pilot == "keep" && settings.replicates > 1 ? PilotUse::Keep
                 : pilot == "discard"                       ? PilotUse::Discard
                                                            : pilot_use_of(settings.replicates);
  result.pilot_samples = static_cast<std::uint64_t>(parameters.get_int("pilot-samples"));
  if (result.pilot_samples == 0 && result.map == Map::Binary) {
    result.pilot_samples = SelectiveHeuristics::kPilotSamplesOfBinary;
  }
  result.binary = {parameters.get_int("window"),
                   static_cast<float>(parameters.get_float("threshold")),
                   static_cast<float>(parameters.get_float("epsilon"))};
  if (result.binary.window == 4) throw UsageError("window: 3 or 5 pixels, not 4");
  result.adaptive = parameters.get_text("samples") == "adaptive";
  result.efficient_roulette = parameters.get_text("roulette") == "efficient";
  result.exclusive = parameters.get_text("choice") == "exclusive";
  result.diffuse_out = parameters.get_text("preset") == "lambertian-out";
  result.antialias = parameters.get_text("edges") == "antialias";
  const bool chains_are_open = parameters.get_text("techniques") == kOpen;
  const bool omc_is_open = parameters.get_text("omc") == kOpen;
  const bool spreads = parameters.get_text("chain") == "erpt";
  const std::string& techniques = result.techniques;
  result.techniques = !chains_are_open          ? parameters.get_text("techniques")
                      : spreads && !omc_is_open ? parameters.get_text("omc")
                                                : "bdpt";
  result.omc = omc_is_open ? techniques : parameters.get_text("omc");
  result.chooses_omc = omc_is_open && chains_are_open;
  result.omc_shares = TechniqueSet::parse(result.omc) == TechniqueSet::parse(techniques);
  const std::string& regions = parameters.get_text("regions");
  if (is_image(regions)) {
    result.painted = read_crop_weights("regions", regions, settings);
    for (float& weight : result.painted) {
      // White is 1 but for rounding. Written so that NaN fails.
      if (!(weight >= 0.F && weight <= 1.00001F)) {
        throw UsageError("regions: a pixel of " + regions + " is not between 0 and 1");
      }
      weight = std::min(weight, 1.F);
    }
  } else if (!regions.empty()) {
    result.rules = parse_region_rules(read_text(regions), regions);
  }
  return result;
}

}  // namespace ajar
