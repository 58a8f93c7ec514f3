#include "geometry/collision/segment_bounds.h"

#include <algorithm>
#include <cmath>

namespace thenar {

double BallPair::narrowest() const {
  const double way = to - from;
  return from + std::clamp((way - (d_to * d_to - d_from * d_from) / way) / 2, 0.0, way);
}

double BallPair::least() const {
  const double way = to - from, s = narrowest() - from;
  const double square = d_from * d_from + s * ((d_to * d_to - d_from * d_from) / way + s - way);
  return square > 0 ? std::sqrt(square) : (d_from + d_to - way) / 2;
}

ConvexBracket::ConvexBracket(double low, double high, const Tangent& first)
    : low_{low, 0, 0}, high_{high, 0, 0} {
  add(first);
}

void ConvexBracket::add(const Tangent& tangent) {
  // The side of the minimum that it is on, and how often in turn.
  const bool falls = tangent.slope <= 0;
  same_side_ = falls == last_low_ ? same_side_ + 1 : 1;
  last_low_ = falls;
  (falls ? low_ : high_) = tangent;
  (falls ? seen_low_ : seen_high_) = true;
}

double ConvexBracket::meeting() const {
  const double turn = high_.slope - low_.slope;  // > 0, as the one falls and the other rises
  const double t = (low_.value - high_.value + high_.slope * high_.t - low_.slope * low_.t) / turn;
  return std::clamp(t, low_.t, high_.t);
}

double ConvexBracket::lower() const {
  if (!seen_high_) return low_.value + low_.slope * (high_.t - low_.t);
  if (!seen_low_) return high_.value - high_.slope * (high_.t - low_.t);
  return low_.value + low_.slope * (meeting() - low_.t);
}

double ConvexBracket::next(double step) const {
  // Only one side is known: growing steps towards the other.
  if (!closed()) {
    const double way = step * std::pow(4, same_side_ - 1);
    return seen_low_ ? std::min(high_.t, low_.t + way) : std::max(low_.t, high_.t - way);
  }
  // Stuck on one side: where the tangents meet; otherwise regula falsi on the slope.
  if (same_side_ > 1) return meeting();
  return low_.t - low_.slope * (high_.t - low_.t) / (high_.slope - low_.slope);
}

}  // namespace thenar
