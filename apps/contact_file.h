#pragma once

/// Contacts of a grasp as `thenar quality` reads them.

#include <string>
#include <vector>

#include "grasp/contact/wrench_set.h"

namespace thenar {

struct FileContact {
  Contact contact;           // its point, normal and coefficients
  double normal_length = 1;  // as given, before it was made unit [1]
  std::vector<ScaledWrench>
      wrenches;  // torque already divided by the scale; empty: its cone counts
};

/// What a grasp is for: loads on the object, about its centre of mass [N, N m] (6).
struct FileTask {
  enum class Kind { kNone, kLoads, kBox, kEllipsoid };
  Kind kind = Kind::kNone;
  std::vector<ScaledWrench> loads;  // each load; or the lower and upper end of a box; or semi-axes
};

struct ContactFile {
  Eigen::Vector3d centre_of_mass;  // [m] (3)
  double torque_scale;             // [m]
  std::vector<FileContact> contacts;
  FileTask task;
  bool planar = false;                // in the plane z = 0, wrenches f_x, f_y and torque about z
  std::vector<std::string> warnings;  // keys ignored, normals made unit, what looks like a mistake
};

/// Reads {"centre_of_mass": [x, y, z], "torque_scale": m, "contacts": [{"position": [x, y, z],
/// "normal": [x, y, z], "friction": mu, "torsion": m?, "wrenches": [[fx, fy, fz, tx, ty, tz],
/// ...]?}]}; see docs/data_format.md. Normals are made unit, with a warning where their length is
/// off by 1e-3 or more. A contact with wrenches needs no position, normal and friction. What may be
/// left out may be null; no number may be beyond 1e12, no scale below 1e-12. Keys that are not
/// known are ignored with a warning, but for those that look like a known one misspelt.
/// With two numbers for the centre of mass everything is in a plane: places and normals of two
/// numbers, wrenches and loads of three (f_x, f_y, torque), no torsion.
/// @throws DataError `path:line: ...`: what was wanted, and what came.
[[nodiscard]] ContactFile read_contact_file(const std::string& path);

/// The same of one line of a stream. @param first_line  its number there, for messages
[[nodiscard]] ContactFile parse_contacts(const std::string& path, const std::string& text,
                                         int first_line);

}  // namespace thenar
