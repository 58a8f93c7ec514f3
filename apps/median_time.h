#pragma once

/// How long a call takes, here and now.

#include <algorithm>
#include <chrono>
#include <vector>

namespace thenar {

/// Median wall time of a call [s], over 21 batches of about 1 ms each; long calls are made thrice.
template <typename Call>
[[nodiscard]] double median_seconds(Call call) {
  using Clock = std::chrono::steady_clock;
  const auto time = [&](int calls) {
    const auto begin = Clock::now();
    for (int i = 0; i < calls; ++i) call();
    return std::chrono::duration<double>(Clock::now() - begin).count() / calls;
  };
  constexpr double kBatch = 1e-3;                   // [s]
  constexpr double kLong = 20e-3;                   // [s]
  const double first = std::min(time(1), time(1));  // the first call of all warms up
  const int calls = std::max(1, static_cast<int>(kBatch / std::max(first, 1e-9)));
  std::vector<double> seconds(first > kLong ? 3 : 21);
  for (double& s : seconds) s = time(calls);
  std::nth_element(seconds.begin(), seconds.begin() + seconds.size() / 2, seconds.end());
  return seconds[seconds.size() / 2];
}

/// Keeps a result that nobody looks at from being optimised away.
template <typename T>
void keep(const T& value) {
  asm volatile("" : : "r"(&value) : "memory");
}

}  // namespace thenar
