#pragma once

/// Worlds as plain data: hands, objects, obstacles, and their materials.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/provenance.h"
#include "base/spatial.h"
#include "data/io/world/materials.h"
#include "geometry/shape_spec.h"

namespace thenar {

/// Mass of a rigid body.
struct BodyMass {
  double mass;              // [kg]
  Eigen::Vector3d com;      // centre of mass in the body's frame [m] (3)
  Eigen::Matrix3d inertia;  // inertia about com [kg m^2] (3, 3)
};

/// An object or obstacle.
struct BodySpec {
  std::string name;
  std::string description;
  std::string source;             // citation keys
  std::vector<ShapeSpec> shapes;  // shapes whose union is the body
  std::string material;           // empty: unknown
  std::optional<BodyMass> mass;   // stated mass; absent: computed from the shapes by the next two
  double uniform_mass = 0;        // spread evenly over the shapes [kg]; 0: unknown
  double density = 0;             // [kg/m^3]; 0: that of the material
  FileDigests files = {};  // digests of the files that were read for it; not written to files
};

/// A body at its pose. A body with a file is written to worlds as its name, its material and this
/// file.
struct PlacedBody {
  BodySpec body;
  std::string file;  // file from which it was read, as written; empty: written out in the world
  Pose<double> X_WB;
  bool dynamic = true;  // false: an obstacle that does not move
};

/// A hand at its pose.
struct PlacedHand {
  std::string name;                       // "barrett", "human:tendons"; api/ builds hands by name
  std::string file;                       // robot or subject, as written; empty: by name
  Pose<double> X_WH;                      // pose of its base link, in the world or on carrier_link
  std::map<std::string, double> posture;  // coordinate -> [rad] or [m]
  std::string carrier, carrier_link;      // hand or arm on which it is mounted; empty: free
};

/// Camera of a picture.
struct Camera {
  Eigen::Vector3d eye{0.4, -0.4, 0.3};  // [m] (3)
  Eigen::Vector3d target{0, 0, 0};      // [m] (3)
};

/// Citation keys that a file defines itself, with their references.
using OwnSources = std::map<std::string, std::string>;

/// A whole world.
struct WorldSpec {
  std::string name;
  std::string description;
  std::string source = "Scene";  // citation keys of its numbers
  OwnSources own_sources{{"Scene", "Arranged for this scene"}};
  std::string materials_file;  // materials file as written; empty: the built-in table alone
  Materials materials = built_in_materials();  // materials of the file, over the built-in table
  std::string folder;  // folder that paths are relative to; empty: working directory
  std::vector<PlacedHand> hands;
  std::vector<PlacedBody> bodies;
  Camera camera;
  FileDigests files = {};  // digests of the world, its materials and bodies; hands are not read yet
};

/// Reads an object (data/objects) or a world (data/worlds) from TOML; docs/data_format.md describes
/// the formats. Files named in them are relative to their folder.
/// @throws DataError  `path:line: what was wanted, what came`.
[[nodiscard]] BodySpec read_object(const std::string& path);
[[nodiscard]] BodySpec parse_object(const std::string& text, const std::string& path);
[[nodiscard]] WorldSpec read_world(const std::string& path);
[[nodiscard]] WorldSpec parse_world(const std::string& text, const std::string& path);

/// Returns an object or a world as TOML that its reader reads without loss, every double to the
/// bit. `folder` and `materials` are not written: they follow from where it is read.
/// @throws InputError if a number is not finite, or an inertia not symmetric.
[[nodiscard]] std::string object_toml(const BodySpec& body);
[[nodiscard]] std::string world_toml(const WorldSpec& world);

/// Returns the mass of a body [kg]: as stated, or spread evenly over the union of its shapes by its
/// mass, its density or the density of its material, the first of these that is known. Overlapping
/// parts count once; union_mass() says when that is exact.
/// @throws InputError if neither mass nor density is known, with the keys that state them, or if
///         the shapes enclose nothing.
[[nodiscard]] BodyMass body_mass(const BodySpec& body,
                                 const Materials& materials = built_in_materials());

}  // namespace thenar
