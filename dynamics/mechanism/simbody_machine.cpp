#include "dynamics/mechanism/simbody_machine.h"

#include <Simbody.h>

#include "base/error.h"
#include "dynamics/mechanism/simbody_mechanism.h"

namespace thenar {

using internal::from_simbody;
using internal::to_simbody;

struct SimbodyMachine::Parts {
  explicit Parts(const Mechanism& mechanism) : bodies(mechanism) {
    state = bodies.system().realizeTopology();
    bodies.system().realizeModel(state);
  }

  /// Returns Simbody's body. @param body  -1: the world
  [[nodiscard]] const SimTK::MobilizedBody& body(int body) const {
    return bodies.matter().getMobilizedBody(SimTK::MobilizedBodyIndex(body + 1));
  }

  SimbodyMechanism bodies;
  SimTK::State state;
};

SimbodyMachine::SimbodyMachine(const Mechanism& mechanism)
    : parts_(std::make_unique<Parts>(mechanism)) {}
SimbodyMachine::~SimbodyMachine() = default;
SimbodyMachine::SimbodyMachine(SimbodyMachine&&) noexcept = default;
SimbodyMachine& SimbodyMachine::operator=(SimbodyMachine&&) noexcept = default;

void SimbodyMachine::set_state(const Eigen::VectorXd& q, const Eigen::VectorXd& v) {
  parts_->bodies.write_state(q, v, parts_->state);
  parts_->bodies.system().realize(parts_->state, SimTK::Stage::Velocity);
}

Pose<double> SimbodyMachine::pose(int body) const {
  return from_simbody(parts_->body(body).getBodyTransform(parts_->state));
}

double SimbodyMachine::kinetic_energy() const {
  return parts_->bodies.matter().calcKineticEnergy(parts_->state);
}

Eigen::MatrixXd SimbodyMachine::mass_matrix() const {
  // Compute the mass matrix of Simbody's velocities, then reduce it to those of the mechanism.
  SimTK::Matrix M;
  parts_->bodies.matter().calcM(parts_->state, M);
  const Eigen::MatrixXd whole = Eigen::MatrixXd::NullaryExpr(
      M.nrow(), M.ncol(),
      [&](Eigen::Index i, Eigen::Index j) { return M(static_cast<int>(i), static_cast<int>(j)); });
  const Eigen::MatrixXd N = parts_->bodies.speed_map(parts_->state);
  return N.transpose() * whole * N;
}

Eigen::VectorXd SimbodyMachine::accelerations(const Eigen::VectorXd& tau,
                                              const Eigen::Vector3d& gravity,
                                              const std::vector<BodyLoad>& loads) {
  const SimbodyMechanism& bodies = parts_->bodies;
  const Mechanism& mechanism = bodies.mechanism();
  require(tau.size() == bodies.layout().v, "wanted {} efforts, got {}", bodies.layout().v,
          tau.size());
  const SimTK::State& state = parts_->state;
  bodies.system().realize(state, SimTK::Stage::Dynamics);

  // Apply efforts of coordinates to their leading joints.
  SimTK::Vector on_joints(state.getNU(), 0.0);
  const std::vector<SimbodyMechanism::Speed> speeds = bodies.speeds(state);
  for (const SimbodyMechanism::Speed& at : speeds) on_joints[at.theirs] = tau[at.ours] / at.ratio;

  // Apply weights and loads.
  SimTK::Vector_<SimTK::SpatialVec> F(bodies.matter().getNumBodies(),
                                      SimTK::SpatialVec(SimTK::Vec3(0), SimTK::Vec3(0)));
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    const BodyMass& mass = mechanism.bodies[i].mass;
    parts_->body(static_cast<int>(i))
        .applyForceToBodyPoint(state, to_simbody(mass.com),
                               to_simbody(Eigen::Vector3d(mass.mass * gravity)), F);
  }
  for (const BodyLoad& load : loads) {
    if (load.body < 0) continue;
    const SimTK::MobilizedBody& body = parts_->body(load.body);
    body.applyForceToBodyPoint(state, body.findStationAtGroundPoint(state, to_simbody(load.p)),
                               to_simbody(load.force), F);
    body.applyBodyTorque(state, to_simbody(load.moment), F);
  }
  // Solve for accelerations with the coupling constraints.
  SimTK::Vector u_dot;
  SimTK::Vector_<SimTK::SpatialVec> A;
  bodies.matter().calcAcceleration(state, on_joints, F, u_dot, A);

  // Convert them to accelerations of the mechanism.
  Eigen::VectorXd v_dot(bodies.layout().v);
  for (const SimbodyMechanism::Speed& at : speeds) v_dot[at.ours] = u_dot[at.theirs] / at.ratio;
  return v_dot;
}

}  // namespace thenar
