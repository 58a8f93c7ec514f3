// Tests for base/private_folder.cpp.

#include "base/private_folder.h"

#include <sys/stat.h>

#include <filesystem>

#include <gtest/gtest.h>

#include "base/cache.h"
#include "base/error.h"
#include "base/file_io.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

class PrivateFolder : public TemporaryFolder {
 protected:
  [[nodiscard]] unsigned mode(const std::string& name) const {
    struct stat about {};
    return stat(path(name).c_str(), &about) == 0 ? about.st_mode & 0777U : 0;
  }
};

TEST_F(PrivateFolder, IsMadeWithItsParentsForThisUserAlone) {
  make_private_folder(path("a/b/c"), ExistingFolder::kStays);
  for (const char* name : {"a", "a/b", "a/b/c"}) EXPECT_EQ(mode(name), 0700U) << name;
}

TEST_F(PrivateFolder, ClosesOneThatIsThereIfAsked) {
  fs::create_directory(path("a"));
  ASSERT_EQ(chmod(path("a").c_str(), 0755), 0);
  make_private_folder(path("a"), ExistingFolder::kStays);
  EXPECT_EQ(mode("a"), 0755U);
  make_private_folder(path("a"), ExistingFolder::kIsClosed);
  EXPECT_EQ(mode("a"), 0700U);
}

TEST_F(PrivateFolder, IsNoLinkAndNoFile) {
  fs::create_directory(path("a"));
  fs::create_directory_symlink(path("a"), path("link"));
  write_file(path("file"), "x");
  for (const char* name : {"link", "file", "file/x"})
    EXPECT_THROW(make_private_folder(path(name), ExistingFolder::kIsClosed), InputError) << name;
}

// The folder of the cache is this user's, as it was made by versions that left it open, too.
TEST_F(PrivateFolder, IsWhereResultsAreCached) {
  use_cache({path("new/thenar"), 1000});
  store_cached("kind", "input", "result");
  EXPECT_EQ(mode("new/thenar"), 0700U);
  fs::create_directory(path("old"));
  ASSERT_EQ(chmod(path("old").c_str(), 0755), 0);
  use_cache({path("old"), 1000, true});
  store_cached("kind", "input", "result");
  EXPECT_EQ(find_cached("kind", "input"), "result");
  use_cache({});
  EXPECT_EQ(mode("old"), 0700U);
}

}  // namespace
}  // namespace thenar
