#pragma once
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/warnings.h"
#include "import/common/file_access.h"
#include "import/pbrt/lexer.h"
#include "import/pbrt/scene_builder.h"

namespace ajar::pbrt {

/// Reads directives and hands them to a builder; follows `Include` and `Import`. The parameters of
/// a directive may go on in a file that is included behind them, and behind the `Include` of the
/// file that it is in.
class Parser {
 public:
  Parser(FileAccess& files, SceneBuilder& builder, Warnings& warnings)
      : files_(files),
        builder_(builder),
        warnings_(warnings),
        dialect_(builder.context().choice.dialect) {}

  /// Parses one file and everything it includes; stops at WorldEnd. Returns where the file ends.
  /// `path` identifies files to find cycles.
  SourceLocation parse(std::string_view text, const std::string& name, const std::string& path) {
    return parse(text, name, path, nullptr);
  }

 private:
  /// `after`: the file that goes on where this one ends, if one does.
  SourceLocation parse(std::string_view text, const std::string& name, const std::string& path,
                       Lexer* after);
  void directive(Lexer& lexer, const Token& token);
  bool transform_directive(Lexer& lexer, const Token& token, const SourceLocation& where);
  bool block_directive(Lexer& lexer, const Token& token, const SourceLocation& where);
  bool thing_directive(Lexer& lexer, const Token& token, const SourceLocation& where);
  /// Directives of pbrt-v4 alone.
  bool directive_of_v4(Lexer& lexer, const Token& token, const SourceLocation& where);
  /// Another file, and the token of its name. `goes_on`: whether one of its directives may end
  /// here.
  void include(Lexer& lexer, const SourceLocation& where, bool goes_on);
  /// A file that another one names, with its circles and limits checked. Raises SceneError.
  struct OpenFile {
    std::string name, path;
    FileBytes bytes;
    std::string decompressed;  ///< content of a gzip file; else empty
    std::string_view text() const { return decompressed.empty() ? bytes.view() : decompressed; }
  };
  void warn_of_missing(const std::string& included, const SourceLocation& where);
  OpenFile open(const std::string& included, const SourceLocation& where);
  bool is_missing(const std::string& included) const;
  /// Skips the parameters of a directive that pbrt-v4 does not have.
  void skip_directive(Lexer& lexer);

  std::string name(Lexer& lexer, const Token& directive);
  std::vector<double> numbers(Lexer& lexer, std::size_t count);
  /// `target`: whose attributes count, too; see SceneBuilder::attributes.
  ParameterList parameters(Lexer& lexer, std::string_view target = {});
  void read_parameters(Lexer& lexer, ParameterList& list, std::size_t& count);
  /// True if an `Include` follows that is among parameters: those of its file are read then.
  bool read_included_parameters(Lexer& lexer, ParameterList& list, std::size_t& count);
  /// Empty, after a warning, for types that pbrt-v4 does not have.
  std::optional<Parameter> parameter(Lexer& lexer);
  void option(Lexer& lexer, const SourceLocation& where);
  static void skip_values(Lexer& lexer);
  void value(Lexer& lexer, const Token& token, Parameter& parameter);

  FileAccess& files_;
  SceneBuilder& builder_;
  Warnings& warnings_;
  const Dialect dialect_;
  std::vector<std::string> open_files_;
  int files_parsed_ = 0;
  /// The file that was last looked into, for the Include that follows.
  std::optional<OpenFile> peeked_;
};

}  // namespace ajar::pbrt
