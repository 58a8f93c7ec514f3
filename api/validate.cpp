#include "api/validate.h"

#include <fmt/format.h>

#include "api/mesh_facts.h"
#include "api/named/digits.h"
#include "api/named/material_names.h"
#include "api/scenes/simulate_scene.h"
#include "base/error.h"
#include "base/lists.h"
#include "base/progress_parts.h"
#include "data/io/doubled_trials.h"
#include "data/io/mesh/repair_shape.h"
#include "data/io/robot/import_robot.h"
#include "data/io/robot/robot_doubts.h"
#include "data/io/subject_doubts.h"
#include "geometry/solid.h"
#include "pads/build_pad.h"
#include "tendons/linear_tendons.h"
#include "tendons/tendon_model.h"

namespace thenar {
namespace {

/// Builds what a thing says; throws where its parts do not fit together.
void build_thing(const Subject& subject, FileVerdict& verdict) {
  append_all(verdict.warnings, subject_doubts(subject));
  for (const Digit& digit : subject.digits) {
    // Its tendons as other questions run them, at the reference posture.
    TendonOptions options;
    options.path = default_path(subject);
    const auto tendons = build_linear_tendons(subject, digit.name, options);
    const TendonNames& names = tendons->digit().names;
    const auto zeros = [](const std::vector<std::string>& of) -> Eigen::VectorXd {
      return Eigen::VectorXd::Zero(static_cast<Eigen::Index>(of.size()));
    };
    const TendonTorque there =
        tendons->evaluate(zeros(names.coordinates), zeros(names.muscles), {});
    if (!there.warning.empty())
      verdict.warnings.push_back(
          fmt::format("digit '{}' at the reference posture: {}", digit.name, there.warning));
  }
}
void build_thing(const BodySpec& body, FileVerdict& verdict) {
  (void)build_solid(body.shapes);  // throws if a mesh has holes
  const std::string owner = fmt::format("object '{}'", body.name);
  note_turned(body.shapes, owner, verdict.warnings);
  append_all(verdict.warnings, size_warnings(body.shapes, owner));
  append_all(verdict.warnings, density_warnings(body, owner));
}
void build_thing(const WorldSpec& world, FileVerdict& /*verdict*/) {
  for (const PlacedBody& placed : world.bodies) (void)build_solid(placed.body.shapes);
}
void build_thing(const SceneSpec& scene, FileVerdict& verdict) {
  verdict.warnings = open_scene(scene).built.warnings;
}
void build_thing(const PadSpec& pad, FileVerdict& /*verdict*/) { (void)build_pad(pad); }
void build_thing(const RobotSpec& robot, FileVerdict& verdict) {
  std::vector<std::string> found = robot.warnings;
  for (const std::vector<std::string>& doubts : {robot_doubts(robot), mass_doubts(robot)})
    for (const std::string& doubt : doubts)
      if (!contains_warning(found, doubt)) found.push_back(doubt);
  append_all(verdict.warnings, found);
  for (const RobotLink& link : robot.links)
    for (const ShapeSpec& shape : link.shapes)
      require_solid(shape, fmt::format("link '{}'", link.name));
}
template <typename Other>
void build_thing(const Other& /*read whole already*/, FileVerdict& /*verdict*/) {}

std::vector<std::string> materials_in(const BodySpec& body) { return {body.material}; }
std::vector<std::string> materials_in(const RobotSpec& robot) {
  return transformed(robot.links, [&](const RobotLink& link) { return link.material; });
}
template <typename Other>
std::vector<std::string> materials_in(const Other& /*none, or checked by its reader*/) {
  return {};
}

FileVerdict verdict_of(const std::string& name, const std::string& data, const Materials& table) {
  // Read, build and look for doubts; whatever throws is the verdict.
  FileVerdict verdict;
  verdict.path = name;
  try {
    verdict.path = named_thing(name, data);
    Thing thing = read_thing(verdict.path);
    verdict.warnings = checksum_warnings(verdict.path);
    std::visit([&](const auto& each) { build_thing(each, verdict); }, thing);
    // Names of materials must be in the table.
    for (std::string& unknown : unknown_materials(
             verdict.path, std::visit([](const auto& each) { return materials_in(each); }, thing),
             table))
      verdict.warnings.push_back(std::move(unknown));
    if (const auto* experiment = std::get_if<Experiment>(&thing))
      append_all(verdict.warnings, doubled_trial_warnings({*experiment}));
    verdict.thing = std::move(thing);
  } catch (const Stopped&) {
    throw;
  } catch (const Error& error) {
    verdict.error = error.what();
  }
  return verdict;
}

}  // namespace

bool Validation::valid() const {
  return all_of(files, [](const FileVerdict& file) { return file.valid(); });
}

Validation validate(const ValidateRequest& request) {
  Validation out;
  out.request = request;
  // The subject is read once, for all experiments.
  Subject subject;
  if (!request.subject.empty()) {
    const SourceText source = subject_source(request.subject, request.data);
    subject = parse_subject(source.text, source.path);
    out.subject = source.path;
  }
  const Materials table = materials_of_file(request.materials);
  bool held = false;
  // Judge every file, and hold experiments to the subject.
  for (const std::string& name : request.things) {
    out.files.push_back(verdict_of(name, request.data, table));
    FileVerdict& file = out.files.back();
    if (out.subject.empty() || !file.thing || !std::holds_alternative<Experiment>(*file.thing))
      continue;
    file.check = check_experiment(read_source(file.path), subject);
    held = true;
  }
  const bool broken = any_of(out.files, [](const FileVerdict& file) { return !file.thing; });
  require_field("subject", out.subject.empty() || held || broken,
                "a subject is what experiments are held to; none of the files is an experiment");
  return out;
}

}  // namespace thenar
