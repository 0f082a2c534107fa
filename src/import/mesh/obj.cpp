#include "import/mesh/obj.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "core/printable_text.h"
#include "import/mesh/corner_table.h"
#include "import/mesh/display_color.h"
#include "import/mesh/polygon.h"
#include "import/mesh/text_lines.h"

namespace ajar {
namespace {

constexpr std::uint32_t kNone = CornerTable::kNone;

/// Marks vertices without a colour; no colour of a file.
constexpr float kNoColor = std::numeric_limits<float>::quiet_NaN();

bool is_colored(const Vec3& color) { return !std::isnan(color.x); }

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
    if (!has_faces_) throw SceneError(whole_file(), "there are no faces in this file");
  }

 protected:
  /// Mesh that faces are added to.
  struct Target {
    desc::Mesh& mesh;
    std::uint32_t number;  ///< number of the mesh
    bool has_uvs, has_normals;
  };
  virtual Target target_of(bool has_uvs, bool has_normals) = 0;
  virtual void use_material(std::string_view /*name*/) {}
  virtual void add_library(std::string_view /*files*/) {}
  virtual void leave_out(std::string_view /*keyword*/) {}
  virtual void leave_out_numbers(std::string_view /*numbers*/) {}
  /// A vertex of the mesh that the last face was added to.
  virtual void add_vertex(std::uint32_t /*position*/) {}

  /// `column` 0: the line.
  SourceLocation here(int column = 0) const { return {name_, lines_.number(), column}; }
  SourceLocation whole_file() const { return {name_, 0, 0}; }

  /// Linear, of the positions up to the last that has one.
  std::vector<Vec3> take_colors() {
    const float full = are_bytes() ? 255.F : 1.F;
    for (Vec3& color : colors_) {
      if (is_colored(color)) color = from_display(color / full);
    }
    return std::move(colors_);
  }

 private:
  bool are_bytes() const {
    bool has_large = false;
    for (const Vec3& color : colors_) {
      if (!is_colored(color)) continue;
      for (int lane = 0; lane < 3; ++lane) {
        if (std::trunc(color[lane]) != color[lane]) return false;
        has_large |= color[lane] > 1.F;
      }
    }
    return has_large;
  }

  void read_line() {
    LineWords words(lines_.line());
    const std::string_view keyword = words.word();
    if (keyword == "v") {
      positions_.push_back(vector(words));
      read_color(words);
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

  /// Reads the rest of a position: nothing, a weight, a colour, or both.
  void read_color(LineWords& words) {
    const std::string_view rest = words.rest();
    std::array<float, 4> numbers{};
    std::size_t count = 0;
    for (std::string_view word = words.word(); !word.empty() && !word.starts_with('#');
         word = words.word()) {
      const std::optional<float> value = number_in(word);
      if (!value || count == numbers.size()) return leave_out_numbers(rest);
      numbers[count++] = *value;
    }
    if (count == 2) return leave_out_numbers(rest);
    if (count < 3) return;
    colors_.resize(positions_.size(), Vec3(kNoColor));
    colors_.back() = Vec3(numbers[count - 3], numbers[count - 2], numbers[count - 1]);
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
    face_.clear();
    for (const Corner& corner : corners_) face_.push_back(vertex_of(target, corner));
    if (corners_.size() == 3) {
      target.mesh.indices.emplace_back(face_[0], face_[1], face_[2]);
      return;
    }
    places_.clear();
    for (const Corner& corner : corners_) places_.push_back(positions_[corner.position]);
    triangles_.clear();
    triangulate(places_, triangles_);
    for (const auto& t : triangles_) {
      target.mesh.indices.emplace_back(face_[t[0]], face_[t[1]], face_[t[2]]);
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
      add_vertex(corner.position);
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
  std::vector<Vec3> colors_;  ///< as in the file, of the positions up to the last that has one
  std::vector<Vec2> uvs_;
  CornerTable vertices_;
  std::vector<Corner> corners_;  ///< corners of the face that is read, and its parts:
  std::vector<unsigned> face_;
  std::vector<Vec3> places_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  bool has_faces_ = false;
};

/// All runs of faces, or one of them.
class OneMesh final : public ObjReader {
 public:
  OneMesh(std::string_view text, const std::string& name, std::optional<std::uint32_t> run = {})
      : ObjReader(text, name), wanted_(run) {}

  desc::Mesh result() {
    if (mesh_.indices.empty() && wanted_) {
      throw SceneError(whole_file(), "there is no run of faces " + std::to_string(*wanted_));
    }
    if (lacks_normals_) mesh_.normals.clear();
    if (!has_uvs_) mesh_.uvs.clear();
    return std::move(mesh_);
  }

 private:
  Target target_of(bool has_uvs, bool has_normals) override {
    is_begun_ = true;
    if (wanted_ && *wanted_ != run_) return {others_, 1, false, false};
    has_uvs_ |= has_uvs;
    lacks_normals_ |= !has_normals;
    return {mesh_, 0, true, true};
  }
  void use_material(std::string_view /*name*/) override { begin_run(); }
  void leave_out(std::string_view keyword) override {
    if (keyword == "g") begin_run();
  }
  void begin_run() {
    if (std::exchange(is_begun_, false)) ++run_;
  }

  std::optional<std::uint32_t> wanted_;
  std::uint32_t run_ = 0;
  bool is_begun_ = false;  ///< this run has faces
  desc::Mesh mesh_, others_;
  bool has_uvs_ = false;
  bool lacks_normals_ = false;
};

class Parts final : public ObjReader {
 public:
  Parts(std::string_view text, const std::string& name, const ObjEvents& events)
      : ObjReader(text, name), events_(events) {}

  std::vector<ObjPart> result() {
    const std::vector<Vec3> colors = take_colors();
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      bool has_some = false;
      for (const std::uint32_t position : positions_[i]) {
        const bool has_color = position < colors.size() && is_colored(colors[position]);
        has_some |= has_color;
        parts_[i].colors.push_back(has_color ? colors[position] : Vec3(1.F));
      }
      if (!has_some) parts_[i].colors.clear();
    }
    return std::move(parts_);
  }

 private:
  Target target_of(bool has_uvs, bool has_normals) override {
    const int kind = (has_uvs ? 1 : 0) + (has_normals ? 2 : 0);
    if (current_ == kNone || kind != kind_) {
      const auto [place, is_new] =
          by_kind_.try_emplace({material_, kind}, static_cast<std::uint32_t>(parts_.size()));
      if (is_new) {
        parts_.push_back({material_, here(), {}, {}});
        positions_.emplace_back();
      }
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
  void leave_out_numbers(std::string_view numbers) override {
    if (!std::exchange(has_odd_numbers_, true)) events_.on_numbers(here(1), numbers);
  }
  void add_vertex(std::uint32_t position) override { positions_[current_].push_back(position); }

  const ObjEvents& events_;
  std::set<std::string, std::less<>> unread_;
  bool has_odd_numbers_ = false;
  std::string material_;
  std::vector<ObjPart> parts_;
  std::vector<std::vector<std::uint32_t>> positions_;  ///< in the file, of the vertices of each
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

desc::Mesh read_obj_run(std::string_view bytes, const std::string& name, std::uint32_t index) {
  OneMesh reader(bytes, name, index);
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
