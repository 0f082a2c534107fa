#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "session/options/render_spec.h"

namespace ajar {

/// A member of `RenderSpec`, by its type.
using SpecMember =
    std::variant<bool RenderSpec::*, int RenderSpec::*, std::uint64_t RenderSpec::*,
                 double RenderSpec::*, std::string RenderSpec::*, std::optional<int> RenderSpec::*,
                 std::optional<std::uint64_t> RenderSpec::*, std::optional<double> RenderSpec::*,
                 std::optional<std::array<int, 2>> RenderSpec::*,
                 std::optional<std::array<int, 4>> RenderSpec::*,
                 std::vector<std::string> RenderSpec::*,
                 std::map<std::string, std::string> RenderSpec::*,
                 std::optional<Exposure> RenderSpec::*, WorkSlice RenderSpec::*>;

/// Commands of the program, as bits: those that have an option.
namespace commands {
inline constexpr unsigned kRender = 1;
inline constexpr unsigned kResume = 2;
inline constexpr unsigned kMerge = 4;
inline constexpr unsigned kDenoise = 8;
inline constexpr unsigned kView = 32;
inline constexpr unsigned kScene = 16;  ///< all that read a scene
}  // namespace commands

/// Headings of `--help`.
enum class OptionGroup { Scene, Pictures, Stop, Method, Safety, Program };

/// An option of a render. A new one needs a member of `RenderSpec` (of `Settings`, if programs
/// are to have it), its row in `render_options`, and the code that uses it: command line, C,
/// Python, checkpoints, statistics and the reference loop over the table.
struct RenderOption {
  std::string name;  ///< name of the member in settings of programs, checkpoints and statistics
  SpecMember member;
  std::string help{};            ///< one line
  std::string default_text{};    ///< text for the value without it
  bool in_settings = false;      ///< programs have it (include/ajar/settings.h)
  bool is_kept = false;          ///< by checkpoints, for who goes on
  bool decides_picture = false;  ///< its bits: who goes on must have the same
  /// Raises UsageError, which begins with the name, for a value that cannot be.
  std::function<void(const RenderSpec&, const std::string& name)> check{};

  // On the command line.
  std::string flags{};       ///< "-o,--output"; empty: none
  std::string value_name{};  ///< "FILE"; empty: it takes no value
  OptionGroup group = OptionGroup::Program;
  unsigned commands = 0;  ///< commands that have it
  bool may_repeat = false;
  bool may_be_empty = false;           ///< an empty text is as if it were not given, else a mistake
  std::string excludes{};              ///< another one
  std::vector<std::string> choices{};  ///< words that it takes, if it takes words
  /// Takes a text; `flag` is the first, for messages. Raises UsageError. Empty: the text itself, or
  /// true.
  std::function<void(RenderSpec&, const std::string& flag, const std::string& text)> read{};

  bool has(unsigned command) const { return (commands & command) != 0; }
};

/// All of them, in the order of `--help`.
const std::vector<RenderOption>& render_options();

/// Takes a text of the command line, which is empty for an option without a value.
void read_option(const RenderOption& option, RenderSpec& spec, const std::string& text);
/// True unless it is as in an empty specification.
bool is_given(const RenderOption& option, const RenderSpec& spec);
void copy_option(const RenderOption& option, const RenderSpec& from, RenderSpec& to);
/// For messages.
std::string option_text(const RenderOption& option, const RenderSpec& spec);
/// For programs: null if nothing holds.
nlohmann::ordered_json option_json(const RenderOption& option, const RenderSpec& spec);
/// Raises UsageError for the first value that cannot be, of those options that `which` has.
void check_options(const RenderSpec& spec, bool RenderOption::*which);

}  // namespace ajar
