#include "live/scene_picture.h"

#include <algorithm>
#include <limits>

#include "base/units.h"
#include "dynamics/human/joint_stops.h"

namespace thenar {
namespace {

/// The joint by which people turn a coordinate: the first that turns as it does, else the first.
int leader_of(const Mechanism& mechanism, int coordinate) {
  int first = -1;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const MechanismJoint& joint = mechanism.joints[i];
    if (!is_scalar(joint.kind) || joint.coordinate != coordinate) continue;
    if (joint.ratio == 1 && joint.offset == 0 && joint.curve.empty()) return static_cast<int>(i);
    if (first < 0) first = static_cast<int>(i);
  }
  return first;
}

/// Returns true if a body is fixed to the world through all bodies that carry it.
bool stands_still(const Mechanism& mechanism, std::size_t body) {
  for (int at = static_cast<int>(body); at >= 0; at = mechanism.joints[at].parent)
    if (mechanism.joints[at].kind != JointKind::kWeld) return false;
  return true;
}

LiveBody body_of_picture(const BuiltScene& built, std::size_t i) {
  const MechanismBody& body = built.scene.mechanism.bodies[i];
  // Copy names and material, by which the viewer picks colours.
  LiveBody out;
  out.name = body.name;
  out.owner = built.owner[i];
  out.digit = body.digit;
  out.material = body.material;
  // Links are called after their hand; anything else is its own owner.
  if (body.name != built.owner[i])
    out.role = body.material == "bone" ? LiveRole::kBone : LiveRole::kLink;
  else if (stands_still(built.scene.mechanism, i))
    out.role = LiveRole::kObstacle;
  out.crease = crease_of(body.material);
  if (body.solid && !body.solid->visual.empty()) out.mesh = picture_of_solid(body.solid);
  return out;
}

void add_bodies(const BuiltScene& built, ScenePicture& out) {
  const Mechanism& mechanism = built.scene.mechanism;
  out.shown_as.assign(mechanism.bodies.size(), -1);
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    // Bodies without a surface are left out, unless a joint turns them.
    const std::shared_ptr<const Solid>& solid = mechanism.bodies[i].solid;
    if ((!solid || solid->visual.empty()) && !is_scalar(mechanism.joints[i].kind)) continue;
    out.shown_as[i] = static_cast<int>(out.body_of.size());
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
    const auto c = static_cast<std::size_t>(joint.coordinate);
    const bool leads = leader_of(mechanism, joint.coordinate) == static_cast<int>(i);
    const std::string& coordinate = mechanism.coordinates[c].name;
    // The leading joint has the coordinate's name and range, joints that follow their own limits.
    LiveJoint shown;
    shown.name = leads ? coordinate : joint.name;
    shown.hand = built.owner[i];
    shown.body = out.shown_as[i];
    // The joint's axis is z of its frame on the body.
    shown.axis = joint.X_BM.R.col(2);
    shown.point = joint.X_BM.p;
    shown.slides = joint.kind == JointKind::kSlide;
    const CoordinateRange range = ranges[c];
    shown.lower = leads ? range.lower : std::max(joint.lower, -2 * kPi);
    shown.upper = leads ? range.upper : std::min(joint.upper, 2 * kPi);
    if (!leads) shown.led_by = coordinate;
    out.shape.joints.push_back(std::move(shown));
    out.joint_of.push_back(static_cast<int>(i));
    out.leads.push_back(leads);
  }
}

/// Narrows the range of a coordinate to where a joint is within its limits. Curved couplings are
/// taken for the straight ones that they begin as.
void narrow(const MechanismJoint& joint, CoordinateRange& range) {
  if (joint.ratio == 0) return;
  double lower = (joint.lower - joint.offset) / joint.ratio;
  double upper = (joint.upper - joint.offset) / joint.ratio;
  if (lower > upper) std::swap(lower, upper);
  range.lower = std::max(range.lower, lower);
  range.upper = std::min(range.upper, upper);
}

/// Stops of human hands, which are elements.
void narrow_by_stops(const MovingScene& scene, std::vector<CoordinateRange>& ranges) {
  const MechanismLayout layout = layout_of(scene.mechanism);
  for (const std::shared_ptr<const ForceElement>& element : scene.elements) {
    const auto* stops = dynamic_cast<const JointStops*>(element.get());
    if (stops == nullptr) continue;
    for (std::size_t k = 0; k < stops->places().q.size(); ++k)
      for (std::size_t c = 0; c < ranges.size(); ++c)
        if (layout.coordinate_q[c] == stops->places().q[k])
          ranges[c] = {stops->ranges()[k].lower, stops->ranges()[k].upper};
  }
}

}  // namespace

std::vector<CoordinateRange> coordinate_ranges(const MovingScene& scene) {
  const Mechanism& mechanism = scene.mechanism;
  // Start from unbounded coordinates.
  constexpr double kNone = std::numeric_limits<double>::infinity();
  std::vector<CoordinateRange> ranges(mechanism.coordinates.size(), {-kNone, kNone});
  // Ranges by limits of joints and stops of hands.
  std::vector<bool> slides(ranges.size(), false);
  for (const MechanismJoint& joint : mechanism.joints) {
    if (!is_scalar(joint.kind)) continue;
    const auto c = static_cast<std::size_t>(joint.coordinate);
    slides[c] = slides[c] || joint.kind == JointKind::kSlide;
    narrow(joint, ranges[c]);
  }
  narrow_by_stops(scene, ranges);
  // Default range of an unbounded coordinate: half a turn or a metre either way.
  for (std::size_t c = 0; c < ranges.size(); ++c) {
    const double far = slides[c] ? 1 : kPi;
    if (ranges[c].lower == -kNone) ranges[c].lower = -far;
    if (ranges[c].upper == kNone) ranges[c].upper = far;
  }
  return ranges;
}

ScenePicture scene_picture(const BuiltScene& built, const std::optional<Camera>& camera) {
  ScenePicture out;
  // Bodies first, because joints and contacts refer to their indices.
  add_bodies(built, out);
  add_joints(built, out);
  // Forces and moments as arrows, tendons as lines.
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
  // Bodies and joints; a joint that follows is shown at its own value.
  const auto pose = [&](int body) { return view.X_WB[body]; };
  for (const int body : picture.body_of) out.bodies.push_back(pose(body));
  for (std::size_t k = 0; k < picture.joint_of.size(); ++k) {
    const auto i = static_cast<std::size_t>(picture.joint_of[k]);
    const double u = view.q[layout.first_q[i]];
    out.joints.push_back(picture.leads[k] ? u : joint_value(scene.mechanism.joints[i], u).value);
  }
  out.line_points = picture.tendons.points(view.q, view.X_WB);
  out.tensions = picture.tendons.tensions(view.q, view.tension);
  // Arrows of forces that do not act now have no length.
  for (std::size_t k = 0; k < scene.forces.size(); ++k) {
    const SceneForce& force = scene.forces[k];
    const Eigen::Vector3d at = pose(force.body) * force.point;
    const Eigen::Vector3d vector = picture.is_moment[k] ? force.moment : force.force;
    out.arrows.push_back({at, force.when.holds(view.t) ? vector : Eigen::Vector3d(0, 0, 0)});
  }
  // Contacts refer to bodies as they are drawn; friction sets the width of the cone.
  for (const ContactSample& contact : view.contacts) {
    LiveContact shown;
    shown.a = picture.shown_as[contact.a];
    shown.b = picture.shown_as[contact.b];
    shown.point = contact.point;
    shown.normal = contact.normal;
    shown.force = contact.force;
    shown.friction = pair_friction(scene, contact.a, contact.b).coefficient;
    out.contacts.push_back(shown);
  }
  return out;
}

}  // namespace thenar
