// Tests for solvers/status.h.

#include "solvers/status.h"

#include <gtest/gtest.h>

namespace thenar {
namespace {

TEST(Status, HasAWordForEachEnd) {
  EXPECT_EQ(name_of(Status::kSolved), "solved");
  EXPECT_EQ(name_of(Status::kInfeasible), "infeasible");
  EXPECT_EQ(name_of(Status::kUnbounded), "unbounded");
  EXPECT_EQ(name_of(Status::kLimit), "limit");
  EXPECT_EQ(name_of(Status::kStopped), "stopped");
  EXPECT_EQ(name_of(Status::kStalled), "stalled");
}

TEST(Status, IsUndecidedWithoutAnswerAndWithoutProof) {
  for (const Status status : {Status::kSolved, Status::kInfeasible, Status::kUnbounded})
    EXPECT_FALSE(is_undecided(status)) << name_of(status);
  for (const Status status : {Status::kLimit, Status::kStopped, Status::kStalled})
    EXPECT_TRUE(is_undecided(status)) << name_of(status);
}

}  // namespace
}  // namespace thenar
