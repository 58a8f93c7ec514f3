#pragma once

#include <Eigen/Core>

#include "tendons/tip_statics.h"

namespace thenar {

/// The statics of a published tip map  (f; axes' m) = A t.
///
/// Its "joints" are the rows of the map: three of force, then k moment components about given
/// axes. So J' = [1; 0], W' = [0; axes'], R = A', and no passive torque.
///
/// @param A            force rows [N/N], then moment rows [N m/N]    (3 + k) x m
/// @param axes         axis of each moment row, world frame          3 x k        [1]
/// @param max_tension  F0, each >= 0, infinite if unknown            m            [N]
/// @throws InputError if shapes disagree, A or axes is not finite, or F0 has a negative entry.
/// Source: such maps are given in [ValeroCuevas1998], [Cohn2018].
[[nodiscard]] TipStatics statics_of_map(const Eigen::Ref<const Eigen::MatrixXd>& A,
                                        const Eigen::Ref<const Eigen::Matrix3Xd>& axes,
                                        const Eigen::Ref<const Eigen::VectorXd>& max_tension);

}  // namespace thenar
