#pragma once

/// Poses of subjects and robots as text, fields and rows.

#include <string>

#include "api/pose.h"
#include "report/fields.h"
#include "report/sweep_axes.h"

namespace thenar {

[[nodiscard]] std::string text_of(const SubjectPoses& poses);
[[nodiscard]] Fields fields_of(const SubjectPoses& poses);
/// Returns a table with a row for each posture: joints, places of tips, conditions.
[[nodiscard]] Table table_of(const SubjectPoses& poses);

[[nodiscard]] std::string text_of(const RobotPoses& poses);
[[nodiscard]] Fields fields_of(const RobotPoses& poses);
/// Returns a table with a row for each posture: joints, places of tips, or of links where there are
/// no tips.
[[nodiscard]] Table table_of(const RobotPoses& poses);

/// Returns the mobility of a tip in words: "regular: condition 3.2; moves least along (0, 1, 0)".
[[nodiscard]] std::string mobility_in_words(const TipPose& tip);

[[nodiscard]] SweepAxes axes_of(const SubjectPoses& poses);
[[nodiscard]] SweepAxes axes_of(const RobotPoses& poses);

/// Reported place of a pose: a tip, or a link of a robot without tips.
struct NamedPlace {
  std::string name;
  Eigen::Vector3d p;  // [m] (3)
};
[[nodiscard]] std::vector<NamedPlace> places_of(const SubjectPose& pose);
[[nodiscard]] std::vector<NamedPlace> places_of(const RobotPose& pose);

}  // namespace thenar
