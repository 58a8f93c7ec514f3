#include "bench/net_rivals/point_masses.h"

#include <algorithm>

#include <Simbody.h>

#include "bench/net_rivals/bone_reaction.h"

namespace thenar::bench {
namespace {

SimTK::Vec3 vec3(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
Eigen::Vector3d eigen(const SimTK::Vec3& v) { return {v[0], v[1], v[2]}; }

/// The net that acts on the masses now.
struct Scene {
  PointMassOptions options;
  const PosedNet* net = nullptr;
  std::vector<SimTK::MobilizedBodyIndex> bodies;  // of the free nodes, in their order
  Eigen::Matrix3Xd x;                             // all nodes; the fixed ones as they stand

  /// All nodes at a state.
  [[nodiscard]] Eigen::Matrix3Xd places(const SimTK::SimbodyMatterSubsystem& matter,
                                        const SimTK::State& state) const {
    Eigen::Matrix3Xd now = x;
    for (std::size_t i = 0; i < bodies.size(); ++i)
      now.col(net->free_nodes()[i]) =
          eigen(matter.getMobilizedBody(bodies[i]).getBodyOriginLocation(state));
    return now;
  }

  /// Bands and bones.
  [[nodiscard]] Eigen::Matrix3Xd forces(const Eigen::Matrix3Xd& at) const {
    return normal_map(*net, at, options.bone);
  }
};

/// Everything that acts: bands, bones, and the medium that damps.
class NetForce : public SimTK::Force::Custom::Implementation {
 public:
  NetForce(const Scene& scene, const SimTK::SimbodyMatterSubsystem& matter)
      : scene_(scene), matter_(matter) {}

  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces,
                 SimTK::Vector_<SimTK::Vec3>&, SimTK::Vector&) const override {
    const Eigen::Matrix3Xd f = scene_.forces(scene_.places(matter_, state));
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
      const SimTK::MobilizedBody& body = matter_.getMobilizedBody(scene_.bodies[i]);
      const SimTK::Vec3 drag = -scene_.options.damping * body.getBodyOriginVelocity(state);
      body_forces[scene_.bodies[i]][1] += vec3(f.col(scene_.net->free_nodes()[i])) + drag;
    }
  }
  SimTK::Real calcPotentialEnergy(const SimTK::State&) const override { return 0; }  // not asked

 private:
  const Scene& scene_;
  const SimTK::SimbodyMatterSubsystem& matter_;
};

std::unique_ptr<SimTK::Integrator> integrator_for(const SimTK::System& system,
                                                  const PointMassOptions& options) {
  if (options.fixed_step > 0)
    return std::make_unique<SimTK::SemiExplicitEulerIntegrator>(system, options.fixed_step);
  auto merson = std::make_unique<SimTK::RungeKuttaMersonIntegrator>(system);
  merson->setAccuracy(options.accuracy);
  return merson;
}

}  // namespace

struct PointMasses::Parts {
  explicit Parts(const PointMassOptions& options)
      : matter(system), forces(system), force(forces, new NetForce(scene, matter)) {
    scene.options = options;
  }

  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter;
  SimTK::GeneralForceSubsystem forces;
  Scene scene;
  SimTK::Force::Custom force;
  SimTK::State state;

  /// Runs until at rest, or for as long as allowed.
  RivalRest run(const SimTK::State& from, const Watch& watch);
};

PointMasses::PointMasses(const Net& net, const PointMassOptions& options)
    : parts_(std::make_unique<Parts>(options)) {
  const SimTK::Body::Rigid body(
      SimTK::MassProperties(options.mass, SimTK::Vec3(0), SimTK::Inertia(0)));
  for (const NetNode& node : net.nodes)
    if (node.free)
      parts_->scene.bodies.push_back(
          SimTK::MobilizedBody::Translation(parts_->matter.Ground(), body).getMobilizedBodyIndex());
  parts_->state = parts_->system.realizeTopology();
}

PointMasses::~PointMasses() = default;

RivalRest PointMasses::Parts::run(const SimTK::State& from, const Watch& watch) {
  const PointMassOptions& options = scene.options;
  const std::unique_ptr<SimTK::Integrator> chosen = integrator_for(system, options);
  SimTK::Integrator& integrator = *chosen;
  integrator.setAllowInterpolation(false);
  integrator.initialize(from);
  RivalRest rest;
  while (!rest.balanced && integrator.getTime() < options.give_up) {
    const double next = integrator.getTime() + options.look_every;
    while (integrator.getTime() < next) integrator.stepTo(next);
    system.realize(integrator.getState(), SimTK::Stage::Velocity);
    const Eigen::Matrix3Xd masses = scene.places(matter, integrator.getState());
    rest.x = settled(*scene.net, masses);
    rest.residual = largest_free(*scene.net, scene.forces(masses));
    // A mass that swings through its place of rest is not at rest: its drag is a force as well.
    const double drag = options.damping * integrator.getState().getU().normInf();
    rest.balanced = std::max(rest.residual, drag) <= options.tolerance;
    if (watch) watch(rest.x);
  }
  rest.iterations = static_cast<int>(integrator.getNumStepsTaken());
  return rest;
}

RivalRest PointMasses::solve(const PosedNet& net, const Eigen::Matrix3Xd& start,
                             const Watch& watch) {
  Scene& scene = parts_->scene;
  scene.net = &net;
  scene.x = net.from(start);
  SimTK::State state = parts_->state;
  parts_->system.realizeModel(state);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    parts_->matter.getMobilizedBody(scene.bodies[i])
        .setQToFitTranslation(state, vec3(scene.x.col(net.free_nodes()[i])));
  return parts_->run(state, watch);
}

}  // namespace thenar::bench
