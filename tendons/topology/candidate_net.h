#pragma once

/// Net of candidate bands, which may or may not exist, and measurements on it.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "hand/chain.h"
#include "tendons/net/net.h"

namespace thenar {

/// Candidate band. If it exists, its EA lies between two anatomical bounds; if not, it is 0. The
/// gap between 0 and the lower bound lets data reject a band: one of zero stiffness could never be
/// rejected.
struct CandidateBand {
  int band = 0;       // index of a passive band in the net
  double min_EA = 0;  // smallest EA that counts as a band, > 0 [N]
  double max_EA = 0;  // largest plausible EA [N]
};

/// Net of all candidate bands, on the bones that carry them. The net's own EA are typical values.
struct CandidateNet {
  Net net;
  Tree<double> tree;
  int coordinates = 0;
  std::vector<CandidateBand> candidates;
};

/// Test: one posture and loading. It measures  map (tau_net + tau_own).
struct TendonTest {
  std::string name;
  Eigen::VectorXd q;        // posture [rad] (coordinates)
  Eigen::VectorXd tension;  // tensions of the net's muscles [N] (muscles)
  Eigen::VectorXd tau_own;  // torque of everything outside the net [N m] (coordinates); empty: none
  Eigen::Matrix3Xd start;   // initial nodes, world [m] (3, nodes); empty: each with its link
  Eigen::MatrixXd map;      // tip force per joint torque [1/m] (rows, coordinates), or the identity
};

/// Result of a test.
struct TendonRecord {
  TendonTest test;
  Eigen::VectorXd measured;  // measured value, [N] if a tip force, [N m] if a torque (rows)
  Eigen::VectorXd sd;        // standard deviation of its noise, same unit (rows)
};

/// Returns every passive band of the net as a candidate, between `least` and `most` times its own
/// EA.
[[nodiscard]] std::vector<CandidateBand> passive_candidates(const Net& net, double least = 0.25,
                                                            double most = 4);

/// Builds the net with these stiffnesses: bands of EA 0 are left out, others keep their order.
/// @param EA  stiffness of each candidate [N] (candidates)
[[nodiscard]] Net net_with_stiffness(const CandidateNet& candidate, const Eigen::VectorXd& EA);

/// Returns the names of the candidates.
[[nodiscard]] std::vector<std::string> candidate_names(const CandidateNet& candidate);

/// Checks the candidates. @throws InputError naming the candidate that is wrong.
void check_candidates(const CandidateNet& candidate);

/// Checks a test, or a record with its test. @throws InputError naming the test that is wrong.
void check_test(const CandidateNet& candidate, const TendonTest& test);
void check_record(const CandidateNet& candidate, const TendonRecord& record);

}  // namespace thenar
