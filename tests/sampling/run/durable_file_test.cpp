// Tests for sampling/run/durable_file.cpp.

#include "sampling/run/durable_file.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/temporary_folder.h"

namespace thenar::internal {
namespace {

class DurableFileTest : public TemporaryFolder {};

TEST_F(DurableFileTest, AppendsAndIsCut) {
  AppendFile file(path("a"));
  file.append("first ");
  file.append("second");
  EXPECT_EQ(file.size(), 12);
  EXPECT_EQ(file.read(6, 6), "second");
  file.truncate(6);
  file.append("third");
  file.sync();
  EXPECT_EQ(AppendFile(path("a")).read(0, 11), "first third");
  EXPECT_THROW((void)file.read(6, 6), InputError);
}

TEST_F(DurableFileTest, IsLockedByOneAtATime) {
  AppendFile other(path("lock"));
  {
    AppendFile file(path("lock"));
    EXPECT_TRUE(file.lock());
    EXPECT_FALSE(other.lock());
  }
  EXPECT_TRUE(other.lock());
}

TEST_F(DurableFileTest, IsReplacedWhole) {
  replace_file(path("state"), "a long old state");
  replace_file(path("state"), "new");
  AppendFile file(path("state"));
  EXPECT_EQ(file.read(0, file.size()), "new");
  EXPECT_FALSE(std::filesystem::exists(path("state.tmp")));
}

TEST_F(DurableFileTest, NamesTheFileThatCannotBeMade) {
  EXPECT_THROW(AppendFile(path("no/such/folder")), InputError);
}

}  // namespace
}  // namespace thenar::internal
