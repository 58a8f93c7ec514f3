#pragma once

/// Units and poses in GraspIt! XML.

#include <string>
#include <vector>

#include "base/spatial.h"
#include "data/io/graspit/xml_file.h"

namespace thenar {

inline constexpr double kGraspitLength = 1e-3;  // GraspIt!'s unit of length [m]
inline constexpr double kGraspitMass = 1e-3;    // GraspIt!'s unit of mass [kg]
inline constexpr double kGraspitForce = 1e-6;   // GraspIt!'s unit of force [N]
inline constexpr double kGraspitMoment = 1e-9;  // GraspIt!'s unit of torque [N m]

/// Reads the pose in a <transform>, or in an element that contains one: the product, left to right,
/// of
///   <fullTransform>(qw qx qy qz)[x y z]   a rotation, then a translation in the outer frame
///   <translation>x y z
///   <rotation>angle axis                  in degrees, about x, y or z, or about "ax ay az"
///   <rotationMatrix>nine numbers          column by column
/// with lengths in mm. The identity if there is none.
/// @param warnings  gets a line for every other element
/// @throws DataError if numbers are missing, or a rotation is off by more than 1e-3; smaller errors
///         are orthogonalised.
/// Source: [GraspIt] for the format.
[[nodiscard]] Pose<double> graspit_transform(const XmlFile& file, const pugi::xml_node& node,
                                             std::vector<std::string>& warnings);

}  // namespace thenar
