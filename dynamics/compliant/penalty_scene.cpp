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

using internal::CompliantMotion;
using internal::CompliantStep;
using internal::StepReach;
using Kind = ActiveContact::Kind;

constexpr int kMostOdeSteps = 100'000'000;
constexpr double kCreepResolved = 1e-2;  // error of speeds over the transition speed, at most [1]

std::string words_of(OdeStatus status) {
  switch (status) {
    case OdeStatus::kLimit:
      return fmt::format("{} steps were not enough", kMostOdeSteps);
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

/// The part of a solid whose surface is nearest to a point; null: its parts are unknown.
/// @param p  body's frame [m] (3)
const SolidPart* part_at(const Solid& solid, const Eigen::Vector3d& p) {
  const SolidPart* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const SolidPart& part : solid.parts) {
    if (solid.parts.size() == 1) return &part;
    const double distance = std::abs(part.shape->distance(part.spec.X_BS.inverse() * p));
    if (distance < least) least = distance, nearest = &part;
  }
  return nearest;
}

class PenaltyMotion : public CompliantMotion {
 public:
  PenaltyMotion(const MovingScene& scene, const SceneOptions& options)
      : options_(options),
        reach_(options.longest),
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
    reach_.restart(kFirstReach);
  }

  CompliantStep step(double stop) override {
    if (state_.v.size() == 0) {  // nothing moves
      state_.t = stop;
      return {};
    }
    const SceneState before = state_;
    // Repeat the step with shorter lengths until surfaces move little enough.
    double most = std::min({reach_.length(), options_.longest, stop - before.t});
    while (true) {
      const bool is_to_stop = most >= stop - before.t;
      const OdeStatus status = ode_->step(is_to_stop ? stop : before.t + most);
      if (status == OdeStatus::kNotFinite) return {SceneStatus::kNotFinite, ""};
      if (status != OdeStatus::kStepped)
        return {SceneStatus::kFailed, fmt::format("at {:.9g} s {}", before.t, words_of(status))};
      take_state();
      // Too far to be sure that nothing went through something: again, shorter.
      const double motion = reach_.follow(step_, before, state_);
      const double h = state_.t - before.t;
      if (motion <= 1 || h <= options_.shortest) return {};
      most = std::max(0.5 * h / motion, options_.shortest);
      state_ = before;
      ++rejected_;
      restart();
    }
  }

  const SceneState& state() const override { return state_; }

  std::vector<ContactSample> contacts(double& stored) override {
    std::vector<ContactSample> out;
    stored = load(state_, &out);
    return out;
  }

  long evaluations() const override { return evaluations_ + (ode_ ? ode_->counts().slopes : 0); }
  long rejected() const override { return rejected_ + (ode_ ? ode_->counts().rejected : 0); }

 private:
  static constexpr double kFirstReach = 1e-4;  // of the first step after a start [s]

  /// Starts the integrator at the present state.
  void restart() {
    // Keep the counts of the integrator that is replaced.
    if (ode_) {
      evaluations_ += ode_->counts().slopes;
      rejected_ += ode_->counts().rejected;
    }
    const Eigen::Index nq = state_.q.size(), nv = state_.v.size();
    if (nv == 0) return;
    // Tolerances of positions and speeds.
    StiffOdeOptions ode;
    ode.relative = options_.tolerance;
    ode.absolute.resize(nq + nv);
    // Creep is resolved, whatever the tolerance.
    const double speeds =
        std::min(100 * options_.tolerance, kCreepResolved * options_.compliance.transition);
    ode.absolute << Eigen::VectorXd::Constant(nq, options_.tolerance),
        Eigen::VectorXd::Constant(nv, speeds);
    ode.max_steps = kMostOdeSteps;
    // Integrator from here on.
    Eigen::VectorXd y(nq + nv);
    y << state_.q, state_.v;
    ode_.emplace([this](double t, const Eigen::VectorXd& at) { return rates(t, at); }, state_.t, y,
                 ode);
  }

  void take_state() {
    const Eigen::VectorXd y = ode_->state();
    state_.t = ode_->time();
    state_.q = y.head(state_.q.size());
    state_.v = y.tail(state_.v.size());
    step_.normalise_quaternions(state_.q);
  }

  /// Rates of positions and speeds, contacts included.
  Eigen::VectorXd rates(double t, const Eigen::VectorXd& y) {
    trial_.t = t;
    trial_.q = y.head(state_.q.size());
    trial_.v = y.tail(state_.v.size());
    step_.normalise_quaternions(trial_.q);
    // Add the accelerations by contacts to those without.
    (void)step_.compute_free_rates(trial_, q_dot_, v_dot_, z_dot_);  // no elements here
    load(trial_, nullptr);
    mass_.compute(motion_);
    mass_.solve(step_.model(), efforts_);
    Eigen::VectorXd out(y.size());
    out << q_dot_, v_dot_ + efforts_;
    return out;
  }

  /// Efforts of all contacts, limits and dry frictions at a state, in efforts_.
  /// @param out  gets the contacts, unless null
  /// @return energy of their springs [J]
  double load(const SceneState& state, std::vector<ContactSample>* out) {
    // Contacts within reach, and links in motion.
    step_.find_contacts(state, 0, found_);
    motion_.set_position(state.q);
    motion_.set_speed(state.v);
    efforts_.setZero();
    double stored = 0;
    for (const ActiveContact& contact : found_)
      stored += contact.kind == Kind::kContact ? push(contact, out) : hold(contact, state);
    return stored;
  }

  [[nodiscard]] Eigen::Vector3d spin_of(int link) const {
    return link < 0 ? Eigen::Vector3d(0, 0, 0) : motion_.links()[static_cast<std::size_t>(link)].w;
  }

  /// A limit or the dry friction of a joint. @return energy [J]
  double hold(const ActiveContact& contact, const SceneState& state) {
    const auto joint = static_cast<std::size_t>(contact.a);
    const MechanismJoint& of = step_.scene().mechanism.joints[joint];
    const ContactCompliance& c = options_.compliance;
    const int row = step_.model().layout.first_v[joint];
    const double slope = joint_value(of, state.q[step_.model().layout.first_q[joint]]).slope;
    // Dry friction follows the ramp over the speed; a limit is a spring with damping.
    if (contact.kind == Kind::kJointFriction) {
      const double share = friction_share(c.ramp, std::abs(contact.approach) / c.transition);
      efforts_[row] -= slope * std::copysign(of.friction * share, contact.approach);
      return 0;
    }
    const NormalLoad stop = linear_load(c.stop, c.dissipation, -contact.gap, -contact.approach);
    efforts_[row] += slope * (contact.kind == Kind::kUpperLimit ? -stop.force : stop.force);
    return stop.energy;
  }

  /// A point of contact. @return energy [J]
  double push(const ActiveContact& contact, std::vector<ContactSample>* out) {
    // Normal force by depth and approach.
    const int a = motion_.link_of(contact.a), b = motion_.link_of(contact.b);
    const NormalLoad normal = normal_load(contact);
    // Friction acts against the slip and the spin about the normal.
    const Eigen::Vector3d u =
        motion_.velocity(a, contact.point) - motion_.velocity(b, contact.point);
    const Eigen::Vector3d slip = u - u.dot(contact.normal) * contact.normal;
    const double spin = contact.normal.dot(spin_of(a) - spin_of(b));
    const TangentialLoad friction =
        friction_load(options_.compliance, contact.friction, normal.force, slip, spin);
    // Efforts at the joints, and the contact as runs keep it.
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
      return hertz_load(c.modulus, radius, c.dissipation, -contact.gap, -contact.approach);
    return linear_load(c.stiffness, c.dissipation, -contact.gap, -contact.approach);
  }

  /// Relative radius of two balls, or of a ball on a box; 0: other shapes [m]
  [[nodiscard]] double hertz_radius(const ActiveContact& contact) const {
    // Sum of the curvatures of both parts.
    double curvature = 0;  // [1/m]
    for (const int body : {contact.a, contact.b}) {
      const MechanismBody& of = step_.scene().mechanism.bodies[static_cast<std::size_t>(body)];
      const SolidPart* part = part_at(*of.solid, motion_.pose(body).inverse() * contact.point);
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
  StepReach reach_;
  ContactStep step_;
  TreeMotion<double> motion_;
  MassMatrix<double> mass_;
  Eigen::VectorXd efforts_;  // of contacts over the speeds, then what they accelerate (v)
  Eigen::VectorXd q_dot_, v_dot_, z_dot_;
  SceneState state_, trial_;
  std::vector<ActiveContact> found_;
  std::optional<StiffOde> ode_;
  long evaluations_ = 0, rejected_ = 0;  // before the last start
};

}  // namespace

SceneRun simulate_penalty_scene(const MovingScene& scene, const SceneOptions& options,
                                const Progress& progress) {
  internal::check_compliant(scene, options);
  PenaltyMotion motion(scene, options);
  return run_compliant(motion, scene, options, progress);
}

}  // namespace thenar
