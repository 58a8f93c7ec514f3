// Tests for data/io/trial_run.cpp.

#include "data/io/trial_run.h"

#include <memory>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

constexpr int kSeconds = 10;

std::string said_of(const std::function<void()>& work) {
  return message_of<DataError>([&] { try_first("a.h5", kSeconds, work); });
}

// What is done in the copy is not seen here: the count stays.
TEST(TrialRun, LeavesNothingBehind) {
  int count = 0;
  EXPECT_EQ(said_of([&] { ++count; }), "nothing was thrown");
  EXPECT_EQ(count, 0);
}

#ifndef __SANITIZE_ADDRESS__  // under which there is no limit of memory
TEST(TrialRun, RefusesWhatNeedsMoreMemory) {
  const auto greedy = [] {
    constexpr std::size_t kBytes = std::size_t{3} << 30U;
    const std::unique_ptr<char[]> many(new char[kBytes]);  // NOLINT(*-avoid-c-arrays)
    *static_cast<volatile char*>(many.get()) = 1;
  };
  EXPECT_EQ(said_of(greedy), "a.h5:1: reading it takes more than 1000 MB of memory");
}
#endif

TEST(TrialRun, TellsWhatTheWorkThrew) {
  EXPECT_EQ(said_of([] { throw DataError("a.h5", 1, "wanted a number"); }),
            "a.h5:1: wanted a number");
  EXPECT_EQ(said_of([] { throw InputError("wanted a number"); }), "a.h5:1: wanted a number");
  const std::string endless(10'000, 'x');
  EXPECT_EQ(said_of([&] { throw InputError(endless); }), "a.h5:1: " + endless.substr(0, 4000));
}

TEST(TrialRun, SaysWhereItCrashes) {
  EXPECT_EQ(said_of([] { std::abort(); }), "a.h5:1: it is damaged: reading it crashes (Aborted)");
}

}  // namespace
}  // namespace thenar
