#include "import/pbrt/transform_state.h"

namespace ajar::pbrt {
namespace {

constexpr WarningKind kMoves{Effect::Geometry,
                             "things move during the exposure, which is not supported: their place "
                             "at the start is used"};

}  // namespace

void TransformState::concatenate(const SourceLocation& where, const Mat4& m) {
  for (std::size_t i = 0; i < 2; ++i) {
    if (!active_[i]) continue;
    current_[i] = m * current_[i];
    if (!is_finite(current_[i])) throw SceneError(where, "the current transform is not finite");
  }
}

void TransformState::replace(const SourceLocation& where, const Mat4& m) {
  if (!is_finite(m)) throw SceneError(where, "the transform is not finite");
  for (std::size_t i = 0; i < 2; ++i) {
    if (active_[i]) current_[i] = m;
  }
}

void TransformState::activate(const SourceLocation& where, std::string_view which) {
  if (which == "StartTime") {
    active_ = {true, false};
  } else if (which == "EndTime") {
    active_ = {false, true};
  } else if (which == "All") {
    active_ = {true, true};
  } else {
    fail_unknown(where, "ActiveTransform", which, {"StartTime", "EndTime", "All"});
  }
}

void TransformState::recall(const SourceLocation& where, const std::string& name) {
  const auto found = named_.find(name);
  if (found != named_.end()) {
    current_ = found->second;
    return;
  }
  std::vector<std::string> valid;
  for (const auto& entry : named_) valid.push_back(entry.first);
  throw SceneError(where, unknown_name_message("coordinate system", name, valid));
}

void TransformState::pop() {
  current_ = stack_.back().transform;
  active_ = stack_.back().active;
  stack_.pop_back();
}

void TransformState::begin_world() {
  current_ = {};
  active_ = {true, true};
  define("world");
}

const Mat4& TransformState::get(const SourceLocation& where, Warnings& warnings) const {
  if (current_[0] != current_[1]) {
    warnings.add(
        kMoves, where,
        "this moves during the exposure, which is not supported: its place at the start is used");
  }
  return current_[0];
}

}  // namespace ajar::pbrt
