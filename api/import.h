#pragma once

/// Robots, worlds, objects and meshes of any format: their content, and conversion to other
/// formats.
///
///     ImportRequest request;
///     request.file = "gripper.urdf";
///     const Imported gripper = import_file(request);
///     write_imported(gripper, "gripper.toml");

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
  std::string file;               // a robot, world, object or mesh; required
  bool repair = false;            // repair meshes, also those of bodies
  double scale = 1;               // length of one unit of a mesh file [m]
  std::string units;              // unit of a mesh, instead of `scale`: "m", "cm", "mm", "in"
  std::optional<double> mass;     // mass of a mesh or an object, spread evenly over it [kg]
  std::optional<double> density;  // density, instead of a mass [kg/m^3]
  std::string materials;          // file of materials, over the built-in table; empty: that table
  std::string material;           // name in materials.toml, of a mesh or an object
};

/// Result of an import.
struct Imported {
  ImportRequest request;  // request that was answered
  Outcome outcome;        // warnings: all, also those of a robot
  std::string kind;       // "URDF", "GraspIt! body", "mesh"
  std::variant<RobotSpec, BodySpec, WorldSpec, MeshContent> thing;  // content of the file
  std::optional<MeshFacts> mesh;                                    // facts of a mesh
  std::optional<BodySpec> body;  // mesh as an object, where its mass or material is stated
};

/// Reads a file of any format.
/// @throws DataError or InputError for a wrong file, an open mesh of a body without `repair`, a
/// mass for a surface without volume, or an unknown material or unit.
[[nodiscard]] Imported import_file(const ImportRequest& request);

/// Returns the file name endings of formats that can store it: ".toml", ".urdf".
[[nodiscard]] std::vector<std::string> writable_endings(const Imported& imported);

/// Returns a sentence for each property that a file with the ending of `out` cannot store.
[[nodiscard]] std::vector<std::string> unsupported_properties(const Imported& imported,
                                                              const std::string& out);

/// Writes it; paths in the file are relative to the folder of `out`.
/// @returns guesses that were made: how a hand grasps
/// @throws InputError if it cannot be written.
std::vector<std::string> write_imported(const Imported& imported, const std::string& out);

}  // namespace thenar
