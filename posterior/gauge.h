#pragma once

/// Shifts of joint axes along themselves, which no measurement can identify (gauge freedoms).

#include <vector>

#include "kinematics_fit/fit_problem.h"

namespace thenar {

/// Shift s of a joint axis along its initial direction d0. Tilted by (u, v), the axis is the line
///   p + s d0 + a e1 + b e2 + R (d0 + u e1 + v e2),
/// which is the same line without s, but with a - s u and b - s v [m]. So s can be left out without
/// loss.
struct Gauge {
  int along = 0;   // coordinate of s
  int point[2]{};  // coordinates of a and b; -1: the axis is not tilted and they have no effect
  int tilt[2]{};   // parameters u and v
};

/// Finds the shifts along an axis that can be left out: shifts that move nothing else, of axes that
/// are not tilted or whose point is free wherever the shift is, in the population or in specimens.
/// @return one gauge per such axis, in the order of the parameters
[[nodiscard]] std::vector<Gauge> find_gauges(const FitProblem& problem);

/// Returns the point with all gauges at zero that predicts the same forces (size).
/// @param gauges  from find_gauges()
/// @param z       any point of the fit [1] (size)
[[nodiscard]] Eigen::VectorXd without_gauges(const FitProblem& problem,
                                             const std::vector<Gauge>& gauges, Eigen::VectorXd z);

}  // namespace thenar
