#pragma once

/// Moment arms of a digit's strands for wrapped and fitted paths.

#include <memory>
#include <string>
#include <vector>

#include "tendons/digit_tendons.h"
#include "tendons/wrapping/path_solver.h"

namespace thenar {

/// Moment arms of all strands at one posture, without friction in sheaths.
struct [[nodiscard]] StrandArms {
  Eigen::MatrixXd R;    // moment arms, flexion positive [m/rad] (strands, coordinates)
  std::string warning;  // reason for a poor `status`; may be empty
  TendonStatus status = TendonStatus::kValid;  // worst status of all strands
};

/// Lengths, arms and arm derivatives of all strands at one posture, without friction in sheaths.
struct [[nodiscard]] StrandDerivatives {
  bool exist = true;       // false: a strand is not differentiable here
  Eigen::MatrixXd R;       // moment arms, as in StrandArms
  Eigen::VectorXd length;  // strand lengths [m] (strands); -R q where arms are constant
  /// Derivatives d R_j/d q_k, one matrix (coordinates, coordinates) per strand [m/rad^2] (strands).
  std::vector<Eigen::MatrixXd> dR;
};

/// Workspace for arms of wrapped strands; it does not affect results.
struct StrandWorkspace {
  PathSolver solver;
};

/// Paths of a digit's strands, wrapped or fitted.
class StrandPaths {
 public:
  virtual ~StrandPaths() = default;
  /// Computes the moment arms of all strands.
  [[nodiscard]] virtual StrandArms arms(const TreeState<double>& state,
                                        const Eigen::VectorXd& q) const = 0;
  /// Returns a workspace for set_arms(), which these paths must outlive; null where none is needed.
  [[nodiscard]] virtual std::unique_ptr<StrandWorkspace> make_workspace() const { return nullptr; }
  /// Overwrites `out` with arms(). @param workspace  from make_workspace()
  virtual void set_arms(const TreeState<double>& state, const Eigen::VectorXd& q,
                        StrandWorkspace* /*workspace*/, StrandArms& out) const {
    out = arms(state, q);
  }
  /// Computes the strand lengths, as in StrandDerivatives (strands) [m].
  [[nodiscard]] virtual Eigen::VectorXd lengths(const TreeState<double>& state,
                                                const Eigen::VectorXd& q) const = 0;
  /// Computes lengths, arms and arm derivatives of all strands.
  /// @param workspace  from make_workspace(); null: one is made for this call
  [[nodiscard]] virtual StrandDerivatives derivatives(const TreeState<double>& state,
                                                      const Eigen::VectorXd& q,
                                                      StrandWorkspace* workspace) const = 0;
  [[nodiscard]] StrandDerivatives derivatives(const TreeState<double>& state,
                                              const Eigen::VectorXd& q) const {
    return derivatives(state, q, nullptr);
  }
};

/// Builds paths as geodesics over the subject's surfaces; strands without a path keep constant
/// arms.
/// @throws InputError as build_paths().
[[nodiscard]] std::unique_ptr<StrandPaths> build_wrapped_paths(const Subject& subject,
                                                               const TendonDigit& digit);

/// Builds paths as polynomials of posture over the joints' ranges, fitted to geodesics by
/// fit_path().
/// @param order  order of the polynomials in each coordinate
/// @throws InputError as build_paths() and fit_path().
[[nodiscard]] std::unique_ptr<StrandPaths> build_fitted_paths(const Subject& subject,
                                                              const TendonDigit& digit,
                                                              int order = 8);

}  // namespace thenar
