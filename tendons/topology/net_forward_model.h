#pragma once

/// Forward model of a net: its readings in a list of tests, for given stiffnesses.

#include <vector>

#include <Eigen/Core>

#include "solvers/bounded_least_squares.h"
#include "tendons/net/solve_net.h"
#include "tendons/topology/candidate_net.h"

namespace thenar {

/// Residual above which a net that the solver could not balance is left out. Below it a net counts
/// as balanced, its derivatives as well: far below what a load cell measures.
/// NetPrediction::residual states it [N].
inline constexpr double kSettledNet = 1e-4;

/// Returns whether a net at rest holds every muscle that pulls it: it is balanced, at least to
/// kSettledNet, and no muscle has drawn its knot into its exit.
[[nodiscard]] bool carries_loads(const Net& net, const NetEquilibrium& rest);

/// Readings of all tests, one below the other.
struct [[nodiscard]] NetPrediction {
  bool holds = false;     // every test was balanced; otherwise nothing else is meant
  Eigen::VectorXd value;  // (rows)
  Eigen::MatrixXd by_EA;  // slope by each candidate's EA (rows, candidates); if asked for
  double residual = 0;    // largest out-of-balance force of a node in any test [N]
  std::vector<Eigen::Matrix3Xd> rest;  // where the nodes of each test rest, world [m] (3, nodes)
};

/// Predicts one list of tests again and again. Each test starts from the equilibrium of the net of
/// all candidates, so the prediction depends on nothing but EA, also where a net has two
/// equilibria; or, if asked, near another prediction, which takes fewer steps.
class NetForwardModel {
 public:
  /// @throws InputError naming what is wrong in the candidates or in a test, or a test in which
  /// even the net of all candidates does not come to rest.
  NetForwardModel(CandidateNet candidate, const std::vector<TendonTest>& tests);

  /// @param EA  of each candidate; 0: it does not exist, and its slope is not asked for (column of
  ///            zeros) [N] (candidates)
  /// @param near  forecast that holds, whose places to start from; null: the net of all candidates
  NetPrediction predict(const Eigen::VectorXd& EA, Sensitivities slopes,
                        const NetPrediction* near = nullptr);

  void add(const TendonTest& test);
  [[nodiscard]] const CandidateNet& candidate() const { return candidate_; }
  [[nodiscard]] long solves() const { return solves_; }

 private:
  struct Posed {
    TendonTest test;
    TreeState<double> state;
    Eigen::Matrix3Xd x;  // where the nodes start, world [m] (3, nodes)
  };
  /// Computes slopes of torque by EA from Maxwell's reciprocity, with E the energy of the net at
  /// rest and phi that of one band:
  ///   d tau / d EA = -d2 E / dq dEA = -d (phi / EA) / dq = -(T / EA) dL / dq,
  /// so one linear solve a joint stands for one by every EA.
  [[nodiscard]] Eigen::MatrixXd slope_of(const Net& net, const Posed& posed,
                                         const NetEquilibrium& rest,
                                         const Eigen::VectorXd& EA) const;

  CandidateNet candidate_;
  std::vector<Posed> tests_;
  long solves_ = 0;
};

}  // namespace thenar
