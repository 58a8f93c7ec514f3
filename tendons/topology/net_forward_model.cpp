#include "tendons/topology/net_forward_model.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "tendons/net/net_derivatives.h"
#include "tendons/net/net_statics.h"

namespace thenar {
namespace {

// Band length below which a muscle has drawn its node in [m]
constexpr double kCollapsedLength = 1e-3;

/// Returns the candidates that exist, each with its index among the bands of net_with_stiffness().
std::vector<std::pair<int, int>> places_of(const CandidateNet& candidate,
                                           const Eigen::VectorXd& EA) {
  // Find the candidate of each band.
  std::vector<int> of_band(candidate.net.bands.size(), -1);
  for (std::size_t c = 0; c < candidate.candidates.size(); ++c)
    of_band[candidate.candidates[c].band] = static_cast<int>(c);
  std::vector<std::pair<int, int>> places;
  // Shift the indices where bands are left out.
  int place = 0;
  for (int c : of_band) {
    if (c >= 0 && EA(c) <= 0) continue;
    if (c >= 0) places.emplace_back(c, place);
    ++place;
  }
  return places;
}

}  // namespace

bool carries_loads(const Net& net, const NetEquilibrium& rest) {
  // Check that the net is balanced, at least nearly.
  const bool still = rest.status == NetStatus::kBalanced ||
                     rest.status == NetStatus::kOverstrained ||
                     (rest.status == NetStatus::kStalled && rest.residual < kMaxSettledResidual);
  if (!still || !rest.x.allFinite()) return false;
  // Check that no muscle has collapsed its node.
  for (std::size_t b = 0; b < net.bands.size(); ++b)
    if (net.bands[b].muscle >= 0 && rest.length(static_cast<Eigen::Index>(b)) < kCollapsedLength)
      return false;
  return true;
}

NetForwardModel::NetForwardModel(CandidateNet candidate, const std::vector<TendonTest>& tests)
    : candidate_(std::move(candidate)) {
  check_candidates(candidate_);
  for (const TendonTest& test : tests) add(test);
}

void NetForwardModel::add(const TendonTest& test) {
  check_test(candidate_, test);
  // Solve the net of all bands, the start of every prediction.
  Posed posed{test, pose_tree(candidate_.tree, test.q), {}};
  const NetEquilibrium rest =
      NetSolver(candidate_.net)
          .solve(posed.state, {test.tension, {}}, test.start.cols() ? &test.start : nullptr);
  require(carries_loads(candidate_.net, rest),
          "test {}: net {} with all its bands does not come to rest", test.name,
          candidate_.net.name);
  posed.x = rest.x;
  tests_.push_back(std::move(posed));
}

Eigen::MatrixXd NetForwardModel::reading_by_EA(const Net& net, const Posed& posed,
                                               const NetEquilibrium& rest,
                                               const Eigen::VectorXd& EA) const {
  Eigen::MatrixXd tau = Eigen::MatrixXd::Zero(candidate_.coordinates, EA.size());
  // Compute the derivatives of band lengths by the joints.
  const Eigen::MatrixXd turn =
      length_by_posture(net, candidate_.tree, posed.state, {posed.test.tension, {}}, rest,
                        {static_cast<int>(posed.test.q.size()), kMaxSettledResidual});
  // Convert them by reciprocity to the torque's derivative by each EA.
  for (const auto& [candidate, band] : places_of(candidate_, EA))
    tau.col(candidate) = -rest.tension(band) / net.bands[band].EA * turn.row(band).transpose();
  return posed.test.map * tau;
}

NetPrediction NetForwardModel::predict(const Eigen::VectorXd& EA, Sensitivities slopes,
                                       const NetPrediction* near) {
  require(EA.size() == static_cast<Eigen::Index>(candidate_.candidates.size()) && EA.allFinite() &&
              (EA.array() >= 0).all(),
          "wanted {} stiffnesses >= 0, got {}", candidate_.candidates.size(), EA.size());
  // Allocate all readings.
  Eigen::Index rows = 0, row = 0;
  for (const Posed& posed : tests_) rows += posed.test.map.rows();
  NetPrediction out;
  out.value.resize(rows);
  if (slopes == Sensitivities::kWith) out.by_EA.resize(rows, EA.size());
  const Net net = net_with_stiffness(candidate_, EA);
  NetSolver solver(net);
  // Solve each test, from the given prediction if there is one.
  for (const Posed& posed : tests_) {
    const std::size_t place = out.rest.size();
    const bool warm = near != nullptr && near->holds && place < near->rest.size();
    const NetEquilibrium rest =
        solver.solve(posed.state, {posed.test.tension, {}}, warm ? &near->rest[place] : &posed.x);
    ++solves_;
    if (!carries_loads(net, rest)) return out;
    out.residual = std::max(out.residual, rest.residual);
    // Map the torque of the net and of everything else to the reading.
    const Eigen::Index n = posed.test.map.rows();
    Eigen::VectorXd tau =
        net_torque(net, candidate_.tree, posed.state, rest, candidate_.coordinates);
    if (posed.test.tau_own.size()) tau += posed.test.tau_own;
    out.value.segment(row, n) = posed.test.map * tau;
    // Compute the derivatives by EA.
    if (slopes == Sensitivities::kWith)
      out.by_EA.middleRows(row, n) = reading_by_EA(net, posed, rest, EA);
    row += n;
    out.rest.push_back(rest.x);
  }
  out.holds = out.value.allFinite() && out.by_EA.allFinite();
  return out;
}

}  // namespace thenar
