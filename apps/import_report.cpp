#include "apps/import_report.h"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>

#include "base/error.h"
#include "data/io/robot/link_poses.h"
#include "data/io/world/world.h"
#include "geometry/mesh_check.h"
#include "geometry/mesh_parts.h"
#include "geometry/shape_mass.h"
#include "report/json.h"

namespace thenar {
namespace {

OrderedJson vector_json(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// A link that an importer put between the joints of one body, or under bodies without a base.
bool is_added(const RobotLink& link, RobotFileKind kind) {
  if (kind == RobotFileKind::kToml || kind == RobotFileKind::kUrdf) return false;
  if (link.mass > 0 || !link.shapes.empty()) return false;
  const std::size_t after = link.name.rfind(" after ");
  const bool between = after != std::string::npos &&
                       link.name.find_first_not_of("0123456789", after + 7) == std::string::npos;
  return between || (kind == RobotFileKind::kMjcf && link.name == "world");
}

OrderedJson counts(const RobotSpec& robot, RobotFileKind kind) {
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

OrderedJson dofs(const RobotSpec& robot) {
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

OrderedJson joints(const RobotSpec& robot) {
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

OrderedJson links(const RobotSpec& robot) {
  const std::vector<Pose<double>> X = link_poses(robot, {});
  OrderedJson list = OrderedJson::array();
  for (std::size_t i = 0; i < robot.links.size(); ++i)
    list.push_back({{"name", robot.links[i].name},
                    {"mass_kg", robot.links[i].mass},
                    {"shapes", robot.links[i].shapes.size()},
                    {"position_at_zero_m", vector_json(X[i].p)}});
  return list;
}

OrderedJson leaves(const RobotSpec& robot) {
  const std::vector<Pose<double>> X = link_poses(robot, {});
  OrderedJson positions = OrderedJson::object();
  for (const std::size_t leaf : leaf_links(robot))
    positions[robot.links[leaf].name] = vector_json(X[leaf].p);
  return positions;
}

OrderedJson shapes(const std::vector<ShapeSpec>& specs) {
  OrderedJson list = OrderedJson::array();
  for (const ShapeSpec& shape : specs) {
    OrderedJson entry{{"kind", name_of(shape.kind)}};
    if (shape.kind == ShapeKind::kMesh) {
      entry["triangles"] = shape.mesh.triangles.cols();
      entry["file"] = shape.mesh_file;
    } else {
      entry["size_m"] = vector_json(shape.size);
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

constexpr double kLargestMesh = 10;  // a larger one is in another unit [m]

/// Longest edge of its box [m].
double extent(const TriangleMesh& mesh) {
  return (mesh.vertices.rowwise().maxCoeff() - mesh.vertices.rowwise().minCoeff()).maxCoeff();
}

/// Empty if there is none.
std::string size_warning(const TriangleMesh& mesh) {
  const double across = extent(mesh);
  if (!(across > kLargestMesh)) return "";
  return fmt::format("{:.4g} m across: are its numbers millimetres? --units mm", across);
}

/// Of the union of its parts; nothing where they do not agree on what is inside.
struct MeshMass {
  bool closed = false;
  double enclosed = 0;  // signed, each part counted [m^3]
  UnionMass all;
};

MeshMass mass_of_parts(const TriangleMesh& mesh, const std::vector<TriangleMesh>& parts) {
  MeshMass found;
  for (const TriangleMesh& part : parts) {
    const MeshReport report = check_mesh(part);
    if (!report.holes.empty() || report.nonmanifold_edges > 0 || report.reversed_edges > 0)
      return {};
    found.enclosed += report.volume;
  }
  found.closed = true;
  if (!(found.enclosed > 0)) return found;
  ShapeSpec shape;
  shape.kind = ShapeKind::kMesh;
  shape.mesh = mesh;
  try {
    found.all = union_mass({shape});
  } catch (const InputError&) {
    found.closed = false;  // as one of its parts is flat
  }
  return found;
}

constexpr double kNoise = 1e-12;  // of the trace, in an inertia of a symmetric solid [1]

/// Symmetric, and zero where only rounding is left.
Eigen::Matrix3d without_noise(const Eigen::Matrix3d& inertia) {
  const Eigen::Matrix3d I = (inertia + inertia.transpose()) / 2;
  return (I.array().abs() < kNoise * I.trace()).select(0.0, I);
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

}  // namespace

OrderedJson report(const RobotSpec& robot, RobotFileKind kind) {
  double mass = 0;
  for (const RobotLink& link : robot.links) mass += link.mass;
  return {{"name", robot.name},
          {"kind", name_of(kind)},
          {"counts", counts(robot, kind)},
          {"total_mass_kg", mass},
          {"root_link", robot.links.front().name},
          {"leaf_link_positions_at_zero_m", leaves(robot)},
          {"dofs", dofs(robot)},
          {"joints", joints(robot)},
          {"links", links(robot)},
          {"warnings", robot.warnings}};
}

OrderedJson report(const BodySpec& body, const std::string& kind,
                   const std::vector<std::string>& warnings) {
  OrderedJson result{{"name", body.name},
                     {"kind", kind},
                     {"material", body.material},
                     {"mass_kg", mass_json(body)},
                     {"shapes", shapes(body.shapes)}};
  if (body.mass) {
    result["centre_of_mass_m"] = vector_json(body.mass->com);
    result["inertia_kg_m2"] = to_json(body.mass->inertia);
  }
  result["warnings"] = warnings;
  return result;
}

OrderedJson report(const WorldSpec& world, const std::string& kind,
                   const std::vector<std::string>& warnings) {
  OrderedJson hands = OrderedJson::array(), bodies = OrderedJson::array();
  for (const PlacedHand& hand : world.hands)
    hands.push_back({{"name", hand.name},
                     {"file", hand.file},
                     {"position_m", vector_json(hand.X_WH.p)},
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
                      {"position_m", vector_json(body.X_WB.p)},
                      {"rotation", to_json(body.X_WB.R)},
                      {"shapes", shapes(body.body.shapes)}});
  return {{"name", world.name},
          {"kind", kind},
          {"counts", {{"hands", world.hands.size()}, {"bodies", world.bodies.size()}}},
          {"hands", hands},
          {"bodies", bodies},
          {"warnings", warnings}};
}

OrderedJson report(const TriangleMesh& mesh, const std::string& name) {
  const MeshReport found = check_mesh(mesh);
  OrderedJson holes = OrderedJson::array();
  for (const MeshHole& hole : found.holes)
    holes.push_back({{"edges", hole.loop.size()}, {"centre_m", vector_json(hole.centre)}});
  OrderedJson warnings = OrderedJson::array();
  if (!found.holes.empty())
    warnings.push_back(
        fmt::format("the surface is open in {} place{}: it has no volume; --repair "
                    "closes it",
                    found.holes.size(), found.holes.size() == 1 ? "" : "s"));
  if (found.reversed_edges > 0)
    warnings.push_back(
        fmt::format("{} edges lie between triangles that face opposite ways; --repair turns them",
                    found.reversed_edges));
  if (found.nonmanifold_edges > 0)
    warnings.push_back(
        fmt::format("{} edges have more than two triangles", found.nonmanifold_edges));
  if (found.degenerate > 0)
    warnings.push_back(fmt::format("{} triangles have no area", found.degenerate));
  if (const std::string size = size_warning(mesh); !size.empty()) warnings.push_back(size);
  const std::vector<TriangleMesh> parts = connected_parts(mesh);
  const MeshMass found_mass = mass_of_parts(mesh, parts);
  const MassProperties& mass = found_mass.all.mass;
  const bool solid = mass.mass > 0;
  if (found_mass.closed && !solid)
    warnings.push_back(found_mass.enclosed < 0
                           ? "inside out: the surface faces inwards, --repair turns it"
                           : "no volume: the surface is flat");
  constexpr double kOverlap = 1e-6;  // of the volume, that parts may share by rounding [1]
  if (solid && found_mass.enclosed > (1 + kOverlap) * mass.mass)
    warnings.push_back(fmt::format(
        "parts overlap: volume, centre and inertia are of their union{}; their volumes add up to "
        "{:.3g} % more",
        found_mass.all.error > 0 ? fmt::format(", to about {:.1g}", found_mass.all.error) : "",
        100 * (found_mass.enclosed / mass.mass - 1)));
  return {{"name", name},
          {"kind", "mesh"},
          {"vertices", mesh.vertices.cols()},
          {"triangles", mesh.triangles.cols()},
          {"parts", parts.size()},
          {"watertight", found.watertight()},
          {"holes", holes},
          {"reversed_edges", found.reversed_edges},
          {"nonmanifold_edges", found.nonmanifold_edges},
          {"degenerate_triangles", found.degenerate},
          {"lowest_corner_m", vector_json(mesh.vertices.rowwise().minCoeff())},
          {"highest_corner_m", vector_json(mesh.vertices.rowwise().maxCoeff())},
          {"volume_m3", solid ? OrderedJson(mass.mass) : OrderedJson(nullptr)},
          {"centre_of_mass_m", solid ? vector_json(mass.centre) : OrderedJson(nullptr)},
          {"inertia_m5",
           solid ? OrderedJson(to_json(without_noise(mass.inertia))) : OrderedJson(nullptr)},
          {"warnings", warnings}};
}

void tell_exact(OrderedJson& report, const TriangleMesh& mesh,
                const std::vector<ShapeSpec>& exact) {
  if (exact.empty()) return;
  OrderedJson told = shapes(exact), warnings = OrderedJson::array();
  for (std::size_t i = 0; i < exact.size(); ++i) {
    told[i]["position_m"] = vector_json(exact[i].X_BS.p);
    told[i]["rotation"] = to_json(exact[i].X_BS.R);
  }
  const UnionMass all = union_mass(exact);
  report["exact_shapes"] = told;
  report["volume_m3"] = all.mass.mass;
  report["centre_of_mass_m"] = vector_json(all.mass.centre);
  report["inertia_m5"] = to_json(without_noise(all.mass.inertia));

  // What the triangles are warned of does not hold for the solids.
  if (const std::string size = size_warning(mesh); !size.empty()) warnings.push_back(size);
  if (all.error > 0)
    warnings.push_back(
        fmt::format("parts overlap: volume, centre and inertia are of their union, to about {:.1g}",
                    all.error));
  report["warnings"] = warnings;
}

std::string report_text(const OrderedJson& report) {
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
  return text;
}

}  // namespace thenar
