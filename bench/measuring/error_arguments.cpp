#include "measuring/error_arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "core/error.h"
#include "measuring/split_arguments.h"

namespace ajar::bench {

namespace {

constexpr int kMaxSide = 16384;
constexpr int kMaxDepth = 1000;

void add_options(CLI::App& app, ErrorArguments& a) {
  const auto positive = CLI::PositiveNumber;
  app.add_option("SCENE", a.scenes, "Default: the built-in scenes and veach-bidir");
  app.add_option("--seconds", a.seconds, "CPU-seconds of each render")
      ->check(positive)
      ->capture_default_str();
  app.add_option("--repeats", a.repeats, "Renders of each variant, with different seeds")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  CLI::Option* size = app.add_option("--size", a.size, "Pixels of the picture's longer side")
                          ->check(CLI::Range(1, kMaxSide))
                          ->capture_default_str();
  app.add_option("--scale", a.scale, "Multiply the scene's own resolution instead")
      ->check(positive)
      ->excludes(size);
  app.add_option("--depth", a.depth, "Longest paths in edges (default: the scene's, else 16)")
      ->check(CLI::Range(1, kMaxDepth));
  app.add_option("--filter", a.filter, "box (one pixel wide) or scene (the scene's own)")
      ->check(CLI::IsMember({"box", "scene"}))
      ->capture_default_str();
  app.add_option("--threads", a.threads, "0: all processors")
      ->check(CLI::Range(0, 4096))
      ->capture_default_str();
  app.add_option("--reference", a.reference_folder, "Folder where references are kept")
      ->capture_default_str();
  app.add_option("--reference-seconds", a.reference_seconds,
                 "CPU-seconds behind a reference; what a kept one lacks is rendered and added")
      ->check(positive)
      ->capture_default_str();
  app.add_option("--reference-variant", a.reference_variant, "Variant that renders references")
      ->capture_default_str();
  app.add_flag("--shared-reference", a.shared_reference,
               "Average the reference with the shared folder's, where it has one");
}

}  // namespace

std::optional<ErrorArguments> parse_error_arguments(const std::vector<std::string>& arguments) {
  SplitArguments split = split_arguments(arguments);
  ErrorArguments parsed;
  CLI::App app(
      "Errors of integrators after equal CPU time, against long renders.\n"
      "ajar_error_bench [OPTIONS] [SCENE...] [-- VARIANT...]",
      "ajar_error_bench");
  app.footer(
      "VARIANT: an integrator with settings, such as pt or "
      "bdpt:heuristic=balance,roulette-start=8\n"
      "(default: pt lt ibpt bdpt). Ratios are to the first one.");
  add_options(app, parsed);
  try {
    // CLI11 takes vectors in reverse.
    std::reverse(split.before.begin(), split.before.end());
    app.parse(split.before);
  } catch (const CLI::Success& help) {
    app.exit(help);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }
  if (parsed.shared_reference && parsed.filter != "box") {
    throw UsageError("--shared-reference needs --filter box, which the shared pictures have");
  }
  parsed.variants = split.after;
  if (parsed.variants.empty()) parsed.variants = default_variants();
  return parsed;
}

}  // namespace ajar::bench
