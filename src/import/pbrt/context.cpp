#include "import/pbrt/context.h"

#include "core/printable_text.h"
#include "import/pbrt/lexer.h"

namespace ajar::pbrt {
namespace {
constexpr WarningKind kSameName{Effect::Slight, "things have the names of others before them"};
}

std::string unknown_message(const DialectChoice& choice, std::string_view what,
                            std::string_view name, const std::vector<std::string>& valid) {
  const std::optional<Dialect> other = dialect_of_word(name);
  if (!other || *other == choice.dialect) {
    return unknown_name_message(what, printable(name), valid);
  }
  std::string message = std::string(what) + " \"" + std::string(name) + "\" belongs to " +
                        std::string(name_of(*other)) + ", but this file is read as " +
                        std::string(name_of(choice.dialect)) + ": ";
  message += choice.word.empty() ? "it says nothing that only another version has"
                                 : choice.word + " at " + choice.where.to_string();
  return message;
}

void report_unknown(const Context& context, const SourceLocation& where, std::string_view what,
                    std::string_view name, const std::vector<std::string>& valid,
                    const WarningKind& kind, std::string_view stand_in) {
  const std::string message = unknown_message(context.choice, what, name, valid);
  if (!context.is_v4()) throw SceneError(where, message);
  context.warnings.add(kind, where, message + ". " + std::string(stand_in), printable(name));
}

void warn_of_same_name(const Context& context, const SourceLocation& where, std::string_view what,
                       std::string_view name) {
  context.warnings.add(kSameName, where,
                       "there is a " + std::string(what) + " \"" + printable(name) +
                           "\" already: from here on this one counts",
                       printable(name));
}

void fail_unknown(const SourceLocation& where, std::string_view what, std::string_view name,
                  const std::vector<std::string>& valid) {
  throw SceneError(where, unknown_name_message(what, printable(name), valid));
}

void warn_of_unknown_name(const Context& context, const WarningKind& kind,
                          const SourceLocation& where, std::string_view what,
                          const std::string& name, const std::vector<std::string>& valid,
                          std::string_view stand_in) {
  const char* order = context.is_v4() ? ". It must be made before it is named" : "";
  context.warnings.add(
      kind, where,
      unknown_name_message(what, printable(name), valid) + order + ". " + std::string(stand_in),
      printable(name));
}

std::string resolve_file(Context& context, const SourceLocation& where, const std::string& name) {
  try {
    return context.files.resolve(name, where);
  } catch (const IoError& error) {
    throw SceneError(where, error.what());
  }
}

}  // namespace ajar::pbrt
