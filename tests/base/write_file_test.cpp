// Tests for base/write_file.h.

#include "base/write_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/error.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

class WriteFile : public TemporaryFolder {};

std::string content(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

TEST_F(WriteFile, KeepsEveryByte) {
  const std::string text("two\r\nlines\0", 11);
  write_file(path("a"), text);
  EXPECT_EQ(content(path("a")), text);
}

TEST_F(WriteFile, MakesMissingFolders) {
  write_file(path("new/folder/a"), "text");
  EXPECT_EQ(content(path("new/folder/a")), "text");
}

TEST_F(WriteFile, ReplacesAndLeavesNoTemporary) {
  write_file(path("a"), "a longer text");
  write_file(path("a"), "short");
  EXPECT_EQ(content(path("a")), "short");
  EXPECT_FALSE(fs::exists(path("a") + ".tmp"));
}

// A file cannot be a folder, for whoever asks.
TEST_F(WriteFile, NamesTheFileItCannotWrite) {
  write_file(path("a"), "a file");
  const std::string below = path("a") + "/b";
  try {
    write_file(below, "text");
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_EQ(e.what(), "cannot write '" + below + "'");
  }
  EXPECT_EQ(content(path("a")), "a file");
}

TEST_F(WriteFile, AsksBeforehandAndLeavesNothing) {
  require_writable(path("folder/a"));
  EXPECT_FALSE(fs::exists(path("folder/a")));
  EXPECT_TRUE(fs::is_empty(path("folder")));
}

// Renaming over a folder fails after the text was written.
TEST_F(WriteFile, RefusesToReplaceAFolder) {
  write_file(path("folder/a"), "text");
  EXPECT_THROW(write_file(path("folder"), "text"), InputError);
  EXPECT_EQ(content(path("folder/a")), "text");
  EXPECT_FALSE(fs::exists(path("folder") + ".tmp"));
}

// Another program, or another run, may be writing to the same place.
TEST_F(WriteFile, RefusesToReplaceADevice) {
  EXPECT_THROW(write_file("/dev/null", "x"), InputError);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(WriteFile, LeavesTheTemporariesOfOthersAlone) {
  std::ofstream(path("a") + ".tmp") << "somebody else's";
  require_writable(path("a"));
  write_file(path("a"), "text");
  EXPECT_EQ(content(path("a")), "text");
  EXPECT_EQ(content(path("a") + ".tmp"), "somebody else's");
  EXPECT_FALSE(fs::exists(path("a") + ".tmp1"));
}

/// Ends the process: 0 if `text` is refused where no file may exceed 4096 bytes.
[[noreturn]] void exit_refused_on_a_full_disk(const std::string& path, const std::string& text) {
  (void)std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{4096, 4096};
  (void)setrlimit(RLIMIT_FSIZE, &limit);
  try {
    write_file(path, text);
  } catch (const InputError&) {
    std::exit(0);
  }
  std::exit(1);
}

TEST_F(WriteFile, KeepsTheOldFileOnAFullDisk) {
  write_file(path("a"), "old");
  EXPECT_EXIT(exit_refused_on_a_full_disk(path("a"), std::string(100000, 'x')),
              testing::ExitedWithCode(0), "");
  EXPECT_EQ(content(path("a")), "old");
  EXPECT_FALSE(fs::exists(path("a") + ".tmp"));
}

// The link was replaced by a file, and what it stood for stayed as it was.
TEST_F(WriteFile, WritesThroughLinks) {
  write_file(path("folder/a"), "old");
  fs::create_symlink("folder/a", path("relative"));
  fs::create_symlink(path("relative"), path("link"));
  write_file(path("link"), "new");
  EXPECT_EQ(content(path("folder/a")), "new");
  EXPECT_TRUE(fs::is_symlink(path("link")) && fs::is_symlink(path("relative")));
  fs::create_symlink(path("not there yet"), path("dangling"));
  write_file(path("dangling"), "new");
  EXPECT_EQ(content(path("not there yet")), "new");
  fs::create_symlink(path("circle"), path("circle"));
  EXPECT_THROW(write_file(path("circle"), "text"), InputError);
  EXPECT_THROW(require_writable(path("circle")), InputError);
}

/// Ends the process: 0 if files that belong together are refused where one may not be written.
[[noreturn]] void exit_refused_together(const std::string& folder) {
  (void)std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{4096, 4096};
  (void)setrlimit(RLIMIT_FSIZE, &limit);
  try {
    write_files({{folder + "/part", "small"}, {folder + "/whole", std::string(10'000, 'x')}});
  } catch (const InputError&) {
    std::exit(0);
  }
  std::exit(1);
}

TEST_F(WriteFile, WritesAllOfSeveralFilesOrNone) {
  write_file(path("part"), "old");
  EXPECT_EXIT(exit_refused_together(path("")), testing::ExitedWithCode(0), "");
  EXPECT_EQ(content(path("part")), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1) << "no temporary is left";
  write_files({{path("part"), "new"}, {path("folder/whole"), "all"}});
  EXPECT_EQ(content(path("part")), "new");
  EXPECT_EQ(content(path("folder/whole")), "all");
}

}  // namespace
}  // namespace thenar
