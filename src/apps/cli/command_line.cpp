#include "apps/cli/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "apps/cli/commands.h"
#include "core/error.h"
#include "import/format.h"
#include "os/standard_streams.h"
#include "session/options/render_options.h"
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
  ViewArguments view;
};

/// An empty value is most likely a variable of a script that was never set.
const CLI::Validator kNotEmpty(
    [](const std::string& text) {
      return text.empty() ? std::string("needs a value") : text.substr(0, 0);
    },
    "");

constexpr const char* kProgram = "Program";

std::string heading_of(OptionGroup group, unsigned command) {
  switch (group) {
    case OptionGroup::Scene:
      return "Options";
    case OptionGroup::Pictures:
      return "Pictures";
    case OptionGroup::Stop:
      return fmt::format("When to stop (whichever comes first; default: {})",
                         command == commands::kResume
                             ? "as before; if any is given, it replaces all"
                             : "the scene's samples per pixel");
    case OptionGroup::Method:
      return "Method";
    case OptionGroup::Safety:
      return "Never to lose a render";
    case OptionGroup::Program:
      return kProgram;
  }
  return {};
}

/// The default is what the heading does not say.
std::string help_of(const RenderOption& option, unsigned command) {
  const bool as_before = command == commands::kResume && option.is_kept;
  const std::string otherwise = as_before ? "as before" : option.default_text;
  if (otherwise.empty() || option.group == OptionGroup::Stop) return option.help;
  return option.help + "; default: " + otherwise;
}

void add_option(CLI::App* command, const RenderOption& option, RenderSpec& spec, unsigned which) {
  const std::string heading = heading_of(option.group, which);
  const std::string help = help_of(option, which);
  if (option.value_name.empty()) {
    command
        ->add_flag_callback(
            option.flags, [&] { read_option(option, spec, ""); }, help)
        ->group(heading);
    return;
  }
  const auto read = [&](const std::string& text) {
    if (!text.empty() || !option.may_be_empty) read_option(option, spec, text);
  };
  CLI::Option* const added =
      option.may_repeat
          ? command->add_option_function<std::vector<std::string>>(
                option.flags,
                [read](const auto& texts) { std::for_each(texts.begin(), texts.end(), read); },
                help)
          : command->add_option_function<std::string>(option.flags, read, help);
  if (option.may_repeat) added->allow_extra_args(false);
  if (!option.may_be_empty) added->check(kNotEmpty);
  added->type_name(option.value_name)->group(heading);
  if (!option.excludes.empty()) added->excludes(option.excludes);
}

/// The options of a command, of which `spec` has the values.
void add_options(CLI::App* command, unsigned which, RenderSpec& spec) {
  for (const RenderOption& option : render_options()) {
    if (option.flags.empty() || !option.has(which)) continue;
    add_option(command, option, spec, which);
  }
}

void add_progress(CLI::App* command, RunArguments& a) {
  command->add_option("--progress", a.progress, "auto, plain (lines), json (lines) or none")
      ->type_name("HOW")
      ->capture_default_str()
      ->group(kProgram);
}

void add_scene(CLI::App* command, SceneArguments& a) {
  command->add_option("SCENE", a.scene, kSceneHelp)->required();
  add_options(command, commands::kScene, a.spec);
}

void add_render(CLI::App& app, RenderArguments& a) {
  CLI::App* command = app.add_subcommand("render", "Render a scene to pictures");
  add_scene(command, a.scene);
  add_options(command, commands::kRender, a.scene.spec);
  add_progress(command, a.run);
  command->footer(
      fmt::format("Without -o the pictures are SCENE.exr and SCENE.png here.\n"
                  "Ctrl-C ends the render after the current pass and writes the pictures; SIGUSR1 "
                  "writes them and goes on.\n"
                  "Example: ajar render scene{} --time 2m --scale 0.5 -o scene.exr -o scene.png",
                  formats().front().extensions.front()));
}

void add_resume(CLI::App& app, ResumeArguments& a) {
  CLI::App* command = app.add_subcommand("resume", "Go on with a render from its checkpoint");
  command->add_option("CHECKPOINT", a.checkpoint, "File that --checkpoint wrote")->required();
  add_options(command, commands::kResume, a.scene.spec);
  add_progress(command, a.run);
  command->add_option("--scene", a.scene.scene, "Where the scene is now, if it has moved")
      ->type_name("SCENE")
      ->check(kNotEmpty)
      ->group(kProgram);
  command->footer(
      "Limits count from the beginning of the render. One that is finished can be extended, or "
      "just "
      "be written to other files.\n"
      "Example: ajar resume room.checkpoint --spp 4096");
}

void add_merge(CLI::App& app, MergeArguments& a) {
  CLI::App* command = app.add_subcommand("merge", "Put checkpoints together to one better picture");
  command->add_option("CHECKPOINT", a.checkpoints, "Renders of one picture: seeds, or all shares")
      ->required();
  add_options(command, commands::kMerge, a.spec);
  command->footer("Example: ajar merge seed-1.checkpoint seed-2.checkpoint -o room.exr");
}

void add_denoise(CLI::App& app, DenoiseArguments& a) {
  CLI::App* command = app.add_subcommand("denoise", "Take the noise out of a rendered picture");
  command->add_option("PICTURE", a.picture, "Picture that ajar render wrote, .exr")->required();
  add_options(command, commands::kDenoise, a.spec);
  command->get_option("--output")->required();
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
  command
      ->add_option_function<std::string>(
          "--ppd",
          [&a](const std::string& text) {
            a.pixels_per_degree =
                parse_number("--ppd", text, "pixels per degree", limits::kPixelsPerDegree);
          },
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

void add_view(CLI::App& app, ViewArguments& a) {
  CLI::App* command = app.add_subcommand(
      "view", "Light a scene, or look at a picture, in a live page of the browser");
  add_scene(command, a.scene);
  add_options(command, commands::kView, a.scene.spec);
  command
      ->add_option_function<std::string>(
          "--port",
          [&a](const std::string& text) {
            a.port = parse_whole("--port", text, Limits<int>{1, 65535});
          },
          "Port of the page; default: any that is free")
      ->type_name("N")
      ->group(kProgram);
  command
      ->add_option("--host", a.host,
                   "Address to listen on; any but this machine's own is open to the network")
      ->type_name("HOST")
      ->check(kNotEmpty)
      ->capture_default_str()
      ->group(kProgram);
  command->footer(
      "Prints the address of the page. Ctrl-C saves the picture here and ends.\n"
      "From another machine: ssh -L 8000:localhost:8000 HOST ajar view SCENE --port 8000\n"
      "Example: ajar view builtin:torus-in-glass");
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
  add_view(app, request.view);
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
  if (app.got_subcommand("view")) return view(request.view);
  return list(request.list);
}

}  // namespace ajar::cli
