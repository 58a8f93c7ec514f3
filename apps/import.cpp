// thenar import FILE [--out robot.toml|robot.urdf|world.toml|object.toml|mesh.stl..] [--json]
// [--strict] [--repair] [--units m|cm|mm|in]
//
// Reads a robot, world, object or mesh of any format, says what it holds and what was not
// understood, and writes it in another.

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <set>

#include <fmt/format.h>

#include "api/files.h"
#include "apps/commands.h"
#include "apps/import_report.h"
#include "apps/options.h"
#include "base/error.h"
#include "base/file_io.h"
#include "data/io/file_kind.h"
#include "data/io/graspit/xml_file.h"
#include "data/io/mesh/mesh_file.h"
#include "data/io/mesh/repair_shape.h"
#include "data/io/robot/urdf.h"
#include "data/io/toml_node.h"
#include "data/io/world/graspit_body.h"
#include "data/io/world/graspit_world.h"
#include "geometry/mesh_check.h"
#include "geometry/repair_to_solid.h"
#include "grasp/robot/infer_hand.h"
#include "report/json.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

struct ImportArguments {
  std::string file, out;
  bool json = false;
  bool strict = false;
  bool repair = false;
  double scale = 1;   // of a mesh [m] per unit of its file
  std::string units;  // of a mesh file, in place of `scale`
};

/// What was read, told, and ready to be written.
struct Imported {
  OrderedJson report;
  std::vector<std::string> endings;               // of outputs that it can be written to
  std::function<void(const std::string&)> write;  // to a path
  /// What a file of that ending could not say; empty: nothing is ever lost.
  std::function<std::vector<std::string>(const std::string&)> lost = {};
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

bool is_hand(const RobotSpec& robot) {
  std::set<std::string> digits;
  for (const RobotLink& link : robot.links)
    if (!link.digit.empty()) digits.insert(link.digit);
  return digits.size() > 1;
}

/// How a hand grasps, guessed where its format leaves it unsaid; another robot as it is.
RobotSpec with_guesses(const RobotSpec& robot) {
  try {
    RobotSpec guessed = graspable(robot);
    return is_hand(guessed) ? guessed : robot;
  } catch (const InputError& error) {
    RobotSpec kept = robot;  // it can be told and written, but not grasp
    kept.warnings.push_back(fmt::format("how it grasps is not guessed: {}", error.what()));
    return kept;
  }
}

/// The robot as TOML, with what was guessed marked, and told.
void write_robot_toml(const std::string& out, const RobotSpec& robot, RobotFileKind kind) {
  RobotSpec written = kind == RobotFileKind::kToml ? robot : with_guesses(robot);
  for (std::size_t i = robot.warnings.size(); i < written.warnings.size(); ++i)
    fmt::print(stderr, "{}: {}\n", out, written.warnings[i]);
  written.warnings = robot.warnings;  // guesses are comments of the file
  write_file(out, robot_toml(written, &robot));
}

Imported import_robot_file(const std::string& path) {
  const RobotSpec robot = import_robot(path);
  const RobotFileKind kind = find_robot_kind(path);
  return {report(robot, kind),
          {".toml", ".urdf"},
          [=](const std::string& out) {
            RobotSpec moved = robot;
            for (RobotLink& link : moved.links)
              point_to(link.shapes, fs::path(path).parent_path(), out);
            if (fs::path(out).extension() == ".toml")
              write_robot_toml(out, moved, kind);
            else
              (void)write_urdf(out, moved);  // its warnings were told before
          },
          [=](const std::string& out) {
            return fs::path(out).extension() == ".urdf" ? robot_urdf(robot, "").warnings
                                                        : std::vector<std::string>{};
          }};
}

/// A body whose meshes bound solids: mended where it stands still anyway, or if asked to.
/// @throws DataError naming the holes
void settle_meshes(BodySpec& body, const ImportArguments& options, bool dynamic,
                   std::vector<std::string>& warnings) {
  const std::string owner = fmt::format("{} '{}'", dynamic ? "body" : "obstacle", body.name);
  if (dynamic && !options.repair) {
    try {
      for (const ShapeSpec& shape : body.shapes) require_solid(shape, owner);
    } catch (const InputError& error) {
      throw DataError(options.file, 1, fmt::format("{}; --repair mends it", error.what()));
    }
    note_turned(body.shapes, owner, warnings);
    return;
  }
  repair_shapes(body.shapes, owner, warnings);
  if (body.shapes.empty())
    throw DataError(options.file, 1, fmt::format("{} is left without a shape", owner));
}

Imported import_body(BodySpec body, const std::string& kind, const ImportArguments& options,
                     std::vector<std::string> warnings) {
  settle_meshes(body, options, true, warnings);
  const std::string path = options.file;
  return {report(body, kind, warnings), {".toml"}, [=](const std::string& out) {
            BodySpec moved = body;
            point_to(moved.shapes, fs::path(path).parent_path(), out);
            write_file(out, object_toml(moved));
          }};
}

Imported import_world(WorldSpec world, const std::string& kind, const ImportArguments& options,
                      std::vector<std::string> warnings) {
  for (PlacedBody& placed : world.bodies) {
    const std::size_t before = warnings.size();
    settle_meshes(placed.body, options, placed.dynamic, warnings);
    if (warnings.size() > before) placed.file.clear();  // it holds another surface now
  }
  const std::string path = options.file;
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

/// [m] in one unit of a mesh file.
double scale_of(const ImportArguments& options) {
  static const std::map<std::string, double> units{
      {"", 1}, {"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}, {"in", 0.0254}};
  const auto found = units.find(options.units);
  require(found != units.end(), "wanted --units m, cm, mm or in, got '{}'", options.units);
  require(options.units.empty() || options.scale == 1, "wanted one of --units and --scale");
  return found->second * options.scale;
}

/// A mesh as an object: its exact shapes if there are some.
/// @param as_in_file  triangles are named, not written out
BodySpec object_of(const MeshContent& content, const ImportArguments& options, bool as_in_file,
                   const std::string& out) {
  BodySpec body;
  body.name = fs::path(options.file).stem().string();
  body.shapes = content.exact;
  if (!body.shapes.empty()) return body;
  ShapeSpec shape;
  shape.kind = ShapeKind::kMesh;
  shape.mesh = content.mesh;
  if (as_in_file) {
    shape.mesh_file = options.file;
    shape.mesh_scale = scale_of(options);
  }
  body.shapes = {shape};
  std::vector<std::string> ignored;
  ImportArguments as_given = options;
  as_given.repair = false;  // that has been done
  settle_meshes(body, as_given, true, ignored);
  point_to(body.shapes, "", out);
  return body;
}

Imported import_mesh(const ImportArguments& options) {
  const double scale = scale_of(options);
  MeshContent content = read_mesh_content(options.file, scale);
  TriangleMesh& mesh = content.mesh;
  std::string repaired;
  const std::size_t holes = check_mesh(mesh).holes.size();
  if (options.repair) {
    RepairedSolid mended = watertight_mesh(mesh);
    mesh = std::move(mended.mesh);
    repaired = mended.done;
  }
  OrderedJson told = report(mesh, fs::path(options.file).stem());
  told["holes_closed"] = holes - told["holes"].size();
  told["repaired"] = repaired;
  tell_exact(told, mesh, content.exact);
  return {told, {".obj", ".stl", ".ply", ".off", ".toml"}, [=](const std::string& out) {
            if (fs::path(out).extension() == ".toml") {
              write_file(out, object_toml(object_of(content, options, repaired.empty(), out)));
            } else {
              write_mesh(out, content.mesh);
            }
          }};
}

Imported import_xml(const ImportArguments& options) {
  const std::string& path = options.file;
  const std::string root = XmlFile(path).root_name();
  if (root == "world") {
    const GraspitWorld read = read_graspit_world(path);
    return import_world(read.world, "GraspIt! world", options, read.warnings);
  }
  if (root == "robot" || root == "mujoco" || root == "mujocoinclude" || root == "sdf")
    return import_robot_file(path);
  const GraspitBody read = read_graspit_body(path);
  return import_body(read.body, "GraspIt! body", options, read.warnings);
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

Imported import_toml(const ImportArguments& options) {
  const std::string& path = options.file;
  const FileKind kind = kind_of_toml(path);
  if (kind == FileKind::kRobot) return import_robot_file(path);
  if (kind == FileKind::kObject) return import_body(read_object(path), "object", options, {});
  if (kind == FileKind::kWorld) return import_world(read_world(path), "world", options, {});
  throw DataError(path, 1,
                  fmt::format("wanted a robot, an object, a world or a mesh, got a file "
                              "of kind '{}'",
                              name_of(kind)));
}

Imported import_file(const ImportArguments& options) {
  const std::string& path = options.file;
  require_kind(path, {"robot", "object", "world", "mesh"});
  if (is_mesh_file(path)) return import_mesh(options);
  require(options.scale == 1 && options.units.empty(),
          "--scale and --units are for meshes, '{}' is none", path);
  const std::string text = read_text_file(path);
  const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  if (first != std::string::npos && text[first] == '<') return import_xml(options);
  const std::string ending = fs::path(path).extension();
  if (ending == ".cfg" || ending == ".wld") return import_robot_file(path);  // refused by name
  return import_toml(options);
}

void run_import(const ImportArguments& options) {
  const Imported imported = import_file(options);
  require_ending(options.out, imported.endings);
  fmt::print("{}{}", options.json ? json_text(imported.report) : report_text(imported.report),
             options.json ? "\n" : "");
  const std::vector<std::string> lost =
      imported.lost ? imported.lost(options.out) : std::vector<std::string>{};
  for (const std::string& warning : lost) fmt::print(stderr, "{}: {}\n", options.out, warning);
  const std::size_t warnings = imported.report.at("warnings").size() + lost.size();
  require(!options.strict || warnings == 0, "--strict: {} warning{} about '{}'; nothing is written",
          warnings, warnings == 1 ? "" : "s", options.file);
  if (!options.out.empty()) imported.write(options.out);
}

}  // namespace

void add_import(CLI::App& app) {
  auto options = std::make_shared<ImportArguments>();
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
      ".ply, .off or, as objects, .toml");
  command->add_flag("--json", options->json, "Print JSON");
  command->add_option("--scale", options->scale, "Metres per unit of a mesh file");
  command->add_option("--units", options->units, "Of a mesh file: m, cm, mm or in");
  command->add_flag("--repair", options->repair,
                    "Mend meshes, also of bodies: close holes, turn triangles");
  command->add_flag("--strict", options->strict, "Fail if there are warnings");
  command->callback([options] { run_import(*options); });
}

}  // namespace thenar
