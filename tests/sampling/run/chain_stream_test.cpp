// Tests for sampling/run/durable_file.cpp, sampling/run/chain_stream.cpp and
// sampling/run/run_folder.cpp.

#include "sampling/run/chain_stream.h"

#include <csignal>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include "base/error.h"
#include "sampling/run/run_folder.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar::internal {
namespace {

namespace fs = std::filesystem;

class ChainStreamTest : public TemporaryFolder {};

const Eigen::MatrixXd kFirst = (Eigen::MatrixXd(2, 3) << 1, -0.1, 1e300, 3, 4e-310, 5).finished();
const Eigen::MatrixXd kSecond = (Eigen::MatrixXd(2, 1) << 7, 8).finished();

Eigen::MatrixXd both() { return (Eigen::MatrixXd(2, 4) << kFirst, kSecond).finished(); }

TEST_F(ChainStreamTest, ReadsBackEveryBit) {
  ChainStream stream(path("a"), 2);
  stream.append(kFirst);
  stream.append(kSecond);
  stream.sync();
  EXPECT_EQ(stream.read(), both());
  EXPECT_EQ(ChainStream(path("a"), 2).read(), both());
}

// A process may be killed after any byte of a block: what was counted before is left as it was.
TEST_F(ChainStreamTest, ForgetsABlockCutAtAnyByte) {
  { ChainStream(path("a"), 2).append(kFirst); }
  const auto whole = fs::file_size(path("a"));
  { ChainStream(path("a"), 2).append(kSecond); }
  const auto end = fs::file_size(path("a"));
  for (auto size = whole; size <= end; ++size) {
    fs::copy_file(path("a"), path("b"), fs::copy_options::overwrite_existing);
    fs::resize_file(path("b"), size);
    ChainStream stream(path("b"), 2);
    stream.resume(3);
    EXPECT_EQ(fs::file_size(path("b")), whole);
    stream.append(kSecond);
    EXPECT_EQ(stream.read(), both());
  }
}

TEST_F(ChainStreamTest, RefusesADamagedByteAnywhere) {
  ChainStream stream(path("a"), 2);
  stream.append(kFirst);
  stream.append(kSecond);
  for (std::uintmax_t at = 0; at < fs::file_size(path("a")); ++at) {
    fs::copy_file(path("a"), path("b"), fs::copy_options::overwrite_existing);
    std::fstream file(path("b"), std::ios::in | std::ios::out | std::ios::binary);
    file.seekg(static_cast<std::streamoff>(at));
    const auto byte = static_cast<char>(file.get() ^ 0x10);
    file.seekp(static_cast<std::streamoff>(at));
    file.put(byte);
    file.close();
    EXPECT_THROW((ChainStream(path("b"), 2).resume(4)), InputError) << "byte " << at;
  }
}

TEST_F(ChainStreamTest, RefusesAColumnWithinABlock) {
  ChainStream stream(path("a"), 2);
  stream.append(kFirst);
  EXPECT_EQ(message_of([&] { stream.resume(2); }),
            "'" + path("a") + "' has no block that ends with column 2");
}

const RunIdentity kIdentity{{"method", "nuts"}, {"seed", "1"}};

TEST_F(ChainStreamTest, FolderGoesOnFromItsLastCommit) {
  {
    RunFolder folder(path("run"), kIdentity, {2, 2});
    EXPECT_FALSE(folder.state());
    folder.commit({kFirst, 2 * kFirst}, "one");
    folder.commit({kSecond, 2 * kSecond}, "two");
  }
  // Draws that no state counts are forgotten: the process was killed between the two.
  { ChainStream(path("run/group_001.draws"), 2).append(kFirst); }
  RunFolder folder(path("run"), kIdentity, {2, 2});
  EXPECT_EQ(*folder.state(), "two");
  EXPECT_EQ(folder.columns(), 4);
  EXPECT_EQ(folder.read(0), both());
  EXPECT_EQ(folder.read(1), 2 * both());
}

TEST_F(ChainStreamTest, FolderOfAnotherRunIsRefusedWithWhatDiffers) {
  { RunFolder(path("run"), kIdentity, {2}); }
  EXPECT_EQ(message_of([&] {
              RunFolder(path("run"), {{"method", "nuts"}, {"seed", "2"}, {"thin", "3"}}, {2});
            }),
            "the checkpoint in '" + path("run") +
                "' belongs to another run; what differs: seed (was 1, is 2), "
                "thin (was not there, is 3)");
}

TEST_F(ChainStreamTest, FolderServesOneAtATime) {
  const RunFolder folder(path("run"), kIdentity, {2});
  EXPECT_EQ(message_of([&] { RunFolder(path("run"), kIdentity, {2}); }),
            "another process is sampling in '" + path("run") + "'");
}

TEST_F(ChainStreamTest, FolderThatCannotBeMadeIsRefused) {
  std::ofstream(path("file")) << "no folder";
  EXPECT_EQ(message_of([&] { RunFolder(path("file/run"), kIdentity, {2}); }),
            "cannot make folder '" + path("file/run") + "' for checkpoints: Not a directory");
}

TEST_F(ChainStreamTest, DamagedStateIsRefused) {
  { RunFolder(path("run"), kIdentity, {2}).commit({kFirst}, "one"); }
  fs::resize_file(path("run/state.bin"), fs::file_size(path("run/state.bin")) - 1);
  EXPECT_EQ(message_of([&] { RunFolder(path("run"), kIdentity, {2}); }),
            "the checkpoint '" + path("run/state.bin") + "' is damaged");
}

/// Commits draws that do not fit the disk, in a process of its own.
void exit_refused_on_a_full_disk(const std::string& path) {
  (void)std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{4096, 4096};  // [bytes]
  setrlimit(RLIMIT_FSIZE, &limit);
  const std::string message = message_of(
      [&] { RunFolder(path, kIdentity, {2}).commit({Eigen::MatrixXd::Ones(2, 1000)}, "two"); });
  std::exit(message == "cannot write '" + path + "/group_000.draws': File too large" ? 0 : 1);
}

TEST_F(ChainStreamTest, FullDiskLeavesTheLastCommit) {
  { RunFolder(path("run"), kIdentity, {2}).commit({kFirst}, "one"); }
  EXPECT_EXIT(exit_refused_on_a_full_disk(path("run")), testing::ExitedWithCode(0), "");
  const RunFolder folder(path("run"), kIdentity, {2});
  EXPECT_EQ(*folder.state(), "one");
  EXPECT_EQ(folder.read(0), kFirst);
}

}  // namespace
}  // namespace thenar::internal
