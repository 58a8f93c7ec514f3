#pragma once

/// Moment arms of a digit's strands on the rungs of paths above via points.

#include <memory>
#include <string>
#include <vector>

#include "tendons/digit_tendons.h"
#include "tendons/wrapping/path_solver.h"

namespace thenar {

/// Moment arms at one posture, before friction in sheaths.
struct [[nodiscard]] StrandArms {
  Eigen::MatrixXd R;                           // flexion + (strands, coordinates) [m/rad]
  std::string warning;                         // why not to trust them; may be empty
  TendonStatus status = TendonStatus::kValid;  // the worst of all strands
};

/// Lengths, arms and their derivatives at one posture, before friction in sheaths.
struct [[nodiscard]] StrandDerivatives {
  bool exist = true;                // false: a strand is not differentiable here
  Eigen::MatrixXd R;                // as of StrandArms
  Eigen::VectorXd length;           // [m]; of strands with constant arms  -R q (strands)
  std::vector<Eigen::MatrixXd> dR;  // d R_j/d q_k [m/rad^2] (strands) of (coordinates, coordinates)
};

/// Scratch memory for arms of wrapped strands; it does not affect results.
struct StrandRoom {
  PathSolver solver;
};

/// The paths of a digit's strands on one rung.
class StrandPaths {
 public:
  virtual ~StrandPaths() = default;
  [[nodiscard]] virtual StrandArms arms(const TreeState<double>& state,
                                        const Eigen::VectorXd& q) const = 0;
  /// Returns scratch memory for set_arms(), which these paths must outlive; null: they need none.
  [[nodiscard]] virtual std::unique_ptr<StrandRoom> room() const { return nullptr; }
  /// Writes arms() over `out`. @param room  by room()
  virtual void set_arms(const TreeState<double>& state, const Eigen::VectorXd& q,
                        StrandRoom* /*room*/, StrandArms& out) const {
    out = arms(state, q);
  }
  /// Returns the lengths of StrandDerivatives (strands) [m].
  [[nodiscard]] virtual Eigen::VectorXd lengths(const TreeState<double>& state,
                                                const Eigen::VectorXd& q) const = 0;
  /// @param room  by room(); null: it has one of its own
  [[nodiscard]] virtual StrandDerivatives derivatives(const TreeState<double>& state,
                                                      const Eigen::VectorXd& q,
                                                      StrandRoom* room) const = 0;
  [[nodiscard]] StrandDerivatives derivatives(const TreeState<double>& state,
                                              const Eigen::VectorXd& q) const {
    return derivatives(state, q, nullptr);
  }
};

/// Geodesics over the subject's surfaces; strands without a path keep their constant arms.
/// @throws InputError as build_paths().
[[nodiscard]] std::unique_ptr<StrandPaths> build_wrapped_paths(const Subject& subject,
                                                               const TendonDigit& digit);

/// Polynomials of posture over the joints' ranges, fitted to those geodesics; see fit_path().
/// @param order  of the polynomials in each coordinate
/// @throws InputError as build_paths() and fit_path().
[[nodiscard]] std::unique_ptr<StrandPaths> build_fitted_paths(const Subject& subject,
                                                              const TendonDigit& digit,
                                                              int order = 8);

}  // namespace thenar
