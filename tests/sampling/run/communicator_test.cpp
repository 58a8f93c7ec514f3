// Tests for sampling/run/communicator.cpp; ranks_test.py has several processes.

#include "sampling/run/communicator.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/sampling/thread_ranks.h"

namespace thenar {
namespace {

TEST(Communicator, OneAloneHasItsOwnVectorOnly) {
  const auto ranks = single_process();
  EXPECT_EQ(ranks->rank(), 0);
  EXPECT_EQ(ranks->size(), 1);
  EXPECT_EQ(ranks->all_gather(Eigen::Vector2d(3, 4)), Eigen::Vector2d(3, 4));
  EXPECT_THROW(ranks->abort("this one cannot go on"), InputError);
}

TEST(Communicator, WithoutMpirunThereIsOne) {
  if (std::getenv("OMPI_COMM_WORLD_SIZE")) GTEST_SKIP() << "started by mpirun";
  EXPECT_EQ(world_communicator()->size(), 1);
}

/// Three ranks that all send what this one sends.
class Threefold : public Communicator {
 public:
  [[nodiscard]] int rank() const override { return 0; }
  [[nodiscard]] int size() const override { return 3; }
  [[nodiscard]] Eigen::VectorXd all_gather(const Eigen::VectorXd& mine) const override {
    return mine.replicate(3, 1);
  }
  void barrier() const override {}
  [[noreturn]] void abort(const std::string& why) const override { throw InputError(why); }
};

TEST(GatherBytes, KeepsEveryByteOfAnyLength) {
  for (std::size_t size = 0; size < 20; ++size) {
    std::string bytes;
    for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(i * 37 + 128);
    EXPECT_EQ(internal::all_gather_bytes(Threefold(), bytes), std::vector<std::string>(3, bytes));
  }
}

// What one rank could not do, none may go on from.
TEST(CollectiveCall, FailsOnAllRanksIfItFailsOnOne) {
  std::vector<std::string> told(3);
  sample::ThreadRanks::run(3, [&](const Communicator& ranks) {
    collective_call(ranks, [] {});  // nothing fails, nothing is thrown
    try {
      collective_call(ranks, [&] { require(ranks.rank() != 1, "no disk on {}", ranks.rank()); });
    } catch (const Error& error) {
      told[static_cast<std::size_t>(ranks.rank())] = error.what();
    }
  });
  EXPECT_EQ(told, std::vector<std::string>(3, "no disk on 1"));
}

}  // namespace
}  // namespace thenar
