// thenar import FILE [-o robot.toml|robot.urdf|world.toml|object.toml|mesh.stl..] [--json]
// [--strict] [--allow-missing] [--repair] [--units m|cm|mm|in] [--mass KG | --density D]
// [--material NAME]
//
// Reads a robot, world, object or mesh of any format, says what it holds and what was not
// understood, and writes it in another.

#include <algorithm>
#include <memory>
#include <variant>

#include <fmt/format.h>

#include "api/import.h"
#include "apps/commands.h"
#include "apps/options.h"
#include "apps/outputs.h"
#include "base/error.h"
#include "base/words.h"
#include "report/answers/import.h"

namespace thenar {
namespace {

struct ImportArguments : Arguments<ImportRequest> {
  bool strict = false, allow_missing = false;
  bool unit_stated = false;  // --scale is given, even if it is 1
};

/// Warnings on the error stream, under the file that they are of.
void print_of(const std::string& out, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) fmt::print(stderr, "{}: {}\n", out, warning);
}

/// Throws for a robot that lacks parts of its file, as only warnings would distinguish it from a
/// complete one.
void require_whole(const Imported& imported, const std::vector<std::string>& files) {
  if (files.empty() || !std::holds_alternative<RobotSpec>(imported.thing)) return;
  const auto missing = std::count_if(imported.outcome.warnings.begin(),
                                     imported.outcome.warnings.end(), names_missing_part);
  require(missing == 0,
          "'{}' names {} missing, see above: mend the name, or write the robot without it by "
          "--allow-missing; nothing is written",
          imported.request.file,
          missing == 1 ? "a file that is" : fmt::format("{} files that are", missing));
}

/// Refuses to write a mesh of an implausible size as if its unit had been stated.
void require_plausible(const Imported& imported, const ImportArguments& options) {
  const bool stated = options.unit_stated || !options.request.units.empty();
  require(stated || !imported.mesh || imported.mesh->across <= kMaxObjectSize,
          "'{}' is {:.4g} m across: are its numbers millimetres? --units mm; if it is as large as "
          "that, --units m; nothing is written",
          options.request.file, imported.mesh ? imported.mesh->across : 0);
}

void run_import(const ImportArguments& options) {
  const Imported imported = import_file(options.request);
  // Check all endings before anything is written.
  const std::vector<std::string> files =
      options.outputs.with_ending({".toml", ".urdf", ".obj", ".stl", ".ply", ".off"});
  std::size_t warnings = imported.outcome.warnings.size();
  for (const std::string& out : files) require_ending(out, writable_endings(imported));
  print_answer(options.outputs.json ? json_text(json_of(imported)) + "\n" : text_of(imported));
  // Warn of what the format cannot hold, before it is lost.
  for (const std::string& out : files) {
    print_of(out, unsupported_properties(imported, out));
    warnings += unsupported_properties(imported, out).size();
  }
  require(!options.strict || warnings == 0, "--strict: {} about '{}'; nothing is written",
          counted(warnings, "warning"), options.request.file);
  // Throw for implausible or incomplete input unless it is allowed.
  if (!files.empty()) require_plausible(imported, options);
  if (!options.allow_missing) require_whole(imported, files);
  for (const std::string& out : files) print_of(out, write_imported(imported, out));
  for (const std::string& out : options.outputs.with_ending({".json"}))
    write_json_file(json_of(imported), out, files_of(imported));
  print_written(options.outputs);
}

void add_mass_options(CLI::App& command, ImportRequest& request) {
  command.add_option("--mass", request.mass,
                     "Mass of an object or a mesh, spread evenly over its volume [kg]");
  command.add_option("--density", request.density, "Density in place of a mass [kg/m3]");
  add_materials_option(command, request.materials);
  command.add_option("--material", request.material,
                     "Material of an object or a mesh, for friction; `thenar list materials` has "
                     "the names. Its density, if it has one, is used without --mass and --density");
}

}  // namespace

void add_import(CLI::App& app) {
  auto options = std::make_shared<ImportArguments>();
  ImportRequest& request = options->request;
  CLI::App* command = app.add_subcommand(
      "import", "Read a robot, world, object or mesh of any format; say what it holds; convert it");
  command
      ->add_option(
          "file", request.file,
          "URDF, MJCF, GraspIt! XML, TOML, or OBJ, STL, PLY, OFF, glTF, Collada, VRML, Inventor")
      ->required();
  add_output_options(*command, options->outputs,
                     {true, false, false, {".toml", ".urdf", ".obj", ".stl", ".ply", ".off"}});
  command
      ->add_option_function<double>(
          "--scale",
          [options](double scale) {
            options->request.scale = scale;
            options->unit_stated = true;
          },
          "Metres per unit of a mesh file")
      ->default_str("1");
  command->add_option("--units", request.units, "Unit of a mesh file: m, cm, mm or in; default: m");
  add_mass_options(*command, request);
  command->add_flag("--repair", request.repair,
                    "Repair meshes, including those of bodies: close holes, reorient triangles");
  command->add_flag("--allow-missing", options->allow_missing,
                    "Write a robot even if meshes or bodies that it names are missing");
  command->add_flag("--strict", options->strict, "Fail if there are warnings");
  add_examples(
      *command,
      {"import data/robots/barrett.toml -o out/barrett.urdf",
       "import data/objects/mug.obj --units mm --mass 0.3 --material glass -o out/mug.toml"});
  command->callback([options] { run_import(*options); });
}

}  // namespace thenar
