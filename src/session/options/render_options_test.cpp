#include "session/options/render_options.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "core/error.h"

namespace ajar {
namespace {

const RenderOption& option_named(const std::string& name) {
  return *std::find_if(render_options().begin(), render_options().end(),
                       [&](const RenderOption& option) { return option.name == name; });
}

TEST(RenderOptions, HaveNamesOfTheirOwnAndHelp) {
  std::set<std::string> names;
  std::set<std::string> flags;
  for (const RenderOption& option : render_options()) {
    EXPECT_TRUE(names.insert(option.name).second) << option.name;
    EXPECT_FALSE(option.help.empty()) << option.name;
    if (!option.flags.empty()) {
      EXPECT_TRUE(flags.insert(option.flags).second) << option.flags;
    }
    EXPECT_TRUE(option.in_settings || !option.flags.empty()) << option.name << " cannot be given";
  }
}

TEST(RenderOptions, OfAnEmptySpecificationAreNotGivenAndCanBe) {
  const RenderSpec empty;
  for (const RenderOption& option : render_options()) {
    EXPECT_FALSE(is_given(option, empty)) << option.name;
    if (option.check) {
      EXPECT_NO_THROW(option.check(empty, option.name)) << option.name;
    }
  }
}

TEST(RenderOptions, AreReadComparedAndCopied) {
  RenderSpec spec;
  for (const auto& [name, text] : {std::pair{"samples_per_pixel", "8"},
                                   {"layers", "albedo,depth"},
                                   {"share", "2/3"},
                                   {"exposure", "auto"},
                                   {"force", ""}}) {
    const RenderOption& option = option_named(name);
    read_option(option, spec, text);
    EXPECT_TRUE(is_given(option, spec)) << name;
    RenderSpec other;
    copy_option(option, spec, other);
    EXPECT_EQ(option_json(option, other), option_json(option, spec)) << name;
  }
  EXPECT_EQ(option_text(option_named("layers"), spec), "albedo,depth");
  EXPECT_EQ(option_text(option_named("share"), spec), "2/3");
  EXPECT_EQ(option_text(option_named("filter"), spec), "the scene's");
  EXPECT_EQ(option_json(option_named("samples_per_pixel"), spec), 8);
  EXPECT_THROW(read_option(option_named("samples_per_pixel"), spec, "0"), UsageError);
  spec.scale = -1.0;
  EXPECT_THROW(check_options(spec, &RenderOption::in_settings), UsageError);
}

}  // namespace
}  // namespace ajar
