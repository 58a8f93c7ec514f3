// Whole grasps of superellipsoids by a Barrett hand, against the 7 ms that one may take: then
// 14,400 take less than two minutes of one core.

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>

#include <fmt/format.h>

#include "bench/grasp_task.h"
#include "bench/ratios.h"

namespace thenar::bench {
namespace {

constexpr double kAllowed = 7e3;  // [us]
constexpr int kAll = 1600;        // starts of each of nine objects
constexpr int kFew = 100;
constexpr int kTurns = 10;

/// Starts of each object: a part of them all, unless THENAR_BENCH_ALL_GRASPS is set.
int starts() { return std::getenv("THENAR_BENCH_ALL_GRASPS") != nullptr ? kAll : kFew; }

/// Seconds on the clock that some threads take together for a tenth of the starts.
double seconds_of(const GraspTask& task, int threads) {
  const auto start = std::chrono::steady_clock::now();
  std::vector<std::thread> running;
  for (int i = 0; i < threads; ++i)
    running.emplace_back([&, i] { keep(time_grasps(task, i, threads, kFew / 10)); });
  for (std::thread& thread : running) thread.join();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

Row ratio_grasp() {
  const auto task = build_grasp_task();
  GraspTimes sum;
  std::vector<double> each;  // [us] a grasp, of every tenth of the starts
  for (int turn = 0; turn < kTurns; ++turn) {
    const GraspTimes part = time_grasps(*task, turn, kTurns, starts());
    each.push_back(1e6 * part.all() / std::max(1, part.grasped));
    sum += part;
  }
  const double to_ms = 1e3 / std::max(1, sum.grasped);
  const double one = seconds_of(*task, 1), two = seconds_of(*task, 2);

  Row row{"grasp by Barrett: 7 ms", median(each), kAllowed, 0, 1};
  row.ratio = row.rival / row.ours;
  row.note = fmt::format(
      "  a grasp: approach {:.2f} ms, close {:.2f}, contacts {:.2f}, quality {:.2f}; {} starts, {} "
      "with contacts,\n  {} with force closure; 14,400 take {:.0f} s of one core; two threads are "
      "{:.2f} times as fast as one\n",
      to_ms * sum.approach, to_ms * sum.close, to_ms * sum.contacts, to_ms * sum.quality,
      sum.starts, sum.grasped, sum.closures, 14.4 * row.ours * 1e-3, one / two);
  return row;
}

}  // namespace thenar::bench
