#include "live/motion_history.h"

#include <algorithm>
#include <utility>

#include "base/error.h"

namespace thenar {
namespace {

/// Returns the memory of an instant [bytes].
std::size_t bytes_of(const PastInstant& past) {
  const SceneState& state = past.scene.state;
  const auto numbers = static_cast<std::size_t>(state.q.size() + state.v.size() + state.z.size());
  return sizeof(PastInstant) + numbers * sizeof(double) +
         past.scene.active.capacity() * sizeof(ActiveContact) +
         past.pads.capacity() * sizeof(ContactSample) +
         (past.readings.capacity() + past.efforts.capacity()) * sizeof(double);
}

}  // namespace

void MotionHistory::add(const PastInstant& instant) {
  // Remove the oldest instants beyond the limits, and reuse the memory of the last one removed.
  PastInstant reused;
  while (!past_.empty() && (past_.size() >= limits_.instants || bytes_ >= limits_.bytes)) {
    reused = std::move(past_.front());
    past_.pop_front();
    bytes_ -= bytes_of(reused);
  }
  reused = instant;
  bytes_ += bytes_of(reused);
  past_.push_back(std::move(reused));
}

void MotionHistory::clear() {
  past_.clear();
  bytes_ = 0;
}

void MotionHistory::erase_after(std::size_t index) {
  while (past_.size() > index + 1) {
    bytes_ -= bytes_of(past_.back());
    past_.pop_back();
  }
}

std::size_t MotionHistory::nearest_index(double t) const {
  require(!past_.empty(), "no instant is kept");
  // Find the first instant not before t, and compare it with the one before.
  const auto next = std::lower_bound(
      past_.begin(), past_.end(), t,
      [](const PastInstant& past, double time) { return past.scene.state.t < time; });
  if (next == past_.begin()) return 0;
  const auto index = static_cast<std::size_t>(next - past_.begin());
  if (next == past_.end()) return index - 1;
  const double before = (next - 1)->scene.state.t;
  return next->scene.state.t - t < t - before ? index : index - 1;
}

}  // namespace thenar
