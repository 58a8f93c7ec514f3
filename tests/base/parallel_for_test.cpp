// Tests for base/parallel_for.cpp.

#include "base/parallel_for.h"

#include <chrono>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

TEST(InParallel, DoesEverythingOnce) {
  std::vector<int> done(1000, 0);
  parallel_for(done.size(), [&](std::size_t i) { done[i] += static_cast<int>(i); });
  for (std::size_t i = 0; i < done.size(); ++i) EXPECT_EQ(done[i], static_cast<int>(i));
  parallel_for(0, [](std::size_t) { FAIL(); });
}

// The later failure comes first in time.
TEST(InParallel, ThrowsWhatTheFirstThrew) {
  for (int again = 0; again < 20; ++again)
    EXPECT_EQ(message_of([] {
                parallel_for(50, [](std::size_t i) {
                  if (i == 3) std::this_thread::sleep_for(std::chrono::milliseconds(2));
                  require(i < 3, "failed at {}", i);
                });
              }),
              "failed at 3");
}

}  // namespace
}  // namespace thenar
