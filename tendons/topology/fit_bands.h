#pragma once

/// Fit of stiffnesses: those that a topology needs to explain what was measured.

#include <vector>

#include <Eigen/Core>

#include "solvers/bounded_least_squares.h"
#include "tendons/topology/net_forward_model.h"

namespace thenar {

/// Assumption about one candidate in a fit.
enum class Presence {
  kNo,     // EA = 0
  kYes,    // least <= EA <= most
  kEither  // 0 < EA <= most, from kGhost of the typical EA on
};
using Presences = std::vector<Presence>;

/// Part of the typical EA below which a band's load is no longer shared by ratios of stiffness [1].
inline constexpr double kSoft = 0.05;

/// Part of the typical EA that a band keeps where it may exist but vanishes, so that the net's
/// slope by it stays defined; it then carries this part of its share [1].
inline constexpr double kGhost = 0.01;

/// Result of a fit: the best stiffnesses under one set of assumptions.
struct [[nodiscard]] BandFit {
  bool holds = false;      // the net carries all loads; otherwise nothing else is meant
  bool converged = false;  // to the tolerance of the fit
  double residual = 0;     // of its nets, as in NetPrediction [N]
  Eigen::VectorXd s;       // EA / typical EA of each candidate [1] (candidates)
  double misfit = 0;       // chi^2 = sum ((predicted - measured) / sd)^2 [1]
  Eigen::VectorXd r;       // the residuals in units of sd (rows)
  Eigen::MatrixXd J;       // their slope by s (rows, candidates)
};

/// Fits one set of records again and again, under changing assumptions.
class BandFitter {
 public:
  /// @throws InputError naming the candidate or record that is wrong.
  BandFitter(const CandidateNet& candidate, const std::vector<TendonRecord>& records,
             const BoundedFitOptions& options = {});

  /// @param presence  of each candidate (candidates)
  /// Unknowns are  x = log(1 + s / kSoft): a net feels ratios of stiffness, but zero is in reach.
  /// Their price is so the log-sum penalty that re-weighted L1 majorises [Candes2008].
  /// @param start     s to start from, moved between the bounds [1] (candidates)
  /// @param price     of the unknowns, or empty [1] (candidates)
  /// On the way each net starts near the one before it; what is stated of the last is as predict()
  /// gives it without.
  BandFit fit(const Presences& presence, const Eigen::VectorXd& start,
              const Eigen::VectorXd& price = {});

  /// A stiffness to start from: all bands at their least, typical or most s (candidates).
  [[nodiscard]] Eigen::VectorXd least() const;
  [[nodiscard]] Eigen::VectorXd most() const;

  void add(const TendonRecord& record);

  [[nodiscard]] const CandidateNet& candidate() const { return forward_.candidate(); }
  [[nodiscard]] const Eigen::VectorXd& typical() const { return typical_; }
  [[nodiscard]] Eigen::Index rows() const { return measured_.size(); }
  [[nodiscard]] long solves() const { return forward_.solves(); }

 private:
  enum class Memory { kKept, kNone };  // of where nets of the same fit came to rest
  struct Followed {
    BandFit fit;
    bool strayed = false;  // a net of two places of rest is not where predict() finds it
  };
  Followed follow(BoundedFit problem, const Eigen::VectorXd& x0, Memory memory);
  [[nodiscard]] FitResiduals residuals(const NetPrediction& forecast) const;
  NetForwardModel forward_;
  BoundedFitOptions options_;
  Eigen::VectorXd typical_;        // EA [N] (candidates)
  Eigen::VectorXd measured_, sd_;  // stacked (rows)
};

/// The topology's presences: kYes where a band is.
[[nodiscard]] Presences presences_of(const std::vector<bool>& bands);

}  // namespace thenar
