#include "scene/desc/node.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "core/error.h"

namespace ajar::desc {
namespace {

ParameterSpec spec(std::string name, ParameterType type, std::string value) {
  return {.name = std::move(name),
          .type = type,
          .default_value = std::move(value),
          .unit = "",
          .help = "",
          .choices = {}};
}

const Model& velvet() {
  static const Model kVelvet = [] {
    Model model{.name = "velvet", .summary = "", .source = "", .parameters = {}};
    ParameterSpec textured = spec("color", ParameterType::Color, "0.5 0.25 1");
    textured.textured = true;
    textured.maximum = 1.0;
    ParameterSpec layers = spec("layers", ParameterType::Int, "3");
    layers.minimum = 0;
    layers.maximum = 64;
    ParameterSpec weave = spec("weave", ParameterType::Choice, "plain");
    weave.choices = {"plain", "satin"};
    model.parameters = {textured,
                        layers,
                        weave,
                        spec("gray", ParameterType::Color, "0.5"),
                        spec("shift", ParameterType::Vector, "1 -2 3e2"),
                        spec("worn", ParameterType::Bool, "true"),
                        spec("scale", ParameterType::Float, "0.75"),
                        spec("along_v", ParameterType::Float, ""),
                        spec("place", ParameterType::Transform, ""),
                        spec("picture", ParameterType::File, ""),
                        spec("under", ParameterType::Material, "")};
    return model;
  }();
  return kVelvet;
}

TEST(Node, HasTheDefaultsOfItsModel) {
  const Node node(velvet());
  EXPECT_TRUE(node.is("velvet"));
  EXPECT_EQ(node.color("color"), Rgb(0.5F, 0.25F, 1.F));
  EXPECT_EQ(node.integer("layers"), 3);
  EXPECT_EQ(node.text("weave"), "plain");
  EXPECT_EQ(node.color("gray"), Rgb(0.5F));
  EXPECT_EQ(node.vector("shift"), Vec3(1.F, -2.F, 300.F));
  EXPECT_TRUE(node.flag("worn"));
  EXPECT_EQ(node.number("scale"), 0.75F);
  EXPECT_EQ(node.get("along_v"), Value());
  EXPECT_EQ(node.transform("place"), Mat4());
  EXPECT_EQ(node.text("picture"), "");
  EXPECT_EQ(node.get("under"), Value());
  EXPECT_EQ(node.values().size(), velvet().parameters.size());
}

TEST(Node, TakesValuesOfTheTypesOfItsParameters) {
  const Node node(velvet(),
                  {{"color", TextureRef{4}}, {"under", MaterialRef{2}}, {"along_v", 2.F}});
  EXPECT_EQ(node.texture("color"), 4);
  EXPECT_EQ(node.material("under"), 2);
  EXPECT_EQ(node.number("along_v"), 2.F);
  EXPECT_NE(node, Node(velvet()));
  for (const auto& [name, value] :
       std::initializer_list<std::pair<const char*, Value>>{{"layers", 1.F},
                                                            {"gray", TextureRef{1}},
                                                            {"color", 0.5F},
                                                            {"scale", Value()},
                                                            {"place", TransformPointer()},
                                                            {"wove", "satin"}}) {
    EXPECT_THROW(Node(velvet(), {{name, value}}), std::logic_error) << name;
  }
  EXPECT_THROW(static_cast<void>(Node().get("color")), std::logic_error);
}

TEST(Node, ReportsInvalidValues) {
  const auto error_of = [](const char* name, const Value& value) -> std::string {
    try {
      const Node node(velvet(), {{name, value}});
    } catch (const SceneError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(error_of("layers", 64), "");
  EXPECT_EQ(error_of("layers", 65), "\"layers\" of velvet must be between 0 and 64, not 65");
  EXPECT_EQ(error_of("weave", "twill"),
            "\"weave\" of velvet must be one of plain, satin, not \"twill\"");
  EXPECT_EQ(error_of("scale", std::numeric_limits<float>::quiet_NaN()),
            "\"scale\" of velvet must be a finite number, not nan");
  // Readers of a texture clamp it to the range, and constants likewise.
  EXPECT_EQ(error_of("color", Vec3(7.F)), "");
}

TEST(DefaultValue, InvalidOneIsAProgrammingError) {
  EXPECT_THROW(default_value(spec("x", ParameterType::Float, "one")), std::logic_error);
  EXPECT_THROW(default_value(spec("x", ParameterType::Color, "1 2")), std::logic_error);
  EXPECT_THROW(default_value(spec("x", ParameterType::Vector, "1")), std::logic_error);
}

}  // namespace
}  // namespace ajar::desc
