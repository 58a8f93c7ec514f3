// thenar import FILE [--out robot.toml|robot.urdf|world.toml|object.toml|mesh.stl..] [--json]
// [--strict]
//
// Reads a robot, world, object or mesh of any format, says what it holds and what was not
// understood, and writes it in another.

#include <filesystem>
#include <functional>
#include <memory>

#include <fmt/format.h>

#include "apps/commands.h"
#include "apps/import_report.h"
#include "apps/output_ending.h"
#include "base/error.h"
#include "base/shapes/mesh_check.h"
#include "base/shapes/mesh_mend.h"
#include "base/write_file.h"
#include "data/io/file_kind.h"
#include "data/io/graspit/xml_file.h"
#include "data/io/mesh/mesh_file.h"
#include "data/io/robot/urdf_export.h"
#include "data/io/toml_node.h"
#include "data/io/world/graspit_body.h"
#include "data/io/world/graspit_world.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct Options {
  std::string file, out;
  bool json = false;
  bool strict = false;
  bool repair = false;
  double scale = 1;  // of a mesh [m] per unit of its file
};

/// What was read, told, and ready to be written.
struct Imported {
  Json report;
  std::vector<std::string> endings;               // of outputs that it can be written to
  std::function<void(const std::string&)> write;  // to a path
};

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

Imported import_robot_file(const std::string& path) {
  const RobotSpec robot = import_robot(path);
  return {report(robot, find_robot_kind(path)), {".toml", ".urdf"}, [=](const std::string& out) {
            RobotSpec moved = robot;
            for (RobotLink& link : moved.links)
              point_to(link.shapes, fs::path(path).parent_path(), out);
            if (fs::path(out).extension() == ".toml") {
              write_file(out, robot_toml(moved));
            } else {
              for (const std::string& warning : write_urdf(out, moved))
                fmt::print(stderr, "{}: {}\n", out, warning);
            }
          }};
}

Imported import_body(const BodySpec& body, const std::string& kind, const std::string& path,
                     const std::vector<std::string>& warnings) {
  return {report(body, kind, warnings), {".toml"}, [=](const std::string& out) {
            BodySpec moved = body;
            point_to(moved.shapes, fs::path(path).parent_path(), out);
            write_file(out, object_toml(moved));
          }};
}

Imported import_world(const WorldSpec& world, const std::string& kind, const std::string& path,
                      const std::vector<std::string>& warnings) {
  return {report(world, kind, warnings), {".toml"}, [=](const std::string& out) {
            WorldSpec moved = world;
            const fs::path folder = fs::path(path).parent_path();
            for (PlacedBody& body : moved.bodies) {
              point_to(body.file, folder, out);
              point_to(body.body.shapes, folder, out);
            }
            for (PlacedHand& hand : moved.hands) point_to(hand.file, folder, out);
            point_to(moved.materials_file, folder, out);
            write_file(out, world_toml(moved));
          }};
}

Imported import_mesh(const Options& options) {
  TriangleMesh mesh = read_mesh(options.file, options.scale);
  std::string repaired;
  const std::size_t holes = check_mesh(mesh).holes.size();
  if (options.repair) {
    MendedMesh mended = mend_mesh(mesh);
    mesh = std::move(mended.mesh);
    repaired = mended.done;
  }
  Json told = report(mesh, fs::path(options.file).stem());
  told["holes_closed"] = holes - told["holes"].size();
  told["repaired"] = repaired;
  return {told, {".obj", ".stl", ".ply", ".off"}, [=](const std::string& out) {
            write_mesh(out, mesh);
          }};
}

bool is_mesh(const std::string& path) {
  try {
    (void)mesh_format(path);
    return true;
  } catch (const DataError&) {
    return false;
  }
}

Imported import_xml(const std::string& path) {
  const std::string root = XmlFile(path).root_name();
  if (root == "world") {
    const GraspitWorld read = read_graspit_world(path);
    return import_world(read.world, "GraspIt! world", path, read.warnings);
  }
  if (root == "robot" || root == "mujoco" || root == "mujocoinclude")
    return import_robot_file(path);
  const GraspitBody read = read_graspit_body(path);
  return import_body(read.body, "GraspIt! body", path, read.warnings);
}

Imported import_toml(const std::string& path) {
  const FileKind kind = find_file_kind(path);
  if (kind == FileKind::kRobot) return import_robot_file(path);
  if (kind == FileKind::kObject) return import_body(read_object(path), "object", path, {});
  if (kind == FileKind::kWorld) return import_world(read_world(path), "world", path, {});
  throw DataError(path, 1,
                  fmt::format("wanted a robot, an object, a world or a mesh, got a file "
                              "of kind '{}'",
                              name_of(kind)));
}

Imported import_file(const Options& options) {
  const std::string& path = options.file;
  if (is_mesh(path)) return import_mesh(options);
  require(!options.repair && options.scale == 1,
          "--repair and --scale are for meshes, '{}' is none", path);
  const std::string text = read_text_file(path);
  const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  if (first != std::string::npos && text[first] == '<') return import_xml(path);
  if (fs::path(path).extension() == ".cfg") return import_robot_file(path);  // refused by name
  return import_toml(path);
}

void run(const Options& options) {
  const Imported imported = import_file(options);
  require_ending(options.out, imported.endings);
  fmt::print("{}{}", options.json ? imported.report.dump(2) : report_text(imported.report),
             options.json ? "\n" : "");
  const std::size_t warnings = imported.report.at("warnings").size();
  require(!options.strict || warnings == 0, "--strict: {} warning{} about '{}'; nothing is written",
          warnings, warnings == 1 ? "" : "s", options.file);
  if (!options.out.empty()) imported.write(options.out);
}

}  // namespace

void add_import(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "import", "Read a robot, world, object or mesh of any format; say what it holds; convert it");
  command
      ->add_option(
          "file", options->file,
          "URDF, MJCF, GraspIt! XML, TOML, or OBJ, STL, PLY, OFF, glTF, Collada, VRML, Inventor")
      ->required();
  command->add_option(
      "--out", options->out,
      "Robots to .toml or .urdf, objects and worlds to .toml, meshes to .obj, .stl, "
      ".ply or .off");
  command->add_flag("--json", options->json, "Print JSON");
  command->add_option("--scale", options->scale, "Metres per unit of a mesh file");
  command->add_flag("--repair", options->repair, "Mend a mesh: close holes, turn triangles");
  command->add_flag("--strict", options->strict, "Fail if there are warnings");
  command->callback([options] { run(*options); });
}

}  // namespace thenar
