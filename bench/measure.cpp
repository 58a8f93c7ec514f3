#include <algorithm>
#include <chrono>
#include <vector>

#include "bench/ratios.h"

namespace thenar::bench {
namespace {

/// Seconds that `count` tasks take.
double time(const std::function<void()>& task, int count) {
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < count; ++i) task();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Tasks that fill the given time, after some to warm up. Of three tries the shortest tells, lest a
/// pause of the machine passes for the time of the task.
int tasks_in(const std::function<void()>& task, double seconds) {
  const auto shortest = [&](int count) {
    return std::min({time(task, count), time(task, count), time(task, count)});
  };
  int count = 1;
  double taken = shortest(count);
  while (taken < seconds / 2) {
    count *= 2;
    taken = shortest(count);
  }
  return std::max(1, static_cast<int>(count * seconds / taken));
}

}  // namespace

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Row measure(const Duel& duel, const Patience& patience) {
  const int ours_count = tasks_in(duel.ours, patience.seconds);
  const int rival_count = tasks_in(duel.rival, patience.seconds);
  std::vector<double> ours, rival, ratio;
  for (int turn = 0; turn < patience.turns; ++turn) {
    ours.push_back(1e6 * time(duel.ours, ours_count) / ours_count);
    rival.push_back(1e6 * time(duel.rival, rival_count) / rival_count);
    ratio.push_back(rival.back() / ours.back());
  }
  return {duel.name,     median(ours), median(rival), median(ratio),
          duel.required, duel.error,   duel.tolerance};
}

}  // namespace thenar::bench
