#include "dynamics/stepping/extrapolation.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace thenar {
namespace {

constexpr int kInitialColumns = 4;    // target number of columns of the first step
constexpr double kTargetError = 0.5;  // error of the next step over the tolerance [1]
constexpr double kOrderGain = 0.9;    // work ratio that justifies another column [1]
constexpr double kMaxGrowth = 4;      // largest ratio of successive step lengths [1]
constexpr double kMinShrink = 0.1, kRejectedShrink = 0.9;  // range of a repeated step's length [1]

/// Returns the work of a step: the substeps of its columns, and one for everything else.
double work(int columns) { return 1 + 0.5 * columns * (columns + 1); }

/// Returns the length for kTargetError over the present length, by an error of order n [1].
double growth(double error, int n) {
  if (!(error < 1e300)) return 1e-12;  // overflow
  return std::min(std::pow(kTargetError / std::max(error, 1e-12), 1.0 / n), kMaxGrowth);
}

}  // namespace

Extrapolation::Extrapolation(const SceneState& like, int max_columns)
    : max_columns_(max_columns), target_columns_(std::min(max_columns, kInitialColumns)) {
  rows_.fill(like);
}

void Extrapolation::add_column(const SceneState& column, int substeps) {
  require(substeps == columns_ + 1 && substeps <= max_columns_ && !verdict_,
          "no column of {} substeps follows {} columns of this step", substeps, columns_);
  ++columns_;
  SceneState& last = rows_[index(columns_ - 1)];
  last = column;
  // Extrapolate from T_n1 on; each entry of the previous row is overwritten once it has been used.
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

std::optional<Extrapolation::Verdict> Extrapolation::judge(double error) {
  require(columns_ >= 2 && !verdict_, "wanted two columns of an undecided step, got {}", columns_);
  errors_[index(columns_)] = error;
  if (error <= 1 && columns_ >= target_columns_ - 1) return verdict_ = Verdict::kAccept;
  // Allow one column beyond the target if it can reduce the error enough.
  const double next = columns_ + 1;
  const bool is_last = columns_ >= std::min(target_columns_ + 1, max_columns_);
  const bool is_hopeless = columns_ == target_columns_ && !(error <= next * next);
  if (is_last || is_hopeless) verdict_ = Verdict::kReject;
  return verdict_;
}

double Extrapolation::plan_next(double length, double max_length) {
  require(verdict_.has_value(), "wanted a verdict before the next step is planned");
  // Choose the number of columns with the least work per time.
  const auto length_of = [&](int n) {
    return std::min(max_length, length * growth(errors_[index(n)], n));
  };
  int best = 2;
  for (int n = 3; n <= columns_; ++n)
    if (work(n) / length_of(n) < kOrderGain * work(best) / length_of(best)) best = n;
  target_columns_ = best;
  // Shorten after a rejection; do not grow right after a repeated step.
  double next = std::max(length_of(best), kMinShrink * length);
  const bool again = was_rejected_;
  was_rejected_ = verdict_ == Verdict::kReject;
  verdict_.reset();
  if (was_rejected_) return std::min(next, kRejectedShrink * length);
  if (again) return std::min(next, length);
  // Aim at one more column if the last one paid.
  if (best == columns_ && best < max_columns_ && next < max_length) {
    ++target_columns_;
    next = std::min(max_length, next * work(target_columns_) / work(best));
  }
  return next;
}

}  // namespace thenar
