#pragma once

/// A scene as plain data: hands, objects, obstacles, what they are made of.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "data/io/world/materials.h"
#include "geometry/shape_spec.h"

namespace thenar {

/// Mass of a rigid body.
struct BodyMass {
  double mass;              // [kg]
  Eigen::Vector3d com;      // in the body's frame [m] (3)
  Eigen::Matrix3d inertia;  // about com [kg m^2] (3, 3)
};

/// An object or obstacle.
struct BodySpec {
  std::string name;
  std::string description;
  std::string source;             // citation keys
  std::vector<ShapeSpec> shapes;  // their union
  std::string material;           // empty: unknown
  std::optional<BodyMass> mass;   // as stated; absent: from the shapes, by the next two
  double uniform_mass = 0;        // spread evenly over the shapes [kg]; 0 if unknown
  double density = 0;             // [kg/m^3]; 0 if unknown: that of the material
};

/// A body in its place. One with a file is written to worlds as its name, its material and that
/// file.
struct PlacedBody {
  BodySpec body;
  std::string file;  // it was read from, as written; empty: written out in the world
  Pose<double> X_WB;
  bool dynamic = true;  // false: an obstacle that does not move
};

/// A hand in its place.
struct PlacedHand {
  std::string name;                       // "barrett", "human:tier4"; what builds it knows them
  std::string file;                       // robot or subject, as written; empty: by name
  Pose<double> X_WH;                      // of its base link, in the world or on carrier_link
  std::map<std::string, double> posture;  // coordinate -> [rad] or [m]
  std::string carrier, carrier_link;      // mounted on that hand or arm; empty: free
};

/// From where a picture is taken.
struct Camera {
  Eigen::Vector3d eye{0.4, -0.4, 0.3};  // [m] (3)
  Eigen::Vector3d target{0, 0, 0};      // [m] (3)
};

/// A citation key of a file's own, and what it stands for.
using OwnSources = std::map<std::string, std::string>;

struct WorldSpec {
  std::string name;
  std::string description;
  std::string source = "Scene";  // citation keys of its numbers
  OwnSources own_sources{{"Scene", "Arranged for this scene"}};
  std::string materials_file;                  // as written; empty: the built-in table alone
  Materials materials = built_in_materials();  // those of the file over the built-in ones
  std::string folder;  // where it was read from, which its files are relative to; empty: here
  std::vector<PlacedHand> hands;
  std::vector<PlacedBody> bodies;
  Camera camera;
};

/// Reads an object (data/objects) or a world (data/worlds) from TOML; formats are in
/// docs/data_format.md. Files named in them are found beside them.
/// @throws DataError  `path:line: what was wanted, what came`.
[[nodiscard]] BodySpec read_object(const std::string& path);
[[nodiscard]] BodySpec parse_object(const std::string& text, const std::string& path);
[[nodiscard]] WorldSpec read_world(const std::string& path);
[[nodiscard]] WorldSpec parse_world(const std::string& text, const std::string& path);

/// An object or a world as TOML that its reader reads without loss; every double survives to the
/// bit. `folder` and `materials` are not written: they follow from where it is read.
/// @throws InputError if a number is not finite, or an inertia not symmetric.
[[nodiscard]] std::string object_toml(const BodySpec& body);
[[nodiscard]] std::string world_toml(const WorldSpec& world);

// What a body weighs.

/// The mass of a body: as stated, or spread evenly over the union of its shapes by its mass, its
/// density or its material's, the first of these that is known.
///
/// Where shapes overlap nothing counts twice; union_mass() says where that is exact.
/// @throws InputError if neither mass nor density is known, with the keys that state them, or the
///         shapes enclose nothing.
[[nodiscard]] BodyMass body_mass(const BodySpec& body,
                                 const Materials& materials = built_in_materials());

}  // namespace thenar
