#include "dynamics/mechanism/simbody_mechanism.h"

#include <Simbody.h>

#include "base/error.h"

namespace thenar {
namespace internal {

SimTK::Vec3 to_simbody(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

SimTK::Transform to_simbody(const Pose<double>& X) {
  SimTK::Mat33 R;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) R(i, j) = X.R(i, j);
  return {SimTK::Rotation(R), to_simbody(X.p)};
}

Eigen::Vector3d from_simbody(const SimTK::Vec3& v) { return {v[0], v[1], v[2]}; }

Pose<double> from_simbody(const SimTK::Transform& X) {
  Pose<double> out;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out.R(i, j) = X.R()[i][j];
  out.p = from_simbody(X.p());
  return out;
}

}  // namespace internal

namespace {

using internal::to_simbody;

SimTK::MobilizedBodyIndex index_of(int body) { return SimTK::MobilizedBodyIndex(body + 1); }

/// Converts a body to Simbody's. @throws InputError if Simbody refuses its mass or inertia.
SimTK::Body::Rigid rigid_body(const MechanismBody& of) try {
  const BodyMass& body = of.mass;
  if (body.mass == 0)
    return SimTK::Body::Rigid(SimTK::MassProperties(0, SimTK::Vec3(0), SimTK::Inertia(0)));
  const Eigen::Matrix3d& I = body.inertia;
  const SimTK::Inertia central(I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2));
  const SimTK::Vec3 com = to_simbody(body.com);
  return SimTK::Body::Rigid(
      SimTK::MassProperties(body.mass, com, central.shiftFromMassCenter(-com, body.mass)));
} catch (const std::exception& failure) {
  throw InputError(fmt::format("Simbody refuses the mass of '{}': {}", of.name, failure.what()));
}

/// Difference of a joint's value from the value that its coordinate prescribes, if `leader` follows
/// the coordinate linearly.
class CouplingError : public SimTK::Function {
 public:
  CouplingError(const MechanismJoint& leader, MechanismJoint follower)
      : ratio_(leader.ratio), offset_(leader.offset), follower_(std::move(follower)) {}

  SimTK::Real calcValue(const SimTK::Vector& values) const override {
    return joint_value(follower_, (values[0] - offset_) / ratio_).value - values[1];
  }
  SimTK::Real calcDerivative(const SimTK::Array_<int>& of,
                             const SimTK::Vector& values) const override {
    // The error is linear in the follower's value; only the leader has a second derivative.
    const JointValue at = joint_value(follower_, (values[0] - offset_) / ratio_);
    if (of.size() == 1) return of[0] == 0 ? at.slope / ratio_ : -1;
    if (of.size() == 2 && of[0] == 0 && of[1] == 0) return at.bend / (ratio_ * ratio_);
    return 0;
  }
  int getArgumentSize() const override { return 2; }
  int getMaxDerivativeOrder() const override { return 2; }
  CouplingError* clone() const override { return new CouplingError(*this); }

 private:
  double ratio_, offset_;
  MechanismJoint follower_;
};

}  // namespace

struct SimbodyMechanism::Parts {
  explicit Parts(const Mechanism& m) : mechanism(m), layout(layout_of(m)), matter(system) {
    leader.assign(mechanism.coordinates.size(), -1);
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) add_body(i);
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) couple(i);
  }

  void add_body(std::size_t i) {
    const MechanismJoint& joint = mechanism.joints[i];
    const SimTK::Body::Rigid body = rigid_body(mechanism.bodies[i]);
    const SimTK::Transform F = to_simbody(joint.X_PF), M = to_simbody(joint.X_BM);
    SimTK::MobilizedBody& parent = matter.updMobilizedBody(index_of(joint.parent));
    // Add the mobilizer with the joint's frames.
    switch (joint.kind) {
      case JointKind::kWeld:
        SimTK::MobilizedBody::Weld(parent, F, body, M);
        break;
      case JointKind::kHinge:
        SimTK::MobilizedBody::Pin(parent, F, body, M);
        break;
      case JointKind::kSlide: {
        // Rotate the frames: Simbody's slider moves along x.
        const SimTK::Transform x_along_z(SimTK::Rotation(SimTK::UnitVec3(0, 0, 1), SimTK::XAxis,
                                                         SimTK::Vec3(0, 1, 0), SimTK::YAxis));
        SimTK::MobilizedBody::Slider(parent, F * x_along_z, body, M * x_along_z);
        break;
      }
      case JointKind::kBall:
        SimTK::MobilizedBody::Ball(parent, F, body, M);
        break;
      case JointKind::kFree:
        SimTK::MobilizedBody::Free(parent, F, body, M);
        break;
    }
    // Make the first joint that follows its coordinate linearly the leader.
    if (!is_scalar(joint.kind)) return;
    int& lead = leader[joint.coordinate];
    if (lead < 0 && joint.curve.empty() && joint.ratio != 0) lead = static_cast<int>(i);
  }

  void couple(std::size_t i) {
    const MechanismJoint& joint = mechanism.joints[i];
    if (!is_scalar(joint.kind)) return;
    // Couple other joints to the leader by a constraint.
    const int lead = leader[joint.coordinate];
    require(lead >= 0, "no joint follows the coordinate '{}' linearly",
            mechanism.coordinates[joint.coordinate].name);
    if (lead == static_cast<int>(i)) return;
    const SimTK::Array_<SimTK::MobilizedBodyIndex> bodies{index_of(lead),
                                                          index_of(static_cast<int>(i))};
    const SimTK::Array_<SimTK::MobilizerQIndex> values(2, SimTK::MobilizerQIndex(0));
    SimTK::Constraint::CoordinateCoupler(matter, new CouplingError(mechanism.joints[lead], joint),
                                         bodies,
                                         values);  // takes ownership of the function
  }

  [[nodiscard]] const SimTK::MobilizedBody& body(std::size_t i) const {
    return matter.getMobilizedBody(index_of(static_cast<int>(i)));
  }

  Mechanism mechanism;
  MechanismLayout layout;
  std::vector<int> leader;  // leading joint of each coordinate (coordinates)
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter;
};

SimbodyMechanism::SimbodyMechanism(const Mechanism& mechanism) {
  check_mechanism(mechanism);
  parts_ = std::make_unique<Parts>(mechanism);
}
SimbodyMechanism::~SimbodyMechanism() = default;
SimbodyMechanism::SimbodyMechanism(SimbodyMechanism&&) noexcept = default;
SimbodyMechanism& SimbodyMechanism::operator=(SimbodyMechanism&&) noexcept = default;

SimTK::MultibodySystem& SimbodyMechanism::system() const { return parts_->system; }
SimTK::SimbodyMatterSubsystem& SimbodyMechanism::matter() const { return parts_->matter; }
const Mechanism& SimbodyMechanism::mechanism() const { return parts_->mechanism; }
const MechanismLayout& SimbodyMechanism::layout() const { return parts_->layout; }
int SimbodyMechanism::leader(int coordinate) const { return parts_->leader[coordinate]; }

void SimbodyMechanism::write_state(const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                                   SimTK::State& state) const {
  require(q.size() == parts_->layout.q && v.size() == parts_->layout.v,
          "wanted {} positions and {} speeds, got {} and {}", parts_->layout.q, parts_->layout.v,
          q.size(), v.size());
  // Convert coordinates to joint values and rates; copy quaternions.
  for (std::size_t i = 0; i < parts_->mechanism.bodies.size(); ++i) {
    const int at_q = parts_->layout.first_q[i], at_v = parts_->layout.first_v[i];
    if (at_q < 0) continue;
    const JointKind kind = parts_->mechanism.joints[i].kind;
    if (is_scalar(kind)) {
      const JointValue joint = joint_value(parts_->mechanism.joints[i], q[at_q]);
      parts_->body(i).setOneQ(state, 0, joint.value);
      parts_->body(i).setOneU(state, 0, joint.slope * v[at_v]);
      continue;
    }
    const bool is_free = kind == JointKind::kFree;
    for (int k = 0; k < (is_free ? 7 : 4); ++k) parts_->body(i).setOneQ(state, k, q[at_q + k]);
    for (int k = 0; k < (is_free ? 6 : 3); ++k) parts_->body(i).setOneU(state, k, v[at_v + k]);
  }
}

void SimbodyMechanism::read_state(const SimTK::State& state, Eigen::VectorXd& q,
                                  Eigen::VectorXd& v) const {
  q.resize(parts_->layout.q);
  v.resize(parts_->layout.v);
  // Read coordinates from their leading joints; normalise quaternions.
  for (std::size_t i = 0; i < parts_->mechanism.bodies.size(); ++i) {
    const int at_q = parts_->layout.first_q[i], at_v = parts_->layout.first_v[i];
    if (at_q < 0) continue;
    const MechanismJoint& joint = parts_->mechanism.joints[i];
    if (is_scalar(joint.kind)) {
      if (leader(joint.coordinate) != static_cast<int>(i)) continue;
      q[at_q] = (parts_->body(i).getOneQ(state, 0) - joint.offset) / joint.ratio;
      v[at_v] = parts_->body(i).getOneU(state, 0) / joint.ratio;
      continue;
    }
    const bool is_free = joint.kind == JointKind::kFree;
    for (int k = 0; k < (is_free ? 7 : 4); ++k) q[at_q + k] = parts_->body(i).getOneQ(state, k);
    for (int k = 0; k < (is_free ? 6 : 3); ++k) v[at_v + k] = parts_->body(i).getOneU(state, k);
    q.segment<4>(at_q).normalize();
  }
}

std::vector<SimbodyMechanism::Speed> SimbodyMechanism::speeds(const SimTK::State& state) const {
  std::vector<Speed> out;
  // Balls and free joints correspond one to one, coordinates to their leading joint.
  for (std::size_t i = 0; i < parts_->mechanism.bodies.size(); ++i) {
    const int at = parts_->layout.first_v[i];
    if (at < 0) continue;
    const int row = parts_->body(i).getFirstUIndex(state);
    const MechanismJoint& joint = parts_->mechanism.joints[i];
    if (!is_scalar(joint.kind)) {
      for (int k = 0; k < speed_count(joint.kind); ++k) out.push_back({row + k, at + k, 1.0});
    } else if (leader(joint.coordinate) == static_cast<int>(i)) {
      out.push_back({row, at, joint.ratio});
    }
  }
  return out;
}

Eigen::MatrixXd SimbodyMechanism::speed_map(const SimTK::State& state) const {
  Eigen::MatrixXd N = Eigen::MatrixXd::Zero(state.getNU(), parts_->layout.v);
  // Insert the slopes of joints by their coordinates, at the leader's value.
  for (std::size_t i = 0; i < parts_->mechanism.bodies.size(); ++i) {
    if (parts_->layout.first_v[i] < 0) continue;
    const int row = parts_->body(i).getFirstUIndex(state);
    const MechanismJoint& joint = parts_->mechanism.joints[i];
    if (is_scalar(joint.kind)) {
      const int lead = leader(joint.coordinate);
      const MechanismJoint& linear = parts_->mechanism.joints[lead];
      const double u = (parts_->body(lead).getOneQ(state, 0) - linear.offset) / linear.ratio;
      N(row, parts_->layout.first_v[i]) = joint_value(joint, u).slope;
      continue;
    }
    for (int k = 0; k < speed_count(joint.kind); ++k) N(row + k, parts_->layout.first_v[i] + k) = 1;
  }
  return N;
}

}  // namespace thenar
