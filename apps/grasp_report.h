#pragma once

/// Tables and the page of a grasp.

#include "apps/grasp_output.h"
#include "report/table.h"

namespace thenar {

/// Where a coordinate came to, and why no farther.
struct JointRow {
  std::string name;
  double value;            // [rad] or [m]
  std::string shown;       // in degrees or millimetres
  std::string stopped_by;  // name_of(StoppedBy)
  std::string why;         // in words
};

/// Of every coordinate; none where nothing was closed.
[[nodiscard]] std::vector<JointRow> joint_rows(const GraspQuestion& question,
                                               const CollisionHand& touching,
                                               const GraspAnswer& answer);

/// Position [mm], normal and friction of contacts, object frame.
[[nodiscard]] Table contact_table(const CollisionHand& touching,
                                  const std::vector<HandContact>& contacts);

}  // namespace thenar
