#pragma once

/// Stiff ordinary differential equations  y' = f(t, y).

#include <functional>
#include <memory>

#include <Eigen/Core>

namespace thenar {

/// f(t, y). A result that is not finite makes the integrator try a shorter step; an exception stops
/// it and comes out of step().
/// @param time  [s]
using OdeRightHandSide = std::function<Eigen::VectorXd(double time, const Eigen::VectorXd& y)>;

/// df/dy at (t, y) (n, n). It only steers the integrator's Newton steps; a step is accepted by f
/// alone. A result that is not finite makes the integrator try a shorter step.
using OdeJacobian = std::function<Eigen::MatrixXd(double time, const Eigen::VectorXd& y)>;

struct StiffOdeOptions {
  double relative = 1e-6;    // error of one step, of each state's size [1]
  Eigen::VectorXd absolute;  // error of one step below which no state is resolved; its units
  int max_steps = 1000000;   // over the whole life
  OdeJacobian jacobian{};    // empty: by differences of f
};

/// Outcome of a step; every answer of CVODE is one of them.
enum class OdeStatus {
  kStepped,     // one step further
  kLimit,       // max_steps done
  kTooStiff,    // no step is short enough: f jumps, or Newton's steps do not converge
  kNotFinite,   // f is not finite, here or at every step that was tried
  kSingular,    // the matrix of Newton's steps could not be set up or solved with
  kImpossible,  // tolerances below rounding, or nothing left between here and `stop`
  kFailed       // anything else
};

/// Counts of the work; slopes exclude those of given Jacobians. Rejected are steps whose error was
/// too large, or whose equations Newton's steps did not solve.
struct OdeCounts {
  long steps = 0, slopes = 0, jacobians = 0, rejected = 0;
};

/// Backward differentiation formulas of order 1 to 5 with dense Newton steps, by CVODE.
/// Source: [Hindmarsh2005].
class StiffOde {
 public:
  /// @param y  initial state (n)
  /// @throws InputError if a tolerance is not positive, or of the wrong length.
  StiffOde(OdeRightHandSide slope, double time, const Eigen::VectorXd& y,
           const StiffOdeOptions& options);
  ~StiffOde();
  StiffOde(StiffOde&&) noexcept;
  StiffOde& operator=(StiffOde&&) noexcept;

  /// One step, of whatever length the tolerances allow, but never beyond `stop` > time(). Unless it
  /// is kStepped, time() and state() are those before.
  [[nodiscard]] OdeStatus step(double stop);

  /// Starts anew from here, where f jumps, with the errors of a step that the options allow times
  /// `looser`, up to the next restart. @throws InputError unless it is positive.
  void restart(double looser = 1);

  [[nodiscard]] double time() const;
  [[nodiscard]] Eigen::VectorXd state() const;

  /// Returns the state at a time within the last step. @throws InputError outside it.
  [[nodiscard]] Eigen::VectorXd state_at(double time) const;

  [[nodiscard]] OdeCounts counts() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace thenar
