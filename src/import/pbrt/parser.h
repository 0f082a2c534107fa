#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/warnings.h"
#include "import/common/file_access.h"
#include "import/pbrt/lexer.h"
#include "import/pbrt/scene_builder.h"

namespace ajar::pbrt {

/// Reads directives and hands them to a builder; follows `Include`.
class Parser {
 public:
  Parser(FileAccess& files, SceneBuilder& builder, Warnings& warnings)
      : files_(files), builder_(builder), warnings_(warnings) {}

  /// Parses one file and everything it includes; stops at WorldEnd. Returns where the file ends.
  /// `path` tells files apart to find circles.
  SourceLocation parse(std::string_view text, const std::string& name, const std::string& path);

 private:
  void directive(Lexer& lexer, const Token& token);
  bool transform_directive(Lexer& lexer, const Token& token, const SourceLocation& where);
  bool block_directive(Lexer& lexer, const Token& token, const SourceLocation& where);
  bool thing_directive(Lexer& lexer, const Token& token, const SourceLocation& where);
  void include(Lexer& lexer, const SourceLocation& where);

  std::string name(Lexer& lexer, const Token& directive);
  std::vector<double> numbers(Lexer& lexer, std::size_t count);
  ParameterList parameters(Lexer& lexer);
  Parameter parameter(Lexer& lexer);
  void value(Lexer& lexer, const Token& token, Parameter& parameter);

  FileAccess& files_;
  SceneBuilder& builder_;
  Warnings& warnings_;
  std::vector<std::string> open_files_;
  int files_parsed_ = 0;
};

}  // namespace ajar::pbrt
