#include "imageio/color_channels.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ajar {
namespace {

/// The names that are chosen, alpha behind them, of names in any order; "?" if others may be meant.
std::string chosen(std::vector<std::string> names) {
  std::sort(names.begin(), names.end(), comes_before);
  const ColorChannels colors = color_channels(names);
  std::string text;
  for (int i = 0; i < colors.count; ++i) {
    text += (i > 0 ? " " : "") + names[static_cast<std::size_t>(colors.first + i)];
  }
  if (colors.alpha >= 0) text += " / " + names[static_cast<std::size_t>(colors.alpha)];
  return text + (colors.remark.empty() ? "" : " ?");
}

TEST(ColorChannels, OfTheImageItselfComeFirst) {
  EXPECT_EQ(chosen({"A", "B", "G", "R"}), "R G B / A");
  EXPECT_EQ(chosen({"A", "Y"}), "Y / A");
  EXPECT_EQ(chosen({"Y"}), "Y");
  EXPECT_EQ(chosen({"Z", "Y", "normal.X", "normal.Y", "normal.Z"}), "Y");
  EXPECT_EQ(chosen({"B", "G", "R", "Z", "albedo.B", "albedo.G", "albedo.R"}), "R G B");
  EXPECT_EQ(chosen({"b", "g", "r", "a"}), "r g b / a");
  EXPECT_EQ(chosen({"Blue", "Green", "Red", "Alpha"}), "Red Green Blue / Alpha");
}

TEST(ColorChannels, OfALayerFollow) {
  EXPECT_EQ(chosen({"diffuse.B", "diffuse.G", "diffuse.R", "Z"}), "diffuse.R diffuse.G diffuse.B");
  EXPECT_EQ(chosen({"View.AO.R", "View.AO.G", "View.AO.B", "View.Combined.A", "View.Combined.R",
                    "View.Combined.G", "View.Combined.B", "View.Depth.Z"}),
            "View.Combined.R View.Combined.G View.Combined.B / View.Combined.A");
  EXPECT_EQ(chosen({"b.R", "b.G", "b.B", "a.R", "a.G", "a.B"}), "a.R a.G a.B ?");
  EXPECT_EQ(chosen({"light.Y", "light.A"}), "light.Y / light.A");
  EXPECT_EQ(chosen({"N.X", "N.Y", "N.Z"}), "N.X N.Y N.Z");
}

TEST(ColorChannels, ElseThereIsWhatThereIs) {
  EXPECT_EQ(chosen({"Z"}), "Z");
  EXPECT_EQ(chosen({"A", "Z"}), "Z / A");
  EXPECT_EQ(chosen({"anything"}), "anything");
  EXPECT_EQ(chosen({"mask", "Z"}), "mask ?");
  EXPECT_EQ(chosen({"A"}), "A / A");
  EXPECT_EQ(chosen({"one", "two", "three"}), "one three two");
  EXPECT_EQ(chosen({"X", "Y", "Z"}), "X Y Z");
  EXPECT_EQ(chosen({"u.X", "u.Y"}), "u.X ?") << "Y beside X is no luminance";
}

TEST(ColorChannels, ARemarkNamesThemAll) {
  EXPECT_EQ(
      color_channels({"a.R", "a.G", "a.B", "b.R", "b.G", "b.B"}).remark,
      "of its channels \"a.R\", \"a.G\", \"a.B\", \"b.R\", \"b.G\", \"b.B\", \"a.R\", \"a.G\", "
      "\"a.B\" are shown");
}

}  // namespace
}  // namespace ajar
