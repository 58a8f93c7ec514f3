#pragma once

/// Postures as people type them, in degrees.

#include <map>
#include <string>
#include <vector>

#include "base/units.h"
#include "data/io/subject.h"
#include "hand/skeleton.h"

namespace thenar {

/// Coordinates from `JOINT=degrees` pairs, or from plain degrees in the order of the joints.
/// @return q (coordinates) [rad]; joints not named stay at the reference posture
/// @throws InputError for an unknown joint, a wrong count, or what is no number.
[[nodiscard]] Eigen::VectorXd parse_posture(const Skeleton& skeleton,
                                            const std::vector<std::string>& texts);

/// Angles of frozen joints from `JOINT=degrees` pairs [rad].
/// @throws InputError for an unknown joint or an angle outside its limits.
[[nodiscard]] std::map<std::string, double> parse_frozen(const Subject& subject,
                                                         const std::vector<std::string>& texts);

/// Says on stderr which angles are outside their limits.
void warn_of_limits(const Skeleton& skeleton, const Eigen::VectorXd& q);

}  // namespace thenar
