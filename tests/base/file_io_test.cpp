// Tests for base/file_io.cpp.

#include <sys/resource.h>
#include <sys/stat.h>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file_io.h"
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
