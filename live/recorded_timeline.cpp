#include "live/recorded_timeline.h"

#include <algorithm>
#include <utility>

namespace thenar {
namespace {

constexpr double kPlaybackStep = 1.0 / 240;  // step size of playback [s]

}  // namespace

RecordedTimeline::RecordedTimeline(std::vector<double> times) : times_(std::move(times)) {
  require(!times_.empty(), "wanted a motion with instants, got none");
  t_ = times_.front();
}

LiveTime RecordedTimeline::live_time() const {
  return {t_, kPlaybackStep, playing_, speed_, times_.back(), true};
}

MotionQuality RecordedTimeline::step(long count, const Progress& /*progress*/) {
  (void)seek(t_ + kPlaybackStep * static_cast<double>(count));
  if (t_ >= times_.back()) playing_ = false;
  MotionQuality out;
  out.steps = count;
  return out;
}

double RecordedTimeline::seek(double t) {
  t_ = std::clamp(t, times_.front(), times_.back());
  const auto next = std::lower_bound(times_.begin(), times_.end(), t_);
  nearest_ = static_cast<std::size_t>(next - times_.begin());
  if (nearest_ > 0 && t_ - times_[nearest_ - 1] < times_[nearest_] - t_) --nearest_;
  ++changes_;
  return t_;
}

void RecordedTimeline::reset() {
  playing_ = false;
  (void)seek(times_.front());
}

RecordedTimeline::Interpolation RecordedTimeline::interpolation() const {
  const bool before = times_[nearest_] <= t_;
  const std::size_t other = before ? nearest_ + 1 : nearest_ - 1;  // instant on the other side of t
  if (times_[nearest_] == t_ || other >= times_.size()) return {nearest_, nearest_, 0};
  const std::size_t from = std::min(nearest_, other), to = from + 1;
  return {from, to, (t_ - times_[from]) / (times_[to] - times_[from])};
}

Eigen::VectorXd RecordedTimeline::interpolated(const Eigen::MatrixXd& rows) const {
  const Interpolation t = interpolation();
  return rows.row(t.from) + t.fraction * (rows.row(t.to) - rows.row(t.from));
}

}  // namespace thenar
