#pragma once

/// Forward model of a net: its readings in a list of tests, for given stiffnesses.

#include <vector>

#include <Eigen/Core>

#include "solvers/bounded_least_squares.h"
#include "tendons/net/solve_net.h"
#include "tendons/topology/candidate_net.h"

namespace thenar {

/// Residual above which a net that the solver could not balance is rejected [N]. Below it a net
/// counts as balanced and differentiable: it is far below what a load cell measures.
/// NetPrediction::residual holds the actual value.
inline constexpr double kMaxSettledResidual = 1e-4;

/// Returns whether a net in equilibrium holds every muscle that pulls it: it is balanced, at least
/// to kMaxSettledResidual, and no muscle has drawn its node into its exit.
[[nodiscard]] bool carries_loads(const Net& net, const NetEquilibrium& rest);

/// Readings of all tests, stacked.
struct [[nodiscard]] NetPrediction {
  bool holds = false;     // true: every test was balanced; false: other members are meaningless
  Eigen::VectorXd value;  // readings (rows)
  Eigen::MatrixXd by_EA;  // derivative by each candidate's EA (rows, candidates); if requested
  double residual = 0;    // largest out-of-balance force of a node in any test [N]
  std::vector<Eigen::Matrix3Xd> rest;  // equilibrium nodes of each test, world [m] (3, nodes)
};

/// Predicts one list of tests for many stiffnesses. Each test starts from the equilibrium of the
/// net of all candidates, so the prediction depends on EA alone, also where a net has two
/// equilibria. On request it starts from another prediction, which takes fewer steps.
class NetForwardModel {
 public:
  /// Solves the net of all candidates in each test.
  /// @throws InputError naming what is wrong in the candidates or in a test, or a test in which
  /// even the net of all candidates has no equilibrium.
  NetForwardModel(CandidateNet candidate, const std::vector<TendonTest>& tests);

  /// Predicts all readings.
  /// @param EA    stiffness of each candidate; 0: it does not exist, and its column of derivatives
  /// is zero [N] (candidates)
  /// @param near  prediction that holds, whose equilibria are the starts; null: the net of all
  ///         candidates
  NetPrediction predict(const Eigen::VectorXd& EA, Sensitivities slopes,
                        const NetPrediction* near = nullptr);

  void add(const TendonTest& test);
  [[nodiscard]] const CandidateNet& candidate() const { return candidate_; }
  [[nodiscard]] long solves() const { return solves_; }

 private:
  struct Posed {
    TendonTest test;
    TreeState<double> state;
    Eigen::Matrix3Xd x;  // initial nodes, world [m] (3, nodes)
  };
  /// Computes the derivative of torque by EA from Maxwell's reciprocity, with E the energy of the
  /// net in equilibrium and phi that of one band:
  ///   d tau / d EA = -d2 E / dq dEA = -d (phi / EA) / dq = -(T / EA) dL / dq,
  /// so one linear solve per joint replaces one per EA.
  [[nodiscard]] Eigen::MatrixXd reading_by_EA(const Net& net, const Posed& posed,
                                              const NetEquilibrium& rest,
                                              const Eigen::VectorXd& EA) const;

  CandidateNet candidate_;
  std::vector<Posed> tests_;
  long solves_ = 0;
};

}  // namespace thenar
