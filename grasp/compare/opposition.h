#pragma once

/// Opposition of the thumb, with Kapandji's score.

#include <random>

#include "grasp/compare/comparison.h"

namespace thenar {

/// Opposition of the thumb, on a scale of 0 to 10.
struct Opposition {
  double score = 0;                  // NaN: a hand of fewer than two digits
  std::string scale;                 // name of the scale
  std::vector<std::string> reached;  // places or digits that the thumb meets
};

/// Measures opposition. With places: Kapandji's score, the highest place that the thumb's pad
/// meets. Without: ten times the share of other tips that the tip of the thumb meets, the best over
/// all digits if none is called thumb. Two points meet if some posture within the limits brings
/// them within 10 mm, centres of tips 20 mm; flesh may overlap on the way, and orientations do not
/// count. Postures are searched from 12 random starts by damped least squares clamped to the
/// limits. Source: [Kapandji1986].
[[nodiscard]] Opposition opposition(const ComparedHand& hand, std::mt19937& random,
                                    const Progress& progress = {});

}  // namespace thenar
