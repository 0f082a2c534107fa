#include "scene/desc/models.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>

namespace ajar::desc {
namespace {

class Models : public ::testing::TestWithParam<ModelKind> {};

TEST_P(Models, HaveUniqueNames) {
  std::vector<std::string> names;
  for (const Model* model : models(GetParam())) names.push_back(model->name);
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  for (const Model* model : models(GetParam()))
    EXPECT_EQ(find_model(GetParam(), model->name), model);
  EXPECT_EQ(find_model(GetParam(), "glas"), nullptr);
  EXPECT_THROW(make_node(GetParam(), "glas"), std::logic_error);
}

TEST_P(Models, DeclareTheirCatalogueEntries) {
  for (const Model* model : models(GetParam())) {
    EXPECT_FALSE(model->summary.empty()) << model->name;
    std::set<std::string> names;
    for (const ParameterSpec& spec : model->parameters) {
      EXPECT_FALSE(spec.help.empty()) << model->name << ' ' << spec.name;
      EXPECT_TRUE(names.insert(spec.name).second) << model->name << ' ' << spec.name;
      const Value value = default_value(spec);
      EXPECT_EQ(complaint(spec, value), std::nullopt) << model->name << ' ' << spec.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(EveryKind, Models, ::testing::ValuesIn(kModelKinds));

}  // namespace
}  // namespace ajar::desc
