#include "dynamics/compliant/simbody_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include <Simbody.h>
#include <fmt/format.h>

#include "base/error.h"
#include "dynamics/compliant/compliant_run.h"
#include "dynamics/compliant/penalty_law.h"
#include "dynamics/compliant/surface_pairs.h"
#include "dynamics/mechanism/simbody_mechanism.h"

namespace thenar {
namespace {

using internal::CompliantContacts;
using internal::CompliantMotion;
using internal::CompliantStep;
using internal::from_simbody;
using internal::StepLimiter;
using internal::to_simbody;

const SimTK::MobilizedBody& body_of(const SimbodyMechanism& bodies, std::size_t i) {
  return bodies.matter().getMobilizedBody(SimTK::MobilizedBodyIndex(static_cast<int>(i) + 1));
}

/// Loads for which Simbody has no element: drives, temporary forces, and dry friction of joints.
class SceneLoads : public SimTK::Force::Custom::Implementation {
 public:
  SceneLoads(const MovingScene& scene, const ContactCompliance& compliance,
             const SimbodyMechanism& bodies, const double& acting)
      : scene_(scene), compliance_(compliance), bodies_(bodies), acting_(acting) {}

  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& on_bodies,
                 SimTK::Vector_<SimTK::Vec3>& /*particles*/,
                 SimTK::Vector& on_joints) const override {
    // Forces that act at this time.
    for (const SceneForce& force : scene_.forces) {
      if (!force.when.contains(acting_)) continue;
      const SimTK::MobilizedBody& body = body_of(bodies_, static_cast<std::size_t>(force.body));
      body.applyForceToBodyPoint(state, to_simbody(force.point), to_simbody(force.force),
                                 on_bodies);
      body.applyBodyTorque(state, to_simbody(force.moment), on_bodies);
    }
    // Drives act on the leading joint of their coordinate.
    for (const SceneDrive& drive : scene_.drives) {
      if (!drive.when.contains(acting_)) continue;
      const int lead = bodies_.leader(drive.coordinate);
      const MechanismJoint& joint = joint_of(lead);
      const SimTK::MobilizedBody& body = body_of(bodies_, static_cast<std::size_t>(lead));
      const double u = (body.getOneQ(state, 0) - joint.offset) / joint.ratio;
      const double rate = body.getOneU(state, 0) / joint.ratio;
      const double effort = drive_effort(drive, u, rate, state.getTime(), acting_);
      body.applyOneMobilityForce(state, 0, effort / joint.ratio, on_joints);
    }
    // Regularized dry friction of joints.
    for (std::size_t i = 0; i < scene_.mechanism.joints.size(); ++i) {
      const MechanismJoint& joint = scene_.mechanism.joints[i];
      if (!is_scalar(joint.kind) || joint.friction == 0) continue;
      const double rate = body_of(bodies_, i).getOneU(state, 0);
      const double ratio =
          friction_ratio(compliance_.ramp, std::abs(rate) / compliance_.transition);
      body_of(bodies_, i)
          .applyOneMobilityForce(state, 0, -std::copysign(joint.friction * ratio, rate), on_joints);
    }
  }

  SimTK::Real calcPotentialEnergy(const SimTK::State& /*state*/) const override { return 0; }

 private:
  [[nodiscard]] const MechanismJoint& joint_of(int joint) const {
    return scene_.mechanism.joints[joint];
  }

  const MovingScene& scene_;
  const ContactCompliance& compliance_;
  const SimbodyMechanism& bodies_;
  const double& acting_;  // time at which loads are switched [s]
};

SimTK::ContactGeometry mesh_geometry(const TriangleMesh& mesh) {
  // Copy vertices and triangles to Simbody's polygons.
  SimTK::PolygonalMesh polygons;
  for (Eigen::Index i = 0; i < mesh.vertices.cols(); ++i)
    polygons.addVertex(to_simbody(Eigen::Vector3d(mesh.vertices.col(i))));
  for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i) {
    const SimTK::Array_<int> corners{mesh.triangles(0, i), mesh.triangles(1, i),
                                     mesh.triangles(2, i)};
    polygons.addFace(corners);
  }
  return SimTK::ContactGeometry::TriangleMesh(polygons);
}

/// Scene as a Simbody system.
class SimbodyScene {
 public:
  SimbodyScene(const MovingScene& scene, const ContactCompliance& compliance,
               const TreeModel& model)
      : bodies(scene.mechanism),
        scene_(scene),
        compliance_(compliance),
        pairs_(plan_simbody_pairs(scene, model)),
        cliques_(separating_cliques(pairs_.size())),
        forces_(bodies.system()),
        gravity_(forces_, bodies.matter(), to_simbody(scene.gravity)),
        tracker_(bodies.system()),
        contacts_(bodies.system(), tracker_),
        loads_(forces_, new SceneLoads(scene, compliance, bodies, acting)) {  // owned by the system
    // Add surfaces and joint resistance, then let Simbody realize the topology.
    for (std::size_t i = 0; i < scene.mechanism.bodies.size(); ++i)
      add_surfaces(static_cast<int>(i));
    contacts_.setTransitionVelocity(compliance.transition);
    for (std::size_t i = 0; i < scene.mechanism.joints.size(); ++i) add_resistance(i);
    bodies.system().realizeTopology();
    // Map Simbody's surface indices, which exist from here on, to pairs.
    for (std::size_t k = 0; k < pairs_.size(); ++k)
      for (const std::size_t side : {0, 1}) pair_of_[surface_index(k, side)] = k;
  }

  /// Returns a new Simbody state, without any history of contacts.
  [[nodiscard]] SimTK::State state_of(const SceneState& at) const {
    SimTK::State out = bodies.system().getDefaultState();
    bodies.system().realizeModel(out);
    bodies.write_state(at.q, at.v, out);
    out.setTime(at.t);
    return out;
  }

  /// Returns the contacts in a state.
  [[nodiscard]] CompliantContacts contacts(const SimTK::State& at) const {
    bodies.system().realize(at, SimTK::Stage::Dynamics);
    CompliantContacts out;
    for (int i = 0; i < contacts_.getNumContactForces(at); ++i) add_contact(at, i, out.samples);
    // Energy of contacts and limits: all but gravity and the joint springs.
    out.energy = bodies.system().calcPotentialEnergy(at) - gravity_.getPotentialEnergy(at);
    for (std::size_t i = 0; i < scene_.mechanism.joints.size(); ++i) {
      const MechanismJoint& joint = scene_.mechanism.joints[i];
      if (!is_scalar(joint.kind) || joint.stiffness == 0) continue;
      const double stretch = body_of(bodies, i).getOneQ(at, 0) - joint.rest;
      out.energy -= 0.5 * joint.stiffness * stretch * stretch;
    }
    return out;
  }

  /// Returns a message that names the bodies of a contact beyond the box face that its half space
  /// represents; "" if there is none.
  std::string departed_face(const SimTK::State& at) const {
    bodies.system().realize(at, SimTK::Stage::Dynamics);
    for (int i = 0; i < contacts_.getNumContactForces(at); ++i) {
      const SimTK::ContactForce& force = contacts_.getContactForce(at, i);
      SimTK::ContactPatch patch;
      if (!contacts_.calcContactPatchDetailsById(at, force.getContactId(), patch)) continue;
      const SimbodyPair& pair = pairs_[pair_at(at, force)];
      for (const SimbodySurface* side : {&pair.a, &pair.b})
        if (side->kind == SurfaceKind::kHalfSpace && is_beyond(at, *side, patch))
          return fmt::format(
              "'{}' and '{}' touch beyond the face that stands for a box: Simbody "
              "cannot simulate this",
              scene_.mechanism.bodies[pair.a.body].name, scene_.mechanism.bodies[pair.b.body].name);
    }
    return "";
  }

  SimbodyMechanism bodies;
  double acting = 0;  // time at which loads are switched, the beginning of a time span [s]

 private:
  [[nodiscard]] const SimbodySurface& surface(std::size_t pair, std::size_t side) const {
    return side == 0 ? pairs_[pair].a : pairs_[pair].b;
  }

  /// Adds all contact surfaces of a body.
  /// @throws InputError if Simbody refuses one, such as an open mesh.
  void add_surfaces(int body) try {
    // Cliques exclude contacts with the surfaces of other pairs.
    SimTK::Body& rigid =
        bodies.matter().updMobilizedBody(SimTK::MobilizedBodyIndex(body + 1)).updBody();
    for (std::size_t k = 0; k < pairs_.size(); ++k)
      for (const std::size_t side : {0, 1}) {
        const SimbodySurface& of = surface(k, side);
        if (of.body != body) continue;
        surfaces_on_[body].emplace_back(k, side);
        SimTK::ContactSurface added(geometry(of), material(k), compliance_.layer);
        for (const int clique : cliques_[2 * k + side]) added.joinClique(clique_id(clique));
        rigid.addContactSurface(surface_pose(of), added);
      }
  } catch (const std::exception& failure) {
    throw InputError(fmt::format("Simbody refuses the surface of '{}': {}",
                                 scene_.mechanism.bodies[body].name, failure.what()));
  }

  SimTK::ContactCliqueId clique_id(int clique) {
    while (static_cast<int>(clique_ids_.size()) <= clique)
      clique_ids_.push_back(SimTK::ContactSurface::createNewContactClique());
    return clique_ids_[clique];
  }

  /// Returns the pose of a surface in its body by Simbody's conventions.
  static SimTK::Transform surface_pose(const SimbodySurface& of) {
    // Simbody's half space is at x > 0.
    if (of.kind == SurfaceKind::kHalfSpace)
      return to_simbody(of.X_BS) *
             SimTK::Transform(SimTK::Rotation(SimTK::Pi / 2, SimTK::YAxis), SimTK::Vec3(0));
    // Vertices of meshes are in the body's frame.
    if (of.kind == SurfaceKind::kMesh) return {};
    return to_simbody(of.X_BS);
  }

  [[nodiscard]] SimTK::ContactGeometry geometry(const SimbodySurface& of) const {
    switch (of.kind) {
      case SurfaceKind::kHalfSpace:
        return SimTK::ContactGeometry::HalfSpace();
      case SurfaceKind::kBall:
        return SimTK::ContactGeometry::Sphere(of.size[0]);
      case SurfaceKind::kEllipsoid:
        return SimTK::ContactGeometry::Ellipsoid(to_simbody(of.size));
      case SurfaceKind::kBrick:
        return SimTK::ContactGeometry::Brick(to_simbody(of.size));
      case SurfaceKind::kMesh:
        break;
    }
    const MechanismBody& body = scene_.mechanism.bodies[of.body];
    return mesh_geometry(body.solid->collision[of.part].core);
  }

  /// Returns the material of both surfaces of a pair. Simbody combines two equal materials to
  /// 2^-1.5 of their modulus in the Hertz law, and to one half in the other laws.
  [[nodiscard]] SimTK::ContactMaterial material(std::size_t pair) const {
    const SimbodyPair& of = pairs_[pair];
    const auto has = [&](SurfaceKind kind) { return of.a.kind == kind || of.b.kind == kind; };
    // Stiffness of each material that combines to that of ContactCompliance.
    double stiffness = std::pow(2, 1.5) * compliance_.modulus;
    if (has(SurfaceKind::kMesh)) stiffness = 2 * compliance_.modulus;
    if (has(SurfaceKind::kBrick)) stiffness = 2 * compliance_.stiffness;
    const double mu = pair_friction(scene_, of.a.body, of.b.body).coefficient;
    return {stiffness, compliance_.dissipation, mu, mu};
  }

  /// Adds spring, damper and stops of a joint.
  void add_resistance(std::size_t i) {
    const MechanismJoint& joint = scene_.mechanism.joints[i];
    if (!is_scalar(joint.kind)) return;
    const SimTK::MobilizedBody& body = body_of(bodies, i);
    const SimTK::MobilizerQIndex q(0);
    if (joint.stiffness > 0)
      SimTK::Force::MobilityLinearSpring(forces_, body, q, joint.stiffness, joint.rest);
    if (joint.damping > 0)
      SimTK::Force::MobilityLinearDamper(forces_, body, SimTK::MobilizerUIndex(0), joint.damping);
    if (std::isfinite(joint.lower) || std::isfinite(joint.upper))
      SimTK::Force::MobilityLinearStop(forces_, body, q, compliance_.stop, compliance_.dissipation,
                                       joint.lower, joint.upper);
  }

  [[nodiscard]] SimTK::ContactSurfaceIndex surface_index(std::size_t pair, std::size_t side) const {
    const int body = surface(pair, side).body;
    const auto& all = surfaces_on_.at(body);
    const auto place = std::find(all.begin(), all.end(), std::make_pair(pair, side));
    return tracker_.getContactSurfaceIndex(SimTK::MobilizedBodyIndex(body + 1),
                                           static_cast<int>(place - all.begin()));
  }

  [[nodiscard]] const SimTK::Contact& contact_of(const SimTK::State& at,
                                                 const SimTK::ContactForce& force) const {
    return tracker_.getActiveContacts(at).getContactById(force.getContactId());
  }

  [[nodiscard]] std::size_t pair_at(const SimTK::State& at,
                                    const SimTK::ContactForce& force) const {
    return pair_of_.at(contact_of(at, force).getSurface1());
  }

  [[nodiscard]] bool is_beyond(const SimTK::State& at, const SimbodySurface& face,
                               const SimTK::ContactPatch& patch) const {
    // Points in the frame of the face; they may exceed it by their deformation.
    const SimTK::Transform X_FG =
        ~(body_of(bodies, static_cast<std::size_t>(face.body)).getBodyTransform(at) *
          to_simbody(face.X_BS));
    for (int d = 0; d < patch.getNumDetails(); ++d) {
      const SimTK::ContactDetail& detail = patch.getContactDetail(d);
      const SimTK::Vec3 p = X_FG * detail.getContactPoint();
      constexpr double kRounding = 1e-9;  // [m]
      const double slack = kRounding + detail.getDeformation();
      if (std::abs(p[0]) > face.extent[0] + slack || std::abs(p[1]) > face.extent[1] + slack)
        return true;
    }
    return false;
  }

  /// Appends all points of one contact, with the forces on the body with the lower index.
  void add_contact(const SimTK::State& at, int number, std::vector<ContactSample>& out) const {
    const SimTK::ContactForce& force = contacts_.getContactForce(at, number);
    SimTK::ContactPatch patch;
    if (!contacts_.calcContactPatchDetailsById(at, force.getContactId(), patch)) return;
    const std::size_t k = pair_at(at, force);
    // Simbody reports forces on the second surface.
    const double sign = contact_of(at, force).getSurface2() == surface_index(k, 0) ? 1 : -1;
    for (int d = 0; d < patch.getNumDetails(); ++d) {
      const SimTK::ContactDetail& detail = patch.getContactDetail(d);
      ContactSample sample;
      sample.a = pairs_[k].a.body;
      sample.b = pairs_[k].b.body;
      sample.id = static_cast<int>(k) * kMaxDetails + d;
      sample.point = from_simbody(detail.getContactPoint());
      sample.normal = sign * from_simbody(SimTK::Vec3(detail.getContactNormal()));
      sample.force = sign * from_simbody(detail.getForceOnSurface2());
      sample.gap = -detail.getDeformation();
      sample.mode = detail.getSlipVelocity().norm() >= compliance_.transition ? ContactMode::kSlide
                                                                              : ContactMode::kStick;
      out.push_back(sample);
    }
  }

  static constexpr int kMaxDetails = 10000;  // largest number of points of a contact, for their ids

  const MovingScene& scene_;
  const ContactCompliance& compliance_;
  std::vector<SimbodyPair> pairs_;
  std::vector<std::vector<int>> cliques_;  // cliques of surface 2 k + side of pair k
  std::vector<SimTK::ContactCliqueId> clique_ids_;
  std::map<int, std::vector<std::pair<std::size_t, std::size_t>>>
      surfaces_on_;  // (pair, side) of the surfaces of each body
  SimTK::GeneralForceSubsystem forces_;
  SimTK::Force::Gravity gravity_;
  SimTK::ContactTrackerSubsystem tracker_;
  SimTK::CompliantContactSubsystem contacts_;
  SimTK::Force::Custom loads_;
  std::map<SimTK::ContactSurfaceIndex, std::size_t> pair_of_;
};

/// Scene that is advanced by Simbody.
class SimbodyMotion : public CompliantMotion {
 public:
  SimbodyMotion(const MovingScene& scene, const SceneOptions& options)
      : options_(options),
        limiter_(options.max_step),
        step_(scene),
        world_(scene, options_.compliance, step_.model()) {
    state_.q = scene.q;
    state_.v = scene.v;
    // Evaluate the initial contacts, so that Simbody refuses what it cannot compute.
    (void)world_.contacts(world_.state_of(state_));
  }

  void begin_span(double instant) override {
    // Keep the counters of the old integrator.
    world_.acting = instant;
    evaluations_ = integrator_ ? evaluations() : 0;
    rejected_ = rejected();
    state_.t = instant;
    // Create an integrator that returns after each internal step.
    integrator_ =
        std::make_unique<SimTK::CPodesIntegrator>(world_.bodies.system(), SimTK::CPodes::BDF);
    integrator_->setAccuracy(options_.tolerance);
    integrator_->setMaximumStepSize(options_.max_step);
    integrator_->setReturnEveryInternalStep(true);
    integrator_->setInternalStepLimit(1000);
    limiter_.set_length(options_.max_step);
    has_begun_ = false;
  }

  CompliantStep step(double stop) override {
    const SceneState before = state_;
    if (state_.v.size() == 0) {  // no degrees of freedom
      state_.t = stop;
      return {};
    }
    try {
      // Start from a fresh state: Simbody confuses contacts of a state that was realized before.
      if (!has_begun_) integrator_->initialize(world_.state_of(state_));
      has_begun_ = true;
      const double end = std::min(stop, before.t + limiter_.length());
      integrator_->stepTo(end, end);
      copy_state();
      if (!state_.q.allFinite() || !state_.v.allFinite()) return {SceneStatus::kNotFinite, ""};
      const std::string left = world_.departed_face(integrator_->getState());
      if (!left.empty())
        return {SceneStatus::kFailed, fmt::format("at {:.9g} s {}", state_.t, left)};
    } catch (const std::exception& failure) {
      return {SceneStatus::kFailed,
              fmt::format("at {:.9g} s Simbody gave up: {}", before.t, failure.what())};
    }
    return check_surface_motion(before);
  }

  const SceneState& state() const override { return state_; }

  CompliantContacts contacts() override {
    return world_.contacts(has_begun_ ? integrator_->getState() : world_.state_of(state_));
  }

  long evaluations() const override { return evaluations_ + integrator_->getNumRealizations(); }

  long rejected() const override {
    if (!has_begun_) return rejected_;
    return rejected_ + integrator_->getNumErrorTestFailures() +
           integrator_->getNumConvergenceTestFailures();
  }

 private:
  void copy_state() {
    const SimTK::State& at = integrator_->getState();
    state_.t = at.getTime();
    world_.bodies.read_state(at, state_.q, state_.v);
  }

  /// Returns a failure if surfaces moved so far that bodies may have passed through each other.
  CompliantStep check_surface_motion(const SceneState& before) {
    const double motion = limiter_.update(step_, before, state_);
    if (motion <= 1) return {};
    return {SceneStatus::kFailed,
            fmt::format("at {:.9g} s surfaces moved {:.2g} times half of the thinner body's "
                        "thickness within a step: they may have passed each other; the longest "
                        "step of {:g} s is too long",
                        before.t, motion, options_.max_step)};
  }

  SceneOptions options_;
  StepLimiter limiter_;
  ContactStep step_;
  SimbodyScene world_;
  std::unique_ptr<SimTK::CPodesIntegrator> integrator_;
  SceneState state_;
  bool has_begun_ = false;
  long evaluations_ = 0, rejected_ = 0;  // counters of earlier integrators
};

/// Builds the motion of a scene.
/// @throws InputError for any exception of Simbody
std::unique_ptr<SimbodyMotion> simbody_motion(const MovingScene& scene,
                                              const SceneOptions& options) try {
  return std::make_unique<SimbodyMotion>(scene, options);
} catch (const InputError&) {
  throw;
} catch (const std::exception& failure) {
  throw InputError(fmt::format("Simbody refuses the scene: {}", failure.what()));
}

void check_for_simbody(const MovingScene& scene, const SceneOptions& options) {
  internal::check_compliant(scene, options);
  require(options.compliance.ramp == FrictionRamp::kQuintic,
          "Simbody's friction has a quintic ramp, not a linear one");
  require(options.compliance.modulus > 0, "Simbody wants a modulus of contacts above 0");
  const auto refuse_torsion = [](const PairFriction& pair) {
    require(pair.torsion_radius == 0,
            "Simbody's contacts have no torsional friction, got a radius "
            "of {} m",
            pair.torsion_radius);
  };
  refuse_torsion(scene.friction);
  for (const auto& [bodies, pair] : scene.friction_pairs) refuse_torsion(pair);
}

}  // namespace

SceneRun simulate_simbody_scene(const MovingScene& scene, const SceneOptions& options,
                                const Progress& progress) {
  check_for_simbody(scene, options);
  const std::unique_ptr<SimbodyMotion> motion = simbody_motion(scene, options);
  return run_compliant(*motion, scene, options, progress);
}

}  // namespace thenar
