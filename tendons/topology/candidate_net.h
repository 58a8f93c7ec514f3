#pragma once

/// A net whose bands are not known to exist, and measurements on it.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "hand/chain.h"
#include "tendons/net/net.h"

namespace thenar {

/// A band that may exist. If it does, its EA lies between two anatomical bounds; if not, it is 0.
/// The gap is what lets data deny a band: one of no stiffness at all could never be denied.
struct CandidateBand {
  int band;      // of the net's; passive
  double least;  // EA of the weakest that would be called a band, > 0 [N]
  double most;   // EA of the stiffest believable [N]
};

/// All bands that may exist, on the bones that carry them. The net's own EA is the typical one.
struct CandidateNet {
  Net net;
  Tree<double> tree;
  int coordinates = 0;
  std::vector<CandidateBand> candidates;
};

/// One posture and loading. What is measured is  map (tau_net + tau_own).
struct TendonTest {
  std::string name;
  Eigen::VectorXd q;        // posture [rad] (coordinates)
  Eigen::VectorXd tension;  // of the net's muscles [N] (muscles)
  Eigen::VectorXd tau_own;  // torque of all that is not in the net [N m] (coordinates); empty: none
  Eigen::Matrix3Xd start;   // nodes to start from, world [m] (3, nodes); empty: each with its link
  Eigen::MatrixXd map;      // tip force per joint torque [1/m] (rows, coordinates), or the identity
};

/// Result of a test.
struct TendonRecord {
  TendonTest test;
  Eigen::VectorXd measured;  // [N] if a tip force, [N m] if a torque (rows)
  Eigen::VectorXd sd;        // of its noise, same unit (rows)
};

/// Every passive band of the net as a candidate, between `least` and `most` times its own EA.
[[nodiscard]] std::vector<CandidateBand> passive_candidates(const Net& net, double least = 0.25,
                                                            double most = 4);

/// The net with these stiffnesses: bands of EA 0 are left out, others keep their order.
/// @param EA  of each candidate [N] (candidates)
[[nodiscard]] Net net_of(const CandidateNet& candidate, const Eigen::VectorXd& EA);

/// Names of the candidates.
[[nodiscard]] std::vector<std::string> candidate_names(const CandidateNet& candidate);

/// @throws InputError naming the candidate or the test that is wrong.
void check_candidates(const CandidateNet& candidate);
void check_test(const CandidateNet& candidate, const TendonTest& test);
void check_record(const CandidateNet& candidate, const TendonRecord& record);

}  // namespace thenar
