// Tests for base/read_file.cpp.

#include "base/read_file.h"

#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

class ReadFile : public TemporaryFolder {
 protected:
  std::string written(const std::string& name, const std::string& bytes) {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }
};

TEST_F(ReadFile, BringsEveryByteBack) {
  const std::string bytes("a\0\xff\r\nb", 6);
  EXPECT_EQ(read_file(written("a", bytes), 6), bytes);
  EXPECT_EQ(read_file(written("empty", ""), 0), "");
}

TEST_F(ReadFile, FollowsLinks) {
  (void)written("a", "text");
  std::filesystem::create_symlink(path("a"), path("link"));
  EXPECT_EQ(read_file(path("link"), 10), "text");
}

// A name that no file can have is none of a file, and no error of its own.
TEST_F(ReadFile, TellsFilesFromOtherThings) {
  const std::string file = written("a", "text");
  std::filesystem::create_symlink(file, path("link"));
  std::filesystem::create_symlink(path("circle"), path("circle"));
  for (const std::string& name : {file, path("link")}) EXPECT_TRUE(is_file(name)) << name;
  for (const std::string& name : {path(""), path("b"), file + "/b", path("circle"),
                                  path(std::string(300, 'a')), std::string()})
    EXPECT_FALSE(is_file(name)) << name;
}

TEST_F(ReadFile, RefusesOneByteTooMany) {
  const std::string file = written("a", "1234567");
  EXPECT_EQ(message_of<DataError>([&] { (void)read_file(file, 6); }),
            file + ":1: wanted at most 6 bytes, got 7");
}

// Its writer never comes: opening it as usual would wait for ever.
TEST_F(ReadFile, RefusesPipesWithoutWaiting) {
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  EXPECT_EQ(message_of<DataError>([&] { (void)read_file(path("pipe"), 6); }),
            path("pipe") + ":1: cannot be read: wanted a file, got a pipe");
}

TEST_F(ReadFile, RefusesDevicesThatNeverEnd) {
  EXPECT_EQ(message_of<DataError>([&] { (void)read_file("/dev/zero", 6); }),
            "/dev/zero:1: cannot be read: wanted a file, got a device");
  EXPECT_EQ(message_of<DataError>([&] { (void)read_start("/dev/zero", 6); }),
            "/dev/zero:1: cannot be read: wanted a file, got a device");
}

TEST_F(ReadFile, RefusesFoldersAndWhatIsNotThere) {
  std::filesystem::create_directories(path("folder"));
  EXPECT_EQ(message_of<DataError>([&] { (void)read_file(path("folder"), 6); }),
            path("folder") + ":1: cannot be read: wanted a file, got a folder");
  EXPECT_EQ(message_of<DataError>([&] { (void)read_file(path("none"), 6); }),
            path("none") + ":1: cannot be read: No such file or directory");
}

// Files of the kernel say that they have no bytes.
TEST_F(ReadFile, ReadsFilesOfUnknownSize) {
  EXPECT_NE(read_file("/proc/self/status", 100'000).find("Name:"), std::string::npos);
  EXPECT_THROW((void)read_file("/proc/self/status", 10), DataError);
}

TEST_F(ReadFile, StartsAreAsLongAsTheFileAtMost) {
  EXPECT_EQ(read_start(written("a", "12345"), 3), "123");
  EXPECT_EQ(read_start(written("b", "12"), 3), "12");
}

}  // namespace
}  // namespace thenar
