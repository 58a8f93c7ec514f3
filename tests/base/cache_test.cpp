// Tests for base/cache.cpp.

#include "base/cache.h"

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "tests/temporary_folder.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

class Cache : public TemporaryFolder {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    use_cache({path("cache")});
  }
  void TearDown() override {
    use_cache({});
    TemporaryFolder::TearDown();
  }
  [[nodiscard]] std::vector<fs::path> files() const {
    std::vector<fs::path> found;
    if (!fs::exists(path("cache"))) return found;
    for (const auto& entry : fs::directory_iterator(path("cache"))) found.push_back(entry.path());
    return found;
  }
};

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST_F(Cache, GivesBackWhatWasKeptForTheSameInput) {
  const std::string bytes("a\0b\n", 4);
  EXPECT_EQ(find_cached("mesh 1", "input"), std::nullopt);
  store_cached("mesh 1", "input", bytes);
  EXPECT_EQ(find_cached("mesh 1", "input"), bytes);
  EXPECT_EQ(find_cached("mesh 2", "input"), std::nullopt);
  EXPECT_EQ(find_cached("mesh 1", "input "), std::nullopt);
}

TEST_F(Cache, KeepsNothingWithoutAFolder) {
  use_cache({});
  store_cached("mesh 1", "input", "result");
  EXPECT_EQ(find_cached("mesh 1", "input"), std::nullopt);
  EXPECT_TRUE(files().empty());
}

// Every byte of an entry in turn turned around, and every shorter entry.
TEST_F(Cache, IgnoresADamagedEntryAndWritesItAnew) {
  store_cached("mesh 1", "input", "result");
  ASSERT_EQ(files().size(), 1U);
  const fs::path entry = files()[0];
  const std::string sound = text_of(entry);
  for (std::size_t i = 0; i < sound.size(); ++i) {
    std::string damaged = sound;
    damaged[i] = static_cast<char>(damaged[i] ^ 4);
    std::ofstream(entry, std::ios::binary) << damaged;
    EXPECT_TRUE(find_cached("mesh 1", "input") == std::nullopt || damaged[i] == sound[i] ||
                sound[i] == '\n')
        << i;
    std::ofstream(entry, std::ios::binary) << sound.substr(0, i);
    EXPECT_EQ(find_cached("mesh 1", "input"), std::nullopt) << i;
  }
  store_cached("mesh 1", "input", "result");
  EXPECT_EQ(find_cached("mesh 1", "input"), "result");
}

TEST_F(Cache, FailsNobodyWhereItCannotWrite) {
  std::ofstream(path("file")) << "no folder";
  for (const std::string& folder : {path("file"), path("file") + "/below",
                                    std::string("/proc/none"), std::string("/dev/full")}) {
    use_cache({folder});
    store_cached("mesh 1", "input", "result");
    EXPECT_EQ(find_cached("mesh 1", "input"), std::nullopt) << folder;
  }
  EXPECT_EQ(text_of(path("file")), "no folder");
}

TEST_F(Cache, FailsNobodyInAFolderThatMustNotBeWritten) {
  fs::create_directories(path("cache"));
  ::chmod(path("cache").c_str(), 0500);
  store_cached("mesh 1", "input", "result");  // root may, others may not
  const auto found = find_cached("mesh 1", "input");
  EXPECT_TRUE(found == std::nullopt || *found == "result");
  ::chmod(path("cache").c_str(), 0700);
}

TEST_F(Cache, LetsTheLeastRecentlyUsedGoAndNoOtherFiles) {
  const CacheOptions small{path("cache"), 100000};
  use_cache(small);
  fs::create_directories(path("cache"));
  std::ofstream(path("cache/mine.txt")) << std::string(200000, 'x');
  const std::string large(20000, 'y');
  for (int i = 0; i < 4; ++i) store_cached("mesh 1", std::to_string(i), large);
  // The first is asked for again, later than all others were made.
  const auto past = fs::file_time_type::clock::now() - std::chrono::hours(1);
  for (const fs::path& file : files()) fs::last_write_time(file, past);
  EXPECT_EQ(find_cached("mesh 1", "0"), large);
  store_cached("mesh 1", "4", large);
  EXPECT_EQ(find_cached("mesh 1", "0"), large);
  EXPECT_EQ(find_cached("mesh 1", "4"), large);
  std::uintmax_t total = 0;
  for (const fs::path& file : files())
    if (file.extension() == ".thenar") total += fs::file_size(file);
  EXPECT_LE(total, small.max_bytes);
  EXPECT_EQ(fs::file_size(path("cache/mine.txt")), 200000U);
  store_cached("mesh 1", "too large", std::string(60000, 'z'));
  EXPECT_EQ(find_cached("mesh 1", "too large"), std::nullopt);
}

// Two processes write and read the same entries at once: what is read is whole.
TEST_F(Cache, IsSharedByProcesses) {
  const auto work = [] {
    bool sound = true;
    for (int i = 0; i < 100; ++i) {
      const std::string input = std::to_string(i % 7), result(5000, static_cast<char>('a' + i % 7));
      store_cached("mesh 1", input, result);
      const auto found = find_cached("mesh 1", input);
      sound = sound && (found == std::nullopt || *found == result);
    }
    return sound;
  };
  const pid_t child = ::fork();
  if (child == 0) ::_exit(work() ? 0 : 1);
  EXPECT_TRUE(work());
  int status = -1;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  for (const fs::path& file : files()) EXPECT_EQ(file.extension(), ".thenar");
  EXPECT_EQ(files().size(), 7U);
}

TEST_F(Cache, StandsWhereTheUserWantsIt) {
  ::setenv("THENAR_CACHE", "/somewhere", 1);
  EXPECT_EQ(cache_options_of_user().folder, "/somewhere");
  ::setenv("THENAR_CACHE", "off", 1);
  EXPECT_EQ(cache_options_of_user().folder, "");
  ::unsetenv("THENAR_CACHE");
  ::setenv("XDG_CACHE_HOME", "/cache", 1);
  ::setenv("THENAR_CACHE_MB", "7", 1);
  EXPECT_EQ(cache_options_of_user().folder, "/cache/thenar");
  EXPECT_EQ(cache_options_of_user().max_bytes, 7000000U);
  ::unsetenv("XDG_CACHE_HOME");
  ::unsetenv("THENAR_CACHE_MB");
  ::setenv("HOME", "/home/me", 1);
  EXPECT_EQ(cache_options_of_user().folder, "/home/me/.cache/thenar");
}

}  // namespace
}  // namespace thenar
