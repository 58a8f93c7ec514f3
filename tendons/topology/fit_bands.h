#pragma once

/// Fit of the band stiffnesses of a topology to measurements.

#include <vector>

#include <Eigen/Core>

#include "solvers/bounded_least_squares.h"
#include "tendons/topology/net_forward_model.h"

namespace thenar {

/// Assumption about one candidate in a fit.
enum class Presence {
  kNo,     // EA = 0
  kYes,    // EA between the bounds of the candidate
  kEither  // 0 < EA <= upper bound, from kGhostRatio of the typical EA on
};
using Presences = std::vector<Presence>;

/// Fraction of the typical EA below which a band's load no longer depends on ratios of stiffness
/// [1].
inline constexpr double kSoftRatio = 0.05;

/// Fraction of the typical EA that a band keeps where it may exist but vanishes, so that the net's
/// derivative by it stays defined; it then carries this fraction of its share [1].
inline constexpr double kGhostRatio = 0.01;

/// Result of a fit: the best stiffnesses under one set of assumptions.
struct [[nodiscard]] BandFit {
  bool holds = false;      // true: the net carries all loads; false: other members are meaningless
  bool converged = false;  // true: the fit reached its tolerance
  double residual = 0;     // largest out-of-balance force of its nets, as in NetPrediction [N]
  Eigen::VectorXd s;       // EA / typical EA of each candidate [1] (candidates)
  double misfit = 0;       // chi^2 = sum ((predicted - measured) / sd)^2 [1]
  Eigen::VectorXd r;       // residuals in units of sd (rows)
  Eigen::MatrixXd J;       // derivative of the residuals by s (rows, candidates)
};

/// Fits one set of records repeatedly, under changing assumptions.
class BandFitter {
 public:
  /// Prepares the fits. @throws InputError naming the candidate or record that is wrong.
  BandFitter(const CandidateNet& candidate, const std::vector<TendonRecord>& records,
             const BoundedFitOptions& options = {});

  /// Fits the stiffnesses. The unknowns are  x = log(1 + s / kSoftRatio),  since a net depends on
  /// ratios of stiffness, but zero must be reachable. Their penalty is thus the log-sum penalty
  /// that re-weighted L1 majorises [Candes2008]. During the fit each net starts near the previous
  /// one; the returned result is that of predict() without this warm start.
  /// @param presence  assumption about each candidate (candidates)
  /// @param start     initial s, clamped to the bounds [1] (candidates)
  /// @param price     penalty on the unknowns, or empty [1] (candidates)
  BandFit fit(const Presences& presence, const Eigen::VectorXd& start,
              const Eigen::VectorXd& price = {});

  /// Initial stiffnesses: all bands at the s of their smallest or largest EA (candidates).
  [[nodiscard]] Eigen::VectorXd min_stiffness() const { return stiffness(&CandidateBand::min_EA); }
  [[nodiscard]] Eigen::VectorXd max_stiffness() const { return stiffness(&CandidateBand::max_EA); }

  /// Adds a record.
  void add(const TendonRecord& record);

  [[nodiscard]] const CandidateNet& candidate() const { return forward_.candidate(); }
  /// Returns the typical EA [N] (candidates).
  [[nodiscard]] const Eigen::VectorXd& typical_EA() const { return typical_EA_; }
  /// Returns the number of measured values.
  [[nodiscard]] Eigen::Index rows() const { return measured_.size(); }
  /// Returns the number of equilibria solved so far.
  [[nodiscard]] long solves() const { return forward_.solves(); }

 private:
  /// Returns one bound of each candidate's EA over its typical EA [1] (candidates).
  [[nodiscard]] Eigen::VectorXd stiffness(double CandidateBand::*EA) const;

  enum class WarmStart { kKept, kNone };  // start of each net: the previous equilibrium, or none
  struct Followed {
    BandFit fit;
    bool strayed = false;  // true: a net with two equilibria is not in the one that predict() finds
  };
  Followed follow(BoundedFit problem, const Eigen::VectorXd& x0, WarmStart warm_start);
  [[nodiscard]] FitResiduals residuals(const NetPrediction& forecast) const;
  NetForwardModel forward_;
  BoundedFitOptions options_;
  Eigen::VectorXd typical_EA_;     // typical EA [N] (candidates)
  Eigen::VectorXd measured_, sd_;  // measured values and their noise, stacked (rows)
};

/// Returns the presences of a topology: kYes for its bands, kNo for others.
[[nodiscard]] Presences topology_presences(const std::vector<bool>& bands);

}  // namespace thenar
