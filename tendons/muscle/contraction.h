#pragma once

/// Tension from activation: the muscle models of the ladder `Muscle`, behind one interface.

#include <memory>
#include <vector>

#include "base/fidelity.h"
#include "tendons/muscle/musculotendon.h"
#include "tendons/tendon_model.h"
#include "tendons/tension_law.h"

namespace thenar {

/// State of one muscle.
struct MuscleState {
  double activation = 0;       // 0..1 [1]
  double length = 0;           // length of muscle and tendon [m]
  double velocity = 0;         // rate of `length`, lengthening positive [m/s]
  double projected_fibre = 0;  // length of the fibre along the tendon, where it is a state [m]
};

/// States of all muscles of a contraction.
struct MuscleStates {
  Eigen::VectorXd activation, length, velocity, projected_fibre;  // as in MuscleState (muscles)

  /// Sets all states to zero.
  void clear(Eigen::Index muscles);
  [[nodiscard]] MuscleState muscle(int m) const {
    return {activation[m], length[m], velocity[m], projected_fibre[m]};
  }
};

/// Tensions of all muscles of a contraction, with their partial derivatives.
struct MuscleTensions {
  Eigen::VectorXd tension;  // [N] (muscles)
  Eigen::VectorXd by_activation, by_length, by_velocity,
      by_projected_fibre;  // as in TensionDerivatives (muscles)
};

/// Computes the tensions of all muscles of a contraction at once. It owns a workspace, which does
/// not affect results: use one object per thread.
class TensionSolver {
 public:
  virtual ~TensionSolver() = default;
  /// Computes Contraction::tension() of all muscles; derivatives in `out` keep their values.
  virtual void tensions(const MuscleStates& at, MuscleTensions& out) = 0;
  /// Computes tensions and Contraction::tension_derivatives() of all muscles.
  virtual void derivatives(const MuscleStates& at, MuscleTensions& out) = 0;
};

/// Muscles of a digit with one muscle model.
class Contraction {
 public:
  explicit Contraction(std::vector<Musculotendon> muscles) : muscles_(std::move(muscles)) {}
  virtual ~Contraction() = default;

  [[nodiscard]] const std::vector<Musculotendon>& muscles() const { return muscles_; }

  /// Returns the muscle model.
  [[nodiscard]] virtual Muscle rung() const = 0;

  /// Returns whether tension depends on velocity.
  [[nodiscard]] virtual bool depends_on_velocity() const { return false; }

  /// Returns whether the projected length of the fibres is a state.
  [[nodiscard]] virtual bool has_fibre_state() const { return false; }

  /// Computes the tension of muscle m, >= 0 [N].
  [[nodiscard]] virtual double tension(int m, const MuscleState& state) const = 0;

  /// Returns a solver for the tensions of all muscles at once, which must not outlive this object;
  /// its results equal tension() and tension_derivatives() to rounding.
  [[nodiscard]] virtual std::unique_ptr<TensionSolver> tension_solver() const;

  /// Computes the rate of projected_fibre of muscle m [m/s]; 0 where it is not a state.
  [[nodiscard]] virtual double projected_fibre_rate(int /*m*/, const MuscleState& /*state*/) const {
    return 0;
  }

  /// Computes the partial derivatives of tension() by the state of muscle m.
  [[nodiscard]] virtual TensionDerivatives tension_derivatives(int m,
                                                               const MuscleState& state) const = 0;

  /// Computes the partial derivatives of projected_fibre_rate() by the state of muscle m; 0 where
  /// projected_fibre is not a state.
  [[nodiscard]] virtual FibreRateDerivatives fibre_rate_derivatives(
      int /*m*/, const MuscleState& /*state*/) const {
    return {};
  }

  /// Computes the projected fibre length of muscle m in equilibrium at zero velocity [m]; 0 where
  /// it is not a state.
  [[nodiscard]] virtual double isometric_projected_fibre(int /*m*/, double /*activation*/,
                                                         double /*length*/) const {
    return 0;
  }

  /// Returns the same fibres on a short tendon, as long as a fibre, that stretches by `strain` at
  /// F0, so that tension is a function of states alone; null where tension does not depend on
  /// velocity.
  [[nodiscard]] virtual std::unique_ptr<Contraction> with_compliant_tendon(
      double /*strain*/) const {
    return nullptr;
  }

  /// Returns the tension law of the tendon of muscle m, which carries `base` beside its own tension
  /// [N]; null where the fibre is not a state.
  [[nodiscard]] virtual std::shared_ptr<const TensionLaw> tendon_law(int /*m*/,
                                                                     double /*base*/) const {
    return nullptr;
  }

  /// Computes fibre length over optimal fibre length [1]; 0 in a model without fibres.
  [[nodiscard]] virtual double fibre(int /*m*/, const MuscleState& /*state*/) const { return 0; }

 protected:
  [[nodiscard]] const Musculotendon& muscle(int m) const { return muscles_[m]; }

 private:
  std::vector<Musculotendon> muscles_;
};

/// Builds the muscle model `rung`. Bounds: tension = activation F0. Rigid tendon: tension by length
/// and velocity. Elastic tendon: tension by length and projected fibre, whose rate follows from the
/// balance of fibre and tendon.
[[nodiscard]] std::unique_ptr<Contraction> build_contraction(std::vector<Musculotendon> muscles,
                                                             Muscle rung,
                                                             const HillOptions& options = {});

/// Returns the first muscle of a digit for which the subject states no fibre length; "" if there is
/// none.
[[nodiscard]] std::string muscle_without_fibre(const Subject& subject, const TendonDigit& digit);

/// Returns the constants of the muscles of a digit, in its order.
/// @throws InputError naming a muscle and the key that its subject lacks: every model needs
/// max_force; a rigid tendon also needs fibre_length; an elastic one also tendon_slack.
[[nodiscard]] std::vector<Musculotendon> musculotendons(const Subject& subject,
                                                        const TendonDigit& digit, Muscle rung);

}  // namespace thenar
