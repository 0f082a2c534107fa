#pragma once
#include <functional>
#include <string>
#include <vector>

#include "core/warnings.h"
#include "scene/desc/scene_desc.h"
#include "support/temporary_file.h"

/// Tiny scenes of the formats whose pictures are known in closed form: units, sides, directions,
/// colours. Each format's file says what is its own.
namespace ajar::test {

/// A few pixels.
struct TinyPicture {
  std::vector<float> pixels;  ///< RGB, the top row first
  Vec2i size;

  /// Mean over the part of the picture between these shares of its width and height.
  Vec3 mean(float x0 = 0.F, float x1 = 1.F, float y0 = 0.F, float y1 = 1.F) const;
  // Means of the middles of its quarters.
  Vec3 upper_left() const { return mean(0.1F, 0.4F, 0.1F, 0.4F); }
  Vec3 upper_right() const { return mean(0.6F, 0.9F, 0.1F, 0.4F); }
  Vec3 lower_left() const { return mean(0.1F, 0.4F, 0.6F, 0.9F); }
  Vec3 lower_right() const { return mean(0.6F, 0.9F, 0.6F, 0.9F); }
};

using Import = std::function<desc::SceneDesc(Warnings&)>;

enum class MayWarn { No, Yes };

/// Rendered by path tracing; a warning fails the test unless there may be some.
TinyPicture picture_of(const Import& import, int samples, MayWarn may_warn = MayWarn::No);

/// Each lane within a share of what is expected.
void expect_color(const Vec3& actual, const Vec3& expected, float relative = 1e-3F);

/// Expects red, green, blue and white at the upper left, the upper right, the lower left and the
/// lower right.
void expect_four_colors(const TinyPicture& picture);

/// Replaces `'` in texts of tests by `"`.
std::string with_quotes(std::string text);

/// An image of 2×2 texels, linear floats: red and green above, blue and white below.
class FourColors {
 public:
  FourColors();
  const std::string& path() const { return file_.path(); }

 private:
  TemporaryFile file_{"colors.pfm"};
};

/// An image of one colour in 8 bits per channel, of a format that is decoded from sRGB.
class CodedGray {
 public:
  explicit CodedGray(int code);
  const std::string& path() const { return file_.path(); }
  int code() const { return code_; }
  /// IEC 61966-2-1.
  float decoded() const;
  float undecoded() const { return static_cast<float>(code_) / 255.F; }

 private:
  TemporaryFile file_{"gray.png"};
  int code_;
};

/// Reflectance of a surface with the index n + ik along its normal: Fresnel's equations.
float normal_reflectance(float n, float k);

}  // namespace ajar::test
