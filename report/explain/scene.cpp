// What objects, worlds, materials and robots hold.

#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/nearest_name.h"
#include "base/units.h"
#include "base/words.h"
#include "report/explain/explanation.h"
#include "report/summary.h"

namespace thenar {
namespace {

constexpr double kGram = 1e-3;  // A gram [kg]

/// "35", "120 60 40": only what the kind of shape uses.
std::string sizes_of(const ShapeSpec& shape) {
  if (shape.kind == ShapeKind::kMesh)
    return fmt::format("{} triangles of {}", shape.mesh.triangles.cols(), or_dash(shape.mesh_file));
  std::vector<std::string> sizes;
  for (const double size : shape.size)
    if (size > 0) sizes.push_back(shown(size / kMm, 2));
  return fmt::format("{}", fmt::join(sizes, " "));
}

std::string mass_of(const BodySpec& body) {
  if (body.mass) return shown(body.mass->mass / kGram, 1) + " g, as stated with its inertia";
  if (body.uniform_mass > 0)
    return shown(body.uniform_mass / kGram, 1) + " g, spread evenly over the shapes";
  if (body.density > 0) return shown(body.density, 0) + " kg/m3 times the volume";
  return "unknown";
}

Section explain_shapes(const BodySpec& body) {
  Section section{
      "shapes", "Shapes, in the body's frame", {{"kind", "size_mm", "x_mm", "y_mm", "z_mm"}}};
  for (const ShapeSpec& shape : body.shapes)
    section.table.add_parts(
        {{name_of(shape.kind), sizes_of(shape)}, cells(Eigen::Vector3d(shape.X_BS.p / kMm), 1)});
  return section;
}

Section explain_hands(const WorldSpec& world) {
  Section section{"hands",
                  "Hands and arms",
                  {{"name", "file", "x_mm", "y_mm", "z_mm", "carried_by", "posture"}}};
  for (const PlacedHand& hand : world.hands)
    section.table.add_parts(
        {{hand.name, or_dash(hand.file)},
         cells(Eigen::Vector3d(hand.X_WH.p / kMm), 1),
         {hand.carrier.empty() ? "-" : hand.carrier + " " + hand.carrier_link,
          hand.posture.empty() ? "rest" : counted(hand.posture.size(), "coordinate")}});
  return section;
}

Section explain_scene_bodies(const SceneSpec& scene) {
  Section section{
      "bodies", "Bodies", {{"name", "joint", "on", "material", "mass", "x_mm", "y_mm", "z_mm"}}};
  for (const SceneBodySpec& body : scene.bodies)
    section.table.add_parts(
        {{body.placed.body.name, name_in(kJointKindNames, body.joint.kind),
          or_dash(body.joint.parent), or_dash(body.placed.body.material),
          body.joint.kind == JointKind::kWeld ? "-" : mass_of(body.placed.body)},
         cells(Eigen::Vector3d(body.placed.X_WB.p / kMm), 1)});
  return section;
}

/// Tabulates the pads of the file; "-" marks values that the fingertip and the pair determine.
Section explain_pads(const SceneSpec& scene) {
  Section section{"pads", "Pads"};
  if (scene.pads.empty()) return section;
  section.lines = {
      "place and scale '-': those of the fingertip; friction '-': that of the pair",
      "all as another rung: thenar simulate SCENE --pads RUNG, of " + listed(pad_rung_names())};
  section.table.header = {"on",   "against", "rung",  "pad",      "laws",       "x_mm",
                          "y_mm", "z_mm",    "scale", "friction", "force_error"};
  const std::vector<std::string> none{"-", "-", "-"};
  for (const ScenePadSpec& pad : scene.pads)
    section.table.add_parts(
        {{pad.on, listed(pad.against), pad.rung, pad.pad, or_dash(pad.laws)},
         pad.X_BP ? cells(Eigen::Vector3d(pad.X_BP->p / kMm), 1) : none,
         {pad.scale  ? shown(*pad.scale, 3)
          : pad.X_BP ? "1"
                     : "-",
          pad.friction ? shown(*pad.friction, 2) : "-", shown(pad.force_error, 3)}});
  return section;
}

/// Lists the constants of pads and of their laws, each once.
Section explain_pad_constants(const SceneSpec& scene) {
  Section section{"pad_constants", "Constants of pads"};
  std::set<std::string> told;
  for (const ScenePadSpec& pad : scene.pads) {
    if (told.insert("pad " + pad.pad).second) {
      section.lines.push_back(summary_of(pad.spec));
      const std::vector<std::string> assumed = assumed_words(pad.spec);
      if (!assumed.empty()) section.lines.push_back("assumed, not measured: " + listed(assumed));
    }
    const bool reduced = pad.rung != "elements" && pad.rung != "hard-point";
    if (reduced && pad.law && told.insert("laws " + pad.laws).second)
      section.lines.push_back(summary_of(*pad.law));
  }
  return section;
}

Section explain_bodies(const WorldSpec& world) {
  Section section{
      "bodies", "Bodies", {{"name", "role", "material", "mass", "x_mm", "y_mm", "z_mm"}}};
  for (const PlacedBody& placed : world.bodies)
    section.table.add_parts(
        {{placed.body.name, placed.dynamic ? "object" : "obstacle", or_dash(placed.body.material),
          placed.dynamic ? mass_of(placed.body) : "-"},
         cells(Eigen::Vector3d(placed.X_WB.p / kMm), 1)});
  return section;
}

/// Tabulates the friction between the materials of a world, and of these on skin.
Section explain_friction(const Materials& materials) {
  Section section{
      "friction", "Friction between materials", {{"one", "other", "static", "kinetic"}}};
  for (const auto& [pair, friction] : materials.friction)
    section.table.add({pair.first, pair.second, shown(friction.static_coefficient, 2),
                       shown(friction.kinetic_coefficient, 2)});
  return section;
}

/// Degrees of what turns, millimetres of what slides.
std::string in_units(double value, bool slides) {
  return slides ? shown(value / kMm, 1) + " mm" : shown(value / kDegree, 1) + " deg";
}

/// "j2b x 0.600 + 17.2 deg": the ratio and the offset of a joint to its motor, where it has some.
std::string driven_words(const RobotJoint& joint) {
  std::string words = joint.name;
  if (joint.ratio != 1) words += " x " + shown(joint.ratio, 3);
  if (joint.offset != 0)
    words += (joint.offset > 0 ? " + " : " - ") + in_units(std::abs(joint.offset), slides(joint));
  return words;
}

Section explain_motors(const RobotSpec& robot) {
  Section section{
      "motors", "Motors", {{"name", "kind", "from", "to", "closes_at", "effort", "drives"}}};
  for (const RobotDof& dof : robot.dofs) {
    std::vector<std::string> joints;
    for (const RobotJoint& joint : robot.joints)
      if (joint.dof == dof.name) joints.push_back(driven_words(joint));
    const bool sliding = slides(robot, dof);
    const std::string effort = shown(dof.max_effort, 2) + (sliding ? " N" : " N m") +
                               (dof.nominal_effort ? " (nominal)" : "");
    section.table.add({dof.name, name_in(kDriveCouplingNames, dof.kind),
                       in_units(dof.lower, sliding), in_units(dof.upper, sliding),
                       shown(dof.speed, 2), dof.max_effort > 0 ? effort : "-", listed(joints)});
  }
  return section;
}

Section explain_robot_joints(const RobotSpec& robot) {
  Section section{"joints", "Joints", {{"name", "kind", "parent", "child", "from", "to", "motor"}}};
  for (const RobotJoint& joint : robot.joints) {
    const bool sliding = joint.kind == RobotJointKind::kPrismatic;
    const bool fixed = joint.kind == RobotJointKind::kFixed;
    section.table.add({joint.name, name_of(joint.kind), joint.parent, joint.child,
                       fixed ? "-" : in_units(joint.lower, sliding),
                       fixed ? "-" : in_units(joint.upper, sliding), or_dash(joint.dof)});
  }
  return section;
}

Section explain_links(const RobotSpec& robot) {
  Section section{"links", "Links", {{"name", "digit", "mass_g", "material", "shapes"}}};
  for (const RobotLink& link : robot.links)
    section.table.add({link.name, or_dash(link.digit),
                       link.mass > 0 ? shown(link.mass * 1e3, 1) : "-", or_dash(link.material),
                       std::to_string(link.shapes.size())});
  return section;
}

}  // namespace

Explanation explain(const BodySpec& body) {
  Section header{"object", fmt::format("object '{}'", body.name)};
  header.lines = {body.description, "source " + or_dash(body.source),
                  "material " + or_dash(body.material), "mass " + mass_of(body)};
  return {header, explain_shapes(body)};
}

Explanation explain(const WorldSpec& world) {
  Section header{"world", fmt::format("world '{}'", world.name)};
  header.lines = {world.description,
                  "materials " + (world.materials_file.empty() ? std::string("built in")
                                                               : world.materials_file)};
  return {header, explain_hands(world), explain_bodies(world)};
}

Explanation explain(const SceneSpec& scene) {
  Section header{"scene", summary_of(scene)};
  header.lines = {or_dash(scene.description), "source " + or_dash(scene.source),
                  "method " + scene.stepping.method};
  WorldSpec hands;
  hands.hands = transformed(scene.hands, &SceneHandSpec::placed);
  return {header, explain_hands(hands), explain_scene_bodies(scene), explain_pads(scene),
          explain_pad_constants(scene)};
}

Explanation explain(const Materials& materials) {
  Section section{"materials", "Materials", {{"name", "density_kg_m3", "young_kPa", "layer_mm"}}};
  for (const Material& material : materials.materials)
    section.table.add({material.name, material.density > 0 ? shown(material.density, 0) : "-",
                       material.young > 0 ? shown(material.young / 1e3, 1) : "rigid",
                       material.young > 0 ? shown(material.layer_thickness / kMm, 2) : "-"});
  return {section, explain_friction(materials)};
}

Explanation explain(const RobotSpec& robot) {
  Section header{
      "robot",
      fmt::format("robot '{}': {}, {}, {}", robot.name, counted(robot.links.size(), "link"),
                  counted(robot.joints.size(), "joint"), counted(robot.dofs.size(), "motor"))};
  header.lines = {or_dash(robot.description), "source " + or_dash(robot.source)};
  return {header, explain_motors(robot), explain_robot_joints(robot), explain_links(robot)};
}

}  // namespace thenar
