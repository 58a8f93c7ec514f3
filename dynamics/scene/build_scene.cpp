#include "dynamics/scene/build_scene.h"

#include <memory>
#include <utility>

#include "base/error.h"
#include "base/lists.h"
#include "data/io/toml_node.h"
#include "dynamics/scene/scene_compliance.h"
#include "dynamics/scene/scene_drives.h"
#include "dynamics/scene/scene_humans.h"
#include "dynamics/scene/scene_pads.h"
#include "dynamics/scene/scene_pairs.h"
#include "dynamics/scene/scene_parts.h"

namespace thenar {
namespace {

/// Assembles a scene: joins its parts, and adds force elements, loads, drives and pairs.
class SceneAssembler {
 public:
  explicit SceneAssembler(const SceneSpec& spec) : spec_(spec) {}

  BuiltScene build(const std::vector<SceneHand>& hands) {
    // Build the parts, join them into one mechanism, and set the initial state.
    SceneParts made = build_scene_parts(spec_, hands);
    built_.warnings = std::move(made.warnings);
    add_parents_first(made.parts);
    set_start(made.parts);
    // Add the force elements: capsules, ligaments, muscles.
    for (const CompliantJoint& joint : compliant_)
      built_.scene.elements.push_back(
          std::make_shared<CapsuleElement>(built_.scene.mechanism, joint));
    append_all(built_.scene.elements, build_scene_ligaments(spec_, built_.scene.mechanism, X_WB_));
    add_human_elements(spec_, made.humans, built_);
    exclude_web_contacts(made.humans, built_);
    // Add loads, drives and options, and check the scene before pads and pairs are added.
    built_.scene.gravity = spec_.gravity;
    add_forces(spec_, built_);
    add_drives(spec_, built_);
    set_stepping(spec_, built_);
    at_line(spec_.path, spec_.stepping.line, [&] { check_scene(built_.scene); });
    add_pads(spec_, made.humans, built_);
    set_pairs(spec_, built_);
    set_hard_point_friction(spec_, built_);
    return std::move(built_);
  }

 private:
  /// Returns true if a body name belongs to the part: its own name, or "HAND/LINK" of a hand.
  static bool owns_name(const ScenePart& part, const std::string& name) {
    return part.prefix.empty() ? part.name == name
                               : name.compare(0, part.prefix.size(), part.prefix) == 0;
  }

  /// Adds all parts to the mechanism, each after the part that carries it. The reader has already
  /// refused cycles of parents.
  void add_parents_first(std::vector<ScenePart>& parts) {
    // Depth-first search.
    std::vector<ScenePart> ordered;
    std::vector<bool> added(parts.size(), false);
    // NOLINTNEXTLINE(misc-no-recursion): as deep as parts carry each other
    const auto add = [&](const auto& self, std::size_t i) -> void {
      if (added[i]) return;
      added[i] = true;
      for (std::size_t j = 0; j < parts.size(); ++j)
        if (j != i && !parts[i].joint.parent.empty() && owns_name(parts[j], parts[i].joint.parent))
          self(self, j);
      add_part(parts[i]);
      ordered.push_back(parts[i]);
    };
    for (std::size_t i = 0; i < parts.size(); ++i) add(add, i);
    parts = std::move(ordered);
  }

  void add_part(const ScenePart& part) {
    Mechanism& whole = built_.scene.mechanism;
    int carrier = -1;
    Pose<double> X_CW;
    // Find the body that carries the part, and its pose.
    if (!part.joint.parent.empty()) {
      carrier = at_line(spec_.path, part.joint.line,
                        [&] { return body_named(whole, part.joint.parent); });
      X_CW = X_WB_[carrier].inverse();
    }
    // Shift the coordinate indices of compliant joints by those of earlier parts.
    for (CompliantJoint joint : part.compliant) {
      joint.name = part.prefix + joint.name;
      for (int& c : joint.coordinate)
        if (c >= 0) c += static_cast<int>(whole.coordinates.size());
      compliant_.push_back(std::move(joint));
    }
    // Append bodies and coordinates.
    append(whole, part.mechanism, part.prefix, carrier, X_CW);
    X_WB_.insert(X_WB_.end(), part.X_WB.begin(), part.X_WB.end());
    built_.owner.resize(whole.bodies.size(), part.name);
  }

  /// Sets the initial positions and speeds.
  /// @param parts  parts in the order in which they were added
  void set_start(const std::vector<ScenePart>& parts) {
    MovingScene& scene = built_.scene;
    const MechanismLayout layout = layout_of(scene.mechanism);
    scene.q = reference_position(scene.mechanism);
    scene.v = Eigen::VectorXd::Zero(layout.v);
    // Bodies and coordinates of consecutive parts are consecutive.
    std::size_t body = 0, coordinate = 0;
    for (const ScenePart& part : parts) {
      for (std::size_t c = 0; c < part.u.size(); ++c, ++coordinate) {
        scene.q[layout.coordinate_q[coordinate]] = part.u[c];
        scene.v[layout.coordinate_v[coordinate]] = part.u_dot[c];
      }
      if (part.joint.kind == JointKind::kBall)
        scene.v.segment<3>(layout.first_v[body]) = part.joint.spin;
      if (part.joint.kind == JointKind::kFree) set_free(static_cast<int>(body), part.velocity);
      body += part.mechanism.bodies.size();
    }
  }

  /// Sets the initial pose and velocity of a free body.
  void set_free(int body, const SceneVelocity& velocity) {
    MovingScene& scene = built_.scene;
    set_free_pose(scene.mechanism, body, X_WB_[body], scene.q);
    // Convert the velocity of the centre of mass to that of the body's origin.
    const Eigen::Vector3d arm = X_WB_[body].R * scene.mechanism.bodies[body].mass.com;
    set_free_velocity(scene.mechanism, body, scene.q, velocity.linear - velocity.angular.cross(arm),
                      velocity.angular, scene.v);
  }

  const SceneSpec& spec_;
  BuiltScene built_;
  std::vector<Pose<double>> X_WB_;  // initial poses (bodies)
  std::vector<CompliantJoint> compliant_;
};

}  // namespace

BuiltScene build_scene(const SceneSpec& spec, const std::vector<SceneHand>& hands) {
  return SceneAssembler(spec).build(hands);
}

}  // namespace thenar
