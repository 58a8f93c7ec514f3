#pragma once

/// Published tip maps of a subject as TipStatics.

#include <string>

#include <Eigen/Core>

#include "data/io/subject.h"
#include "tendons/tip_statics.h"

namespace thenar {

/// Returns one of the subject's maps. @param name  empty: the first map of the digit
/// @throws InputError listing the available maps.
[[nodiscard]] const TipMap& find_tip_map(const Subject& subject, const std::string& digit,
                                         const std::string& name = "");

/// Builds the statics of a map; rows in the order Fx, Fy, Fz, then its moments. See
/// statics_from_matrix().
/// @throws InputError if the map lacks a force row.
[[nodiscard]] TipStatics statics_from_tip_map(const Subject& subject, const TipMap& map);

/// Returns the names of the moment rows, in the order of the columns of W of
/// statics_from_tip_map(): "tx".
[[nodiscard]] std::vector<std::string> moment_rows(const TipMap& map);

/// Builds the statics of a published tip map  (f; axes' m) = A t.
///
/// Its "joints" are the rows of the map: three of force, then k moment components about given axes.
/// So J' = [1; 0], W' = [0; axes'], R = A', and no passive torque.
///
/// @param A            force rows [N/N], then moment rows [N m/N]    (3 + k) x m
/// @param axes         axis of each moment row, world frame          3 x k        [1]
/// @param max_tension  F0, each >= 0, infinite if unknown            m            [N]
/// @throws InputError if shapes disagree, A or axes is not finite, or F0 has a negative entry.
/// Source: such maps are given in [ValeroCuevas1998], [Cohn2018].
[[nodiscard]] TipStatics statics_from_matrix(const Eigen::Ref<const Eigen::MatrixXd>& A,
                                             const Eigen::Ref<const Eigen::Matrix3Xd>& axes,
                                             const Eigen::Ref<const Eigen::VectorXd>& max_tension);

}  // namespace thenar
