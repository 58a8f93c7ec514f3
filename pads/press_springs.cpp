#include "pads/press_springs.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/numbers.h"

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

// Stiffness of the skin's springs, over that of other contacts [1]
constexpr double kSpringStiffnessRatio = 2;
// Springs change once the body's stiffness has changed by this factor [1]
constexpr double kStiffnessChange = 8;

constexpr int kFreeIterations = 2;  // Iterations before steps are shortened or lengthened
constexpr int kStepHalvings = 10;   // Most halvings in a line search
// Least fall of the potential, over the fall that its slope predicts [1]
constexpr double kArmijoParameter = 1e-4;
constexpr double kRoundedPotential = 1e-11;  // Relative rounding of a potential [1]
// Rounding of the sum of squared stretches less 3, in an energy [1]
constexpr double kRoundedStretch = 1e-15;

constexpr double kSameWayCosine = 0.95;  // Steps go the same way if their cosine exceeds this [1]
// Largest factor by which a step that runs off is lengthened [1]
constexpr double kMostGrowth = 16;

constexpr int kRoundIterations = 8;  // Iterations within which a residual must fall
constexpr double kRoundFall = 0.5;   // A fall of the residual to less than this share counts [1]

class SpringPress {
 public:
  explicit SpringPress(PressIterate& iterate) : iterate_(iterate) {}

  PressOutcome solve() {
    PressOutcome out;
    iterate_.springs.emplace(iterate_.body, iterate_.surface);
    if (misses_skin_at_rest()) {
      // Skin that hangs on an edge would be another answer.
      iterate_.state.x.setZero();
      iterate_.state.pressure.clear();
      iterate_.accept(iterate_.body.node_displacements(iterate_.state.x, {}), out);
      return out;
    }
    for (; iterate_.may_continue(out); ++out.iterations) {
      // Tissue and springs at the iterate; a step that did not lower the potential is cut.
      Matrix3Xd u;
      if (!iterate_.evaluate_tissue(ElementRequest::kStiffness, dx_, u, out)) return out;
      if (out.iterations == 0) find_spring_stiffness();
      find_springs(iterate_.object.friction);
      if (out.iterations > kFreeIterations && !search_line(u, out)) return out;
      // Balanced, or going round without progress.
      iterate_.measure_residual(iterate_.springs->normal_forces(), out);
      if (iterate_.is_converged(out)) {
        iterate_.accept(u, out);
        return out;
      }
      if (goes_round(out)) {
        out.message = "steps go round";
        return out;
      }
      if (iterate_.goal.force && iterate_.total_force == 0) {
        // A force is sought and nothing touches: move the object on.
        iterate_.gaps.update(*iterate_.object.shape, iterate_.state.X_PO, iterate_.state.x);
        if (!iterate_.move_to_contact(out)) return out;
        line_.before = kInfinity;
        continue;
      }
      if (!find_step()) {
        out.message = "the stiffness is not positive definite";
        return out;
      }
      take_step(u, out.iterations > kFreeIterations);
    }
    return out;
  }

  Eigen::Matrix<double, 6, 6> stiffness() {
    // Springs at the state. Friction is bounded a little lower, so that nodes on their cones slip.
    iterate_.residual = VectorXd::Zero(iterate_.body.unknowns());
    find_spring_stiffness();
    iterate_.springs.emplace(iterate_.body, iterate_.surface);
    find_springs(iterate_.object.friction * (1 - kSlipMargin));
    iterate_.springs->add_stiffness(iterate_.tissue.tangent);
    if (!factored()) return Eigen::Matrix<double, 6, 6>::Zero();
    // Forces by a motion of the object, less those that the body's motion gives back.
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
  /// Sets springs that stay as they were unless tissue has become much stiffer or softer, as a
  /// change makes energy from nothing.
  void find_spring_stiffness() {
    iterate_.set_node_stiffness(iterate_.tissue.tangent);
    for (double& each : iterate_.node_stiffness) each *= kSpringStiffnessRatio;
    for (std::size_t k = 0; k < iterate_.start.spring_stiffness.size(); ++k) {
      const double was = iterate_.start.spring_stiffness[k], is = iterate_.node_stiffness[k];
      if (std::max(was / is, is / was) < kStiffnessChange) iterate_.node_stiffness[k] = was;
    }
  }

  /// Sets springs, and contact forces by them.
  void find_springs(double friction) {
    iterate_.springs->update(*iterate_.object.shape, iterate_.state.X_PO, iterate_.state.x,
                             iterate_.node_stiffness, friction,
                             {iterate_.start.anchor, iterate_.state.friction_force});
    for (std::size_t k = 0; k < iterate_.contacts.size(); ++k) {
      const auto column = static_cast<Eigen::Index>(k);
      iterate_.contacts[k].normal_force = iterate_.springs->normal_forces().col(column).norm();
      iterate_.contacts[k].friction_force = iterate_.springs->friction_forces().col(column);
    }
  }

  /// Halves the last step until the potential falls as slopes promise (Armijo's rule); with
  /// friction there is none.
  /// @return false if tissue gives no answer
  bool search_line(Matrix3Xd& u, PressOutcome& out) {
    if (iterate_.object.friction > 0) return true;
    for (int cut = 0; cut < kStepHalvings; ++cut) {
      if (potential() <= line_.before + kArmijoParameter * line_.promise + rounded_potential())
        break;
      // Take back half of the last step, of body and object.
      line_.promise /= 2;
      line_.motion /= 2;
      dx_ /= 2;
      iterate_.state.x -= dx_;
      iterate_.state.X_PO.p -= line_.motion * iterate_.goal.along;
      if (!iterate_.evaluate_tissue(ElementRequest::kStiffness, dx_, u, out)) return false;
      find_springs(0);
    }
    return true;
  }

  /// Returns whether steps with friction go round for ever.
  bool goes_round(const PressOutcome& out) {
    // Iteration in which the residual last fell by half.
    if (out.residual < kRoundFall * least_) {
      least_ = out.residual;
      fell_ = out.iterations;
    }
    return iterate_.object.friction > 0 && out.iterations > fell_ + kRoundIterations;
  }

  /// Finds the next step. @return false if there is none
  bool find_step() {
    iterate_.springs->add_stiffness(iterate_.tissue.tangent);
    dx_.resize(0);
    line_ = {potential(), 0, 0};
    if (!factored()) return false;
    // Newton step; to reach a force the object's motion is one more unknown.
    dx_ = solve(-iterate_.residual);
    if (iterate_.goal.force &&
        !iterate_.solve_object_motion(
            [&](const Matrix3Xd& moved) { return iterate_.springs->force_loss(moved); },
            [&](const VectorXd& b) { return solve(b); }, dx_, line_.motion))
      return false;
    // Change of the potential by its slope.
    line_.promise = iterate_.residual.dot(dx_) - iterate_.force_deficit * line_.motion;
    return true;
  }

  /// Applies the step. @param may_grow  if it runs off an equilibrium that is not stable
  void take_step(const Matrix3Xd& u, bool may_grow) {
    // Lengthen a step that runs off, up to the longest motion.
    const bool runs = may_grow && runs_off();
    last_ = dx_;
    if (runs)
      dx_ *= std::clamp(iterate_.max_motion / dx_.lpNorm<Eigen::Infinity>(), 1.0, kMostGrowth);
    // Pressure and friction that the step predicts.
    iterate_.state.pressure =
        iterate_.body.predict_pressure(u, iterate_.body.node_displacements(dx_, {}));
    if (iterate_.object.friction > 0) {
      Matrix3Xd moved = iterate_.surface_displacements(dx_);
      moved.colwise() -= line_.motion * iterate_.goal.along;
      iterate_.state.friction_force =
          iterate_.springs->friction_forces() - iterate_.springs->friction_force_loss(moved);
    }
    iterate_.state.x += dx_;
    iterate_.state.X_PO.p += line_.motion * iterate_.goal.along;
  }

  /// Returns whether steps go on in one direction and grow, as off an equilibrium that is not
  /// stable.
  [[nodiscard]] bool runs_off() const {
    return iterate_.object.friction <= 0 && !iterate_.goal.force && last_.size() > 0 &&
           dx_.norm() > last_.norm() && dx_.dot(last_) > kSameWayCosine * dx_.norm() * last_.norm();
  }

  /// Returns whether the object, which does not wait for a force, is off the skin at rest.
  bool misses_skin_at_rest() {
    if (iterate_.goal.force || iterate_.body.relaxes()) return false;
    // Depth of the skin at rest, for which any stiffness will do.
    const std::vector<double> any(iterate_.surface.nodes.size(), 1);
    iterate_.springs->update(*iterate_.object.shape, iterate_.state.X_PO,
                             VectorXd::Zero(iterate_.state.x.size()), any, 0,
                             {iterate_.start.anchor, iterate_.state.friction_force});
    return iterate_.springs->max_depth() <= 0;
  }

  /// Energy of tissue and springs, less the work of the force on the object [J].
  [[nodiscard]] double potential() const {
    return iterate_.tissue.energy + iterate_.springs->energy() -
           iterate_.goal.force.value_or(0) *
               iterate_.goal.along.dot(iterate_.state.X_PO.p - iterate_.start.X_PO.p);
  }
  [[nodiscard]] double rounded_potential() const {
    return kRoundedPotential * std::abs(potential()) +
           kRoundedStretch * iterate_.body.max_shear_modulus() *
               std::pow(iterate_.surface.area.sum(), 1.5);
  }

  bool factored() {
    return iterate_.factor_stabilized(
        [&] { return iterate_.factors.tangent.factor(iterate_.tissue.tangent); });
  }

  /// Solves with the matrix of this iteration, of which friction is not symmetric and comes by
  /// iterations.
  [[nodiscard]] VectorXd solve(const VectorXd& b) const {
    if (iterate_.object.friction <= 0) return iterate_.factors.tangent.solve(b);
    return iterate_.solve_iteratively(
        b, [&](const Matrix3Xd& moved) { return iterate_.springs->unfactored_loss(moved); });
  }

  /// Line search along the last step.
  struct LineSearch {
    double before = kInfinity;  // potential before it [J]
    double promise = 0;         // its change by slopes [J]
    double motion = 0;          // of the object [m]
  };

  PressIterate& iterate_;
  VectorXd dx_, last_;  // steps [m] (3 free nodes)
  LineSearch line_;
  double least_ = kInfinity;  // residual [N]
  int fell_ = 0;              // the iteration in which it became that
};

}  // namespace

PressOutcome press_by_springs(PressIterate& iterate) { return SpringPress(iterate).solve(); }

Eigen::Matrix<double, 6, 6> spring_press_stiffness(PressIterate& iterate) {
  return SpringPress(iterate).stiffness();
}

}  // namespace thenar
