// Tests for base/file_lock.cpp.

#include "base/file_lock.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

class FileLockTest : public TemporaryFolder {};

TEST_F(FileLockTest, KeepsOthersOutAndLeavesNothing) {
  {
    const FileLock first(path("a"));
    EXPECT_EQ(message_of([&] { const FileLock second(path("a")); }),
              "another process works on '" + path("a") + "'");
    const FileLock other(path("b"));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
  const FileLock again(path("a"));
}

// Two names of one file are one lock, also before there is a file.
TEST_F(FileLockTest, FollowsLinksToTheFile) {
  std::filesystem::create_symlink("a", path("link"));
  std::filesystem::create_directory(path("in"));
  std::filesystem::create_symlink("../link", path("in/far"));
  for (const bool exists : {false, true}) {
    if (exists) std::ofstream(path("a")) << "it";
    const FileLock first(path("a"));
    for (const char* name : {"link", "in/far", "in/../a"})
      EXPECT_EQ(message_of([&] { const FileLock second(path(name)); }),
                "another process works on '" + path(name) + "'")
          << exists;
  }
}

// A process that was killed leaves the name, and no lock.
TEST_F(FileLockTest, TakesOverWhatADeadProcessLeft) {
  std::ofstream(path("a.lock")) << "";
  EXPECT_NO_THROW(FileLock(path("a")));
}

}  // namespace
}  // namespace thenar
