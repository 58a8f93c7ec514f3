// Tests for base/inside_folder.cpp.

#include "base/inside_folder.h"

#include <sys/stat.h>

#include <atomic>
#include <filesystem>
#include <thread>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file_io.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

class Inside : public TemporaryFolder {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    for (const char* name : {"work", "other"}) fs::create_directory(path(name));
  }
  [[nodiscard]] std::string work(const std::string& name = "") const {
    return path("work/" + name);
  }
  /// Everything below a folder.
  [[nodiscard]] static std::size_t count(const std::string& folder) {
    const fs::recursive_directory_iterator all(folder);
    return static_cast<std::size_t>(std::distance(fs::begin(all), fs::end(all)));
  }
};

TEST_F(Inside, WritesAndReplacesFiles) {
  const InsideFolder folder(work());
  folder.write("a/b/c.toml", "one");
  EXPECT_EQ(read_file(work("a/b/c.toml"), 10), "one");
  folder.write("a/b/./c.toml", "two");
  EXPECT_EQ(read_file(work("a/b/c.toml"), 10), "two");
  folder.write("empty", "");
  EXPECT_EQ(count(work()), 4U);  // and no leftovers
  EXPECT_EQ(folder.entry("a/b/c.toml"), InsideFolder::Entry::kFile);
  EXPECT_EQ(folder.entry("a/b"), InsideFolder::Entry::kFolder);
  EXPECT_EQ(folder.entry("a/x/y"), InsideFolder::Entry::kNothing);
  EXPECT_EQ(folder.path_of("a//b"), fs::canonical(work()).string() + "/a/b");
}

TEST_F(Inside, FollowsNoLinkBelowIt) {
  write_file(path("other/victim"), "own");
  fs::create_symlink(path("other/victim"), work("file"));
  fs::create_symlink(path("other/new"), work("dangling"));
  fs::create_directory_symlink(path("other"), work("folder"));
  fs::create_directory_symlink(path("other/gone"), work("gone"));
  fs::create_symlink("circle", work("circle"));
  ASSERT_EQ(mkfifo(work("pipe").c_str(), 0600), 0);
  const InsideFolder folder(work());
  for (const char* name : {"file", "dangling", "folder", "folder/x", "folder/a/x", "gone/x",
                           "circle", "circle/x", "pipe", "pipe/x", "../other/x", ".x"}) {
    EXPECT_THROW(folder.write(name, "planted"), InputError) << name;
    EXPECT_THROW(folder.require_writable(name), InputError) << name;
  }
  EXPECT_EQ(folder.entry("file"), InsideFolder::Entry::kOther);
  EXPECT_THROW((void)folder.entry("folder/x"), InputError);
  EXPECT_EQ(read_file(path("other/victim"), 10), "own");
  EXPECT_EQ(count(path("other")), 1U);
  EXPECT_EQ(count(work()), 6U);
}

TEST_F(Inside, FollowsLinksOfItsOwnPath) {
  fs::create_directory_symlink(work(), path("alias"));
  InsideFolder(path("alias")).write("x", "y");
  EXPECT_EQ(read_file(work("x"), 10), "y");
  EXPECT_THROW(InsideFolder(path("nowhere")), InputError);
}

// A folder that becomes a link again and again while files are written into it.
TEST_F(Inside, IsNotLedOutByARace) {
  const InsideFolder folder(work());
  std::atomic<bool> done{false};
  std::thread attacker([&] {
    std::error_code ignored;
    while (!done) {
      fs::create_directory(work("a"), ignored);
      fs::remove_all(work("a"), ignored);
      fs::create_directory_symlink(path("other"), work("a"), ignored);
      fs::remove(work("a"), ignored);
    }
  });
  for (int i = 0; i < 3000; ++i) {
    try {
      folder.write("a/x", "planted");
    } catch (const InputError&) {
      continue;  // a link was there, or the folder was gone
    }
  }
  done = true;
  attacker.join();
  EXPECT_EQ(count(path("other")), 0U);
}

}  // namespace
}  // namespace thenar
