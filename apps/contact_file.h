#pragma once

/// Contacts of a grasp as `thenar quality` reads them.

#include <string>
#include <vector>

#include "grasp/quality/wrench_set.h"

namespace thenar {

struct FileContact {
  Contact contact;               // its point, normal and coefficients
  double normal_length = 1;      // as given, before it was made unit [1]
  std::vector<Wrench> wrenches;  // torque already divided by the scale; empty: its cone counts
};

struct ContactFile {
  Eigen::Vector3d centre_of_mass;  // [m] (3)
  double torque_scale;             // [m]
  std::vector<FileContact> contacts;
  std::vector<std::string> warnings;  // keys ignored, normals made unit, what looks like a mistake
};

/// Reads {"centre_of_mass": [x, y, z], "torque_scale": m, "contacts": [{"position": [x, y, z],
/// "normal": [x, y, z], "friction": mu, "torsion": m?, "wrenches": [[fx, fy, fz, tx, ty, tz],
/// ...]?}]}; see docs/data_format.md. Normals are made unit, with a warning where their length is
/// off by 1e-3 or more. A contact with wrenches needs no position, normal and friction. What may be
/// left out may be null; no number may be beyond 1e12, no scale below 1e-12. Keys that are not
/// known are ignored with a warning, but for those that look like a known one misspelt.
/// @throws DataError `path:line: ...`: what was wanted, and what came.
[[nodiscard]] ContactFile read_contact_file(const std::string& path);

}  // namespace thenar
