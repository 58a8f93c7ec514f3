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
  explicit SpringPress(PressIterate& at) : at_(at) {}

  PressOutcome solve() {
    PressOutcome out;
    at_.springs.emplace(at_.body, at_.surface);
    if (is_off_at_rest()) {
      // Skin that hangs on an edge would be another answer.
      at_.now.x.setZero();
      at_.now.pressure.clear();
      at_.end(at_.body.spread(at_.now.x, {}), out);
      return out;
    }
    for (; at_.goes_on(out); ++out.iterations) {
      // Tissue and springs at the iterate; a step that did not lower the potential is cut.
      Matrix3Xd u;
      if (!at_.respond(ElementAsk::kStiffness, dx_, u, out)) return out;
      if (out.iterations == 0) find_spring_stiffness();
      find_springs(at_.object.friction);
      if (out.iterations > kFreeIterations && !search_line(u, out)) return out;
      // Balanced, or going round without progress.
      at_.measure(at_.springs->push(), out);
      if (at_.is_solved(out)) {
        at_.end(u, out);
        return out;
      }
      if (goes_round(out)) {
        out.message = "steps go round";
        return out;
      }
      if (at_.goal.force && at_.scale == 0) {
        // A force is sought and nothing touches: move the object on.
        at_.gaps.find(*at_.object.shape, at_.now.X_PO, at_.now.x);
        if (!at_.go_to_touch(out)) return out;
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
    at_.residual = VectorXd::Zero(at_.body.unknowns());
    find_spring_stiffness();
    at_.springs.emplace(at_.body, at_.surface);
    find_springs(at_.object.friction * (1 - kSlipMargin));
    at_.springs->add_slopes(at_.tissue.values);
    if (!factored()) return Eigen::Matrix<double, 6, 6>::Zero();
    // Forces by a motion of the object, less those that the body's motion gives back.
    const SkinSprings& springs = *at_.springs;
    return push_slope(places_of(at_.surface, at_.now.x), springs.push() + springs.shear(),
                      [&](const Matrix3Xd& rigid, const Matrix3Xd& turned) {
                        const Matrix3Xd pushed = springs.loss(rigid) + turned;
                        const Matrix3Xd moved = at_.on_surface(solve(at_.on_body(pushed)));
                        return PushAnswer{pushed - springs.loss(moved), moved};
                      });
  }

 private:
  /// Sets springs that stay as they were unless tissue has become much stiffer or softer, as a
  /// change makes energy from nothing.
  void find_spring_stiffness() {
    at_.find_stiffness(at_.tissue.values);
    for (double& each : at_.stiffness) each *= kSpringStiffnessRatio;
    for (std::size_t k = 0; k < at_.start.spring_stiffness.size(); ++k) {
      const double was = at_.start.spring_stiffness[k], is = at_.stiffness[k];
      if (std::max(was / is, is / was) < kStiffnessChange) at_.stiffness[k] = was;
    }
  }

  /// Sets springs, and contact forces by them.
  void find_springs(double friction) {
    at_.springs->find(*at_.object.shape, at_.now.X_PO, at_.now.x, at_.stiffness, friction,
                      {at_.start.anchor, at_.now.shear});
    for (std::size_t k = 0; k < at_.contacts.size(); ++k) {
      const auto column = static_cast<Eigen::Index>(k);
      at_.contacts[k].push = at_.springs->push().col(column).norm();
      at_.contacts[k].shear = at_.springs->shear().col(column);
    }
  }

  /// Halves the last step until the potential falls as slopes promise (Armijo's rule); with
  /// friction there is none.
  /// @return false if tissue gives no answer
  bool search_line(Matrix3Xd& u, PressOutcome& out) {
    if (at_.object.friction > 0) return true;
    for (int cut = 0; cut < kStepHalvings; ++cut) {
      if (potential() <= line_.before + kArmijoParameter * line_.promise + rounded_potential())
        break;
      // Take back half of the last step, of body and object.
      line_.promise /= 2;
      line_.motion /= 2;
      dx_ /= 2;
      at_.now.x -= dx_;
      at_.now.X_PO.p -= line_.motion * at_.goal.along;
      if (!at_.respond(ElementAsk::kStiffness, dx_, u, out)) return false;
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
    return at_.object.friction > 0 && out.iterations > fell_ + kRoundIterations;
  }

  /// Finds the next step. @return false if there is none
  bool find_step() {
    at_.springs->add_slopes(at_.tissue.values);
    dx_.resize(0);
    line_ = {potential(), 0, 0};
    if (!factored()) return false;
    // Newton step; to reach a force the object's motion is one more unknown.
    dx_ = solve(-at_.residual);
    if (at_.goal.force &&
        !at_.reach_force([&](const Matrix3Xd& moved) { return at_.springs->loss(moved); },
                         [&](const VectorXd& b) { return solve(b); }, dx_, line_.motion))
      return false;
    // Change of the potential by its slope.
    line_.promise = at_.residual.dot(dx_) - at_.missing * line_.motion;
    return true;
  }

  /// Applies the step. @param may_grow  if it runs off an equilibrium that is not stable
  void take_step(const Matrix3Xd& u, bool may_grow) {
    // Lengthen a step that runs off, up to the longest motion.
    const bool runs = may_grow && runs_off();
    last_ = dx_;
    if (runs) dx_ *= std::clamp(at_.longest / dx_.lpNorm<Eigen::Infinity>(), 1.0, kMostGrowth);
    // Pressure and friction that the step predicts.
    at_.now.pressure = at_.body.pressure_after(u, at_.body.spread(dx_, {}));
    if (at_.object.friction > 0) {
      Matrix3Xd moved = at_.on_surface(dx_);
      moved.colwise() -= line_.motion * at_.goal.along;
      at_.now.shear = at_.springs->shear() - at_.springs->friction_loss(moved);
    }
    at_.now.x += dx_;
    at_.now.X_PO.p += line_.motion * at_.goal.along;
  }

  /// Returns whether steps go on in one direction and grow, as off an equilibrium that is not
  /// stable.
  [[nodiscard]] bool runs_off() const {
    return at_.object.friction <= 0 && !at_.goal.force && last_.size() > 0 &&
           dx_.norm() > last_.norm() && dx_.dot(last_) > kSameWayCosine * dx_.norm() * last_.norm();
  }

  /// Returns whether the object, which does not wait for a force, is off the skin at rest.
  bool is_off_at_rest() {
    if (at_.goal.force || at_.body.relaxes()) return false;
    // Depth of the skin at rest, for which any stiffness will do.
    const std::vector<double> any(at_.surface.nodes.size(), 1);
    at_.springs->find(*at_.object.shape, at_.now.X_PO, VectorXd::Zero(at_.now.x.size()), any, 0,
                      {at_.start.anchor, at_.now.shear});
    return at_.springs->deepest() <= 0;
  }

  /// Energy of tissue and springs, less the work of the force on the object [J].
  [[nodiscard]] double potential() const {
    return at_.tissue.energy + at_.springs->energy() -
           at_.goal.force.value_or(0) * at_.goal.along.dot(at_.now.X_PO.p - at_.start.X_PO.p);
  }
  [[nodiscard]] double rounded_potential() const {
    return kRoundedPotential * std::abs(potential()) +
           kRoundedStretch * at_.body.largest_modulus() * std::pow(at_.surface.area.sum(), 1.5);
  }

  bool factored() {
    return at_.factored([&] { return at_.factors.moment.factor(at_.tissue.values); });
  }

  /// Solves with the matrix of this iteration, of which friction is not symmetric and comes by
  /// iterations.
  [[nodiscard]] VectorXd solve(const VectorXd& b) const {
    if (at_.object.friction <= 0) return at_.factors.moment.solve(b);
    return at_.solve_with(
        b, [&](const Matrix3Xd& moved) { return at_.springs->loss_left_out(moved); });
  }

  /// Line search along the last step.
  struct LineSearch {
    double before = kInfinity;  // potential before it [J]
    double promise = 0;         // its change by slopes [J]
    double motion = 0;          // of the object [m]
  };

  PressIterate& at_;
  VectorXd dx_, last_;  // steps [m] (3 free nodes)
  LineSearch line_;
  double least_ = kInfinity;  // residual [N]
  int fell_ = 0;              // the iteration in which it became that
};

}  // namespace

PressOutcome press_by_springs(PressIterate& at) { return SpringPress(at).solve(); }

Eigen::Matrix<double, 6, 6> spring_press_stiffness(PressIterate& at) {
  return SpringPress(at).stiffness();
}

}  // namespace thenar
