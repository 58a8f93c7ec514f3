#pragma once

/// Robots, worlds, objects and meshes of any format: what they hold, and how to write them in
/// another.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "api/mesh_facts.h"
#include "data/io/mesh/mesh_file.h"
#include "data/io/robot/import_robot.h"
#include "data/io/world/world.h"
#include "solvers/status.h"

namespace thenar {

/// Options of an import: a file, and facts that the file does not state.
struct ImportRequest {
  std::string file;               // a robot, world, object or mesh
  bool repair = false;            // mend meshes, also of bodies
  double scale = 1;               // of a mesh [m] per unit of its file
  std::string units;              // of a mesh, in place of `scale`: "m", "cm", "mm", "in"
  std::optional<double> mass;     // of a mesh or an object, spread evenly over it [kg]
  std::optional<double> density;  // in place of a mass [kg/m^3]
  std::string materials;          // file of materials, over the built-in table; empty: that table
  std::string material;  // of a mesh or an object, as materials.toml has it; empty: as read
};

/// Result of an import.
struct Imported {
  ImportRequest request;
  Outcome outcome;   // warnings: all, also those of a robot
  std::string kind;  // "URDF", "GraspIt! body", "mesh"
  std::variant<RobotSpec, BodySpec, WorldSpec, MeshContent> thing;
  std::optional<MeshFacts> mesh;  // of a mesh
  std::optional<BodySpec> body;   // of a mesh whose mass or material is stated: as an object
};

/// Reads a file of any format.
/// @throws DataError or InputError where it is wrong; an open mesh of a body without `repair`, a
/// mass for a surface that has no volume, an unknown material or unit.
[[nodiscard]] Imported import_file(const ImportRequest& request);

/// Returns endings of files that it can be written to: ".toml", ".urdf".
[[nodiscard]] std::vector<std::string> endings_for(const Imported& imported);

/// Returns a sentence for each property that a file with the ending of `out` cannot store.
[[nodiscard]] std::vector<std::string> lost_in(const Imported& imported, const std::string& out);

/// Writes it; files that it names are named as seen from the folder of `out`.
/// @returns what was guessed on the way: how a hand grasps
/// @throws InputError if it cannot be written.
std::vector<std::string> write_imported(const Imported& imported, const std::string& out);

}  // namespace thenar
