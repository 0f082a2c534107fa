#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace ajar {

/// Extensions of JSON that a file may use: comments, `// …` and `/* … */`, and a comma behind the
/// last part of an array or object.
enum class JsonExtras { None, CommentsAndTrailingCommas };

/// A value of a JSON file that knows where it was read. Objects keep the order of the file, and
/// members of the same name.
class LocatedJson {
 public:
  enum class Kind { Null, Bool, Number, String, Array, Object };
  struct Member;

  /// Reads a whole file. `name` stands in messages. Raises SceneError, with line and column, for
  /// text that is no JSON, for numbers beyond the range of doubles, and for values nested more than
  /// `kDeepest` levels.
  static LocatedJson parse(std::string_view text, const std::string& name,
                           JsonExtras extras = JsonExtras::None);
  static constexpr std::size_t kDeepest = 100;

  Kind kind() const { return kind_; }
  bool is(Kind kind) const { return kind_ == kind; }
  /// "a number", "an array", …, for messages.
  std::string_view kind_name() const;
  const SourceLocation& where() const { return where_; }

  /// The value of a Bool, Number, String; the parts of an Array, Object. False, zero or empty for
  /// other kinds.
  bool flag() const { return flag_; }
  double number() const { return number_; }
  const std::string& text() const { return text_; }
  const std::vector<LocatedJson>& items() const { return items_; }
  const std::vector<Member>& members() const { return members_; }
  /// The first member of this name, or null.
  const LocatedJson* find(std::string_view name) const;

 private:
  class Builder;

  Kind kind_ = Kind::Null;
  bool flag_ = false;
  double number_ = 0.0;
  SourceLocation where_;
  std::string text_;
  std::vector<LocatedJson> items_;
  std::vector<Member> members_;
};

struct LocatedJson::Member {
  std::string name;
  SourceLocation where;  ///< place of the name
  LocatedJson value;
};

}  // namespace ajar
