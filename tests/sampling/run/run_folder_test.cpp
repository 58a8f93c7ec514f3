// Tests for sampling/run/run_folder.cpp.

#include "sampling/run/run_folder.h"

#include <csignal>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "base/error.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar::internal {
namespace {

namespace fs = std::filesystem;

class RunFolderTest : public TemporaryFolder {};

const RunIdentity kIdentity{{"method", "nuts"}, {"seed", "1"}};
const Eigen::MatrixXd kDraws = (Eigen::MatrixXd(2, 3) << 1, -0.1, 1e300, 3, 4e-310, 5).finished();
const Eigen::MatrixXd kLater = (Eigen::MatrixXd(2, 1) << 7, 8).finished();

Eigen::MatrixXd all_draws() { return (Eigen::MatrixXd(2, 4) << kDraws, kLater).finished(); }

TEST_F(RunFolderTest, GoesOnFromItsLastCommit) {
  {
    RunFolder folder(path("run"), kIdentity, {2, 2});
    EXPECT_FALSE(folder.state());
    folder.commit({kDraws, 2 * kDraws}, "one");
    folder.commit({kLater, 2 * kLater}, "two");
  }
  // Draws that no state counts are forgotten: the process was killed between the two.
  { ChainStream(path("run/group_001.draws"), 2).append(kDraws); }
  RunFolder folder(path("run"), kIdentity, {2, 2});
  EXPECT_EQ(*folder.state(), "two");
  EXPECT_EQ(folder.columns(), 4);
  EXPECT_EQ(folder.read(0), all_draws());
  EXPECT_EQ(folder.read(1), 2 * all_draws());
}

TEST_F(RunFolderTest, OfAnotherRunIsRefusedWithWhatDiffers) {
  { RunFolder(path("run"), kIdentity, {2}); }
  EXPECT_EQ(message_of([&] {
              RunFolder(path("run"), {{"method", "nuts"}, {"seed", "2"}, {"thin", "3"}}, {2});
            }),
            "the checkpoint in '" + path("run") +
                "' belongs to another run; what differs: seed (was 1, is 2), "
                "thin (was not there, is 3)");
}

TEST_F(RunFolderTest, ServesOneAtATime) {
  const RunFolder folder(path("run"), kIdentity, {2});
  EXPECT_EQ(message_of([&] { RunFolder(path("run"), kIdentity, {2}); }),
            "another process is sampling in '" + path("run") + "'");
}

TEST_F(RunFolderTest, ThatCannotBeMadeIsRefused) {
  std::ofstream(path("file")) << "no folder";
  EXPECT_EQ(message_of([&] { RunFolder(path("file/run"), kIdentity, {2}); }),
            "cannot make folder '" + path("file/run") + "' for checkpoints: Not a directory");
}

TEST_F(RunFolderTest, DamagedStateIsRefused) {
  { RunFolder(path("run"), kIdentity, {2}).commit({kDraws}, "one"); }
  fs::resize_file(path("run/state.bin"), fs::file_size(path("run/state.bin")) - 1);
  EXPECT_EQ(message_of([&] { RunFolder(path("run"), kIdentity, {2}); }),
            "the checkpoint '" + path("run/state.bin") + "' is damaged");
}

/// Commits draws that do not fit the disk, in a process of its own.
/// Commits draws that do not fit the disk, in a process of its own.
void exit_refused_on_a_full_disk(const std::string& path) {
  (void)std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{4096, 4096};  // [bytes]
  setrlimit(RLIMIT_FSIZE, &limit);
  const std::string message = message_of(
      [&] { RunFolder(path, kIdentity, {2}).commit({Eigen::MatrixXd::Ones(2, 1000)}, "two"); });
  std::exit(message == "cannot write '" + path + "/group_000.draws': File too large" ? 0 : 1);
}

TEST_F(RunFolderTest, FullDiskLeavesTheLastCommit) {
  { RunFolder(path("run"), kIdentity, {2}).commit({kDraws}, "one"); }
  EXPECT_EXIT(exit_refused_on_a_full_disk(path("run")), testing::ExitedWithCode(0), "");
  const RunFolder folder(path("run"), kIdentity, {2});
  EXPECT_EQ(*folder.state(), "one");
  EXPECT_EQ(folder.read(0), kDraws);
}

}  // namespace
}  // namespace thenar::internal
