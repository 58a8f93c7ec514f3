#include "dynamics/ligament/compliant_joint.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/lists.h"
#include "base/nearest_name.h"

namespace thenar {
namespace {

// Smallest part of a bone's direction across the hinge, over its length [1]
constexpr double kMinBoneAcross = 0.1;

/// Order of the joints from the proximal to the distal bone.
constexpr std::array<BushingCoordinate, kBushingCoordinates> kChain{
    BushingCoordinate::kAcross,  BushingCoordinate::kAlong,     BushingCoordinate::kAxial,
    BushingCoordinate::kFlexion, BushingCoordinate::kAbduction, BushingCoordinate::kTwist};

std::size_t index_of(BushingCoordinate coordinate) { return static_cast<std::size_t>(coordinate); }

bool is_rigid(const BushingLaw& law, BushingCoordinate coordinate) {
  return coordinate != BushingCoordinate::kFlexion && std::isinf(law.law_for(coordinate).stiffness);
}

/// Returns the rotation of the bushing's frame in the hinge's: z is the hinge's axis, y the
/// component of the bone across it.
Eigen::Matrix3d bone_frame(const Mechanism& mechanism, std::size_t body,
                           const Eigen::Vector3d& bone) {
  const MechanismJoint& joint = mechanism.joints[body];
  // Direction of the bone, by default towards the centre of mass.
  require(!bone.isZero(0) || mechanism.bodies[body].mass.mass > 0,
          "joint '{}': '{}' has no mass, so that nothing says where its bone points: state one, "
          "'bone'",
          joint.name, mechanism.bodies[body].name);
  const Eigen::Vector3d direction =
      bone.isZero(0) ? mechanism.bodies[body].mass.com - joint.X_BM.p : bone;
  // Component of the bone across the hinge.
  Eigen::Vector3d y = joint.X_BM.R.transpose() * direction;
  const double length = y.norm();
  y.z() = 0;
  require(direction.allFinite() && y.norm() > kMinBoneAcross * length,
          "joint '{}': its bone has no direction across the hinge: state one", joint.name);
  y.normalize();
  Eigen::Matrix3d R;
  R << y.cross(Eigen::Vector3d::UnitZ()), y, Eigen::Vector3d::UnitZ();
  return R;
}

/// Returns the rotation of a frame in the bushing's frame whose z is the axis of a coordinate.
Eigen::Matrix3d axis_frame(BushingCoordinate coordinate) {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  const bool along_x =
      coordinate == BushingCoordinate::kAcross || coordinate == BushingCoordinate::kAbduction;
  const bool along_y =
      coordinate == BushingCoordinate::kAlong || coordinate == BushingCoordinate::kTwist;
  if (along_x) R << 0, 0, 1, 1, 0, 0, 0, 1, 0;  // columns y, z, x
  if (along_y) R << 0, 1, 0, 0, 0, 1, 1, 0, 0;  // columns z, x, y
  return R;
}

void check_hinge(const Mechanism& mechanism, const MechanismJoint& hinge) {
  require(hinge.kind == JointKind::kHinge, "joint '{}' is a {}: only hinges give", hinge.name,
          name_in(kJointKindNames, hinge.kind));
  const auto shares = std::count_if(
      mechanism.joints.begin(), mechanism.joints.end(),
      [&](const MechanismJoint& joint) { return is_moved_by(joint, hinge.coordinate); });
  require(shares == 1, "joint '{}' shares its coordinate with others: it cannot give", hinge.name);
  require(hinge.ratio == 1 && hinge.offset == 0 && hinge.curve.empty(),
          "joint '{}' does not turn as its coordinate does (ratio {:g}, offset {:g} rad{}): it "
          "cannot give, as flexion is the coordinate",
          hinge.name, hinge.ratio, hinge.offset, hinge.curve.empty() ? "" : ", a curve");
}

/// Returns the joint of the chain at a coordinate: the hinge itself, or a slide or hinge with a new
/// coordinate of the mechanism.
MechanismJoint chain_joint(Mechanism& mechanism, const MechanismJoint& hinge,
                           BushingCoordinate coordinate) {
  if (coordinate == BushingCoordinate::kFlexion) return hinge;
  MechanismJoint link;
  link.name = hinge.name + "/" + bushing_coordinate_names()[index_of(coordinate)];
  link.kind = coordinate < BushingCoordinate::kFlexion ? JointKind::kSlide : JointKind::kHinge;
  link.coordinate = static_cast<int>(mechanism.coordinates.size());
  mechanism.coordinates.push_back({link.name});
  return link;
}

}  // namespace

CompliantJoint make_compliant(Mechanism& mechanism, int joint, const JointCompliance& compliance) {
  const auto body = static_cast<std::size_t>(joint);
  const MechanismJoint hinge = mechanism.joints.at(body);
  check_hinge(mechanism, hinge);
  CompliantJoint out{hinge.name, compliance.law, {}};
  // Select the compliant coordinates; clear the laws of the rigid ones.
  std::vector<BushingCoordinate> compliant;
  for (const BushingCoordinate coordinate : kChain) {
    out.coordinate[index_of(coordinate)] = -1;
    if (is_rigid(compliance.law, coordinate))
      out.law.law_for(coordinate) = {};
    else
      compliant.push_back(coordinate);
  }
  check_law(out.law);

  // Build the chain; all its frames coincide with the hinge at value 0, but for their z axes.
  const Eigen::Matrix3d R_bone = bone_frame(mechanism, body, compliance.bone);
  std::vector<MechanismJoint> chain;
  for (std::size_t k = 0; k < compliant.size(); ++k) {
    const BushingCoordinate coordinate = compliant[k];
    MechanismJoint link = chain_joint(mechanism, hinge, coordinate);
    out.coordinate[index_of(coordinate)] = link.coordinate;
    // Frames of the joint: the first one is attached to the parent, the last one to the body.
    const Pose<double> X_axis{coordinate == BushingCoordinate::kFlexion
                                  ? Eigen::Matrix3d::Identity()
                                  : Eigen::Matrix3d(R_bone * axis_frame(coordinate)),
                              Eigen::Vector3d::Zero()};
    link.parent = k == 0 ? hinge.parent : joint + static_cast<int>(k) - 1;
    link.X_PF = k == 0 ? hinge.X_PF * X_axis : X_axis;
    link.X_BM = k + 1 == compliant.size() ? hinge.X_BM * X_axis : X_axis;
    chain.push_back(std::move(link));
  }

  // Insert the massless bodies, and shift the parent indices of later bodies.
  const int added = static_cast<int>(chain.size()) - 1;
  for (std::size_t i = body + 1; i < mechanism.joints.size(); ++i)
    if (mechanism.joints[i].parent >= joint) mechanism.joints[i].parent += added;
  std::vector<MechanismBody> massless(added);
  for (int k = 0; k < added; ++k)
    massless[k].name = mechanism.bodies[body].name + " on " + chain[k].name;
  mechanism.bodies.insert(mechanism.bodies.begin() + joint, massless.begin(), massless.end());
  // Replace the hinge by the chain.
  mechanism.joints[body] = chain.front();
  mechanism.joints.insert(mechanism.joints.begin() + joint + 1, chain.begin() + 1, chain.end());
  return out;
}

int joint_index(const Mechanism& mechanism, const std::string& name) {
  return static_cast<int>(index_of_name(name, names_of(mechanism.joints), "joint"));
}

CapsuleElement::CapsuleElement(const Mechanism& mechanism, CompliantJoint joint)
    : joint_(std::move(joint)) {
  const MechanismLayout layout = layout_of(mechanism);
  // Indices of the coordinates in positions and speeds; -1 for rigid ones.
  for (std::size_t i = 0; i < q_.size(); ++i) {
    const int coordinate = joint_.coordinate[i];
    require(coordinate < static_cast<int>(layout.coordinate_q.size()),
            "joint '{}': there is no coordinate {}", joint_.name, coordinate);
    q_[i] = coordinate < 0 ? -1 : layout.coordinate_q[coordinate];
    v_[i] = coordinate < 0 ? -1 : layout.coordinate_v[coordinate];
  }
}

BushingVector CapsuleElement::coordinates(const ElementInput& at) const {
  BushingVector x = BushingVector::Zero();
  for (std::size_t i = 0; i < q_.size(); ++i)
    if (q_[i] >= 0) x[i] = at.q[q_[i]];
  return x;
}

BushingAction CapsuleElement::action(const ElementInput& at) const {
  BushingVector rate = BushingVector::Zero();
  for (std::size_t i = 0; i < v_.size(); ++i)
    if (v_[i] >= 0) rate[i] = at.v[v_[i]];
  return bushing_action(joint_.law, coordinates(at), rate);
}

bool CapsuleElement::add_action(const ElementInput& at, ElementAction& out) {
  const BushingAction action = this->action(at);
  // Add force and slopes of the compliant coordinates.
  for (std::size_t i = 0; i < v_.size(); ++i) {
    if (v_[i] < 0) continue;
    out.tau[v_[i]] += action.effort[i];
    for (std::size_t j = 0; j < v_.size(); ++j) {
      if (v_[j] < 0) continue;
      out.stiffness(v_[i], v_[j]) += action.stiffness(i, j);
      out.damping(v_[i], v_[j]) += action.damping(i, j);
    }
  }
  return std::abs(coordinates(at)[static_cast<int>(BushingCoordinate::kAbduction)]) < kMaxAbduction;
}

}  // namespace thenar
