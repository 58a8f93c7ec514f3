#include "live/scene_picture.h"

#include <algorithm>

#include "base/numbers.h"
#include "base/units.h"
#include "dynamics/human/joint_stops.h"

namespace thenar {
namespace {

/// Returns the joint that represents a coordinate: the first with ratio 1, else the first.
int leading_joint(const Mechanism& mechanism, int coordinate) {
  int first = -1;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const MechanismJoint& joint = mechanism.joints[i];
    if (!is_moved_by(joint, coordinate)) continue;
    if (joint.ratio == 1 && joint.offset == 0 && joint.curve.empty()) return static_cast<int>(i);
    if (first < 0) first = static_cast<int>(i);
  }
  return first;
}

/// Builds the drawn body of a body of the mechanism.
LiveBody body_of_picture(const BuiltScene& built, std::size_t i) {
  const MechanismBody& body = built.scene.mechanism.bodies[i];
  // Copy the names and the material, which sets the colour.
  LiveBody out;
  out.name = body.name;
  out.owner = built.owner[i];
  out.digit = body.digit;
  out.material = body.material;
  // Set the role: links and bones have a hand as owner, other bodies own themselves.
  if (body.name != built.owner[i])
    out.role = body.material == "bone" ? LiveRole::kBone : LiveRole::kLink;
  else if (carrier_by_welds(built.scene.mechanism, static_cast<int>(i)) < 0)
    out.role = LiveRole::kObstacle;
  // Set the surface.
  out.crease = crease_of(body.material);
  if (body.solid && !body.solid->visual.empty()) out.mesh = picture_of_solid(body.solid);
  return out;
}

void add_bodies(const BuiltScene& built, ScenePicture& out) {
  const Mechanism& mechanism = built.scene.mechanism;
  out.shape_body_of.assign(mechanism.bodies.size(), -1);
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    // Skip bodies without a surface, unless a joint moves them.
    const std::shared_ptr<const Solid>& solid = mechanism.bodies[i].solid;
    if ((!solid || solid->visual.empty()) && !is_scalar(mechanism.joints[i].kind)) continue;
    out.shape_body_of[i] = static_cast<int>(out.body_of.size());
    out.body_of.push_back(static_cast<int>(i));
    out.shape.bodies.push_back(body_of_picture(built, i));
  }
}

void add_joints(const BuiltScene& built, ScenePicture& out) {
  const Mechanism& mechanism = built.scene.mechanism;
  const std::vector<CoordinateRange> ranges = coordinate_ranges(built.scene);
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const MechanismJoint& joint = mechanism.joints[i];
    if (!is_scalar(joint.kind)) continue;
    const int c = joint.coordinate;
    const bool leads = leading_joint(mechanism, joint.coordinate) == static_cast<int>(i);
    const std::string& coordinate = mechanism.coordinates[c].name;
    // Name the leading joint after the coordinate.
    LiveJoint shown;
    shown.name = leads ? coordinate : joint.name;
    shown.hand = built.owner[i];
    shown.body = out.shape_body_of[i];
    // The axis is z of the joint's frame on the body.
    shown.axis = joint.X_BM.R.col(2);
    shown.point = joint.X_BM.p;
    shown.slides = joint.kind == JointKind::kSlide;
    // The leading joint has the coordinate's range, the others have their own limits.
    const CoordinateRange range = ranges[c];
    shown.lower = leads ? range.lower : std::max(joint.lower, -2 * kPi);
    shown.upper = leads ? range.upper : std::min(joint.upper, 2 * kPi);
    if (!leads) shown.led_by = coordinate;
    out.shape.joints.push_back(std::move(shown));
    out.joint_of.push_back(static_cast<int>(i));
    out.leads.push_back(leads);
  }
}

/// Narrows the range of a coordinate to the limits of one of its joints. Nonlinear couplings are
/// approximated by their linear part.
void narrow_range(const MechanismJoint& joint, CoordinateRange& range) {
  if (joint.ratio == 0) return;
  double lower = (joint.lower - joint.offset) / joint.ratio;
  double upper = (joint.upper - joint.offset) / joint.ratio;
  if (lower > upper) std::swap(lower, upper);
  range.lower = std::max(range.lower, lower);
  range.upper = std::min(range.upper, upper);
}

/// Sets the ranges of coordinates with joint stops, which are force elements of human hands.
void set_stop_ranges(const MovingScene& scene, std::vector<CoordinateRange>& ranges) {
  const MechanismLayout layout = layout_of(scene.mechanism);
  for (const std::shared_ptr<const ForceElement>& element : scene.elements) {
    const auto* stops = dynamic_cast<const JointStops*>(element.get());
    if (stops == nullptr) continue;
    for (std::size_t k = 0; k < stops->indices().q.size(); ++k)
      for (std::size_t c = 0; c < ranges.size(); ++c)
        if (layout.coordinate_q[c] == stops->indices().q[k])
          ranges[c] = {stops->ranges()[k].lower, stops->ranges()[k].upper};
  }
}

}  // namespace

std::vector<CoordinateRange> coordinate_ranges(const MovingScene& scene) {
  const Mechanism& mechanism = scene.mechanism;
  // Start from unlimited coordinates.
  std::vector<CoordinateRange> ranges(mechanism.coordinates.size(), {-kInfinity, kInfinity});
  // Narrow the ranges to the limits of joints, and apply the joint stops of human hands.
  std::vector<bool> slides(ranges.size(), false);
  for (const MechanismJoint& joint : mechanism.joints) {
    if (!is_scalar(joint.kind)) continue;
    if (joint.kind == JointKind::kSlide) slides[joint.coordinate] = true;
    narrow_range(joint, ranges[joint.coordinate]);
  }
  set_stop_ranges(scene, ranges);
  // Give unlimited coordinates half a turn or a metre to either side.
  for (std::size_t c = 0; c < ranges.size(); ++c) {
    const double limit = slides[c] ? 1 : kPi;
    if (ranges[c].lower == -kInfinity) ranges[c].lower = -limit;
    if (ranges[c].upper == kInfinity) ranges[c].upper = limit;
  }
  return ranges;
}

ScenePicture scene_picture(const BuiltScene& built, const std::optional<Camera>& camera) {
  ScenePicture out;
  // Add bodies first, because joints and contacts refer to their indices.
  add_bodies(built, out);
  add_joints(built, out);
  // Add forces and moments as arrows, tendons as lines.
  for (std::size_t i = 0; i < built.scene.forces.size(); ++i) {
    const bool is_moment = built.scene.forces[i].force.isZero(0);
    const std::string& name = i < built.force_names.size() ? built.force_names[i] : "";
    out.shape.arrows.push_back({name.empty() ? fmt::format("force {}", i + 1) : name,
                                is_moment ? LiveArrowKind::kMoment : LiveArrowKind::kForce});
    out.is_moment.push_back(is_moment);
  }
  out.tendons = SceneTendons(built);
  out.shape.lines = out.tendons.lines();
  if (camera) {
    out.shape.eye = camera->eye;
    out.shape.target = camera->target;
  }
  return out;
}

LiveInstant scene_instant(const ScenePicture& picture, const MovingScene& scene,
                          const MechanismLayout& layout, const SceneView& view) {
  LiveInstant out;
  out.time = view.t;
  // Set poses and joint values; a joint that follows a coordinate has its own value.
  for (const int body : picture.body_of) out.bodies.push_back(view.X_WB[body]);
  for (std::size_t k = 0; k < picture.joint_of.size(); ++k) {
    const int i = picture.joint_of[k];
    const double u = view.q[layout.first_q[i]];
    out.joints.push_back(picture.leads[k] ? u : joint_value(scene.mechanism.joints[i], u).value);
  }
  out.line_points = picture.tendons.points(view.q, view.X_WB);
  out.tensions = picture.tendons.tensions(view.q, view.tension);
  // Set the arrows; forces that are not active at this time have zero length.
  for (std::size_t k = 0; k < scene.forces.size(); ++k) {
    const SceneForce& force = scene.forces[k];
    const Eigen::Vector3d at = view.X_WB[force.body] * force.point;
    const Eigen::Vector3d vector = picture.is_moment[k] ? force.moment : force.force;
    out.arrows.push_back({at, force.when.contains(view.t) ? vector : Eigen::Vector3d(0, 0, 0)});
  }
  // Convert the contacts to the bodies of the shape; friction sets the angle of the cone.
  for (const ContactSample& contact : view.contacts)
    out.contacts.push_back({picture.shape_body_of[contact.a], picture.shape_body_of[contact.b],
                            contact.point, contact.normal, contact.force,
                            pair_friction(scene, contact.a, contact.b).coefficient});
  return out;
}

}  // namespace thenar
