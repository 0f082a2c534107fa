#pragma once
#include <array>
#include <string>
#include <vector>

#include "core/warnings.h"
#include "import/common/transforms.h"
#include "import/pbrt/context.h"

namespace ajar::pbrt {

/// The current transformation matrix: two of them, for the start and the end of the exposure. Only
/// the start is used; a difference is reported where something is placed.
class TransformState {
 public:
  /// First `m`, then the current transform. Raises SceneError if the result is not finite.
  void concatenate(const SourceLocation& where, const Mat4& m);
  void replace(const SourceLocation& where, const Mat4& m);
  /// `ActiveTransform`: "StartTime", "EndTime" or "All".
  void activate(const SourceLocation& where, std::string_view which);

  void define(const std::string& name) { named_[name] = current_; }
  void define_camera(const Mat4& to_world) { named_["camera"] = {to_world, to_world}; }
  /// `CoordSysTransform`. Raises SceneError for unknown names.
  void recall(const SourceLocation& where, const std::string& name);

  void push() { stack_.push_back({current_, active_}); }
  void pop();
  void begin_world();

  /// The transform at the start; a warning at `where` if it moves.
  const Mat4& get(const SourceLocation& where, Warnings& warnings) const;

 private:
  using Pair = std::array<Mat4, 2>;
  struct Saved {
    Pair transform;
    std::array<bool, 2> active;
  };
  Pair current_;
  std::array<bool, 2> active_ = {true, true};
  std::vector<Saved> stack_;
  std::map<std::string, Pair> named_;
};

}  // namespace ajar::pbrt
