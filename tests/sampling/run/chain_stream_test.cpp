// Tests for sampling/run/chain_stream.cpp.

#include "sampling/run/chain_stream.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "base/error.h"
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

}  // namespace
}  // namespace thenar::internal
