#pragma once

/// The published tip-force map of an index finger, shared by tests of tendons/.

#include <Eigen/Core>

#include "tendons/forces/tip_map.h"

namespace thenar {

/// Rows Fx Fy Fz [N/N] and tx [N m/N], columns FDP FDS EIP EDC LUM DI PI: the map J^-T R' of an
/// index finger and its F0, as distributed in [CohnStf] (github.com/bc/stfeasibility, R/main.r).
inline TipStatics published_index() {
  Eigen::MatrixXd A(4, 7);
  A << -0.08941, -0.0447, -0.009249, 0.03669, 0.1421, 0.2087, -0.2138,  //
      -0.04689, -0.1496, 0.052, 0.052, 0.0248, 0, 0.0248,               //
      0.06472, 0.001953, -0.1518, -0.1518, 0.2919, 0.0568, 0.2067,      //
      0.003081, -0.002352, -0.0001649, -0.0001649, -0.0004483, 0.0001579, -0.000685;
  Eigen::VectorXd F0(7);
  F0 << 123, 219, 23.52, 91.74, 21.6, 124.8, 129.6;  // [N]
  TipStatics statics = statics_from_matrix(A, Eigen::Vector3d::UnitX(), F0);
  statics.muscles = {"FDP", "FDS", "EIP", "EDC", "LUM", "DI", "PI"};
  return statics;
}

}  // namespace thenar
