// Tests for base/stop_scope.cpp.

#include "base/stop_scope.h"

#include <atomic>

#include <gtest/gtest.h>

#include "base/parallel_for.h"
#include "base/progress_parts.h"

namespace thenar {
namespace {

Progress stopping(bool& stop) {
  Progress progress;
  progress.stop_requested = [&stop] { return stop; };
  return progress;
}

TEST(StopScope, EndsWorkOnceItIsAskedTo) {
  bool stop = false;
  const Progress progress = stopping(stop);
  end_if_stopped();  // no scope
  {
    const StopScope scope(progress);
    end_if_stopped();
    stop = true;
    EXPECT_THROW(end_if_stopped(), Stopped);
    {
      const Progress never;
      const StopScope inner(never);
      end_if_stopped();  // the innermost counts
    }
    EXPECT_THROW(end_if_stopped(), Stopped);
  }
  end_if_stopped();
}

TEST(StopScope, IsHeardByThreadsThatShareTheWork) {
  bool stop = true;
  const Progress progress = stopping(stop);
  const StopScope scope(progress);
  std::atomic<int> ended{0};
  parallel_for(16, [&](std::size_t) {
    try {
      end_if_stopped();
    } catch (const Stopped&) {
      ++ended;
    }
  });
  EXPECT_EQ(ended, 16);
}

}  // namespace
}  // namespace thenar
