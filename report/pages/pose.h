#pragma once

/// Poses of subjects and robots as a page: joints, bones or links, and tips in space and in rows.

#include "api/pose.h"
#include "report/json.h"

namespace thenar {

/// The whole page.
[[nodiscard]] Json page_of(const SubjectPoses& poses);
[[nodiscard]] Json page_of(const RobotPoses& poses);

}  // namespace thenar
