#include "dynamics/ligament/compliant_joint.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/nearest_name.h"

namespace thenar {
namespace {

/// Ways from the proximal to the distal bone.
constexpr std::array<BushingWay, kBushingWays> kChain{BushingWay::kAcross,    BushingWay::kAlong,
                                                      BushingWay::kAxial,     BushingWay::kFlexion,
                                                      BushingWay::kAbduction, BushingWay::kTwist};

std::size_t index_of(BushingWay way) { return static_cast<std::size_t>(way); }

bool is_rigid(const BushingLaw& law, BushingWay way) {
  return way != BushingWay::kFlexion && std::isinf(law.of(way).stiffness);
}

/// Rotations of the bushing's frame in the hinge's: z stays, y is the bone across it.
Eigen::Matrix3d frame_of_bone(const Mechanism& mechanism, std::size_t body,
                              const Eigen::Vector3d& bone) {
  const MechanismJoint& joint = mechanism.joints[body];
  // The bone points to the centre of mass unless the file states where.
  require(!bone.isZero(0) || mechanism.bodies[body].mass.mass > 0,
          "joint '{}': '{}' has no mass, so that nothing says where its bone points: state one, "
          "'bone'",
          joint.name, mechanism.bodies[body].name);
  const Eigen::Vector3d way =
      bone.isZero(0) ? mechanism.bodies[body].mass.com - joint.X_BM.p : bone;
  // Axis y is the bone's part across the hinge.
  Eigen::Vector3d y = joint.X_BM.R.transpose() * way;
  const double length = y.norm();
  y.z() = 0;
  require(way.allFinite() && y.norm() > 0.1 * length,
          "joint '{}': its bone has no direction across the hinge: state one", joint.name);
  y.normalize();
  Eigen::Matrix3d R;
  R << y.cross(Eigen::Vector3d::UnitZ()), y, Eigen::Vector3d::UnitZ();
  return R;
}

/// A frame of the bushing whose z is the axis of a way.
Eigen::Matrix3d axis_frame(BushingWay way) {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  const bool along_x = way == BushingWay::kAcross || way == BushingWay::kAbduction;
  const bool along_y = way == BushingWay::kAlong || way == BushingWay::kTwist;
  if (along_x) R << 0, 0, 1, 1, 0, 0, 0, 1, 0;  // columns y, z, x
  if (along_y) R << 0, 1, 0, 0, 0, 1, 1, 0, 0;  // columns z, x, y
  return R;
}

void check_hinge(const Mechanism& mechanism, const MechanismJoint& hinge) {
  require(hinge.kind == JointKind::kHinge, "joint '{}' is a {}: only hinges give", hinge.name,
          name_in(kJointKindNames, hinge.kind));
  const auto shares = std::count_if(
      mechanism.joints.begin(), mechanism.joints.end(), [&](const MechanismJoint& joint) {
        return is_scalar(joint.kind) && joint.coordinate == hinge.coordinate;
      });
  require(shares == 1, "joint '{}' shares its coordinate with others: it cannot give", hinge.name);
  require(hinge.ratio == 1 && hinge.offset == 0 && hinge.curve.empty(),
          "joint '{}' does not turn as its coordinate does (ratio {:g}, offset {:g} rad{}): it "
          "cannot give, as flexion is the coordinate",
          hinge.name, hinge.ratio, hinge.offset, hinge.curve.empty() ? "" : ", a curve");
}

}  // namespace

CompliantJoint make_compliant(Mechanism& mechanism, int joint, const JointCompliance& compliance) {
  const auto body = static_cast<std::size_t>(joint);
  const MechanismJoint hinge = mechanism.joints.at(body);
  check_hinge(mechanism, hinge);
  CompliantJoint out{hinge.name, compliance.law, {}};
  // Ways that yield; rigid ones have no law.
  std::vector<BushingWay> ways;
  for (const BushingWay way : kChain) {
    out.coordinate[index_of(way)] = -1;
    if (is_rigid(compliance.law, way))
      out.law.of(way) = {};
    else
      ways.push_back(way);
  }
  check_law(out.law);

  // All frames stand where the hinge is at value 0, its z first turned to the way's axis.
  const Pose<double> C{frame_of_bone(mechanism, body, compliance.bone), Eigen::Vector3d::Zero()};
  std::vector<MechanismJoint> chain;
  for (std::size_t k = 0; k < ways.size(); ++k) {
    const BushingWay way = ways[k];
    // Link of the chain: the hinge itself, or a slide or hinge with a coordinate of its own.
    MechanismJoint link;
    if (way == BushingWay::kFlexion) {
      link = hinge;
      out.coordinate[index_of(way)] = hinge.coordinate;
    } else {
      link.name = hinge.name + "/" + bushing_way_names()[index_of(way)];
      link.kind = way < BushingWay::kFlexion ? JointKind::kSlide : JointKind::kHinge;
      out.coordinate[index_of(way)] = link.coordinate =
          static_cast<int>(mechanism.coordinates.size());
      mechanism.coordinates.push_back({link.name});
    }
    // Frames of the link; the first hangs on the parent, the last carries the body.
    const Pose<double> own{way == BushingWay::kFlexion ? Eigen::Matrix3d::Identity()
                                                       : Eigen::Matrix3d(C.R * axis_frame(way)),
                           Eigen::Vector3d::Zero()};
    link.parent = k == 0 ? hinge.parent : joint + static_cast<int>(k) - 1;
    link.X_PF = k == 0 ? hinge.X_PF * own : own;
    link.X_BM = k + 1 == ways.size() ? hinge.X_BM * own : own;
    chain.push_back(std::move(link));
  }

  // Bodies without mass in between, and parents of those behind.
  const int added = static_cast<int>(chain.size()) - 1;
  for (std::size_t i = body + 1; i < mechanism.joints.size(); ++i)
    if (mechanism.joints[i].parent >= joint) mechanism.joints[i].parent += added;
  std::vector<MechanismBody> massless;
  for (int k = 0; k < added; ++k)
    massless.push_back(
        {mechanism.bodies[body].name + " on " + chain[static_cast<std::size_t>(k)].name,
         {0, {0, 0, 0}, Eigen::Matrix3d::Zero()},
         {},
         {}});
  mechanism.bodies.insert(mechanism.bodies.begin() + joint, massless.begin(), massless.end());
  // The chain in place of the hinge.
  mechanism.joints[body] = chain.front();
  mechanism.joints.insert(mechanism.joints.begin() + joint + 1, chain.begin() + 1, chain.end());
  return out;
}

int joint_named(const Mechanism& mechanism, const std::string& name) {
  std::vector<std::string> names;
  for (const MechanismJoint& joint : mechanism.joints) names.push_back(joint.name);
  return static_cast<int>(index_of_name(name, names, "joint"));
}

CapsuleElement::CapsuleElement(const Mechanism& mechanism, CompliantJoint joint)
    : joint_(std::move(joint)) {
  const MechanismLayout layout = layout_of(mechanism);
  // Places of coordinates in positions and speeds, -1 of rigid ways.
  for (std::size_t i = 0; i < q_.size(); ++i) {
    const int coordinate = joint_.coordinate[i];
    require(coordinate < static_cast<int>(layout.coordinate_q.size()),
            "joint '{}': there is no coordinate {}", joint_.name, coordinate);
    q_[i] = coordinate < 0 ? -1 : layout.coordinate_q[static_cast<std::size_t>(coordinate)];
    v_[i] = coordinate < 0 ? -1 : layout.coordinate_v[static_cast<std::size_t>(coordinate)];
  }
}

std::unique_ptr<ForceElement> CapsuleElement::clone() const {
  return std::make_unique<CapsuleElement>(*this);
}

BushingVector CapsuleElement::coordinates(const ElementInput& at) const {
  BushingVector x = BushingVector::Zero();
  for (std::size_t i = 0; i < q_.size(); ++i)
    if (q_[i] >= 0) x[static_cast<Eigen::Index>(i)] = at.q[q_[i]];
  return x;
}

BushingAction CapsuleElement::action(const ElementInput& at) const {
  BushingVector rate = BushingVector::Zero();
  for (std::size_t i = 0; i < v_.size(); ++i)
    if (v_[i] >= 0) rate[static_cast<Eigen::Index>(i)] = at.v[v_[i]];
  return bushing_action(joint_.law, coordinates(at), rate);
}

bool CapsuleElement::add_action(const ElementInput& at, ElementAction& out) {
  const BushingAction action = this->action(at);
  // Efforts and slopes of the ways that yield.
  for (std::size_t i = 0; i < v_.size(); ++i) {
    if (v_[i] < 0) continue;
    const auto row = static_cast<Eigen::Index>(i);
    out.tau[v_[i]] += action.effort[row];
    for (std::size_t j = 0; j < v_.size(); ++j) {
      if (v_[j] < 0) continue;
      out.stiffness(v_[i], v_[j]) += action.stiffness(row, static_cast<Eigen::Index>(j));
      out.damping(v_[i], v_[j]) += action.damping(row, static_cast<Eigen::Index>(j));
    }
  }
  return std::abs(coordinates(at)[static_cast<int>(BushingWay::kAbduction)]) < kMostAbduction;
}

double CapsuleElement::energy(const ElementInput& at) { return action(at).energy; }

}  // namespace thenar
