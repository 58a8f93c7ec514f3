// Prints how many times faster than its rival each part is, and whether that is enough.
// Exit code 1 if any row misses. Medians over turns taken one after the other in this very run.

#include "bench/ratios.h"

#include <algorithm>
#include <chrono>
#include <vector>

#include <fmt/format.h>

namespace thenar::bench {
namespace {

/// Seconds that `count` tasks take.
double time(const std::function<void()>& task, int count) {
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < count; ++i) task();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Tasks that fill the given time, after some to warm up.
int tasks_in(const std::function<void()>& task, double seconds) {
  int count = 1;
  double taken = time(task, count);
  while (taken < seconds / 2) {
    count *= 2;
    taken = time(task, count);
  }
  return std::max(1, static_cast<int>(count * seconds / taken));
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

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

int main() {
  using namespace thenar::bench;
  fmt::print("{:<44}{:>11}{:>12}{:>9}{:>10}{:>10}{:>11}\n", "", "ours [us]", "rival [us]", "ratio",
             "required", "error", "verdict");
  bool pass = true;
  for (const auto& row_function : {ratio_kinematics, ratio_chain, ratio_force_map, ratio_fit}) {
    const Row row = row_function();
    fmt::print(
        "{:<44}{:>11.3f}{:>12.2f}{:>9.1f}{:>10}{:>10}{:>11}\n", row.name, row.ours, row.rival,
        row.ratio, row.required > 0 ? fmt::format("{:.0f}", row.required) : "none",
        row.tolerance > 0 ? fmt::format("{:.1e}", row.error) : "-", row.pass() ? "PASS" : "MISS");
    pass = pass && row.pass();
  }
  fmt::print(
      "Rival: Simbody 3.7 as Debian packages it; built from source with -O3 and without asserts\n"
      "it is 2.0 to 2.8 times faster, and the ratios as much smaller. The rival of the fit is the "
      "second that it may take.\n"
      "Who uses what: fits run the templated chain, on jets (hand/chain.h), not the first row;\n"
      "FastKinematics is for whoever needs many poses of a whole hand, force_map for samplers of\n"
      "static thumb forces. No command of thenar calls either of these two today.\n");
  return pass ? 0 : 1;
}
