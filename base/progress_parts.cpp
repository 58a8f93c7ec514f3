#include "base/progress_parts.h"

#include <algorithm>
#include <utility>

namespace thenar {

ProgressParts::ProgressParts(Progress whole, double seconds)
    : whole_(std::move(whole)), seconds_(seconds) {}

Progress ProgressParts::next(double seconds) {
  const double from = done_ / seconds_, share = seconds / seconds_;
  done_ += seconds;
  Progress part = whole_;
  part.report = [whole = whole_, from, share](double fraction, const std::string& what) {
    whole(std::min(1.0, from + fraction * share), what);
  };
  return part;
}

void report_or_stop(const Progress& progress, double fraction, const std::string& what) {
  if (progress.stop()) throw Stopped("stopped before: " + what);
  progress(fraction, what);
}

}  // namespace thenar
