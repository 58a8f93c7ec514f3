#include "dynamics/mechanism/simbody_machine.h"

#include <Simbody.h>

#include "base/error.h"

namespace thenar {
namespace {

SimTK::Vec3 to_simbody(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

SimTK::Transform to_simbody(const Pose<double>& X) {
  SimTK::Mat33 R;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) R(i, j) = X.R(i, j);
  return {SimTK::Rotation(R), to_simbody(X.p)};
}

SimTK::Body::Rigid to_simbody(const BodyMass& body) {
  if (body.mass == 0)
    return SimTK::Body::Rigid(SimTK::MassProperties(0, SimTK::Vec3(0), SimTK::Inertia(0)));
  const Eigen::Matrix3d& I = body.inertia;
  const SimTK::Inertia central(I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2));
  const SimTK::Vec3 com = to_simbody(body.com);
  return SimTK::Body::Rigid(
      SimTK::MassProperties(body.mass, com, central.shiftFromMassCenter(-com, body.mass)));
}

/// How far a joint's value is from what its coordinate says, where `leader` follows it linearly.
class CouplingError : public SimTK::Function {
 public:
  CouplingError(const MechanismJoint& leader, MechanismJoint follower)
      : ratio_(leader.ratio), offset_(leader.offset), follower_(std::move(follower)) {}

  SimTK::Real calcValue(const SimTK::Vector& values) const override {
    return joint_value(follower_, (values[0] - offset_) / ratio_).value - values[1];
  }
  SimTK::Real calcDerivative(const SimTK::Array_<int>& of,
                             const SimTK::Vector& values) const override {
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

struct SimbodyMachine::Parts {
  explicit Parts(const Mechanism& m) : mechanism(m), layout(layout_of(m)), matter(system) {
    leader.assign(mechanism.coordinates.size(), -1);
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) add_body(i);
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) couple(static_cast<int>(i));
    state = system.realizeTopology();
    system.realizeModel(state);
  }

  [[nodiscard]] bool is_scalar(std::size_t i) const {
    const JointKind kind = mechanism.joints[i].kind;
    return thenar::is_scalar(kind);
  }

  void add_body(std::size_t i) {
    const MechanismJoint& joint = mechanism.joints[i];
    const SimTK::Body::Rigid body = to_simbody(mechanism.bodies[i].mass);
    const SimTK::Transform F = to_simbody(joint.X_PF), M = to_simbody(joint.X_BM);
    SimTK::MobilizedBody& parent = matter.updMobilizedBody(index(joint.parent));
    switch (joint.kind) {
      case JointKind::kWeld:
        SimTK::MobilizedBody::Weld(parent, F, body, M);
        break;
      case JointKind::kHinge:
        SimTK::MobilizedBody::Pin(parent, F, body, M);
        break;
      case JointKind::kSlide: {
        // Simbody's slider goes along x.
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
    if (!is_scalar(i)) return;
    int& lead = leader[static_cast<std::size_t>(joint.coordinate)];
    if (lead < 0 && joint.curve.empty() && joint.ratio != 0) lead = static_cast<int>(i);
  }

  void couple(int i) {
    const MechanismJoint& joint = mechanism.joints[static_cast<std::size_t>(i)];
    if (!is_scalar(static_cast<std::size_t>(i))) return;
    const int lead = leader[static_cast<std::size_t>(joint.coordinate)];
    require(lead >= 0, "no joint follows the coordinate '{}' linearly",
            mechanism.coordinates[static_cast<std::size_t>(joint.coordinate)].name);
    if (lead == i) return;
    const SimTK::Array_<SimTK::MobilizedBodyIndex> bodies{index(lead), index(i)};
    const SimTK::Array_<SimTK::MobilizerQIndex> values(2, SimTK::MobilizerQIndex(0));
    SimTK::Constraint::CoordinateCoupler(
        matter, new CouplingError(mechanism.joints[static_cast<std::size_t>(lead)], joint), bodies,
        values);  // which owns the function
  }

  static SimTK::MobilizedBodyIndex index(int body) { return SimTK::MobilizedBodyIndex(body + 1); }

  [[nodiscard]] const SimTK::MobilizedBody& body(std::size_t i) const {
    return matter.getMobilizedBody(index(static_cast<int>(i)));
  }

  void set(const Eigen::VectorXd& q, const Eigen::VectorXd& v) {
    require(q.size() == layout.q && v.size() == layout.v,
            "wanted {} positions and {} speeds, got {} and {}", layout.q, layout.v, q.size(),
            v.size());
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
      const int at_q = layout.first_q[i], at_v = layout.first_v[i];
      if (at_q < 0) continue;
      if (is_scalar(i)) {
        const JointValue joint = joint_value(mechanism.joints[i], q[at_q]);
        body(i).setOneQ(state, 0, joint.value);
        body(i).setOneU(state, 0, joint.slope * v[at_v]);
        continue;
      }
      const bool is_free = mechanism.joints[i].kind == JointKind::kFree;
      for (int k = 0; k < (is_free ? 7 : 4); ++k) body(i).setOneQ(state, k, q[at_q + k]);
      for (int k = 0; k < (is_free ? 6 : 3); ++k) body(i).setOneU(state, k, v[at_v + k]);
    }
    system.realize(state, SimTK::Stage::Velocity);
  }

  /// Simbody's speeds are  N v.
  [[nodiscard]] Eigen::MatrixXd speed_map() const {
    Eigen::MatrixXd N = Eigen::MatrixXd::Zero(state.getNU(), layout.v);
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
      if (layout.first_v[i] < 0) continue;
      const int row = body(i).getFirstUIndex(state);
      if (is_scalar(i)) {
        const MechanismJoint& joint = mechanism.joints[i];
        const int lead = leader[static_cast<std::size_t>(joint.coordinate)];
        const MechanismJoint& linear = mechanism.joints[static_cast<std::size_t>(lead)];
        const double u =
            (body(static_cast<std::size_t>(lead)).getOneQ(state, 0) - linear.offset) / linear.ratio;
        N(row, layout.first_v[i]) = joint_value(joint, u).slope;
        continue;
      }
      const int entries = speeds_of(mechanism.joints[i].kind);
      for (int k = 0; k < entries; ++k) N(row + k, layout.first_v[i] + k) = 1;
    }
    return N;
  }

  /// Calls work(Simbody's speed, ours, ratio) for every speed of ours, coordinates by the joint
  /// that leads:  Simbody's = ratio times ours.
  template <typename Work>
  void each_speed(const Work& work) const {
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
      const int at = layout.first_v[i];
      if (at < 0) continue;
      const int row = body(i).getFirstUIndex(state);
      const MechanismJoint& joint = mechanism.joints[i];
      if (!is_scalar(i)) {
        for (int k = 0; k < speeds_of(joint.kind); ++k) work(row + k, at + k, 1.0);
      } else if (leader[static_cast<std::size_t>(joint.coordinate)] == static_cast<int>(i)) {
        work(row, at, joint.ratio);
      }
    }
  }

  Mechanism mechanism;
  MechanismLayout layout;
  std::vector<int> leader;  // joint that turns by the coordinate linearly (coordinates)
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter;
  SimTK::State state;
};

SimbodyMachine::SimbodyMachine(const Mechanism& mechanism) {
  check_mechanism(mechanism);
  parts_ = std::make_unique<Parts>(mechanism);
}
SimbodyMachine::~SimbodyMachine() = default;
SimbodyMachine::SimbodyMachine(SimbodyMachine&&) noexcept = default;
SimbodyMachine& SimbodyMachine::operator=(SimbodyMachine&&) noexcept = default;

void SimbodyMachine::set(const Eigen::VectorXd& q, const Eigen::VectorXd& v) { parts_->set(q, v); }

Pose<double> SimbodyMachine::pose(int body) const {
  const SimTK::Transform& X =
      parts_->matter.getMobilizedBody(Parts::index(body)).getBodyTransform(parts_->state);
  Pose<double> out;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) out.R(i, j) = X.R()[i][j];
    out.p[i] = X.p()[i];
  }
  return out;
}

double SimbodyMachine::kinetic_energy() const {
  return parts_->matter.calcKineticEnergy(parts_->state);
}

Eigen::MatrixXd SimbodyMachine::mass_matrix() const {
  SimTK::Matrix M;
  parts_->matter.calcM(parts_->state, M);
  const Eigen::MatrixXd whole = Eigen::MatrixXd::NullaryExpr(
      M.nrow(), M.ncol(),
      [&](Eigen::Index i, Eigen::Index j) { return M(static_cast<int>(i), static_cast<int>(j)); });
  const Eigen::MatrixXd N = parts_->speed_map();
  return N.transpose() * whole * N;
}

Eigen::VectorXd SimbodyMachine::accelerations(const Eigen::VectorXd& tau,
                                              const Eigen::Vector3d& gravity,
                                              const std::vector<BodyLoad>& loads) {
  const Mechanism& mechanism = parts_->mechanism;
  const MechanismLayout& layout = parts_->layout;
  require(tau.size() == layout.v, "wanted {} efforts, got {}", layout.v, tau.size());
  SimTK::State& state = parts_->state;
  parts_->system.realize(state, SimTK::Stage::Dynamics);

  // Efforts of shared coordinates act on the joint that leads.
  SimTK::Vector on_joints(state.getNU(), 0.0);
  parts_->each_speed([&](int row, int at, double ratio) { on_joints[row] = tau[at] / ratio; });

  // Weights and loads.
  SimTK::Vector_<SimTK::SpatialVec> F(parts_->matter.getNumBodies(),
                                      SimTK::SpatialVec(SimTK::Vec3(0), SimTK::Vec3(0)));
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    const BodyMass& mass = mechanism.bodies[i].mass;
    parts_->body(i).applyForceToBodyPoint(state, to_simbody(mass.com),
                                          to_simbody(Eigen::Vector3d(mass.mass * gravity)), F);
  }
  for (const BodyLoad& load : loads) {
    if (load.body < 0) continue;
    const SimTK::MobilizedBody& body = parts_->body(static_cast<std::size_t>(load.body));
    body.applyForceToBodyPoint(state, body.findStationAtGroundPoint(state, to_simbody(load.p)),
                               to_simbody(load.force), F);
    body.applyBodyTorque(state, to_simbody(load.moment), F);
  }
  SimTK::Vector u_dot;
  SimTK::Vector_<SimTK::SpatialVec> A;
  parts_->matter.calcAcceleration(state, on_joints, F, u_dot, A);

  // Accelerations of the coordinates.
  Eigen::VectorXd v_dot(layout.v);
  parts_->each_speed([&](int row, int at, double ratio) { v_dot[at] = u_dot[row] / ratio; });
  return v_dot;
}

}  // namespace thenar
