#include "measuring/csv_keys.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace ajar::bench {
namespace {

TEST(CsvKeys, AreTheFirstColumns) {
  const std::string path =
      (std::filesystem::temp_directory_path() / ("ajar_keys_" + std::to_string(::getpid())))
          .string();
  EXPECT_TRUE(csv_keys(path, 2).empty());
  begin_csv(path, "scene,method,error");
  std::ofstream(path, std::ios::app) << "pool,\"mmlt:a=1,b=2\",0.5\n";
  begin_csv(path, "something else");
  EXPECT_EQ(csv_keys(path, 2), (std::set<std::string>{"scene,method", "pool,\"mmlt:a=1,b=2\""}));
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace ajar::bench
