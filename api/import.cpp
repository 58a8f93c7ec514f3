#include "api/import.h"

#include <filesystem>
#include <map>

#include <fmt/format.h>

#include "api/named/files.h"
#include "api/named/material_names.h"
#include "api/named/portable_world.h"
#include "base/error.h"
#include "base/lists.h"
#include "base/nearest_name.h"
#include "base/words.h"
#include "data/io/file_kind.h"
#include "data/io/graspit/xml_file.h"
#include "data/io/mesh/repair_shape.h"
#include "data/io/mesh/stl_copy.h"
#include "data/io/robot/urdf.h"
#include "data/io/toml_node.h"
#include "data/io/world/graspit_body.h"
#include "data/io/world/graspit_world.h"
#include "geometry/mesh_faults.h"
#include "geometry/repair_to_solid.h"
#include "grasp/robot/infer_closing.h"
#include "grasp/robot/infer_hand.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

/// Makes the meshes of a body solids: repairs those of obstacles, and others if requested.
/// @throws DataError naming the holes
void settle_meshes(BodySpec& body, const std::string& file, bool mend,
                   std::vector<std::string>& warnings, bool dynamic) {
  const std::string owner = fmt::format("{} '{}'", dynamic ? "body" : "obstacle", body.name);
  // A body that moves needs a volume for its mass, so open meshes are refused unless repair was
  // asked for.
  if (dynamic && !mend) {
    try {
      for (const ShapeSpec& shape : body.shapes) require_solid(shape, owner);
    } catch (const InputError& error) {
      throw DataError(
          file, 1,
          fmt::format("{}{}", error.what(), any_is_flat(body.shapes) ? "" : "; repairing mends it"),
          any_is_flat(body.shapes) ? "" : "repair");
    }
    // A closed surface that faces inwards is turned in any case, with a note.
    note_turned(body.shapes, owner, warnings);
    return;
  }
  // Obstacles need no mass, so repair them without a request.
  repair_shapes(body.shapes, owner, warnings);
  if (body.shapes.empty())
    throw DataError(file, 1, fmt::format("{} is left without a shape", owner));
}

bool states_mass(const ImportRequest& request) {
  return request.mass || request.density || !request.material.empty();
}

void check_statements(const ImportRequest& request) {
  // A mass follows from a density and a volume, so only one of the two can be stated.
  require_field("density", !request.mass || !request.density,
                "wanted a mass or a density, got both");
  require_field("mass", !request.mass || *request.mass > 0, "wanted a mass above 0 kg, got {}",
                request.mass.value_or(0));
  require_field("density", !request.density || *request.density > 0,
                "wanted a density above 0 kg/m3, got {}", request.density.value_or(0));
  // Refuse an unknown material here, where its name was typed.
  const std::vector<std::string> names = names_of(materials_of_file(request.materials).materials);
  if (!request.material.empty()) (void)index_of_name(request.material, names, "material");
}

/// Puts the stated mass and material into a body, with centre and inertia of its volume. A material
/// of unknown density, as the surface alone is known, leaves the mass as it was.
void state_mass(const ImportRequest& request, BodySpec& body) {
  if (!states_mass(request)) return;
  if (!request.material.empty()) body.material = request.material;
  // A stated mass or density replaces whatever the file says.
  if (request.mass || request.density) {
    body.mass.reset();
    body.uniform_mass = request.mass.value_or(0);
    body.density = request.density.value_or(0);
  }
  const Materials materials = materials_of_file(request.materials);
  // Mass is computed only if something states it: directly, by density or by the material.
  const bool known = body.uniform_mass > 0 || body.density > 0 ||
                     (!body.material.empty() && materials.at(body.material).density > 0);
  if (body.mass || !known) return;
  body.mass = body_mass(body, materials);
  Eigen::Matrix3d& inertia = body.mass->inertia;
  inertia = ((inertia + inertia.transpose()) / 2).eval();  // rounding leaves it not quite so
}

Outcome warned(std::vector<std::string> warnings) {
  Outcome outcome;
  outcome.warnings = std::move(warnings);
  return outcome;
}

Imported import_robot_file(const ImportRequest& request) {
  RobotSpec robot = import_robot(request.file);
  return {
      request, warned(robot.warnings), name_of(find_robot_kind(request.file)), std::move(robot), {},
      {}};
}

Imported import_body(BodySpec body, const std::string& kind, const ImportRequest& request,
                     std::vector<std::string> warnings) {
  settle_meshes(body, request.file, request.repair, warnings, true);
  append_all(warnings, size_warnings(body.shapes, fmt::format("object '{}'", body.name)));
  state_mass(request, body);
  append_all(warnings, density_warnings(body, fmt::format("object '{}'", body.name)));
  return {request, warned(std::move(warnings)), kind, std::move(body), {}, {}};
}

Imported import_world(WorldSpec world, const std::string& kind, const ImportRequest& request,
                      std::vector<std::string> warnings) {
  // Settle every mesh of the world, obstacles too.
  for (PlacedBody& placed : world.bodies) {
    const std::size_t before = warnings.size();
    settle_meshes(placed.body, request.file, request.repair, warnings, placed.dynamic);
    if (warnings.size() > before) placed.file.clear();  // it holds another surface now
  }
  // Sizes far from those of the hand suggest wrong units.
  for (const PlacedBody& placed : world.bodies) {
    if (!placed.dynamic) continue;  // floors are large
    const std::string owner = fmt::format("object '{}'", placed.body.name);
    append_all(warnings, size_warnings(placed.body.shapes, owner));
  }
  return {request, warned(std::move(warnings)), kind, std::move(world), {}, {}};
}

/// [m] in one unit of a mesh file.
double scale_of(const ImportRequest& request) {
  static const std::map<std::string, double> units{
      {"", 1}, {"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}, {"in", 0.0254}};
  const auto found = units.find(request.units);
  require_field("units", found != units.end(), "wanted units of m, cm, mm or in, got '{}'",
                request.units);
  require_field("scale", request.units.empty() || request.scale == 1,
                "wanted units or a scale, got both");
  return found->second * request.scale;
}

/// A mesh as an object: its exact shapes if there are some.
/// @param as_in_file  triangles are named, not written out
BodySpec object_of(const MeshContent& content, const ImportRequest& request, bool as_in_file) {
  BodySpec body;
  body.name = fs::path(request.file).stem().string();
  // Prefer exact solids such as boxes and spheres to their triangles.
  body.shapes = content.exact;
  if (!body.shapes.empty()) return body;
  ShapeSpec shape;
  shape.kind = ShapeKind::kMesh;
  shape.mesh = content.mesh;
  // Refer to the mesh in its file, at its scale, unless repair has changed the triangles.
  if (as_in_file) {
    shape.mesh_file = request.file;
    shape.mesh_scale = scale_of(request);
  }
  body.shapes = {shape};
  std::vector<std::string> ignored;
  settle_meshes(body, request.file, false, ignored, true);  // it was mended before, if asked to
  return body;
}

/// Returns the first reason why triangles bound no volume, with its remedy.
std::string why_no_volume(const MeshFacts& facts) {
  const MeshReport& surface = facts.surface;
  const MeshFaults& faults = facts.faults;
  // Report the cause that makes all later ones meaningless first: a flat mesh has no inside at all.
  if (faults.flat)
    return "it is flat, all its triangles lie in one plane; no repair gives it a thickness";
  if (faults.holes > 0)
    return fmt::format("its surface is open in {}; repairing closes it",
                       counted(static_cast<std::size_t>(faults.holes), "place"));
  if (faults.seams > 0)
    return fmt::format(
        "corners of its triangles lie on edges of others in {}; repairing cuts these",
        counted(static_cast<std::size_t>(faults.seams), "place"));
  if (faults.flaps > 0)
    return fmt::format("{} of fins or sheets {} nothing; repairing leaves them out",
                       counted(static_cast<std::size_t>(faults.flaps), "triangle"),
                       faults.flaps == 1 ? "encloses" : "enclose");
  // The remaining causes are local, and repair mends each of them.
  if (!surface.holes.empty() && surface.degenerate > 0)
    return fmt::format("edges are open beside {} of no area; repairing drops such triangles",
                       counted(surface.degenerate, "triangle"));
  if (surface.nonmanifold_edges > 0)
    return fmt::format("{} of its surface {} more than two triangles; repairing mends this",
                       counted(surface.nonmanifold_edges, "edge"),
                       surface.nonmanifold_edges == 1 ? "has" : "have");
  if (surface.reversed_edges > 0)
    return fmt::format("its triangles face opposite ways along {}; repairing turns them",
                       counted(surface.reversed_edges, "edge"));
  return "its surface is turned inside out; repairing turns it";
}

/// @throws InputError where there is no volume that a mass could fill
void require_volume(const ImportRequest& request, const MeshFacts& facts) {
  require_field("repair", facts.solid, "'{}' has no volume that a mass could fill: {}",
                request.file, why_no_volume(facts));
}

/// Returns doubts about the mass of a mesh with a material, or the reason why it has no mass.
std::vector<std::string> mass_warnings(const BodySpec& body) {
  const std::string owner = fmt::format("object '{}'", body.name);
  if (body.mass || body.uniform_mass > 0 || body.density > 0) return density_warnings(body, owner);
  return {fmt::format("{} has no mass: '{}' has no density; wanted a mass or a density", owner,
                      body.material)};
}

Imported import_mesh(const ImportRequest& request) {
  MeshContent content = read_mesh_content(request.file, scale_of(request));
  // Remember how many holes there were, to report how many the repair has closed.
  const std::size_t holes = check_mesh(content.mesh).holes.size();
  std::string repaired;
  if (request.repair) {
    try {
      RepairedSolid mended = watertight_mesh(content.mesh);
      content.mesh = std::move(mended.mesh);
      repaired = mended.done;
    } catch (const InputError& error) {
      throw InputError(fmt::format("'{}': {}", request.file, error.what()));
    }
  }
  // Look at the surface as it is now, after the repair if there was one.
  MeshFacts facts = compute_mesh_facts(content);
  facts.closed = holes - facts.surface.holes.size();
  facts.repaired = repaired;
  // A stated mass turns the mesh into an object, for which it has to bound a volume.
  std::optional<BodySpec> body;
  if (states_mass(request)) {
    require_volume(request, facts);
    body = object_of(content, request, facts.repaired.empty());
    state_mass(request, *body);
  }
  std::vector<std::string> warnings = facts.warnings;
  if (body) append_all(warnings, mass_warnings(*body));
  return {request,        warned(std::move(warnings)), "mesh", std::move(content), std::move(facts),
          std::move(body)};
}

Imported import_xml(const ImportRequest& request) {
  const std::string root = XmlFile(request.file).root_name();
  if (root == "world") {
    const GraspitWorld read = read_graspit_world(request.file);
    return import_world(read.world, "GraspIt! world", request, read.warnings);
  }
  if (root == "robot" || root == "mujoco" || root == "mujocoinclude" || root == "sdf")
    return import_robot_file(request);
  const GraspitBody read = read_graspit_body(request.file);
  return import_body(read.body, "GraspIt! body", request, read.warnings);
}

FileKind kind_of_toml(const std::string& path) {
  if (fs::path(path).extension() == ".toml") return find_file_kind(path);
  try {
    return find_file_kind(path);
  } catch (const DataError&) {
    throw DataError(path, 1,
                    "wanted a robot (URDF, MJCF, GraspIt! XML, TOML), an object or a world "
                    "(GraspIt! XML, TOML), or a mesh (.obj, .stl, .ply, .off, .gltf, .glb, .dae, "
                    ".wrl, .vrml, .iv)");
  }
}

Imported import_toml(const ImportRequest& request) {
  const std::string& path = request.file;
  const FileKind kind = kind_of_toml(path);
  if (kind == FileKind::kRobot) return import_robot_file(request);
  if (kind == FileKind::kObject) return import_body(read_object(path), "object", request, {});
  if (kind == FileKind::kWorld) return import_world(read_world_at(path, ""), "world", request, {});
  throw DataError(path, 1,
                  fmt::format("wanted a robot, an object, a world or a mesh, got a file "
                              "of kind '{}'",
                              name_of(kind)));
}

Imported import_any(const ImportRequest& request) {
  const std::string& path = request.file;
  // Refuse files of other commands with a hint, then options that the kind does not take.
  require_kind(path, {"robot", "object", "world", "mesh"});
  if (is_mesh_file(path)) return import_mesh(request);
  require_field(request.units.empty() ? "scale" : "units",
                request.scale == 1 && request.units.empty(),
                "scales and units are for meshes, '{}' is not a mesh", path);
  // Tell XML from the rest by the first sign of the text, behind a byte order mark and blanks.
  if (first_sign(read_text_file(path)) == '<') return import_xml(request);
  const std::string ending = fs::path(path).extension();
  if (ending == ".cfg" || ending == ".wld") return import_robot_file(request);  // refused by name
  return import_toml(request);
}

}  // namespace

Imported import_file(const ImportRequest& request) {
  check_statements(request);
  Imported imported = import_any(request);
  const bool body = std::holds_alternative<BodySpec>(imported.thing) ||
                    std::holds_alternative<MeshContent>(imported.thing);
  require(body || !states_mass(request),
          "masses, densities and materials are for objects and meshes, '{}' is a {}", request.file,
          std::holds_alternative<WorldSpec>(imported.thing) ? "world" : "robot");
  return imported;
}

// Writing in another format.
namespace {

/// A file as seen from the folder of `out`. @param from  folder that it is relative to
void point_to(std::string& file, const fs::path& from, const std::string& out) {
  if (file.empty()) return;
  file = fs::absolute(from / file)
             .lexically_normal()
             .lexically_relative(fs::absolute(out).parent_path().lexically_normal())
             .string();
}

void point_to(std::vector<ShapeSpec>& shapes, const fs::path& from, const std::string& out) {
  for (ShapeSpec& shape : shapes) point_to(shape.mesh_file, from, out);
}

/// Adds guesses of how a robot grasps, where its format does not say, for a hand or a jaw that
/// holds a ball against a fixed jaw; returns other robots unchanged.
RobotSpec with_guesses(const RobotSpec& robot) {
  RobotSpec kept = robot;  // it can be told and written, but not grasp
  try {
    // Guess a palm, digits and closing directions from the geometry.
    RobotSpec guessed = graspable(robot);
    const std::size_t digits = digits_in(guessed).size();
    const bool one_jaw = digits == 1 && robot.dofs.size() == 1;
    // Accept the guess for several digits; a single jaw must at least close against something
    // fixed.
    if (digits > 1 || (one_jaw && infer_closing(guessed, {true, false}).facing)) return guessed;
    if (one_jaw)
      kept.warnings.emplace_back(
          "how it grasps is not guessed: its only digit holds no ball against what is fixed");
  } catch (const InputError& error) {
    kept.warnings.push_back(fmt::format("how it grasps is not guessed: {}", error.what()));
  }
  return kept;
}

using Sentences = std::vector<std::string>;

/// Writes the robot as TOML with marked guesses, and returns the guesses.
Sentences write_thing(RobotSpec robot, const Imported& imported, const std::string& out) {
  // Let links refer to meshes as seen from the folder of the new file.
  for (RobotLink& link : robot.links)
    point_to(link.shapes, fs::path(imported.request.file).parent_path(), out);
  if (fs::path(out).extension() != ".toml") {
    (void)write_urdf(out, robot);  // unsupported_properties() has its warnings
    return {};
  }
  // Only formats without words for grasping are completed by guesses.
  const bool guess = imported.kind != name_of(RobotFileKind::kToml);
  StlFiles files(out);
  for (const RobotLink& link : robot.links) files.leave(link.shapes);
  for (RobotLink& link : robot.links) files.give(link.shapes, link.name);
  RobotSpec written = guess ? with_guesses(robot) : robot;
  // Report the guesses, which are the warnings that were added.
  Sentences guessed;
  for (std::size_t i = robot.warnings.size(); i < written.warnings.size(); ++i)
    guessed.push_back(written.warnings[i]);
  written.warnings = robot.warnings;  // guesses are comments of the file
  files.write(robot_toml(written, &robot));
  return guessed;
}

/// Writes an object, and meshes that have no file as STL files beside it.
void write_object(BodySpec body, const std::string& out) {
  StlFiles files(out);
  files.leave(body.shapes);
  files.give(body.shapes, body.name);
  files.write(object_toml(body));
}

Sentences write_thing(BodySpec body, const Imported& imported, const std::string& out) {
  point_to(body.shapes, fs::path(imported.request.file).parent_path(), out);
  write_object(std::move(body), out);
  return {};
}

Sentences write_thing(WorldSpec world, const Imported& imported, const std::string& out) {
  // Let bodies, hands and materials refer to their files as seen from the new file.
  const fs::path folder = fs::path(imported.request.file).parent_path();
  for (PlacedBody& body : world.bodies) {
    point_to(body.file, folder, out);
    point_to(body.body.shapes, folder, out);
  }
  for (PlacedHand& hand : world.hands) point_to(hand.file, folder, out);
  point_to(world.materials_file, folder, out);
  // Write meshes as STL files of their own unless a file states them already.
  StlFiles files(out);
  for (const PlacedBody& body : world.bodies) files.leave(body.body.shapes);
  for (PlacedBody& body : world.bodies)
    if (body.file.empty()) files.give(body.body.shapes, body.body.name);
  files.write(world_toml(world));
  return {};
}

Sentences write_thing(const MeshContent& content, const Imported& imported,
                      const std::string& out) {
  if (fs::path(out).extension() != ".toml") {
    write_mesh(out, content.mesh);
    return {};
  }
  // A mesh becomes an object, even if no mass was stated.
  BodySpec body = imported.body
                      ? *imported.body
                      : object_of(content, imported.request, imported.mesh->repaired.empty());
  point_to(body.shapes, "", out);
  write_object(std::move(body), out);
  return {};
}

}  // namespace

std::vector<std::string> writable_endings(const Imported& imported) {
  if (std::holds_alternative<RobotSpec>(imported.thing)) return {".toml", ".urdf"};
  if (std::holds_alternative<MeshContent>(imported.thing))
    return {".obj", ".stl", ".ply", ".off", ".toml"};
  return {".toml"};
}

std::vector<std::string> unsupported_properties(const Imported& imported, const std::string& out) {
  const std::string ending = fs::path(out).extension();
  if (const auto* robot = std::get_if<RobotSpec>(&imported.thing); robot && ending == ".urdf")
    return robot_urdf(*robot, "").warnings;
  if (imported.body && !ending.empty() && ending != ".toml")
    return {fmt::format("a mesh ({}) has neither mass nor material: write .toml", ending)};
  return {};
}

std::vector<std::string> write_imported(const Imported& imported, const std::string& out) {
  return std::visit([&](const auto& thing) { return write_thing(thing, imported, out); },
                    imported.thing);
}

}  // namespace thenar
