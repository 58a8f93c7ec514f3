#pragma once

/// A scene as plain data: hands, objects, obstacles, what they are made of.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/shapes/shape_spec.h"
#include "base/spatial.h"

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
  std::string material;
  std::optional<BodyMass> mass;  // absent: from the shapes at `density`
  double density = 0;            // [kg/m^3]; 0 if unknown
};

/// A body in its place.
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
  Pose<double> X_WH;                      // of its base link
  std::map<std::string, double> posture;  // coordinate -> [rad] or [m]
  std::string carrier, carrier_link;      // mounted on that hand or arm; empty: free
};

/// From where a picture is taken.
struct Camera {
  Eigen::Vector3d eye{0.4, -0.4, 0.3};  // [m] (3)
  Eigen::Vector3d target{0, 0, 0};      // [m] (3)
};

struct WorldSpec {
  std::string name;
  std::vector<PlacedHand> hands;
  std::vector<PlacedBody> bodies;
  Camera camera;
};

/// Reads an object (data/objects) or a world from TOML; formats are in docs/data_format.md. Files
/// named in them are found beside them.
/// @throws DataError  `path:line: what was wanted, what came`.
[[nodiscard]] BodySpec read_object(const std::string& path);
[[nodiscard]] WorldSpec read_world(const std::string& path);

/// A world as TOML that read_world() reads without loss; every double survives to the bit.
[[nodiscard]] std::string world_toml(const WorldSpec& world);

}  // namespace thenar
