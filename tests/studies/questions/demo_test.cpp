// Tests for studies/questions/demo.cpp. What it asks is tested where it is answered; the whole
// takes minutes.

#include "studies/questions/demo.h"

#include "base/error.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using Demo = TemporaryFolder;

TEST_F(Demo, NeedsItsDataAndWritesNothingWithout) {
  DemoRequest request;
  request.data = folder_.string();
  request.output = (folder_ / "out").string();
  EXPECT_THROW((void)run_demo_study(request), DataError);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}

}  // namespace
}  // namespace thenar
