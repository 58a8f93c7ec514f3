#pragma once

/// Forces of an experiment and their adjoint, several points at a time.

#include <memory>

#include <Eigen/Core>

#include "kinematics_fit/model/predict_forces.h"

namespace thenar {

/// predict_forces() for many parameter values at once, with derivatives by a hand-written adjoint.
///
/// Points share registers (lanes) of the widest vector unit that this processor has; every unit
/// gives the same bits, also for a single point. Constant once built; used by many threads.
/// Derivation: docs/theory/fitting.md, "The adjoint of the force model".
class ForceKernel {
 public:
  /// Returns whether the kernel covers a digit and a plan: no extensor net, and no forces measured
  /// at other segments than the tip.
  [[nodiscard]] static bool knows(const TendonDigit& digit, const ExperimentPlan& plan);

  /// @param parameters  which entries of the parameter values move; the others stay at their mean
  /// @throws InputError for an experiment that it does not know.
  ForceKernel(const TendonDigit& digit, const FitParameters& parameters,
              const ExperimentPlan& plan);
  ~ForceKernel();
  ForceKernel(ForceKernel&&) noexcept;

  [[nodiscard]] int coordinates() const;  // of u, FitParameters::coordinates()
  [[nodiscard]] int trials() const;
  [[nodiscard]] static int lanes();  // points of a batch at which the cost of each is least

  /// Forces of every trial at displacements u (coordinates, points) [N] (3 trials, points).
  /// NaN where the held tip is singular.
  [[nodiscard]] Eigen::MatrixXd forces(const Eigen::Ref<const Eigen::MatrixXd>& u) const;

  /// Forces at one point and their derivatives.
  struct Slopes {
    Eigen::VectorXd forces;  // [N] (3 trials)
    Eigen::MatrixXd J;       // d forces / du [N per SI] (3 trials, coordinates)
  };
  /// One adjoint for each force, as many at once as there are lanes, through its posture alone.
  [[nodiscard]] Slopes slopes(const Eigen::VectorXd& u) const;

  /// Intermediate results of forces() that adjoint_product() needs.
  class Tape;

  /// Forces with the tape of their computation.
  struct Recorded {
    Eigen::MatrixXd forces;      // [N] (3 trials, points)
    std::shared_ptr<Tape> tape;  // shared, since the type is private to the source
  };
  [[nodiscard]] Recorded record(const Eigen::Ref<const Eigen::MatrixXd>& u) const;

  /// J' w for every point, J = d forces / du  (coordinates, points).
  /// @param weights  [1/N times whatever] (3 trials, points)
  [[nodiscard]] Eigen::MatrixXd adjoint_product(
      const Recorded& recorded, const Eigen::Ref<const Eigen::MatrixXd>& weights) const;

 private:
  struct Program;
  std::unique_ptr<Program> program_;
};

}  // namespace thenar
