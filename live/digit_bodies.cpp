#include "live/digit_bodies.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "base/error.h"
#include "base/lists.h"
#include "geometry/solid.h"
#include "hand/skin/human_surfaces.h"
#include "hand/skin/skin_body.h"
#include "tendons/neighbouring_axes.h"

namespace thenar {
namespace {

constexpr int kSkinTriangles = 1500;       // triangles of a phalanx's skin; enough to look smooth
constexpr double kBoneRadius = 2.5e-3;     // radius of capsules [m]
constexpr double kAxisArrowLength = 0.03;  // length of an arrow along an axis [m]
constexpr double kMinBoneLength = 1e-6;    // distance of axes below which they share a point [m]

/// Bodies of a digit, and how to add one.
struct BodyList {
  const std::string& digit;
  DigitBodies& out;

  void add(const std::string& name, LiveRole role, int link,
           std::shared_ptr<const TriangleMesh> mesh) {
    LiveBody body;
    body.name = digit + "/" + name;
    body.owner = body.digit = digit;
    body.material = role == LiveRole::kBone ? "bone" : "skin";
    body.role = role;
    body.mesh = std::move(mesh);
    out.bodies.push_back(std::move(body));
    out.links.push_back(link);
  }
};

/// Returns the rotation that lays the digit along x with its dorsal side up.
Pose<double> upright_frame(const TendonDigit& digit) {
  // Columns of tip_axes: proximal, dorsal, radial. Project the distal direction onto the plane.
  const Eigen::Vector3d up = digit.model.tip_axes.col(1).normalized();
  const Eigen::Vector3d distal = -digit.model.tip_axes.col(0);
  const Eigen::Vector3d along = (distal - distal.dot(up) * up).normalized();
  Pose<double> X;
  X.R.row(0) = along.transpose();
  X.R.row(1) = up.cross(along).transpose();
  X.R.row(2) = up.transpose();
  return X;
}

void add_bones(const Subject& subject, const TendonDigit& digit, BodyList& list) {
  for (const LinkSurface& bone : bone_surfaces(subject, digit.skeleton))
    list.add(bone.name + " bone", LiveRole::kBone, bone.link, picture_of_solid(bone.solid));
}

/// Adds the skin of the digit's own bones; the skin of the palm would hide the tendons.
void add_skin(const HandAnatomy& hand, const std::string& name, const TendonDigit& digit,
              BodyList& list) {
  const DigitAnatomy* anatomy = digit_named(hand, name);
  if (anatomy == nullptr) return;
  // Mesh the skin of each bone in the reference posture.
  const std::map<std::string, ImplicitBody> skins = skin_bodies(hand);
  for (const DigitBone& bone : anatomy->bones) {
    const auto skin = skins.find(bone.segment);
    const auto link = digit.skeleton.link_of_segment.find(bone.segment);
    if (skin == skins.end() || link == digit.skeleton.link_of_segment.end()) continue;
    // Transform it to the link's frame, which frozen joints may have displaced.
    const Pose<double>& X = digit.skeleton.segment_at.at(bone.segment);
    TriangleMesh mesh = skin_mesh(skin->second, kSkinTriangles);
    mesh.vertices = ((X.R * mesh.vertices).colwise() + X.p).eval();
    list.add(bone.segment + " skin", LiveRole::kLink, link->second,
             std::make_shared<const TriangleMesh>(std::move(mesh)));
  }
}

/// Builds the mesh of a capsule between two points.
std::shared_ptr<const TriangleMesh> capsule_mesh(const Eigen::Vector3d& a,
                                                 const Eigen::Vector3d& b) {
  ShapeSpec shape;
  shape.kind = ShapeKind::kCapsule;
  // Turn z, the axis of a capsule, onto the segment, and centre the capsule on it.
  shape.size = {kBoneRadius, (b - a).norm(), 0};
  shape.X_BS = frame_with_z((b - a).normalized(), (a + b) / 2);
  return std::make_shared<const TriangleMesh>(build_solid({shape}).visual);
}

/// Adds capsules from axis to axis to the tip.
void add_capsules(const TendonDigit& digit, BodyList& list) {
  const TendonModel<double>& model = digit.model;
  const TreeState<double> state =
      pose_tree(model.tree, Eigen::VectorXd::Zero(model.coordinates).eval());
  std::vector<Eigen::Vector3d> ends = axis_points(model, state);
  ends.push_back(moved(state, model.tip_link, model.tip));
  // Draw one capsule for each pair of neighbours; skip axes that intersect (universal joints).
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    if ((ends[i + 1] - ends[i]).norm() < kMinBoneLength) continue;
    const Pose<double> X = state[i].X.inverse();
    list.add(digit.names.hinges[i] + " bone", LiveRole::kBone, static_cast<int>(i),
             capsule_mesh(X * ends[i], X * ends[i + 1]));
  }
}

/// Returns the joints, each at the point where the bone crosses its axis.
std::vector<LiveJoint> joints_of(const std::string& name, const TendonDigit& digit,
                                 const std::vector<int>& links) {
  const TendonModel<double>& model = digit.model;
  const TreeState<double> state =
      pose_tree(model.tree, Eigen::VectorXd::Zero(model.coordinates).eval());
  const std::vector<Eigen::Vector3d> points = axis_points(model, state);
  std::vector<LiveJoint> joints;
  for (std::size_t i = 0; i < model.tree.size(); ++i) {
    const Hinge<double>& hinge = model.tree[i];
    const CoordinateLimits& limits = digit.skeleton.limits[hinge.coordinate];
    const std::string& leader = digit.names.coordinates[hinge.coordinate];
    LiveJoint joint;
    joint.name = digit.names.hinges[i];
    joint.hand = name;
    joint.body = place_in(links, static_cast<int>(i));
    joint.axis = hinge.direction;
    joint.point = state[i].X.inverse() * points[i];
    // Map the limits of the coordinate to the hinge; a negative ratio swaps them.
    const double a = hinge.ratio * limits.lower + hinge.offset;
    const double b = hinge.ratio * limits.upper + hinge.offset;
    joint.lower = std::min(a, b);
    joint.upper = std::max(a, b);
    if (leader != joint.name) joint.led_by = leader;
    joints.push_back(std::move(joint));
  }
  return joints;
}

}  // namespace

DigitBodies digit_bodies(const Subject& subject, const std::string& name, const TendonDigit& digit,
                         DigitLook look) {
  DigitBodies out;
  out.X_WS = upright_frame(digit);
  BodyList list{name, out};
  // Look up the anatomy; a subject without one is drawn as capsules, with a warning.
  std::optional<HandAnatomy> hand;
  if (look == DigitLook::kAnatomy) try {
      hand = find_anatomy(subject);
    } catch (const InputError& error) {
      out.warnings.push_back(std::string("capsules stand for bones: ") + error.what());
    }
  if (hand) {
    add_bones(subject, digit, list);
    add_skin(*hand, name, digit, list);
  } else {
    add_capsules(digit, list);
  }
  // Give every remaining link (of a universal joint) a body without a mesh, for its joint.
  for (int link = 0; link < static_cast<int>(digit.model.tree.size()); ++link)
    if (!contains(out.links, link))
      list.add(digit.names.hinges[link] + " link", LiveRole::kBone, link, nullptr);
  out.joints = joints_of(name, digit, out.links);
  return out;
}

std::vector<Pose<double>> body_poses(const DigitBodies& bodies, const TreeState<double>& state) {
  return transformed(bodies.links, [&](const int link) {
    return link < 0 ? bodies.X_WS : bodies.X_WS * state[link].X;
  });
}

std::vector<double> hinge_angles(const TendonModel<double>& model, const Eigen::VectorXd& q) {
  return transformed(model.tree, [&](const Hinge<double>& hinge) {
    return hinge.ratio * q[hinge.coordinate] + hinge.offset;
  });
}

std::vector<LiveArrow> axis_arrows(const std::vector<std::string>& names) {
  return transformed(names, [](const std::string& name) {
    return LiveArrow{name, LiveArrowKind::kAxis};
  });
}

std::vector<LiveVector> axis_vectors(const DigitBodies& bodies, const TendonModel<double>& model,
                                     const TreeState<double>& state) {
  const std::vector<Eigen::Vector3d> points = axis_points(model, state);
  std::vector<LiveVector> arrows;
  arrows.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    // Centre each arrow on the point where the bone crosses the axis.
    const Eigen::Vector3d arrow = kAxisArrowLength * (bodies.X_WS.R * state[i].axis);
    arrows.push_back({bodies.X_WS * points[i] - arrow / 2, arrow});
  }
  return arrows;
}

void aim_at_digit(const DigitBodies& bodies, const TendonModel<double>& model,
                  const TreeState<double>& state, LiveShape& shape) {
  // Compute the bounding box of all joints and the tip.
  std::vector<Eigen::Vector3d> points = axis_points(model, state);
  points.push_back(moved(state, model.tip_link, model.tip));
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : points) box.extend(bodies.X_WS * p);
  // Look at its centre, from far enough for a field of view of 40 degrees: 1.8 diagonals and 5 cm.
  shape.target = box.center();
  shape.eye = box.center() +
              (1.8 * box.diagonal().norm() + 0.05) * Eigen::Vector3d(0.25, -1, 0.35).normalized();
}

}  // namespace thenar
