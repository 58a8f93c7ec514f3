#include "pads/press_springs.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/numbers.h"

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

// Stiffness of the skin's springs over that of node contacts [1]
constexpr double kSpringStiffnessRatio = 2;
// Smallest factor of a change of the body's stiffness that changes the springs [1]
constexpr double kMinStiffnessChange = 8;

constexpr int kFullStepIterations = 2;  // iterations before steps are shortened or lengthened
constexpr int kMaxStepHalvings = 10;    // halvings in a line search
// Least decrease of the potential over the decrease that its slope predicts [1]
constexpr double kArmijoParameter = 1e-4;
constexpr double kRoundedPotential = 1e-11;  // relative rounding error of a potential [1]
// Rounding error of the sum of squared stretches less 3, in an energy [1]
constexpr double kRoundedStretch = 1e-15;

constexpr double kSameDirectionCosine = 0.95;  // least cosine of steps in the same direction [1]
constexpr double kMaxLengthening = 16;         // largest factor that lengthens a step [1]

constexpr int kCycleIterations = 8;    // iterations within which the residual must decrease
constexpr double kResidualFall = 0.5;  // least decrease of the residual that counts, a factor [1]

/// Solver for one step with springs on the skin.
class SpringPress {
 public:
  explicit SpringPress(PressIterate& iterate) : iterate_(iterate) {}

  PressOutcome solve() {
    PressOutcome out;
    iterate_.springs.emplace(iterate_.body, iterate_.surface);
    if (misses_skin_at_rest()) {
      // Return the skin to rest: it could otherwise stay caught on an edge.
      iterate_.state.x.setZero();
      iterate_.state.pressure.clear();
      iterate_.accept(iterate_.body.node_displacements(iterate_.state.x, {}), out);
      return out;
    }
    for (; iterate_.may_continue(out); ++out.iterations) {
      // Evaluate tissue and springs; shorten a step that did not decrease the potential.
      Matrix3Xd u;
      if (!iterate_.evaluate_tissue(ElementRequest::kStiffness, dx_, u, out)) return out;
      if (out.iterations == 0) set_spring_stiffness();
      update_springs(iterate_.object.friction);
      if (out.iterations > kFullStepIterations && !search_line(u, out)) return out;
      // End if the forces balance, or if iterations cycle.
      iterate_.measure_residual(iterate_.springs->normal_forces(), out);
      if (iterate_.is_converged(out)) {
        iterate_.accept(u, out);
        return out;
      }
      if (is_cycling(out)) return failed_by(out, "steps go round");
      if (iterate_.goal.force && iterate_.total_force == 0) {
        // Move an object that seeks a force to where it touches.
        iterate_.gaps.update(*iterate_.object.shape, iterate_.state.X_PO, iterate_.state.x);
        if (!iterate_.move_to_contact(out)) return out;
        line_.start_potential = kInfinity;
        continue;
      }
      if (!compute_step()) return failed_by(out, "the stiffness is not positive definite");
      take_step(u, out.iterations > kFullStepIterations);
    }
    return out;
  }

  Eigen::Matrix<double, 6, 6> stiffness() {
    // Update the springs; a slightly smaller friction makes nodes on their cones slip.
    iterate_.residual = VectorXd::Zero(iterate_.body.unknowns());
    set_spring_stiffness();
    iterate_.springs.emplace(iterate_.body, iterate_.surface);
    update_springs(iterate_.object.friction * (1 - kSlipMargin));
    iterate_.springs->add_stiffness(iterate_.tissue.tangent);
    if (!factor()) return Eigen::Matrix<double, 6, 6>::Zero();
    // Move the object; subtract the forces that the motion of the body relieves.
    const SkinSprings& springs = *iterate_.springs;
    return object_stiffness(deformed_positions(iterate_.surface, iterate_.state.x),
                            springs.normal_forces() + springs.friction_forces(),
                            [&](const Matrix3Xd& rigid, const Matrix3Xd& turned) {
                              const Matrix3Xd pushed = springs.force_loss(rigid) + turned;
                              const Matrix3Xd moved = iterate_.surface_displacements(
                                  solve(iterate_.body_forces(pushed)));
                              return MotionResponse{pushed - springs.force_loss(moved), moved};
                            });
  }

 private:
  /// Sets the stiffness of the springs. It changes only when the tissue has become much stiffer or
  /// softer, because a change creates or destroys energy.
  void set_spring_stiffness() {
    iterate_.set_node_stiffness(iterate_.tissue.tangent);
    for (double& each : iterate_.node_stiffness) each *= kSpringStiffnessRatio;
    for (std::size_t k = 0; k < iterate_.start.spring_stiffness.size(); ++k) {
      const double before = iterate_.start.spring_stiffness[k], after = iterate_.node_stiffness[k];
      if (std::max(before / after, after / before) < kMinStiffnessChange)
        iterate_.node_stiffness[k] = before;
    }
  }

  /// Updates the springs and the contact forces.
  void update_springs(double friction) {
    iterate_.springs->update(*iterate_.object.shape, iterate_.state.X_PO, iterate_.state.x,
                             iterate_.node_stiffness, friction,
                             {iterate_.start.anchor, iterate_.state.friction_force});
    for (std::size_t k = 0; k < iterate_.contacts.size(); ++k) {
      iterate_.contacts[k].normal_force = iterate_.springs->normal_forces().col(k).norm();
      iterate_.contacts[k].friction_force = iterate_.springs->friction_forces().col(k);
    }
  }

  /// Halves the last step until the potential decreases enough (Armijo's rule). With friction there
  /// is no potential, and the step stays.
  /// @return false if the tissue cannot be evaluated
  bool search_line(Matrix3Xd& u, PressOutcome& out) {
    if (iterate_.object.friction > 0) return true;
    for (int cut = 0; cut < kMaxStepHalvings; ++cut) {
      if (potential() <=
          line_.start_potential + kArmijoParameter * line_.predicted_change + potential_rounding())
        break;
      // Take back half of the last step of body and object.
      line_.predicted_change /= 2;
      line_.object_motion /= 2;
      dx_ /= 2;
      iterate_.state.x -= dx_;
      iterate_.state.X_PO.p -= line_.object_motion * iterate_.goal.along;
      if (!iterate_.evaluate_tissue(ElementRequest::kStiffness, dx_, u, out)) return false;
      update_springs(0);
    }
    return true;
  }

  /// Returns whether iterations with friction cycle without progress.
  bool is_cycling(const PressOutcome& out) {
    // Record the iteration in which the residual last halved.
    if (out.residual < kResidualFall * reference_residual_) {
      reference_residual_ = out.residual;
      progress_iteration_ = out.iterations;
    }
    return iterate_.object.friction > 0 && out.iterations > progress_iteration_ + kCycleIterations;
  }

  /// Computes the next step. @return false if the tangent is not positive definite
  bool compute_step() {
    iterate_.springs->add_stiffness(iterate_.tissue.tangent);
    dx_.resize(0);
    line_ = {potential(), 0, 0};
    if (!factor()) return false;
    // Solve for the step; to reach a force the object's motion is one more unknown.
    dx_ = solve(-iterate_.residual);
    const std::optional<double> motion = iterate_.solve_object_motion(
        [&](const Matrix3Xd& moved) { return iterate_.springs->force_loss(moved); },
        [&](const VectorXd& b) { return solve(b); }, dx_);
    if (!motion) return false;
    line_.object_motion = *motion;
    // Predict the change of the potential by its slope.
    line_.predicted_change =
        iterate_.residual.dot(dx_) - iterate_.force_deficit * line_.object_motion;
    return true;
  }

  /// Applies the step.
  /// @param may_lengthen  whether a step away from an unstable equilibrium is lengthened
  void take_step(const Matrix3Xd& u, bool may_lengthen) {
    // Lengthen a step away from an unstable equilibrium, up to the longest motion.
    const bool lengthens = may_lengthen && diverges();
    last_dx_ = dx_;
    if (lengthens)
      dx_ *= std::clamp(iterate_.max_motion / dx_.lpNorm<Eigen::Infinity>(), 1.0, kMaxLengthening);
    // Predict the friction after the step.
    if (iterate_.object.friction > 0) {
      Matrix3Xd moved = iterate_.surface_displacements(dx_);
      moved.colwise() -= line_.object_motion * iterate_.goal.along;
      iterate_.state.friction_force =
          iterate_.springs->friction_forces() - iterate_.springs->friction_force_loss(moved);
    }
    iterate_.advance(u, dx_, line_.object_motion);
  }

  /// Returns whether frictionless steps grow in one direction, as away from an unstable
  /// equilibrium.
  [[nodiscard]] bool diverges() const {
    return iterate_.object.friction <= 0 && !iterate_.goal.force && last_dx_.size() > 0 &&
           dx_.norm() > last_dx_.norm() &&
           dx_.dot(last_dx_) > kSameDirectionCosine * dx_.norm() * last_dx_.norm();
  }

  /// Returns whether an object at a given pose does not touch the elastic skin at rest.
  bool misses_skin_at_rest() {
    if (iterate_.goal.force || iterate_.body.relaxes()) return false;
    // Measure the depth of the skin at rest, which does not depend on the stiffness.
    const std::vector<double> unit_stiffness(iterate_.surface.nodes.size(), 1);
    iterate_.springs->update(*iterate_.object.shape, iterate_.state.X_PO,
                             VectorXd::Zero(iterate_.state.x.size()), unit_stiffness, 0,
                             {iterate_.start.anchor, iterate_.state.friction_force});
    return iterate_.springs->max_depth() <= 0;
  }

  /// Returns the energy of tissue and springs, less the work of the force on the object [J].
  [[nodiscard]] double potential() const {
    return iterate_.tissue.energy + iterate_.springs->energy() -
           iterate_.goal.force.value_or(0) *
               iterate_.goal.along.dot(iterate_.state.X_PO.p - iterate_.start.X_PO.p);
  }
  [[nodiscard]] double potential_rounding() const {
    return kRoundedPotential * std::abs(potential()) +
           kRoundedStretch * iterate_.body.max_shear_modulus() *
               std::pow(iterate_.surface.area.sum(), 1.5);
  }

  bool factor() {
    return iterate_.factor_stabilized(
        [&] { return iterate_.factors.tangent.factor(iterate_.tissue.tangent); });
  }

  /// Solves with the matrix of this iteration: directly by the factor, or with friction, whose part
  /// is not symmetric, by GMRES.
  [[nodiscard]] VectorXd solve(const VectorXd& b) const {
    if (iterate_.object.friction <= 0) return iterate_.factors.tangent.solve(b);
    return iterate_.solve_iteratively(
        b, [&](const Matrix3Xd& moved) { return iterate_.springs->unfactored_loss(moved); });
  }

  /// Line search along the last step.
  struct LineSearch {
    double start_potential = kInfinity;  // potential before the step [J]
    double predicted_change = 0;         // change that slopes predict [J]
    double object_motion = 0;            // motion of the object [m]
  };

  PressIterate& iterate_;
  VectorXd dx_, last_dx_;  // this step and the last one [m] (3 free nodes)
  LineSearch line_;
  double reference_residual_ = kInfinity;  // residual when it last halved [N]
  int progress_iteration_ = 0;             // iteration in which it last halved
};

}  // namespace

PressOutcome press_by_springs(PressIterate& iterate) { return SpringPress(iterate).solve(); }

Eigen::Matrix<double, 6, 6> spring_press_stiffness(PressIterate& iterate) {
  return SpringPress(iterate).stiffness();
}

}  // namespace thenar
