#pragma once

/// Contact sets: the contacts of a grasp and its task, in JSON files.

#include <string>
#include <vector>

#include <Eigen/Core>

namespace thenar {

using FileWrench = Eigen::Matrix<double, 6, 1>;  // force, then torque (6)

/// Contact in a file.
struct FileContact {
  Eigen::Vector3d position{0, 0, 0};  // [m] (3)
  Eigen::Vector3d normal{0, 0, 1};    // unit, into the object (3)
  double normal_length = 1;           // length as given, before the normal was made unit [1]
  double friction = 0;                // Coulomb's coefficient [1]
  double torsion = 0;                 // torque about the normal per normal force [m]
  int patch = -1;  // contacts with the same number form one face; -1: a separate face
  std::vector<FileWrench> wrenches;  // wrenches in place of the cone, torques already divided by
                                     // the scale [N] (6); empty: the cone counts
};

/// Task of a grasp: loads on the object, about its centre of mass.
struct FileTask {
  enum class Kind { kNone, kLoads, kBox, kEllipsoid };
  Kind kind = Kind::kNone;
  std::vector<FileWrench> loads;  // each load; or the lower and upper end of a box; or semi-axes
                                  // [N, N m] (6)
};

/// A contact set.
struct ContactFile {
  std::string path;                // path of the file, or its substitute in messages
  Eigen::Vector3d centre_of_mass;  // [m] (3)
  double torque_scale = 0;         // length that divides torques [m]
  std::vector<FileContact> contacts;
  FileTask task;
  bool planar = false;  // contacts in the plane z = 0, wrenches f_x, f_y and torque about z
  std::vector<std::string> warnings;  // warnings about ignored keys
};

/// Reads {"centre_of_mass": [x, y, z], "torque_scale": m, "contacts": [{"position": [x, y, z],
/// "normal": [x, y, z], "friction": mu, "torsion": m?, "wrenches": [[fx, fy, fz, tx, ty, tz],
/// ...]?}]}; see docs/data_format.md. Normals are made unit. A contact with wrenches needs no
/// position, normal and friction. Optional members may be null; no number may exceed 1e12, no scale
/// may be below 1e-12. Unknown keys are ignored with a warning, except those that look like a
/// misspelt key, which throw. With two numbers for the centre of mass the contact set is planar:
/// places and normals of two numbers, wrenches and loads of three (f_x, f_y, torque), no torsion.
/// JSON of `thenar grasp` is read, too: "centre_of_mass_m", "torque_scale_m", "position_m" ..
/// @throws DataError `path:line: ...`: what was wanted, and what came.
[[nodiscard]] ContactFile read_contact_file(const std::string& path);

/// Parses a contact set from a text, such as one line of a stream.
/// @param path        name of the file in messages
/// @param first_line  number of the text's first line
[[nodiscard]] ContactFile parse_contacts(const std::string& path, const std::string& text,
                                         int first_line = 1);

}  // namespace thenar
