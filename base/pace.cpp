#include "base/pace.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace thenar {
namespace {

constexpr double kMinReportedTime = 1.5;  // shortest time between reports for an estimate [s]
constexpr double kMinReportedShare =
    0.02;  // smallest share of the work between reports for an estimate [1]

}  // namespace

void Pace::add_report(double now, double fraction) {
  if (!first_) first_ = {now, fraction};
  last_ = {now, std::max(fraction, last_.fraction)};
}

std::optional<double> Pace::remaining_time() const {
  if (!first_) return {};
  const double taken = last_.at - first_->at, gone = last_.fraction - first_->fraction;
  if (taken < kMinReportedTime || gone < kMinReportedShare) return {};
  return taken * std::max(0.0, 1 - last_.fraction) / gone;
}

std::optional<double> Pace::total_time() const {
  const std::optional<double> rest = remaining_time();
  if (!rest) return {};
  return last_.at - begin_ + *rest;
}

std::string rough_time(double seconds) {
  const auto rounded = [](double value, double step) {
    return std::lround(std::max(1.0, value / step)) * std::lround(step);
  };
  if (seconds < 90) return fmt::format("{} s", rounded(seconds, seconds < 20 ? 1 : 10));
  const double minutes = seconds / 60;
  if (minutes < 90) return fmt::format("{} min", rounded(minutes, minutes < 20 ? 1 : 10));
  return fmt::format("{} h", rounded(minutes / 60, 1));
}

}  // namespace thenar
