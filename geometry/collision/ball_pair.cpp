#include "geometry/collision/ball_pair.h"

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

}  // namespace thenar
