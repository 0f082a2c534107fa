#include "apps/cli/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "apps/cli/commands.h"
#include "core/error.h"
#include "import/format.h"
#include "os/standard_streams.h"
#include "post/denoise/denoiser.h"
#include "session/options/option_values.h"
#include "session/scenes/catalog.h"
#include "session/version.h"
#include "study/metric.h"

namespace ajar::cli {

namespace {

constexpr const char* kSceneHelp = "Scene file, or builtin:NAME (see: ajar list scenes)";

/// Parsed arguments of the program.
struct Request {
  RenderArguments render;
  ResumeArguments resume;
  MergeArguments merge;
  DenoiseArguments denoise;
  InfoArguments info;
  ConvertArguments convert;
  ListArguments list;
  CompareArguments compare;
  StudyArguments study;
};

/// An empty value is most likely a variable of a script that was never set.
const CLI::Validator kNotEmpty(
    [](const std::string& text) {
      return text.empty() ? std::string("needs a value") : text.substr(0, 0);
    },
    "");

/// An option whose value `read(name, text)` makes of a text, raising UsageError in words.
template <typename Value, typename Read>
CLI::Option* add_value(CLI::App* command, const std::string& name, Value& value, Read read,
                       const std::string& help) {
  return command->add_option_function<std::string>(
      name, [&value, name, read](const std::string& text) { value = read(name, text); }, help);
}

std::uint64_t read_samples(const std::string& option, const std::string& text) {
  return parse_whole(option, text, limits::kSamples);
}

int read_threads(const std::string& option, const std::string& text) {
  return parse_whole(option, text, limits::kThreads);
}

double read_scale(const std::string& option, const std::string& text) {
  return parse_number(option, text, "times the scene's own size", limits::kScale);
}

double read_pixels_per_degree(const std::string& option, const std::string& text) {
  return parse_number(option, text, "pixels per degree", limits::kPixelsPerDegree);
}

constexpr const char* kPictures = "Pictures";
constexpr const char* kMethod = "Method";
constexpr const char* kSafety = "Never to lose a render";
constexpr const char* kProgram = "Program";

std::string denoise_help() {
  return fmt::format(
      "Take the noise out of .png and .jpg; .exr keeps both. One of {} (auto: Open Image Denoise "
      "where it is found, else builtin)",
      fmt::join(denoiser_names(), ", "));
}

/// `budget_default`: what holds without a limit.
void add_run(CLI::App* command, RunArguments& a, const std::string& output_default,
             const std::string& budget_default) {
  command
      ->add_option("-o,--output", a.outputs,
                   "Picture to write; may be given several times. The extension decides: .exr "
                   "(scene-linear, all "
                   "layers), .png .jpg (tone-mapped), .pfm .hdr. Default: " +
                       output_default)
      ->allow_extra_args(false)
      ->type_name("FILE")
      ->group(kPictures);
  command->add_option("--tone-map", a.tone_map, "Curve of .png and .jpg: srgb or filmic")
      ->type_name("NAME")
      ->check(kNotEmpty)
      ->group(kPictures);
  add_value(command, "--exposure", a.exposure, parse_exposure,
            "Brighten .png and .jpg by this many stops, or auto: as suits the picture")
      ->type_name("STOPS|auto")
      ->group(kPictures);
  command->add_option("--denoise", a.denoiser, denoise_help() + "; default: auto, or as before")
      ->type_name("HOW")
      ->check(kNotEmpty)
      ->group(kPictures);
  command
      ->add_option("--output-every", a.output_every,
                   "Also write the pictures while rendering, such as every 30s")
      ->type_name("TIME")
      ->check(kNotEmpty)
      ->group(kPictures);

  command
      ->add_option("--preview", a.preview,
                   "Show the picture while it is rendered in a viewer that speaks tev's protocol, "
                   "such as localhost:14158; without one, --output-every keeps a picture to look "
                   "at")
      ->type_name("HOST:PORT")
      ->check(kNotEmpty)
      ->group(kPictures);

  const std::string stop = "When to stop (whichever comes first; default: " + budget_default + ")";
  add_value(command, "--spp", a.spp, read_samples,
            "Samples per pixel (rounded up to equal replicates)")
      ->type_name("N")
      ->group(stop);
  command->add_option("--time", a.time, "Time to render, such as 60s, 2m or 1h30m")
      ->type_name("TIME")
      ->check(kNotEmpty)
      ->group(stop);
  add_value(command, "--target-error", a.target_error, parse_target_error,
            "Estimated relative error of the picture, such as 0.01 or 1%; denoised:1%: of the "
            "denoised picture")
      ->type_name("[denoised:]X")
      ->group(stop);

  command
      ->add_option("--checkpoint", a.checkpoint,
                   "Keep in this file all that is needed to go on (ajar resume FILE)")
      ->type_name("FILE")
      ->check(kNotEmpty)
      ->group(kSafety);
  command->add_option("--checkpoint-every", a.checkpoint_every, "How often to write it")
      ->type_name("TIME")
      ->check(kNotEmpty)
      ->capture_default_str()
      ->group(kSafety);
  command
      ->add_flag(
          "--force", a.force,
          "Go on even if another version of ajar wrote the checkpoint, or the scene has moved")
      ->group(kSafety);

  add_value(command, "--threads", a.threads, read_threads, "Threads to use; 0: all processors")
      ->type_name("N")
      ->default_str("0")
      ->group(kProgram);
  command->add_option("--stats", a.stats, "Write statistics as JSON")
      ->type_name("FILE.json")
      ->check(kNotEmpty)
      ->group(kProgram);
  command->add_option("--progress", a.progress, "auto, plain (lines), json (lines) or none")
      ->type_name("HOW")
      ->capture_default_str()
      ->group(kProgram);
}

void add_scene(CLI::App* command, SceneArguments& a) {
  command->add_option("SCENE", a.scene, kSceneHelp)->required();
  command
      ->add_option("-D,--define", a.definitions,
                   "Give a parameter that the scene leaves open a value ($NAME in scenes of "
                   "Mitsuba); may be given several times")
      ->allow_extra_args(false)
      ->type_name("NAME=VALUE");
}

void add_render(CLI::App& app, RenderArguments& a) {
  CLI::App* command = app.add_subcommand("render", "Render a scene to pictures");
  add_scene(command, a.scene);
  add_run(command, a.run, "SCENE.exr and SCENE.png here", "the scene's samples per pixel");
  command
      ->add_option("--resolution", a.resolution, "Size of the picture in pixels, such as 640x480")
      ->type_name("WxH")
      ->group(kPictures);
  add_value(command, "--scale", a.scale, read_scale,
            "Multiply the scene's own resolution, such as 0.5")
      ->type_name("F")
      ->excludes("--resolution")
      ->group(kPictures);
  command
      ->add_option(
          "--crop", a.crop,
          "Render only this window, from the top left: fractions if all are at most 1, else pixels")
      ->type_name("X0,Y0,X1,Y1")
      ->group(kPictures);
  command
      ->add_option(
          "--filter", a.filter,
          "Filter of the film instead of the scene's: box, triangle, gaussian, mitchell or "
          "sinc, and its radius in pixels")
      ->type_name("NAME[:RADIUS]")
      ->group(kPictures);
  command->add_option("--aov", a.aovs, "Extra layers for .exr files, or all (see: ajar list aovs)")
      ->type_name("LIST")
      ->group(kPictures);

  command->add_option("--integrator", a.integrator, "Rendering method (see: ajar list integrators)")
      ->type_name("NAME")
      ->check(kNotEmpty)
      ->group(kMethod);
  command
      ->add_option("--set", a.assignments,
                   "Set a parameter of the method (see: ajar list integrators NAME); may be given "
                   "several times")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE")
      ->group(kMethod);
  command
      ->add_option(
          "--depth", a.depth,
          "Path lengths in edges: 1 is light seen directly, 2 direct lighting, such as 1:8")
      ->type_name("MIN:MAX")
      ->group(kMethod);
  command->add_option("--seed", a.seed, "Seed of the random numbers")
      ->type_name("N")
      ->capture_default_str()
      ->group(kMethod);
  command
      ->add_option("--resume", a.resume,
                   "Go on with this checkpoint of the same render; begin anew if there is none")
      ->type_name("FILE")
      ->check(kNotEmpty)
      ->group(kSafety);
  command
      ->add_option(
          "--share", a.share,
          "Render only the K-th of N parts of the work, for ajar merge; needs --checkpoint")
      ->type_name("K/N")
      ->check(kNotEmpty)
      ->group(kProgram);
  command->footer(
      fmt::format("Ctrl-C ends the render after the current pass and writes the pictures; SIGUSR1 "
                  "writes them and goes on.\n"
                  "Example: ajar render scene{} --time 2m --scale 0.5 -o scene.exr -o scene.png",
                  formats().front().extensions.front()));
}

void add_resume(CLI::App& app, ResumeArguments& a) {
  CLI::App* command = app.add_subcommand("resume", "Go on with a render from its checkpoint");
  command->add_option("CHECKPOINT", a.checkpoint, "File that --checkpoint wrote")->required();
  add_run(command, a.run, "as before", "as before; if any is given, it replaces all");
  command->add_option("--scene", a.scene, "Where the scene is now, if it has moved")
      ->type_name("SCENE")
      ->check(kNotEmpty)
      ->group(kProgram);
  command->footer(
      "Limits count from the beginning of the render. One that is finished can be extended, or "
      "just "
      "be written to other files.\n"
      "Example: ajar resume room.checkpoint --spp 4096");
}

/// How pictures for the eye are made of what was rendered before.
template <typename Arguments>
void add_display(CLI::App* command, Arguments& a) {
  command->add_option("--tone-map", a.tone_map, "Curve of .png and .jpg: srgb or filmic")
      ->type_name("NAME")
      ->capture_default_str();
  add_value(command, "--exposure", a.exposure, parse_exposure,
            "Brighten .png and .jpg by this many stops, or auto: as suits the picture")
      ->type_name("STOPS|auto")
      ->default_str("0");
  command->add_option("--denoise", a.denoiser, denoise_help())
      ->type_name("HOW")
      ->check(kNotEmpty)
      ->capture_default_str();
}

void add_merge(CLI::App& app, MergeArguments& a) {
  CLI::App* command = app.add_subcommand("merge", "Put checkpoints together to one better picture");
  command->add_option("CHECKPOINT", a.checkpoints, "Renders of one picture: seeds, or all shares")
      ->required();
  command->add_option("-o,--output", a.outputs, "Picture to write; may be given several times")
      ->allow_extra_args(false)
      ->type_name("FILE");
  command->add_option("--checkpoint", a.checkpoint, "Write the whole as a checkpoint, too")
      ->type_name("FILE")
      ->check(kNotEmpty);
  command->add_option("--stats", a.stats, "Write statistics as JSON")
      ->type_name("FILE.json")
      ->check(kNotEmpty);
  add_display(command, a);
  command->add_flag("--force", a.force, "Merge what other versions of ajar have written, too");
  command->footer("Example: ajar merge seed-1.checkpoint seed-2.checkpoint -o room.exr");
}

void add_denoise(CLI::App& app, DenoiseArguments& a) {
  CLI::App* command = app.add_subcommand("denoise", "Take the noise out of a rendered picture");
  command->add_option("PICTURE", a.picture, "Picture that ajar render wrote, .exr")->required();
  command->add_option("-o,--output", a.outputs, "Picture to write; may be given several times")
      ->required()
      ->allow_extra_args(false)
      ->type_name("FILE");
  add_display(command, a);
  command->footer("Example: ajar denoise room.exr -o room.png");
}

void add_others(CLI::App& app, Request& request) {
  CLI::App* info = app.add_subcommand("info", "Print what is in a scene");
  add_scene(info, request.info.scene);
  info->add_flag("--json", request.info.json, "Print JSON");

  CLI::App* convert = app.add_subcommand("convert", "Write a scene as a file of its own");
  add_scene(convert, request.convert.scene);
  convert
      ->add_option("OUT", request.convert.output,
                   "File to write, in the format of its extension: " + writable_formats())
      ->required();
  convert->footer(
      "Meshes, and images that the format needs in another form, go into folders beside OUT "
      "(…_meshes, …_images).");

  CLI::App* list = app.add_subcommand("list", "List what there is to choose from");
  list->add_option(
      "KIND", request.list.kind,
      fmt::format("{}; or the name of one thing; default: all", fmt::join(catalog_kinds(), ", ")));
  list->add_option("NAME", request.list.name, "An integrator, a material …, to see its parameters");
  list->add_flag("--json", request.list.json, "Print JSON");
}

void add_compare(CLI::App& app, CompareArguments& a) {
  CLI::App* command = app.add_subcommand("compare", "Measure pictures against a reference");
  command->add_option("REFERENCE", a.reference, "Picture that is taken as right")->required();
  command->add_option("PICTURE", a.pictures, "Pictures to measure: .exr .pfm .hdr .png .jpg")
      ->required();
  std::string names;
  for (const study::Metric& metric : study::metrics()) {
    names += (names.empty() ? "" : ", ") + metric.name;
  }
  command->add_option("--metrics", a.metrics, "Which, separated by commas: " + names)
      ->type_name("LIST")
      ->check(kNotEmpty);
  add_value(command, "--ppd", a.pixels_per_degree, read_pixels_per_degree,
            "Pixels per degree of sight, for FLIP")
      ->type_name("X")
      ->default_str(fmt::format("{:g}", a.pixels_per_degree));
  command->add_flag("--json", a.json, "Print JSON");
  command
      ->add_option("--report", a.report,
                   "Also write a page to look at the pictures, in this folder")
      ->type_name("DIR")
      ->check(kNotEmpty);
  command->footer("Pictures rendered with --aov replicates are also tested for bias.");
}

void add_study(CLI::App& app, StudyArguments& a) {
  CLI::App* command = app.add_subcommand("study", "Compare methods at equal time or equal samples");
  command->add_option("FILE", a.file, "Study to carry out, JSON (see docs/studies.md)")->required();
  command->add_option("--out", a.out, "Folder for pictures and tables; default: STUDY-results here")
      ->type_name("DIR")
      ->check(kNotEmpty);
  command->footer(
      "Ctrl-C stops after the render that runs; the same command goes on where it stopped.");
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

/// Other renderers' names of our options.
struct OtherName {
  std::string theirs;
  std::string ours;
};

const std::vector<OtherName>& other_names() {
  static const std::vector<OtherName> names = {
      {"--samples", "--spp"},     {"--pixelsamples", "--spp"},     {"--nthreads", "--threads"},
      {"--outfile", "--output"},  {"--cropwindow", "--crop"},      {"--pixelfilter", "--filter"},
      {"--size", "--resolution"}, {"--quality", "--target-error"}, {"--timeout", "--time"},
      {"--time-limit", "--time"}};
  return names;
}

/// The option of ours for which other renderers have the name that is nearest; empty if one of ours
/// is nearer.
std::string our_name_of(const std::string& name, const std::vector<std::string>& valid) {
  std::vector<std::string> known;
  for (const OtherName& other : other_names()) {
    if (std::find(valid.begin(), valid.end(), other.ours) != valid.end()) {
      known.push_back(other.theirs);
    }
  }
  known.insert(known.end(), valid.begin(), valid.end());
  const std::string nearest = nearest_name(name, known);
  const auto found = std::find_if(other_names().begin(), other_names().end(),
                                  [&](const OtherName& other) { return other.theirs == nearest; });
  return found == other_names().end() ? std::string() : found->ours;
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

/// Raises UsageError if the first argument is neither a command nor an option.
void check_command(const CLI::App& app, int argc, const char* const* argv) {
  if (argc < 2) throw UsageError("a command is missing; try: ajar --help");
  const std::string first = argv[1];
  const std::vector<std::string> names = command_names(app);
  if (first.starts_with('-') || std::find(names.begin(), names.end(), first) != names.end()) return;
  std::error_code error;
  if (std::filesystem::exists(first, error) || first.starts_with("builtin:")) {
    throw UsageError("a command is missing before " + first + "; try: ajar render " + first);
  }
  throw UsageError(unknown_name_message("command", first, names));
}

/// Raises UsageError for arguments that no option took.
void check_leftovers(const CLI::App& app) {
  const std::vector<std::string> leftovers = app.remaining(true);
  if (leftovers.empty()) return;
  const std::vector<CLI::App*> commands = app.get_subcommands();
  const CLI::App& command = commands.empty() ? app : *commands.front();
  const auto option = std::find_if(leftovers.begin(), leftovers.end(), [](const std::string& text) {
    return text.size() > 1 && text.front() == '-';
  });
  if (option == leftovers.end()) {
    throw UsageError("unexpected argument \"" + leftovers.front() + "\"");
  }
  const std::string name = option->substr(0, option->find('='));
  const std::vector<std::string> valid = option_names(command);
  if (const std::string ours = our_name_of(name, valid); !ours.empty()) {
    throw UsageError("unknown option \"" + name + "\"; did you mean \"" + ours + "\"?");
  }
  throw UsageError(unknown_name_message("option", name, valid));
}

}  // namespace

int run(int argc, const char* const* argv, Ranks* ranks) {
  // "help render" asks for what "render --help" says.
  if (argc > 1 && std::string_view(argv[1]) == "help") {
    if (argc > 3) throw UsageError("unexpected argument \"" + std::string(argv[3]) + "\"");
    const char* const of_command[] = {argv[0], argc > 2 ? argv[2] : "--help", "--help"};
    return run(argc > 2 ? 3 : 2, of_command, ranks);
  }
  Request request;
  CLI::App app("Ajar renders the light that other renderers miss.", "ajar");
  app.set_version_flag("--version", "ajar " + version(), "Print the version");
  app.set_help_flag("-h,--help", "Print this help");
  app.get_formatter()->column_width(34);
  app.require_subcommand(1);
  app.footer(
      "Try: ajar render builtin:cornell\n"
      "Exit codes: 0 done, 1 renders of a study failed, 2 wrong usage, 3 unusable scene, 4 cannot "
      "read or write, 130 interrupted.");
  request.render.run.ranks = ranks;
  request.resume.run.ranks = ranks;
  add_render(app, request.render);
  add_resume(app, request.resume);
  add_merge(app, request.merge);
  add_denoise(app, request.denoise);
  add_others(app, request);
  add_compare(app, request.compare);
  add_study(app, request.study);
  for (CLI::App* command : app.get_subcommands({})) command->allow_extras();
  check_command(app, argc, argv);

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    std::ostringstream text;
    const int code = app.exit(help, text, text);
    print_result(text.str());
    return code;
  } catch (const CLI::ParseError& error) {
    check_leftovers(app);
    throw UsageError(error.what());
  }
  check_leftovers(app);

  if (app.got_subcommand("render")) return render(request.render);
  if (app.got_subcommand("resume")) return resume(request.resume);
  if (app.got_subcommand("merge")) return merge(request.merge);
  if (app.got_subcommand("denoise")) return denoise(request.denoise);
  if (app.got_subcommand("info")) return info(request.info);
  if (app.got_subcommand("convert")) return convert(request.convert);
  if (app.got_subcommand("compare")) return compare(request.compare);
  if (app.got_subcommand("study")) return study(request.study);
  return list(request.list);
}

}  // namespace ajar::cli
