#include "dynamics/stepping/extrapolation.h"

#include <algorithm>
#include <cmath>

namespace thenar {
namespace {

constexpr int kFirstAim = 4;
constexpr double kAimedError = 0.5;  // of the next step, over the tolerance [1]
constexpr double kOrderGain = 0.9;   // work per time that makes another order worth while [1]

/// Substeps of a step of so many columns, and what it costs beside them.
double work(int columns) { return 1 + 0.5 * columns * (columns + 1); }

/// Length over that of a step with an error of order n.
double growth(double error, int n) {
  if (!(error < 1e300)) return 1e-12;
  return std::min(std::pow(kAimedError / std::max(error, 1e-12), 1.0 / n), 4.0);
}

}  // namespace

Extrapolation::Extrapolation(const SceneState& like, int most)
    : most_(most), aim_(std::min(most, kFirstAim)) {
  rows_.fill(like);
}

void Extrapolation::add(const SceneState& column) {
  ++columns_;
  SceneState& last = rows_[index(columns_ - 1)];
  last = column;
  // From T_n1 on; a row's entry gives way to that of the next row once it has been used.
  for (int k = 1; k < columns_; ++k) {
    SceneState& above = rows_[index(k - 1)];
    const double ratio = static_cast<double>(columns_ - k) / k;
    const auto extrapolate = [&](auto& at, auto& before) {
      before = at + ratio * (at - before);
      at.swap(before);
    };
    extrapolate(last.q, above.q);
    extrapolate(last.v, above.v);
    extrapolate(last.z, above.z);
    extrapolate(last.w, above.w);
  }
}

Extrapolation::Verdict Extrapolation::judge(double error) {
  errors_[index(columns_)] = error;
  if (error <= 1 && columns_ >= aim_ - 1) return Verdict::kAccept;
  const int last = std::min(aim_ + 1, most_);
  if (columns_ >= last) return Verdict::kReject;
  // One column more than wanted may do, if it has to make the error not much smaller.
  const double next = columns_ + 1;
  const bool hopeless = columns_ == aim_ && !(error <= next * next);
  return hopeless ? Verdict::kReject : Verdict::kGoOn;
}

double Extrapolation::next_length(double length, double longest, Verdict verdict) {
  // The least work per time among the columns that were made.
  const auto length_of = [&](int n) {
    return std::min(longest, length * growth(errors_[index(n)], n));
  };
  int best = 2;
  for (int n = 3; n <= columns_; ++n)
    if (work(n) / length_of(n) < kOrderGain * work(best) / length_of(best)) best = n;
  aim_ = best;
  double next = std::max(length_of(best), 0.1 * length);
  const bool again = was_rejected_;
  was_rejected_ = verdict == Verdict::kReject;
  if (was_rejected_) return std::min(next, 0.9 * length);
  if (again) return std::min(next, length);
  // One more, if the last one was worth while.
  if (best == columns_ && best < most_ && next < longest) {
    ++aim_;
    next = std::min(longest, next * work(aim_) / work(best));
  }
  return next;
}

}  // namespace thenar
