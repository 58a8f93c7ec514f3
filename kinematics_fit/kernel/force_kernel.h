#pragma once

/// Forces of an experiment and their adjoint, several points at a time.

#include <memory>

#include <Eigen/Core>

#include "kinematics_fit/model/predict_forces.h"

namespace thenar {

/// Vectorised predict_forces() for many parameter values, with derivatives by a hand-written
/// adjoint.
///
/// Points share the registers (lanes) of the widest vector unit of the processor; every unit gives
/// the same bits, also for a single point. Immutable once built; used by many threads. Derivation:
/// docs/theory/fitting.md, "The adjoint of the force model".
class ForceKernel {
 public:
  /// Returns whether the kernel supports a digit and a plan: no extensor net, and no forces
  /// measured at segments other than the tip.
  [[nodiscard]] static bool supports(const TendonDigit& digit, const ExperimentPlan& plan);

  /// @param parameters  selects the parameters that move; the others stay at their means
  /// @throws InputError for an experiment that it does not support.
  ForceKernel(const TendonDigit& digit, const FitParameters& parameters,
              const ExperimentPlan& plan);
  ~ForceKernel();
  ForceKernel(ForceKernel&&) noexcept;

  [[nodiscard]] int coordinates() const;  // entries of u, FitParameters::coordinates()
  [[nodiscard]] int trials() const;
  [[nodiscard]] static int lanes();  // batch size for which the cost per point is lowest

  /// Predicts the forces of every trial at displacements u (coordinates, points) [N] (3 trials,
  /// points). NaN if the constrained tip is singular.
  [[nodiscard]] Eigen::MatrixXd forces(const Eigen::Ref<const Eigen::MatrixXd>& u) const;

  /// Forces at one point and their derivatives.
  struct Slopes {
    Eigen::VectorXd forces;  // [N] (3 trials)
    Eigen::MatrixXd J;       // d forces / du [N per SI] (3 trials, coordinates)
  };
  /// Computes forces and derivatives, by one adjoint per force. Evaluates as many at once as there
  /// are lanes, each only through its own posture.
  [[nodiscard]] Slopes slopes(const Eigen::VectorXd& u) const;

  /// Intermediate results of forces() that adjoint_product() needs.
  class Tape;

  /// Forces with the tape of their computation.
  struct Recorded {
    Eigen::MatrixXd forces;      // [N] (3 trials, points)
    std::shared_ptr<Tape> tape;  // shared, since the type is private to the source
  };
  /// Predicts the forces and records the tape.
  [[nodiscard]] Recorded record(const Eigen::Ref<const Eigen::MatrixXd>& u) const;

  /// Computes J' w for every point, J = d forces / du  (coordinates, points).
  /// @param weights  weights w, in a unit of the caller's choice per N (3 trials, points)
  [[nodiscard]] Eigen::MatrixXd adjoint_product(
      const Recorded& recorded, const Eigen::Ref<const Eigen::MatrixXd>& weights) const;

 private:
  struct Program;
  std::unique_ptr<Program> program_;
};

}  // namespace thenar
