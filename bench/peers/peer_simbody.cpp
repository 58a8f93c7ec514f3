// Hands without contacts in Simbody.

#include <Simbody.h>

#include "base/error.h"
#include "bench/peers/peer_machine.h"
#include "bench/peers/peer_scene.h"
#include "dynamics/mechanism/simbody_machine.h"
#include "dynamics/mechanism/simbody_mechanism.h"

namespace thenar::bench {
namespace {

using internal::to_simbody;

/// A tree of hinges under weight.
struct SimbodyHand {
  explicit SimbodyHand(const MovingScene& of)
      : scene(of),
        matter(system),
        forces(system),
        gravity(forces, matter, to_simbody(scene.gravity)) {
    for (std::size_t i = 0; i < scene.mechanism.bodies.size(); ++i) {
      const MechanismJoint& joint = scene.mechanism.joints[i];
      require(joint.kind == JointKind::kHinge, "Simbody is given hinges only");
      const BodyMass& mass = scene.mechanism.bodies[i].mass;
      const Eigen::Matrix3d& I = mass.inertia;
      const SimTK::Inertia central(I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2));
      const SimTK::Vec3 com = to_simbody(mass.com);
      SimTK::Body::Rigid body(
          SimTK::MassProperties(mass.mass, com, central.shiftFromMassCenter(-com, mass.mass)));
      nodes.push_back(SimTK::MobilizedBody::Pin(
          matter.updMobilizedBody(SimTK::MobilizedBodyIndex(joint.parent + 1)),
          to_simbody(joint.X_PF), body, to_simbody(joint.X_BM)));
    }
    state = system.realizeTopology();
    for (int i = 0; i < state.getNQ(); ++i) {
      state.updQ()[i] = scene.q[i];
      state.updU()[i] = scene.v[i];
    }
  }

  [[nodiscard]] std::vector<BodyMotion> motion(const SimTK::State& at) const {
    Eigen::VectorXd q(at.getNQ()), v(at.getNU());
    for (int i = 0; i < at.getNQ(); ++i) {
      q[i] = at.getQ()[i];
      v[i] = at.getU()[i];
    }
    return motion_at(scene, q, v);
  }

  const MovingScene& scene;
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter;
  SimTK::GeneralForceSubsystem forces;
  SimTK::Force::UniformGravity gravity;
  std::vector<SimTK::MobilizedBody> nodes;
  SimTK::State state;
};

/// @param make  an integrator of a system
template <typename Make>
PeerSetting setting(const std::string& name, Make make) {
  PeerSetting out{"Simbody", name, true, [=](const PeerScene& peer, double accuracy) {
                    SimbodyHand hand(peer.scene);
                    PeerRun run;
                    run.samples.push_back({0, hand.motion(hand.state)});
                    const auto integrator = make(hand.system);
                    integrator->setAccuracy(accuracy);
                    integrator->setInternalStepLimit(1000000);
                    SimTK::TimeStepper stepper(hand.system, *integrator);
                    const double start = thread_seconds();
                    try {
                      stepper.initialize(hand.state);
                      stepper.stepTo(peer.seconds);
                    } catch (const std::exception&) {
                      run.message = "not finite";
                      return run;
                    }
                    run.cpu_seconds = thread_seconds() - start;
                    run.samples.push_back({peer.seconds, hand.motion(stepper.getState())});
                    return run;
                  }};
  out.use = PeerUse::kFree;
  return out;
}

}  // namespace

std::vector<PeerSetting> simbody_settings() {
  return {setting("Runge-Kutta-Merson",
                  [](SimTK::System& system) {
                    return std::make_unique<SimTK::RungeKuttaMersonIntegrator>(system);
                  }),
          setting("CPodes, Adams",
                  [](SimTK::System& system) {
                    return std::make_unique<SimTK::CPodesIntegrator>(system, SimTK::CPodes::Adams,
                                                                     SimTK::CPodes::Functional);
                  }),
          setting("Verlet", [](SimTK::System& system) {
            return std::make_unique<SimTK::VerletIntegrator>(system);
          })};
}

PeerMachine simbody_machine(const MovingScene& scene) {
  auto machine = std::make_shared<SimbodyMachine>(scene.mechanism);
  auto answer = std::make_shared<Eigen::VectorXd>();
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(scene.v.size());
  const Eigen::Vector3d gravity = scene.gravity;
  return {"Simbody",
          [=](const Eigen::VectorXd& q, const Eigen::VectorXd& v) -> const Eigen::VectorXd& {
            machine->set(q, v);
            *answer = machine->accelerations(none, gravity);
            return *answer;
          }};
}

}  // namespace thenar::bench
