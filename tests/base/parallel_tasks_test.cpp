// Tests for base/parallel_tasks.cpp.

#include "base/parallel_tasks.h"

#include <atomic>
#include <thread>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

TEST(ParallelTasks, DoesEachOnce) {
  std::vector<int> done(20, 0);
  std::vector<ParallelTask> tasks;
  for (std::size_t i = 0; i < done.size(); ++i)
    tasks.push_back({static_cast<double>(i), [&done, i](const Progress&) { ++done[i]; }});
  run_tasks(tasks, {});
  EXPECT_EQ(done, std::vector<int>(20, 1));
}

// By hand: half of the task of 1 s, all of that of 3 s: 3.5 of 4; reports never go back.
TEST(ParallelTasks, ReportsTheWholeByTime) {
  std::vector<double> heard;
  Progress whole;
  whole.report = [&](double fraction, const std::string& /*what*/) { heard.push_back(fraction); };
  std::atomic<bool> first_done{false};
  run_tasks({{1,
              [&](const Progress& own) {
                while (!first_done) std::this_thread::yield();
                own(0.5, "second");
                own(0.25, "not back");
              }},
             {3,
              [&](const Progress& own) {
                own(0.5, "first");
                own(1, "first");
                first_done = true;
              }}},
            whole);
  EXPECT_EQ(heard, (std::vector<double>{0.375, 0.75, 0.875, 0.875}));
}

TEST(ParallelTasks, LeavesOutWhatHasNotBegunWhenStopped) {
  std::atomic<bool> stopped{false};
  std::atomic<int> begun{0};
  Progress whole;
  whole.stop_requested = [&] { return stopped.load(); };
  const ParallelTask task{1, [&](const Progress&) {
                            ++begun;
                            stopped = true;
                          }};
  run_tasks(std::vector<ParallelTask>(1000, task), whole);
  EXPECT_LE(begun, static_cast<int>(std::thread::hardware_concurrency()));
}

TEST(ParallelTasks, ThrowsWhatATaskThrew) {
  EXPECT_EQ(message_of([] {
              run_tasks({{1, [](const Progress&) { throw InputError("no such pad"); }}}, {});
            }),
            "no such pad");
}

}  // namespace
}  // namespace thenar
