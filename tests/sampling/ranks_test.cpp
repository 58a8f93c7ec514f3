// Tests for sampling/ranks.cpp and sampling/gather_bytes.cpp; ranks_test.py has several processes.

#include "sampling/ranks.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "base/error.h"
#include "sampling/gather_bytes.h"

namespace thenar {
namespace {

TEST(Ranks, OneAloneHasItsOwnVectorOnly) {
  const auto ranks = one_rank();
  EXPECT_EQ(ranks->rank(), 0);
  EXPECT_EQ(ranks->size(), 1);
  EXPECT_EQ(ranks->all_gather(Eigen::Vector2d(3, 4)), Eigen::Vector2d(3, 4));
  EXPECT_THROW(ranks->abort("this one cannot go on"), InputError);
}

TEST(Ranks, WithoutMpirunThereIsOne) {
  if (std::getenv("OMPI_COMM_WORLD_SIZE")) GTEST_SKIP() << "started by mpirun";
  EXPECT_EQ(world_ranks()->size(), 1);
}

/// Three ranks that all send what this one sends.
class Threefold : public Ranks {
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
    EXPECT_EQ(internal::gather_bytes(Threefold(), bytes), std::vector<std::string>(3, bytes));
  }
}

}  // namespace
}  // namespace thenar
