#include "report/answers/import.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "data/io/robot/link_poses.h"

namespace thenar {
namespace {

/// A link that an importer put between the joints of one body, or under bodies without a base.
bool is_added(const RobotLink& link, const std::string& kind) {
  if (kind == name_of(RobotFileKind::kToml) || kind == name_of(RobotFileKind::kUrdf)) return false;
  if (link.mass > 0 || !link.shapes.empty()) return false;
  const std::size_t after = link.name.rfind(" after ");
  const bool between = after != std::string::npos &&
                       link.name.find_first_not_of("0123456789", after + 7) == std::string::npos;
  return between || (kind == name_of(RobotFileKind::kMjcf) && link.name == "world");
}

Fields count_fields(const RobotSpec& robot, const std::string& kind) {
  const auto added = std::count_if(robot.links.begin(), robot.links.end(),
                                   [&](const RobotLink& link) { return is_added(link, kind); });
  const auto moving =
      std::count_if(robot.joints.begin(), robot.joints.end(),
                    [](const RobotJoint& joint) { return joint.kind != RobotJointKind::kFixed; });
  return {{"links", static_cast<long>(robot.links.size()) - added},
          {"links_added", added},
          {"joints", robot.joints.size()},
          {"joints_moving", moving},
          {"dofs", robot.dofs.size()}};
}

std::string effort_word(const RobotDof& dof) {
  if (!(dof.max_effort > 0)) return "unknown";
  return dof.nominal_effort ? "nominal" : "published";
}

std::vector<Fields> dof_fields(const RobotSpec& robot) {
  std::vector<Fields> list;
  for (const RobotDof& dof : robot.dofs) {
    std::vector<std::string> driven;
    for (const RobotJoint& joint : robot.joints)
      if (joint.dof == dof.name) driven.push_back(joint.name);
    const bool sliding = slides(robot, dof);
    const FieldUnit unit = sliding ? units::kMetreBare : units::kRadianBare;
    list.push_back(
        {{"name", dof.name},
         {"kind", name_in(kDriveCouplingNames, dof.kind)},
         {"lower", unit, dof.lower},
         {"upper", unit, dof.upper},
         {"max_effort", sliding ? units::kNewtonBare : units::kNewtonMetreBare, dof.max_effort},
         {"effort_is", effort_word(dof)},
         {"joints", driven}});
  }
  return list;
}

std::vector<Fields> joint_fields(const RobotSpec& robot) {
  return fields_of_each(robot.joints, [&](const RobotJoint& joint) {
    Fields fields{{"name", joint.name},
                  {"kind", name_of(joint.kind)},
                  {"parent", joint.parent},
                  {"child", joint.child}};
    if (joint.kind == RobotJointKind::kFixed) return fields;
    const FieldUnit unit = slides(joint) ? units::kMetreBare : units::kRadianBare;
    fields.append({{"dof", joint.dof},
                   {"ratio", joint.ratio},
                   {"offset", unit, joint.offset},
                   {"lower", unit, joint.lower},
                   {"upper", unit, joint.upper}});
    return fields;
  });
}

std::vector<Fields> link_fields(const RobotSpec& robot) {
  const std::vector<Pose<double>> X = link_poses(robot, {});
  std::vector<Fields> list;
  for (std::size_t i = 0; i < robot.links.size(); ++i)
    list.push_back({{"name", robot.links[i].name},
                    {"mass", units::kKilogram, robot.links[i].mass},
                    {"shapes", robot.links[i].shapes.size()},
                    {"position_at_zero", units::kMetre, X[i].p}});
  return list;
}

OrderedJson leaf_places(const RobotSpec& robot) {
  const std::vector<Pose<double>> X = link_poses(robot, {});
  OrderedJson positions = OrderedJson::object();
  for (const std::size_t leaf : leaf_links(robot))
    positions[robot.links[leaf].name] = to_json(X[leaf].p);
  return positions;
}

/// @param placed  include the places of the shapes
std::vector<Fields> shape_fields(const std::vector<ShapeSpec>& specs, bool placed = false) {
  return fields_of_each(specs, [&](const ShapeSpec& shape) {
    Fields fields{{"kind", name_of(shape.kind)}};
    if (shape.kind == ShapeKind::kMesh)
      fields.append({{"triangles", shape.mesh.triangles.cols()}, {"file", shape.mesh_file}});
    else
      fields.add("size", units::kMetre, shape.size);
    if (placed)
      fields.append(
          {{"position", units::kMetre, shape.X_BS.p}, {"rotation", units::kOne, shape.X_BS.R}});
    return fields;
  });
}

/// The mass; none where nothing states it.
std::optional<double> stated_mass(const BodySpec& body) {
  if (body.mass) return body.mass->mass;
  if (!(body.uniform_mass > 0) && body.density > 0) return body_mass(body).mass;
  return body.uniform_mass > 0 ? std::optional(body.uniform_mass) : std::nullopt;
}

// Rounding of an inertia of a symmetric solid, over its trace [1]
constexpr double kInertiaNoise = 1e-12;

/// Symmetric, and zero where only rounding is left.
Eigen::Matrix3d without_noise(const Eigen::Matrix3d& inertia) {
  const Eigen::Matrix3d I = (inertia + inertia.transpose()) / 2;
  return (I.array().abs() < kInertiaNoise * I.trace()).select(0.0, I);
}

/// JSON on one line, its numbers to seven digits: a report shows no rounding.
std::string rounded_text(OrderedJson value) {
  const OrderedJson all = value.flatten();
  for (const auto& each : all.items())
    if (each.value().is_number_float())
      value[OrderedJson::json_pointer(each.key())] =
          std::strtod(fmt::format("{:.7g}", each.value().get<double>()).c_str(), nullptr);
  return json_text(value, -1);
}

std::string line_of_text(const std::string& key, const OrderedJson& value) {
  return fmt::format("{}: {}\n", key,
                     value.is_string() ? value.get<std::string>() : rounded_text(value));
}

Fields told_of(const RobotSpec& robot, const Imported& imported) {
  double mass = 0;
  for (const RobotLink& link : robot.links) mass += link.mass;
  return {{"name", robot.name},
          {"kind", imported.kind},
          {"counts", count_fields(robot, imported.kind)},
          {"total_mass", units::kKilogram, mass},
          {"root_link", robot.links.front().name},
          {"leaf_link_positions_at_zero", units::kMetre, leaf_places(robot)},
          {"dofs", dof_fields(robot)},
          {"joints", joint_fields(robot)},
          {"links", link_fields(robot)},
          {"warnings", imported.outcome.warnings}};
}

Fields told_of(const BodySpec& body, const Imported& imported) {
  Fields fields{{"name", body.name},
                {"kind", imported.kind},
                {"material", body.material},
                {"mass", units::kKilogram, stated_mass(body)},
                {"shapes", shape_fields(body.shapes)}};
  if (body.mass)
    fields.append({{"centre_of_mass", units::kMetre, body.mass->com},
                   {"inertia", units::kKilogramSquareMetre, body.mass->inertia}});
  fields.add("warnings", imported.outcome.warnings);
  return fields;
}

Fields told_of(const WorldSpec& world, const Imported& imported) {
  // Hands and bodies with their poses, as a file of the world states them.
  std::vector<Fields> hands, bodies;
  for (const PlacedHand& hand : world.hands)
    hands.push_back({{"name", hand.name},
                     {"file", hand.file},
                     {"position", units::kMetre, hand.X_WH.p},
                     {"rotation", units::kOne, hand.X_WH.R},
                     {"posture", hand.posture},
                     {"carrier", hand.carrier},
                     {"carrier_link", hand.carrier_link}});
  for (const PlacedBody& body : world.bodies)
    bodies.push_back({{"name", body.body.name},
                      {"file", body.file},
                      {"dynamic", body.dynamic},
                      {"material", body.body.material},
                      {"mass", units::kKilogram, stated_mass(body.body)},
                      {"position", units::kMetre, body.X_WB.p},
                      {"rotation", units::kOne, body.X_WB.R},
                      {"shapes", shape_fields(body.body.shapes)}});
  return {{"name", world.name},
          {"kind", imported.kind},
          {"counts", Fields{{"hands", hands.size()}, {"bodies", bodies.size()}}},
          {"hands", std::move(hands)},
          {"bodies", std::move(bodies)},
          {"warnings", imported.outcome.warnings}};
}

Fields told_of(const MeshContent& content, const Imported& imported) {
  const MeshFacts& facts = *imported.mesh;
  const TriangleMesh& mesh = content.mesh;
  // Volume, centre and inertia exist for closed surfaces only.
  const auto of_solid = [&](const OrderedJson& value) {
    return facts.solid ? value : OrderedJson(nullptr);
  };
  const Eigen::Matrix3d inertia = without_noise(facts.unit_mass.inertia);
  return {{"name", std::filesystem::path(imported.request.file).stem()},
          {"kind", "mesh"},
          {"vertices", mesh.vertices.cols()},
          {"triangles", mesh.triangles.cols()},
          {"parts", facts.parts},
          {"watertight", facts.surface.watertight()},
          {"holes",
           fields_of_each(
               facts.surface.holes,
               [](const MeshHole& hole) {
                 return Fields{{"edges", hole.loop.size()}, {"centre", units::kMetre, hole.centre}};
               })},
          {"reversed_edges", facts.surface.reversed_edges},
          {"nonmanifold_edges", facts.surface.nonmanifold_edges},
          {"degenerate_triangles", facts.surface.degenerate},
          {"lowest_corner", units::kMetre, mesh.vertices.rowwise().minCoeff()},
          {"highest_corner", units::kMetre, mesh.vertices.rowwise().maxCoeff()},
          {"volume", units::kCubicMetre, of_solid(facts.unit_mass.mass)},
          {"centre_of_mass", units::kMetre, of_solid(to_json(facts.unit_mass.centre))},
          {"inertia", units::kInertiaOfDensityOne, of_solid(to_json(inertia))},
          {"warnings", imported.outcome.warnings},
          {"holes_closed", facts.closed},
          {"repaired", facts.repaired}};
}

/// The material, mass and inertia that were stated besides a mesh's file.
Fields told_besides(const BodySpec& body) {
  Fields fields{{"material", body.material}, {"mass", units::kKilogram, stated_mass(body)}};
  if (body.mass)
    fields.add("inertia", units::kKilogramSquareMetre, without_noise(body.mass->inertia));
  return fields;
}

}  // namespace

Fields fields_of(const Imported& imported) {
  Fields told =
      std::visit([&](const auto& thing) { return told_of(thing, imported); }, imported.thing);
  if (const auto* content = std::get_if<MeshContent>(&imported.thing))
    if (!content->exact.empty()) told.add("exact_shapes", shape_fields(content->exact, true));
  if (imported.body) told.append(told_besides(*imported.body));
  return told;
}

std::string text_of(const Imported& imported) {
  const OrderedJson report = json_of(imported);
  // Values on lines of their own, lists below their name.
  std::string text;
  for (const auto& [key, value] : report.items()) {
    const bool is_list = value.is_array() && !value.empty() && value[0].is_structured() &&
                         key.rfind("inertia", 0) != 0;
    if (key == "warnings") continue;
    if (!is_list && !(value.is_object() && key.rfind("leaf", 0) == 0)) {
      text += line_of_text(key, value);
      continue;
    }
    text += key + ":\n";
    for (const auto& [inner_key, inner] : value.items())
      text += value.is_object() ? "  " + line_of_text(inner_key, inner)
                                : "  " + rounded_text(inner) + "\n";
  }
  // Warnings come last, with options that answer them.
  const OrderedJson warnings = report.value("warnings", OrderedJson::array());
  text += fmt::format("{}\n", warnings.empty() ? "no warnings" : "warnings:");
  for (const OrderedJson& warning : warnings) text += "  " + warning.get<std::string>() + "\n";
  // Options of the command for what the warnings advise.
  const auto advised = [&](const char* word) {
    return any_of(warnings, [&](const OrderedJson& warning) {
      return warning.get_ref<const std::string&>().find(word) != std::string::npos;
    });
  };
  if (advised("repairing")) text += "  --repair mends what these warnings say\n";
  if (advised("numbers millimetres?")) text += "  --units mm reads them so\n";
  return text;
}

}  // namespace thenar
