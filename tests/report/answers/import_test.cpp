// Tests for report/answers/import.cpp.

#include "report/answers/import.h"

#include <gtest/gtest.h>

#include "tests/data_folder.h"

namespace thenar {
namespace {

Imported read(const std::string& file) {
  ImportRequest request;
  request.file = kData + file;
  return import_file(request);
}

TEST(ImportJson, CountsWhatARobotHas) {
  const OrderedJson told = json_of(read("/robots/barrett.toml"));
  EXPECT_EQ(told["name"], "barrett");
  EXPECT_EQ(told["counts"]["dofs"], 4);  // spread and three fingers
  EXPECT_EQ(told["counts"]["joints_moving"], 8);
}

TEST(ImportText, EndsInWarnings) {
  const std::string none = "no warnings\n";
  const std::string ball = text_of(read("/objects/sphere_70.toml"));
  EXPECT_EQ(ball.substr(ball.size() - none.size()), none);
  // The mug's file is in millimetres.
  EXPECT_NE(text_of(read("/objects/mug.obj")).find("are its numbers millimetres?\n  --units mm"),
            std::string::npos);
}

}  // namespace
}  // namespace thenar
