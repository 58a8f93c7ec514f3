// Tests for base/interrupt.cpp. What raises signals does so in a process of its own.

#include "base/interrupt.h"

#include <csignal>
#include <cstdlib>

#include <gtest/gtest.h>

namespace thenar {
namespace {

TEST(InterruptDeathTest, IsAnsweredAtOnceAndKept) {
  EXPECT_EXIT(
      {
        catch_interrupts("stopping\n");
        std::raise(SIGTERM);
        std::exit(interrupted() ? exit_code_of_interruption() : 0);
      },
      testing::ExitedWithCode(143), "stopping");
}

TEST(InterruptDeathTest, EndsAtOnceTheSecondTime) {
  EXPECT_EXIT(
      {
        catch_interrupts("stopping\n");
        std::raise(SIGINT);
        std::raise(SIGINT);
      },
      testing::KilledBySignal(SIGINT), "stopping");
}

TEST(InterruptDeathTest, EndsAtOnceWhereNothingIsKept) {
  EXPECT_EXIT(
      {
        catch_interrupts("stopping\n");
        const SignalsEndAtOnce at_once;
        std::raise(SIGINT);
      },
      testing::KilledBySignal(SIGINT), "");
}

// A program that loads the library and ignores Ctrl-C goes on ignoring it.
TEST(InterruptDeathTest, LeavesHandlersOfOthers) {
  EXPECT_EXIT(
      {
        std::signal(SIGINT, SIG_IGN);
        const SignalsEndAtOnce at_once;
        std::raise(SIGINT);
        std::exit(7);
      },
      testing::ExitedWithCode(7), "");
}

}  // namespace
}  // namespace thenar
