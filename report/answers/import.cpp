#include "report/answers/import.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

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

OrderedJson counts_json(const RobotSpec& robot, const std::string& kind) {
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

std::string name_of(RobotDofKind kind) {
  switch (kind) {
    case RobotDofKind::kRigid:
      return "rigid";
    case RobotDofKind::kBreakaway:
      return "breakaway";
    case RobotDofKind::kCompliant:
      break;
  }
  return "compliant";
}

std::string effort_word(const RobotDof& dof) {
  if (!(dof.max_effort > 0)) return "unknown";
  return dof.nominal_effort ? "nominal" : "published";
}

OrderedJson dofs_json(const RobotSpec& robot) {
  OrderedJson list = OrderedJson::array();
  for (const RobotDof& dof : robot.dofs) {
    OrderedJson driven = OrderedJson::array();
    for (const RobotJoint& joint : robot.joints)
      if (joint.dof == dof.name) driven.push_back(joint.name);
    list.push_back({{"name", dof.name},
                    {"kind", name_of(dof.kind)},
                    {"lower", dof.lower},
                    {"upper", dof.upper},
                    {"max_effort", dof.max_effort},
                    {"effort_is", effort_word(dof)},
                    {"joints", driven}});
  }
  return list;
}

OrderedJson joints_json(const RobotSpec& robot) {
  OrderedJson list = OrderedJson::array();
  for (const RobotJoint& joint : robot.joints) {
    OrderedJson entry{{"name", joint.name},
                      {"kind", name_of(joint.kind)},
                      {"parent", joint.parent},
                      {"child", joint.child}};
    if (joint.kind != RobotJointKind::kFixed) {
      entry.update({{"dof", joint.dof},
                    {"ratio", joint.ratio},
                    {"offset", joint.offset},
                    {"lower", joint.lower},
                    {"upper", joint.upper}});
    }
    list.push_back(std::move(entry));
  }
  return list;
}

OrderedJson links_json(const RobotSpec& robot) {
  const std::vector<Pose<double>> X = link_poses(robot, {});
  OrderedJson list = OrderedJson::array();
  for (std::size_t i = 0; i < robot.links.size(); ++i)
    list.push_back({{"name", robot.links[i].name},
                    {"mass_kg", robot.links[i].mass},
                    {"shapes", robot.links[i].shapes.size()},
                    {"position_at_zero_m", to_json(X[i].p)}});
  return list;
}

OrderedJson leaves_json(const RobotSpec& robot) {
  const std::vector<Pose<double>> X = link_poses(robot, {});
  OrderedJson positions = OrderedJson::object();
  for (const std::size_t leaf : leaf_links(robot))
    positions[robot.links[leaf].name] = to_json(X[leaf].p);
  return positions;
}

OrderedJson shapes_json(const std::vector<ShapeSpec>& specs) {
  OrderedJson list = OrderedJson::array();
  for (const ShapeSpec& shape : specs) {
    OrderedJson entry{{"kind", name_of(shape.kind)}};
    if (shape.kind == ShapeKind::kMesh) {
      entry["triangles"] = shape.mesh.triangles.cols();
      entry["file"] = shape.mesh_file;
    } else {
      entry["size_m"] = to_json(shape.size);
    }
    list.push_back(std::move(entry));
  }
  return list;
}

OrderedJson mass_json(const BodySpec& body) {
  if (body.mass) return body.mass->mass;
  if (!(body.uniform_mass > 0) && body.density > 0) return body_mass(body).mass;
  return body.uniform_mass > 0 ? OrderedJson(body.uniform_mass) : OrderedJson(nullptr);
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

OrderedJson told_of(const RobotSpec& robot, const Imported& imported) {
  double mass = 0;
  for (const RobotLink& link : robot.links) mass += link.mass;
  return {{"name", robot.name},
          {"kind", imported.kind},
          {"counts", counts_json(robot, imported.kind)},
          {"total_mass_kg", mass},
          {"root_link", robot.links.front().name},
          {"leaf_link_positions_at_zero_m", leaves_json(robot)},
          {"dofs", dofs_json(robot)},
          {"joints", joints_json(robot)},
          {"links", links_json(robot)},
          {"warnings", imported.warnings}};
}

OrderedJson told_of(const BodySpec& body, const Imported& imported) {
  OrderedJson result{{"name", body.name},
                     {"kind", imported.kind},
                     {"material", body.material},
                     {"mass_kg", mass_json(body)},
                     {"shapes", shapes_json(body.shapes)}};
  if (body.mass) {
    result["centre_of_mass_m"] = to_json(body.mass->com);
    result["inertia_kg_m2"] = to_json(body.mass->inertia);
  }
  result["warnings"] = imported.warnings;
  return result;
}

OrderedJson told_of(const WorldSpec& world, const Imported& imported) {
  OrderedJson hands = OrderedJson::array(), bodies = OrderedJson::array();
  for (const PlacedHand& hand : world.hands)
    hands.push_back({{"name", hand.name},
                     {"file", hand.file},
                     {"position_m", to_json(hand.X_WH.p)},
                     {"rotation", to_json(hand.X_WH.R)},
                     {"posture", hand.posture},
                     {"carrier", hand.carrier},
                     {"carrier_link", hand.carrier_link}});
  for (const PlacedBody& body : world.bodies)
    bodies.push_back({{"name", body.body.name},
                      {"file", body.file},
                      {"dynamic", body.dynamic},
                      {"material", body.body.material},
                      {"mass_kg", mass_json(body.body)},
                      {"position_m", to_json(body.X_WB.p)},
                      {"rotation", to_json(body.X_WB.R)},
                      {"shapes", shapes_json(body.body.shapes)}});
  return {{"name", world.name},
          {"kind", imported.kind},
          {"counts", {{"hands", world.hands.size()}, {"bodies", world.bodies.size()}}},
          {"hands", hands},
          {"bodies", bodies},
          {"warnings", imported.warnings}};
}

OrderedJson told_of(const MeshContent& content, const Imported& imported) {
  const MeshFacts& facts = *imported.mesh;
  const TriangleMesh& mesh = content.mesh;
  const auto of_solid = [&](const OrderedJson& value) {
    return facts.solid ? value : OrderedJson(nullptr);
  };
  OrderedJson holes = OrderedJson::array();
  for (const MeshHole& hole : facts.surface.holes)
    holes.push_back({{"edges", hole.loop.size()}, {"centre_m", to_json(hole.centre)}});
  return {{"name", std::filesystem::path(imported.request.file).stem()},
          {"kind", "mesh"},
          {"vertices", mesh.vertices.cols()},
          {"triangles", mesh.triangles.cols()},
          {"parts", facts.parts},
          {"watertight", facts.surface.watertight()},
          {"holes", holes},
          {"reversed_edges", facts.surface.reversed_edges},
          {"nonmanifold_edges", facts.surface.nonmanifold_edges},
          {"degenerate_triangles", facts.surface.degenerate},
          {"lowest_corner_m", to_json(mesh.vertices.rowwise().minCoeff())},
          {"highest_corner_m", to_json(mesh.vertices.rowwise().maxCoeff())},
          {"volume_m3", of_solid(facts.unit_mass.mass)},
          {"centre_of_mass_m", of_solid(to_json(facts.unit_mass.centre))},
          {"inertia_m5", of_solid(to_json(without_noise(facts.unit_mass.inertia)))},
          {"warnings", imported.warnings},
          {"holes_closed", facts.closed},
          {"repaired", facts.repaired}};
}

/// Exact shapes of a mesh file, with their places.
OrderedJson exact_json(const std::vector<ShapeSpec>& exact) {
  OrderedJson told = shapes_json(exact);
  for (std::size_t i = 0; i < exact.size(); ++i) {
    told[i]["position_m"] = to_json(exact[i].X_BS.p);
    told[i]["rotation"] = to_json(exact[i].X_BS.R);
  }
  return told;
}

/// Adds the material, mass and inertia that were stated besides a mesh's file.
void add_body(const BodySpec& body, OrderedJson& report) {
  report["material"] = body.material;
  report["mass_kg"] = mass_json(body);
  if (body.mass) report["inertia_kg_m2"] = to_json(without_noise(body.mass->inertia));
}

}  // namespace

OrderedJson json_of(const Imported& imported) {
  OrderedJson told =
      std::visit([&](const auto& thing) { return told_of(thing, imported); }, imported.thing);
  if (const auto* content = std::get_if<MeshContent>(&imported.thing))
    if (!content->exact.empty()) told["exact_shapes"] = exact_json(content->exact);
  if (imported.body) add_body(*imported.body, told);
  return told;
}

std::string text_of(const Imported& imported) {
  const OrderedJson report = json_of(imported);
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
  const OrderedJson warnings = report.value("warnings", OrderedJson::array());
  text += fmt::format("{}\n", warnings.empty() ? "no warnings" : "warnings:");
  for (const OrderedJson& warning : warnings) text += "  " + warning.get<std::string>() + "\n";
  // Options of the command for what the warnings advise.
  const auto advised = [&](const char* word) {
    return std::any_of(warnings.begin(), warnings.end(), [&](const OrderedJson& warning) {
      return warning.get_ref<const std::string&>().find(word) != std::string::npos;
    });
  };
  if (advised("repairing")) text += "  --repair mends what these warnings say\n";
  if (advised("numbers millimetres?")) text += "  --units mm reads them so\n";
  return text;
}

}  // namespace thenar
