#include "session/options/option_values.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace ajar {
namespace {

TEST(Duration, UnderstandsUnits) {
  EXPECT_DOUBLE_EQ(parse_duration("--time", "60"), 60.0);
  EXPECT_DOUBLE_EQ(parse_duration("--time", "60s"), 60.0);
  EXPECT_DOUBLE_EQ(parse_duration("--time", "2m"), 120.0);
  EXPECT_DOUBLE_EQ(parse_duration("--time", "1h"), 3600.0);
  EXPECT_DOUBLE_EQ(parse_duration("--time", "1.5h"), 5400.0);
  EXPECT_THROW(parse_duration("--time", "1e300d"), UsageError) << "no infinite seconds";
  EXPECT_DOUBLE_EQ(parse_duration("--time", "1h30m"), 5400.0);
  EXPECT_DOUBLE_EQ(parse_duration("--time", "0.25"), 0.25);
}

TEST(Duration, RejectsWhatIsNoTime) {
  for (const char* text : {"", "0", "-5", "5x", "s", "1h30", "nan", "inf", "1 m", "0s"}) {
    EXPECT_THROW(parse_duration("--time", text), UsageError) << text;
  }
}

TEST(Resolution, IsWidthTimesHeight) {
  EXPECT_EQ(parse_resolution("--resolution", "640x480"), Vec2i(640, 480));
  EXPECT_EQ(parse_resolution("--resolution", "1x65536"), Vec2i(1, 65536));
  for (const char* text : {"", "640", "640x", "x480", "0x5", "-1x5", "640x480x3", "640X480",
                           "6.4x4", "65537x1", "99999999999x1"}) {
    EXPECT_THROW(parse_resolution("--resolution", text), UsageError) << text;
  }
}

TEST(Depth, HasOptionalEnds) {
  EXPECT_EQ(parse_depth("--depth", "2:8").minimum, 2);
  EXPECT_EQ(parse_depth("--depth", "2:8").maximum, 8);
  EXPECT_FALSE(parse_depth("--depth", "3:").maximum.has_value());
  EXPECT_EQ(parse_depth("--depth", "3:").minimum, 3);
  EXPECT_FALSE(parse_depth("--depth", ":4").minimum.has_value());
  EXPECT_EQ(parse_depth("--depth", "4").maximum, 4);
  for (const char* text : {"", ":", "0:3", "5:4", "a:b", "1:2:3", "1:1001", "-1:3"}) {
    EXPECT_THROW(parse_depth("--depth", text), UsageError) << text;
  }
}

TEST(Crop, FractionsAreAtMostOne) {
  const CropWindow crop = parse_crop("--crop", "0.25,0,1,0.5");
  EXPECT_TRUE(crop.fractions);
  const Box2i pixels = crop_pixels("--crop", crop, {100, 40});
  EXPECT_EQ(pixels.min, Vec2i(25, 0));
  EXPECT_EQ(pixels.max, Vec2i(99, 19));
}

TEST(Crop, FractionsThatTouchShareNoPixelAndMissNone) {
  const Vec2i resolution(101, 33);
  const Box2i left = crop_pixels("--crop", parse_crop("--crop", "0,0,0.37,1"), resolution);
  const Box2i right = crop_pixels("--crop", parse_crop("--crop", "0.37,0,1,1"), resolution);
  EXPECT_EQ(left.max.x + 1, right.min.x);
  EXPECT_EQ(left.min.x, 0);
  EXPECT_EQ(right.max.x, 100);
}

TEST(Crop, PixelsAreExclusiveAtTheEnd) {
  const CropWindow crop = parse_crop("--crop", "10,20,30,25");
  EXPECT_FALSE(crop.fractions);
  const Box2i pixels = crop_pixels("--crop", crop, {100, 40});
  EXPECT_EQ(pixels.min, Vec2i(10, 20));
  EXPECT_EQ(pixels.max, Vec2i(29, 24));
  EXPECT_EQ(crop_pixels("--crop", crop, {20, 22}).max, Vec2i(19, 21));
  EXPECT_THROW(crop_pixels("--crop", crop, {10, 10}), UsageError);
}

TEST(Crop, ZeroToOneIsTheWholePicture) {
  const Box2i pixels = crop_pixels("--crop", parse_crop("--crop", "0,0,1,1"), {7, 5});
  EXPECT_EQ(pixels.min, Vec2i(0, 0));
  EXPECT_EQ(pixels.max, Vec2i(6, 4));
}

TEST(Crop, RejectsNonsense) {
  for (const char* text : {"", "0,0,1", "0,0,1,1,1", "a,b,c,d", "0.5,0,0.5,1", "5,0,2,9",
                           "0,0,10.5,10", "-1,0,1,1", "0,0,nan,1", "0 ,0,1,1"}) {
    EXPECT_THROW(parse_crop("--crop", text), UsageError) << text;
  }
}

TEST(Assignments, SplitAtTheFirstEqualsSign) {
  const auto values = parse_assignments("--set", {"a=1", "b=x=y", "c=", "a=2"});
  EXPECT_EQ(values.at("a"), "2");
  EXPECT_EQ(values.at("b"), "x=y");
  EXPECT_EQ(values.at("c"), "");
  EXPECT_THROW(parse_assignments("--set", {"alone"}), UsageError);
  EXPECT_THROW(parse_assignments("--set", {"=1"}), UsageError);
}

TEST(List, DropsEmptyAndRepeatedNames) {
  EXPECT_EQ(parse_list("albedo,,depth,albedo"), (std::vector<std::string>{"albedo", "depth"}));
  EXPECT_TRUE(parse_list("").empty());
}

TEST(OptionValues, NumbersAreToldInWords) {
  constexpr Limits<int> kWhole{1, 100};
  constexpr Limits<double> kNumber{-64.0, 64.0};
  EXPECT_EQ(parse_whole("--spp", "64", kWhole), 64);
  EXPECT_EQ(parse_number("--scale", "-2.5", "times", kNumber), -2.5);
  for (const char* text : {"", "0", "101", "1.5", "-1", "many", "1e1", "99999999999999999999"}) {
    EXPECT_THROW(parse_whole("--spp", text, kWhole), UsageError) << text;
  }
  for (const char* text : {"", "lots", "nan", "inf", "-65", "1 stop"}) {
    EXPECT_THROW(parse_number("--scale", text, "times", kNumber), UsageError) << text;
  }
}

TEST(OptionValues, AnExposureIsANumberOrAuto) {
  EXPECT_EQ(parse_exposure("--exposure", "-2.5").stops, -2.5F);
  EXPECT_FALSE(parse_exposure("--exposure", "-2.5").automatic);
  EXPECT_TRUE(parse_exposure("--exposure", "auto").automatic);
  for (const char* text : {"", "lots", "nan", "inf", "-65", "1 stop", "Auto", "auto "}) {
    try {
      parse_exposure("--exposure", text);
      ADD_FAILURE() << text;
    } catch (const UsageError& error) {
      EXPECT_NE(std::string(error.what()).find("stops from -64 to 64, or auto, not"),
                std::string::npos)
          << error.what();
    }
  }
}

TEST(OptionValues, ErrorsMayBePercent) {
  EXPECT_DOUBLE_EQ(parse_relative_error("--target-error", "0.05"), 0.05);
  EXPECT_FALSE(parse_target_error("--target-error", "5%").is_denoised);
  EXPECT_TRUE(parse_target_error("--target-error", "denoised:5%").is_denoised);
  EXPECT_DOUBLE_EQ(parse_target_error("--target-error", "denoised:5%").value, 0.05);
  EXPECT_THROW(parse_target_error("--target-error", "denoised:"), UsageError);
  for (const char* text : {"Denoised:5%", "raw:5%", "denoised:raw:5%"}) {
    try {
      parse_target_error("--target-error", text);
      ADD_FAILURE() << text;
    } catch (const UsageError& error) {
      EXPECT_NE(std::string(error.what()).find("denoised:5%"), std::string::npos) << error.what();
    }
  }
  EXPECT_DOUBLE_EQ(parse_relative_error("--target-error", "5%"), 0.05);
  EXPECT_DOUBLE_EQ(parse_relative_error("--target-error", "100%"), 1.0);
  for (const char* text : {"", "%", "0", "0%", "-1", "nan", "5", "101%", "5 percent"}) {
    EXPECT_THROW(parse_relative_error("--target-error", text), UsageError) << text;
  }
}

}  // namespace
}  // namespace ajar
