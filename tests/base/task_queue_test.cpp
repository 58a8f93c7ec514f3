// Tests for base/task_queue.cpp.

#include "base/task_queue.h"

#include <array>
#include <atomic>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

TEST(TaskQueue, DoesEveryPieceOnceAndThoseThatPiecesAdd) {
  for (const int threads : {1, 2, 5}) {
    std::array<std::atomic<int>, 200> done{};
    TaskQueue queue;
    for (std::size_t i = 0; i < 100; ++i)
      queue.add([&, i] {
        ++done[i];
        queue.add_first([&, i] { ++done[100 + i]; });
      });
    queue.run(threads);
    for (const std::atomic<int>& times : done) EXPECT_EQ(times, 1);
  }
}

TEST(TaskQueue, TakesPiecesInOrderAndAddedOnesFirst) {
  std::vector<int> order;
  TaskQueue queue;
  queue.add([&] {
    order.push_back(1);
    queue.add_first([&] { order.push_back(2); });
  });
  queue.add([&] { order.push_back(3); });
  queue.run(1);
  EXPECT_EQ(order, (std::vector<int>{1, 2, 3}));
}

// The caller sees the work of all others at the latest when all is done.
TEST(TaskQueue, CallsBetweenOnTheCallersThreadAlone) {
  std::atomic<int> done{0};
  int seen = 0;
  const std::thread::id caller = std::this_thread::get_id();
  TaskQueue queue;
  for (int i = 0; i < 50; ++i) queue.add([&] { ++done; });
  queue.run(4, [&] {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    seen = done;
  });
  EXPECT_EQ(seen, 50);
}

TEST(TaskQueue, ThrowsWhatAPieceThrew) {
  for (const int threads : {1, 3}) {
    TaskQueue queue;
    std::atomic<int> done{0};
    queue.add([] { require(false, "failed"); });
    for (int i = 0; i < 5 && threads == 1; ++i) queue.add([&] { ++done; });
    EXPECT_EQ(message_of([&] { queue.run(threads); }), "failed");
    EXPECT_EQ(done, 0);  // what has not begun is left out
    queue.add([&] { ++done; });
    queue.run(threads);
    EXPECT_EQ(done, 1);
  }
}

TEST(TaskQueue, ThrowsWhatHappensBetween) {
  TaskQueue queue;
  for (int i = 0; i < 5; ++i) queue.add([] {});
  EXPECT_EQ(message_of([&] { queue.run(2, [] { require(false, "disk is full"); }); }),
            "disk is full");
}

}  // namespace
}  // namespace thenar
