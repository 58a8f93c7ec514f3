#include "geometry/collision/segment_bounds.h"

#include <algorithm>
#include <cmath>

namespace thenar {

double BallPair::narrowest_position() const {
  const double way = to - from;
  return from + std::clamp((way - (d_to * d_to - d_from * d_from) / way) / 2, 0.0, way);
}

double BallPair::min_bound() const {
  const double way = to - from, s = narrowest_position() - from;
  const double square = d_from * d_from + s * ((d_to * d_to - d_from * d_from) / way + s - way);
  return square > 0 ? std::sqrt(square) : (d_from + d_to - way) / 2;
}

ConvexBracket::ConvexBracket(double low, double high, const Tangent& first)
    : low_{low, 0, 0}, high_{high, 0, 0} {
  add(first);
}

void ConvexBracket::add(const Tangent& tangent) {
  // Replace the tangent on its side of the minimum, and count tangents on one side.
  const bool falls = tangent.slope <= 0;
  same_side_count_ = falls == last_was_low_ ? same_side_count_ + 1 : 1;
  last_was_low_ = falls;
  (falls ? low_ : high_) = tangent;
  (falls ? has_low_ : has_high_) = true;
}

double ConvexBracket::intersection() const {
  const double turn = high_.slope - low_.slope;  // > 0, as the one falls and the other rises
  const double t = (low_.value - high_.value + high_.slope * high_.t - low_.slope * low_.t) / turn;
  return std::clamp(t, low_.t, high_.t);
}

double ConvexBracket::lower() const {
  if (!has_high_) return low_.value + low_.slope * (high_.t - low_.t);
  if (!has_low_) return high_.value - high_.slope * (high_.t - low_.t);
  return low_.value + low_.slope * (intersection() - low_.t);
}

double ConvexBracket::next_position(double step) const {
  // While only one side is known, take growing steps towards the other.
  if (!is_closed()) {
    const double way = step * std::pow(4, same_side_count_ - 1);
    return has_low_ ? std::min(high_.t, low_.t + way) : std::max(low_.t, high_.t - way);
  }
  // Repeatedly on one side: intersect the tangents; otherwise regula falsi on the slope.
  if (same_side_count_ > 1) return intersection();
  return low_.t - low_.slope * (high_.t - low_.t) / (high_.slope - low_.slope);
}

}  // namespace thenar
