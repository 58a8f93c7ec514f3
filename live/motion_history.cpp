#include "live/motion_history.h"

#include <algorithm>
#include <utility>

#include "base/error.h"

namespace thenar {
namespace {

std::size_t bytes_of(const PastInstant& past) {
  const SceneState& state = past.at.state;
  const auto numbers = static_cast<std::size_t>(state.q.size() + state.v.size() + state.z.size());
  return sizeof(PastInstant) + numbers * sizeof(double) +
         past.at.active.capacity() * sizeof(ActiveContact) +
         past.pads.capacity() * sizeof(ContactSample) +
         (past.readings.capacity() + past.efforts.capacity()) * sizeof(double);
}

}  // namespace

void MotionHistory::add(const PastInstant& instant) {
  // The room of the oldest, if there is no more.
  PastInstant room;
  while (!past_.empty() && (past_.size() >= limits_.instants || bytes_ >= limits_.bytes)) {
    room = std::move(past_.front());
    past_.pop_front();
    bytes_ -= bytes_of(room);
  }
  room = instant;
  bytes_ += bytes_of(room);
  past_.push_back(std::move(room));
}

void MotionHistory::clear() {
  past_.clear();
  bytes_ = 0;
}

void MotionHistory::cut_behind(std::size_t index) {
  while (past_.size() > index + 1) {
    bytes_ -= bytes_of(past_.back());
    past_.pop_back();
  }
}

std::size_t MotionHistory::nearest(double t) const {
  require(!past_.empty(), "no instant is kept");
  // Binary search: instants are in order of time.
  const auto behind =
      std::lower_bound(past_.begin(), past_.end(), t,
                       [](const PastInstant& past, double time) { return past.at.state.t < time; });
  if (behind == past_.begin()) return 0;
  const auto index = static_cast<std::size_t>(behind - past_.begin());
  if (behind == past_.end()) return index - 1;
  const double before = (behind - 1)->at.state.t;
  return behind->at.state.t - t < t - before ? index : index - 1;
}

}  // namespace thenar
