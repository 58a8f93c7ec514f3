// Tests for server/token_file.cpp.

#include "server/token_file.h"

#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file_io.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

class TokenFiles : public TemporaryFolder {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    ASSERT_EQ(setenv("XDG_RUNTIME_DIR", path("run").c_str(), 1), 0);
    ASSERT_EQ(setenv("XDG_CACHE_HOME", path("cache").c_str(), 1), 0);
  }
  void TearDown() override {
    for (const char* name : {"XDG_RUNTIME_DIR", "XDG_CACHE_HOME"}) (void)unsetenv(name);
    TemporaryFolder::TearDown();
  }
  [[nodiscard]] static unsigned mode(const std::string& name) {
    struct stat about {};
    return lstat(name.c_str(), &about) == 0 ? about.st_mode & 0777U : 0;
  }
};

TEST_F(TokenFiles, AreOfThisUserAloneAndGo) {
  const std::string name = path("run/thenar/8081.token");
  {
    const TokenFile file(8081, "0123456789abcdef");
    EXPECT_EQ(file.path(), name);
    EXPECT_EQ(read_file(name, 100), "0123456789abcdef\n");
    EXPECT_EQ(mode(name), 0600U);
    EXPECT_EQ(mode(path("run/thenar")), 0700U);
  }
  EXPECT_TRUE(fs::is_empty(path("run/thenar")));
}

// Whatever the umask lets others do.
TEST_F(TokenFiles, AreClosedUnderAnOpenUmask) {
  const mode_t before = umask(0);
  const TokenFile file(8081, "0123456789abcdef");
  umask(before);
  EXPECT_EQ(mode(file.path()), 0600U);
  EXPECT_EQ(mode(path("run/thenar")), 0700U);
}

TEST_F(TokenFiles, ReplaceWhatIsThereWithoutFollowingIt) {
  fs::create_directories(path("run/thenar"));
  write_file(path("victim"), "own");
  fs::create_symlink(path("victim"), path("run/thenar/8081.token"));
  const TokenFile file(8081, "0123456789abcdef");
  EXPECT_EQ(read_file(file.path(), 100), "0123456789abcdef\n");
  EXPECT_EQ(read_file(path("victim"), 100), "own");
}

TEST_F(TokenFiles, LeaveTheFileOfALaterServer) {
  auto first = std::make_unique<TokenFile>(8081, "of the first one");
  const TokenFile second(8081, "of the later one");
  first.reset();
  EXPECT_EQ(read_file(second.path(), 100), "of the later one\n");
}

TEST_F(TokenFiles, GoToTheNextPlaceWhereOneCannotBeUsed) {
  write_file(path("run"), "a file");
  const TokenFile file(8081, "0123456789abcdef");
  EXPECT_EQ(file.path(), path("cache/thenar/8081.token"));
  ASSERT_EQ(setenv("XDG_CACHE_HOME", path("run").c_str(), 1), 0);
  const char* home = std::getenv("HOME");
  const std::string before = home == nullptr ? "" : home;
  ASSERT_EQ(setenv("HOME", path("run").c_str(), 1), 0);
  EXPECT_THROW(TokenFile(8081, "x"), InputError);
  ASSERT_EQ(setenv("HOME", before.c_str(), 1), 0);
}

}  // namespace
}  // namespace thenar
