#pragma once

/// Stiff ordinary differential equations  y' = f(t, y).

#include <functional>
#include <memory>

#include <Eigen/Core>

namespace thenar {

/// Right-hand side f(t, y). If the result is not finite, the integrator tries a shorter step.
/// Exceptions propagate out of step().
/// @param time  [s]
using OdeRightHandSide = std::function<Eigen::VectorXd(double time, const Eigen::VectorXd& y)>;

/// Jacobian df/dy at (t, y) (n, n). It is only used in the integrator's Newton iterations; step
/// acceptance depends on f alone. If the result is not finite, the integrator tries a shorter step.
using OdeJacobian = std::function<Eigen::MatrixXd(double time, const Eigen::VectorXd& y)>;

struct StiffOdeOptions {
  double relative = 1e-6;    // relative tolerance of the error of one step [1]
  Eigen::VectorXd absolute;  // absolute tolerance of each state, in its unit (n)
  int max_steps = 1000000;   // maximum number of steps in the lifetime of the integrator
  OdeJacobian jacobian{};    // Jacobian of f; empty: finite differences
};

/// Outcome of a step; covers every return code of CVODE.
enum class OdeStatus {
  kStepped,     // the step succeeded
  kLimit,       // max_steps was reached
  kTooStiff,    // no step is short enough: f jumps, or Newton's iteration does not converge
  kNotFinite,   // f is not finite, at the current state or for every step that was tried
  kSingular,    // the Newton matrix could not be set up or solved
  kImpossible,  // the tolerances are below rounding, or `stop` is too close
  kFailed       // any other failure
};

/// Work counters. `slopes` counts evaluations of f, including those for finite differences;
/// `rejected` counts steps whose error was too large or whose Newton iteration failed.
struct OdeCounts {
  long steps = 0, slopes = 0, jacobians = 0, rejected = 0;
};

/// Integrator with backward differentiation formulas of order 1 to 5 and dense Newton steps, by
/// CVODE.
/// Source: [Hindmarsh2005].
class StiffOde {
 public:
  /// @param y  initial state (n)
  /// @throws InputError if a tolerance is not positive or has the wrong length.
  StiffOde(OdeRightHandSide slope, double time, const Eigen::VectorXd& y,
           const StiffOdeOptions& options);
  ~StiffOde();
  StiffOde(StiffOde&&) noexcept;
  StiffOde& operator=(StiffOde&&) noexcept;

  /// Takes one step whose length the tolerances determine, but never beyond `stop` > time(). Unless
  /// the result is kStepped, time() and state() are unchanged.
  [[nodiscard]] OdeStatus step(double stop);

  /// Restarts the integrator at the current state, e.g. after a jump of f. Step tolerances are
  /// multiplied by `tolerance_factor` until the next restart. @throws InputError unless it is
  /// positive.
  void restart(double tolerance_factor = 1);

  [[nodiscard]] double time() const;
  [[nodiscard]] Eigen::VectorXd state() const;

  /// Returns the interpolated state at a time within the last step. @throws InputError outside it.
  [[nodiscard]] Eigen::VectorXd state_at(double time) const;

  [[nodiscard]] OdeCounts counts() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace thenar
