#include "dynamics/compliant/penalty_scene.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "dynamics/compliant/compliant_run.h"
#include "dynamics/compliant/penalty_law.h"
#include "dynamics/mechanism/composite_body.h"
#include "solvers/stiff_ode.h"

namespace thenar {
namespace {

using internal::CompliantContacts;
using internal::CompliantMotion;
using internal::CompliantStep;
using internal::StepLimiter;
using Kind = ActiveContact::Kind;

constexpr int kMaxOdeSteps = 100'000'000;
constexpr double kCreepErrorRatio = 1e-2;  // largest error of speeds over the transition speed [1]
// Absolute error of speeds [m/s], [rad/s] over that of positions [m], [rad]
constexpr double kSpeedErrorRatio = 100;

std::string failure_reason(OdeStatus status) {
  switch (status) {
    case OdeStatus::kLimit:
      return fmt::format("{} steps were not enough", kMaxOdeSteps);
    case OdeStatus::kTooStiff:
      return "no step is short enough: forces jump, or the contacts are too stiff";
    case OdeStatus::kSingular:
      return "the linear equations of a step are singular";
    case OdeStatus::kImpossible:
      return "the tolerance is below rounding";
    default:
      return "CVODE failed";
  }
}

/// Returns the part of a solid whose surface is nearest to a point; null if its parts are unknown.
/// @param p  point in the body's frame [m] (3)
const SolidPart* nearest_part(const Solid& solid, const Eigen::Vector3d& p) {
  const SolidPart* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const SolidPart& part : solid.parts) {
    if (solid.parts.size() == 1) return &part;
    const double distance = std::abs(part.shape->distance(part.spec.X_BS.inverse() * p));
    if (distance < least) least = distance, nearest = &part;
  }
  return nearest;
}

/// Scene with spring contacts that is advanced by CVODE.
class PenaltyMotion : public CompliantMotion {
 public:
  PenaltyMotion(const MovingScene& scene, const SceneOptions& options)
      : options_(options),
        limiter_(options.max_step),
        step_(scene),
        motion_(step_.model()),
        mass_(step_.model()),
        efforts_(Eigen::VectorXd::Zero(scene.v.size())),
        q_dot_(Eigen::VectorXd::Zero(scene.q.size())),
        v_dot_(efforts_) {
    state_.q = scene.q;
    state_.v = scene.v;
  }

  void begin_span(double instant) override {
    step_.select_active_forces(instant);
    state_.t = instant;
    restart();
    limiter_.set_length(kInitialStep);
  }

  CompliantStep step(double stop) override {
    if (state_.v.size() == 0) {  // no degrees of freedom
      state_.t = stop;
      return {};
    }
    const SceneState before = state_;
    // Repeat the step with shorter lengths until surfaces move little enough.
    double max_length = std::min({limiter_.length(), options_.max_step, stop - before.t});
    while (true) {
      const bool is_to_stop = max_length >= stop - before.t;
      const OdeStatus status = ode_->step(is_to_stop ? stop : before.t + max_length);
      if (status == OdeStatus::kNotFinite) return {SceneStatus::kNotFinite, ""};
      if (status != OdeStatus::kStepped)
        return {SceneStatus::kFailed,
                fmt::format("at {:.9g} s {}", before.t, failure_reason(status))};
      copy_state();
      // Repeat a step in which bodies may have passed through each other.
      const double motion = limiter_.update(step_, before, state_);
      const double h = state_.t - before.t;
      if (motion <= 1 || h <= options_.min_step) return {};
      max_length = std::max(0.5 * h / motion, options_.min_step);
      state_ = before;
      ++rejected_;
      restart();
    }
  }

  [[nodiscard]] const SceneState& state() const override { return state_; }

  CompliantContacts contacts() override {
    CompliantContacts out;
    out.energy = add_loads(state_, &out.samples);
    return out;
  }

  [[nodiscard]] long evaluations() const override {
    return evaluations_ + (ode_ ? ode_->counts().slopes : 0);
  }
  [[nodiscard]] long rejected() const override {
    return rejected_ + (ode_ ? ode_->counts().rejected : 0);
  }

 private:
  static constexpr double kInitialStep = 1e-4;  // longest first step of a time span [s]

  /// Restarts the integrator at the present state.
  void restart() {
    // Keep the counters of the old integrator.
    if (ode_) {
      evaluations_ += ode_->counts().slopes;
      rejected_ += ode_->counts().rejected;
    }
    const Eigen::Index nq = state_.q.size(), nv = state_.v.size();
    if (nv == 0) return;
    // Set the tolerances of positions and speeds; those of speeds must resolve creep.
    StiffOdeOptions ode;
    ode.relative = options_.tolerance;
    ode.absolute.resize(nq + nv);
    const double speed_error = std::min(kSpeedErrorRatio * options_.tolerance,
                                        kCreepErrorRatio * options_.compliance.transition);
    ode.absolute << Eigen::VectorXd::Constant(nq, options_.tolerance),
        Eigen::VectorXd::Constant(nv, speed_error);
    ode.max_steps = kMaxOdeSteps;
    // Create the new integrator.
    Eigen::VectorXd y(nq + nv);
    y << state_.q, state_.v;
    ode_.emplace([this](double t, const Eigen::VectorXd& at) { return rates(t, at); }, state_.t, y,
                 ode);
  }

  void copy_state() {
    const Eigen::VectorXd y = ode_->state();
    state_.t = ode_->time();
    state_.q = y.head(state_.q.size());
    state_.v = y.tail(state_.v.size());
    step_.normalise_quaternions(state_.q);
  }

  /// Returns the time derivatives of positions and speeds.
  Eigen::VectorXd rates(double t, const Eigen::VectorXd& y) {
    trial_.t = t;
    trial_.q = y.head(state_.q.size());
    trial_.v = y.tail(state_.v.size());
    step_.normalise_quaternions(trial_.q);
    // Accelerations without contacts, plus those by contact forces.
    (void)step_.compute_free_rates(trial_, q_dot_, v_dot_, z_dot_);  // the scene has no elements
    add_loads(trial_, nullptr);
    mass_.compute(motion_);
    mass_.solve(step_.model(), efforts_);
    Eigen::VectorXd out(y.size());
    out << q_dot_, v_dot_ + efforts_;
    return out;
  }

  /// Computes efforts_, the efforts of all contacts, joint limits and dry friction at a state.
  /// @param out  list to which the contacts are appended, unless null
  /// @return energy of their springs [J]
  double add_loads(const SceneState& state, std::vector<ContactSample>* out) {
    // Find overlapping contacts, and compute the motion of the links.
    step_.find_contacts(state, 0, contacts_);
    motion_.set_position(state.q);
    motion_.set_speed(state.v);
    efforts_.setZero();
    double stored = 0;
    for (const ActiveContact& contact : contacts_)
      stored += contact.kind == Kind::kContact ? add_contact_load(contact, out)
                                               : add_joint_load(contact, state);
    return stored;
  }

  [[nodiscard]] Eigen::Vector3d spin_of(int link) const {
    return link < 0 ? Eigen::Vector3d(0, 0, 0) : motion_.links()[link].w;
  }

  /// Adds the effort of a joint limit or of dry friction. @return its energy [J]
  double add_joint_load(const ActiveContact& contact, const SceneState& state) {
    const int joint = contact.a;
    const MechanismJoint& spec = step_.scene().mechanism.joints[joint];
    const ContactCompliance& c = options_.compliance;
    const int row = step_.model().layout.first_v[joint];
    const double slope = joint_value(spec, state.q[step_.model().layout.first_q[joint]]).slope;
    // Regularized dry friction.
    if (contact.kind == Kind::kJointFriction) {
      const double ratio = friction_ratio(c.ramp, std::abs(contact.approach) / c.transition);
      efforts_[row] -= slope * std::copysign(spec.friction * ratio, contact.approach);
      return 0;
    }
    // Spring and damping of a limit.
    const NormalLoad stop =
        linear_normal_load(c.stop, c.dissipation, -contact.gap, -contact.approach);
    efforts_[row] += slope * (contact.kind == Kind::kUpperLimit ? -stop.force : stop.force);
    return stop.energy;
  }

  /// Adds the force of a contact point. @return its energy [J]
  double add_contact_load(const ActiveContact& contact, std::vector<ContactSample>* out) {
    const int a = motion_.link_of(contact.a), b = motion_.link_of(contact.b);
    const NormalLoad normal = normal_load(contact);
    // Friction opposes the slip and the spin about the normal.
    const Eigen::Vector3d u =
        motion_.velocity(a, contact.point) - motion_.velocity(b, contact.point);
    const Eigen::Vector3d slip = u - u.dot(contact.normal) * contact.normal;
    const double spin = contact.normal.dot(spin_of(a) - spin_of(b));
    const TangentialLoad friction =
        friction_load(options_.compliance, contact.friction, normal.force, slip, spin);
    // Add the generalized force, and a contact sample if it is wanted.
    const Eigen::Vector3d force = normal.force * contact.normal + friction.force;
    const Eigen::Vector3d moment = friction.torsion * contact.normal;
    motion_.add_relative_jacobian_row(a, b, contact.point, force, moment, efforts_);
    if (out != nullptr && normal.energy > 0) {
      const bool slides = std::hypot(slip.norm(), contact.friction.torsion_radius * spin) >=
                          options_.compliance.transition;
      out->push_back({contact.a, contact.b, contact.id, contact.point, contact.normal, force,
                      friction.torsion, contact.gap,
                      slides ? ContactMode::kSlide : ContactMode::kStick});
    }
    return normal.energy;
  }

  [[nodiscard]] NormalLoad normal_load(const ActiveContact& contact) const {
    const ContactCompliance& c = options_.compliance;
    const double radius = c.modulus > 0 ? hertz_radius(contact) : 0;
    if (radius > 0)
      return hertz_normal_load(c.modulus, radius, c.dissipation, -contact.gap, -contact.approach);
    return linear_normal_load(c.stiffness, c.dissipation, -contact.gap, -contact.approach);
  }

  /// Returns the relative radius of two balls or of a ball on a box; 0 for other shapes [m].
  [[nodiscard]] double hertz_radius(const ActiveContact& contact) const {
    // Sum the curvatures of both parts.
    double curvature = 0;  // [1/m]
    for (const int body : {contact.a, contact.b}) {
      const MechanismBody& spec = step_.scene().mechanism.bodies[body];
      const SolidPart* part =
          nearest_part(*spec.solid, motion_.pose(body).inverse() * contact.point);
      if (part == nullptr) return 0;
      if (part->spec.kind == ShapeKind::kSphere) {
        curvature += 1 / part->spec.size[0];
      } else if (part->spec.kind != ShapeKind::kBox) {
        return 0;
      }
    }
    return curvature > 0 ? 1 / curvature : 0;
  }

  SceneOptions options_;
  StepLimiter limiter_;
  ContactStep step_;
  TreeMotion<double> motion_;
  MassMatrix<double> mass_;
  Eigen::VectorXd efforts_;  // efforts of contacts, then the accelerations by them (v)
  Eigen::VectorXd q_dot_, v_dot_, z_dot_;
  SceneState state_, trial_;
  std::vector<ActiveContact> contacts_;
  std::optional<StiffOde> ode_;
  long evaluations_ = 0, rejected_ = 0;  // counters of earlier integrators
};

}  // namespace

SceneRun simulate_penalty_scene(const MovingScene& scene, const SceneOptions& options,
                                const Progress& progress) {
  internal::check_compliant(scene, options);
  PenaltyMotion motion(scene, options);
  return run_compliant(motion, scene, options, progress);
}

}  // namespace thenar
