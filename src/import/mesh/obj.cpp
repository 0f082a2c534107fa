#include "import/mesh/obj.h"

#include <map>
#include <memory>
#include <set>
#include <utility>

#include "core/printable_text.h"
#include "import/mesh/corner_table.h"
#include "import/mesh/text_lines.h"

namespace ajar {
namespace {

constexpr std::uint32_t kNone = CornerTable::kNone;

struct Corner {
  std::uint32_t position = kNone, uv = kNone, normal = kNone;
};

class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& name)
      : lines_(text), name_(std::make_shared<const std::string>(name)) {}
  virtual ~ObjReader() = default;

  void read() {
    while (lines_.next()) read_line();
    if (!has_faces_) throw SceneError({name_, 0, 0}, "there are no faces in this file");
  }

 protected:
  /// What a face is added to.
  struct Target {
    desc::Mesh& mesh;
    std::uint32_t number;  ///< of the mesh
    bool has_uvs, has_normals;
  };
  virtual Target target_of(bool has_uvs, bool has_normals) = 0;
  virtual void use_material(std::string_view /*name*/) {}
  virtual void add_library(std::string_view /*files*/) {}
  virtual void leave_out(std::string_view /*keyword*/) {}
  virtual void leave_out_colors() {}

  /// `column` 0: the line.
  SourceLocation here(int column = 0) const { return {name_, lines_.number(), column}; }

 private:
  void read_line() {
    LineWords words(lines_.line());
    const std::string_view keyword = words.word();
    if (keyword == "v") {
      positions_.push_back(vector(words));
      // A fourth number is a weight.
      if (!words.word().empty() && !words.rest().empty()) leave_out_colors();
    } else if (keyword == "vn") {
      normals_.push_back(vector(words));
    } else if (keyword == "vt") {
      const float u = number(words);
      // v may be left out.
      const bool is_last = words.rest().empty();
      uvs_.emplace_back(u, is_last ? 0.F : number(words));
    } else if (keyword == "f") {
      read_face(words);
    } else if (keyword == "usemtl") {
      use_material(words.rest());
    } else if (keyword == "mtllib") {
      add_library(words.rest());
    } else if (!keyword.empty() && keyword.front() != '#') {
      leave_out(keyword);
    }
  }

  float number(LineWords& words) const {
    const int column = words.column();
    const std::string_view word = words.word();
    const std::optional<float> value = number_in(word);
    if (value) return *value;
    throw SceneError(here(column), word.empty()
                                       ? "here a number is missing"
                                       : "this is no number: \"" + printable_line(word) + "\"");
  }
  Vec3 vector(LineWords& words) const {
    const float x = number(words);
    const float y = number(words);
    return {x, y, number(words)};
  }

  /// Numbers count from 1, or backwards from the last one.
  std::uint32_t resolve(long long written, std::size_t count, const char* what, int column) const {
    const auto available = static_cast<long long>(count);
    const long long place = written > 0 ? written - 1 : available + written;
    if (written == 0 || place < 0 || place >= available) {
      throw SceneError(here(column), "this face refers to " + std::string(what) + " " +
                                         std::to_string(written) + " of " + std::to_string(count));
    }
    return static_cast<std::uint32_t>(place);
  }

  /// "position", "position/uv", "position//normal" or "position/uv/normal".
  Corner corner_in(std::string_view word, int column) const {
    long long numbers[3] = {0, 0, 0};
    const char* place = word.data();
    const char* end = place + word.size();
    for (int i = 0; i < 3; ++i) {
      const bool is_left_out = i > 0 && (place == end || *place == '/');
      if (!is_left_out) {
        const auto [stopped, error] = std::from_chars(place, end, numbers[i]);
        if (error != std::errc() || (stopped != end && *stopped != '/')) break;
        place = stopped;
      }
      if (place == end || i == 2) break;
      ++place;
    }
    if (place != end) {
      throw SceneError(here(column),
                       "this is no corner of a face: \"" + printable_line(word) + "\"");
    }
    Corner corner;
    corner.position = resolve(numbers[0], positions_.size(), "vertex", column);
    if (numbers[1] != 0) {
      corner.uv = resolve(numbers[1], uvs_.size(), "texture coordinate", column);
    }
    if (numbers[2] != 0) corner.normal = resolve(numbers[2], normals_.size(), "normal", column);
    return corner;
  }

  void read_face(LineWords& words) {
    corners_.clear();
    bool has_uvs = true;
    bool has_normals = true;
    while (true) {
      const int column = words.column();
      const std::string_view word = words.word();
      if (word.empty() || word.starts_with('#')) break;
      corners_.push_back(corner_in(word, column));
      has_uvs &= corners_.back().uv != kNone;
      has_normals &= corners_.back().normal != kNone;
    }
    if (corners_.size() < 3) return;
    has_faces_ = true;
    const Target target = target_of(has_uvs, has_normals);
    const unsigned first = vertex_of(target, corners_[0]);
    unsigned previous = vertex_of(target, corners_[1]);
    for (std::size_t i = 2; i < corners_.size(); ++i) {
      const unsigned next = vertex_of(target, corners_[i]);
      target.mesh.indices.emplace_back(first, previous, next);
      previous = next;
    }
  }

  unsigned vertex_of(const Target& target, Corner corner) {
    if (!target.has_uvs) corner.uv = kNone;
    if (!target.has_normals) corner.normal = kNone;
    desc::Mesh& mesh = target.mesh;
    const auto [vertex, is_new] =
        vertices_.try_emplace({corner.position, corner.uv, corner.normal, target.number},
                              static_cast<std::uint32_t>(mesh.positions.size()));
    if (is_new) {
      mesh.positions.push_back(positions_[corner.position]);
      if (target.has_uvs) mesh.uvs.push_back(corner.uv == kNone ? Vec2(0.F) : uvs_[corner.uv]);
      if (target.has_normals) {
        mesh.normals.push_back(corner.normal == kNone ? Vec3(0.F) : normals_[corner.normal]);
      }
    }
    return vertex;
  }

  TextLines lines_;
  std::shared_ptr<const std::string> name_;
  std::vector<Vec3> positions_, normals_;
  std::vector<Vec2> uvs_;
  CornerTable vertices_;
  std::vector<Corner> corners_;
  bool has_faces_ = false;
};

class OneMesh final : public ObjReader {
 public:
  using ObjReader::ObjReader;

  desc::Mesh result() {
    if (lacks_normals_) mesh_.normals.clear();
    if (!has_uvs_) mesh_.uvs.clear();
    return std::move(mesh_);
  }

 private:
  Target target_of(bool has_uvs, bool has_normals) override {
    has_uvs_ |= has_uvs;
    lacks_normals_ |= !has_normals;
    return {mesh_, 0, true, true};
  }

  desc::Mesh mesh_;
  bool has_uvs_ = false;
  bool lacks_normals_ = false;
};

class Parts final : public ObjReader {
 public:
  Parts(std::string_view text, const std::string& name, const ObjEvents& events)
      : ObjReader(text, name), events_(events) {}

  std::vector<ObjPart> result() { return std::move(parts_); }

 private:
  Target target_of(bool has_uvs, bool has_normals) override {
    const int kind = (has_uvs ? 1 : 0) + (has_normals ? 2 : 0);
    if (current_ == kNone || kind != kind_) {
      const auto [place, is_new] =
          by_kind_.try_emplace({material_, kind}, static_cast<std::uint32_t>(parts_.size()));
      if (is_new) parts_.push_back({material_, here(), {}});
      current_ = place->second;
      kind_ = kind;
    }
    return {parts_[current_].mesh, current_, has_uvs, has_normals};
  }
  void use_material(std::string_view name) override {
    material_ = name;
    current_ = kNone;
  }
  void add_library(std::string_view files) override { events_.on_library(here(), files); }
  void leave_out(std::string_view keyword) override {
    if (!unread_.emplace(keyword).second) return;
    events_.on_unread(here(1), keyword);
  }
  void leave_out_colors() override {
    if (!std::exchange(has_colors_, true)) events_.on_colors(here(1), {});
  }

  const ObjEvents& events_;
  std::set<std::string, std::less<>> unread_;
  bool has_colors_ = false;
  std::string material_;
  std::vector<ObjPart> parts_;
  std::map<std::pair<std::string, int>, std::uint32_t> by_kind_;
  std::uint32_t current_ = kNone;
  int kind_ = 0;
};

}  // namespace

desc::Mesh read_obj(std::string_view bytes, const std::string& name) {
  OneMesh reader(bytes, name);
  reader.read();
  return reader.result();
}

std::vector<ObjPart> read_obj_parts(std::string_view bytes, const std::string& name,
                                    const ObjEvents& events) {
  Parts reader(bytes, name, events);
  reader.read();
  return reader.result();
}

}  // namespace ajar
