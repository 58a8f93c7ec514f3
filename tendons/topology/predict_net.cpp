#include "tendons/topology/predict_net.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "tendons/net/net_statics.h"

namespace thenar {
namespace {

constexpr double kDrawnIn = 1e-3;  // a muscle shorter than this has drawn its node in [m]

/// Whether every muscle is held up by the net.
bool holds(const Net& net, const NetEquilibrium& rest) {
  const bool still = rest.status == NetStatus::kBalanced ||
                     (rest.status == NetStatus::kStalled && rest.residual < kSettledNet);
  if (!still || !rest.x.allFinite()) return false;
  for (std::size_t b = 0; b < net.bands.size(); ++b)
    if (net.bands[b].muscle >= 0 && rest.length(static_cast<Eigen::Index>(b)) < kDrawnIn)
      return false;
  return true;
}

/// Where a candidate that exists stands in net_of().
int place_of(const CandidateNet& candidate, const Eigen::VectorXd& EA, std::size_t c) {
  int place = candidate.candidates[c].band;
  for (std::size_t d = 0; d < candidate.candidates.size(); ++d)
    if (EA(d) <= 0 && candidate.candidates[d].band < candidate.candidates[c].band) --place;
  return place;
}

}  // namespace

NetForward::NetForward(CandidateNet candidate, const std::vector<TendonTest>& tests)
    : candidate_(std::move(candidate)) {
  check_candidates(candidate_);
  for (const TendonTest& test : tests) add(test);
}

void NetForward::add(const TendonTest& test) {
  check_test(candidate_, test);
  Posed posed{test, pose_tree(candidate_.tree, test.q), {}};
  const NetEquilibrium rest = NetSolver(candidate_.net).solve(posed.state, {test.tension, {}});
  require(holds(candidate_.net, rest), "test {}: net {} with all its bands does not come to rest",
          test.name, candidate_.net.name);
  posed.x = rest.x;
  tests_.push_back(std::move(posed));
}

Eigen::MatrixXd NetForward::slope_of(const Net& net, const Posed& posed, const NetEquilibrium& rest,
                                     const Eigen::VectorXd& EA_all) const {
  const Eigen::VectorXd tau =
      net_torque(net, candidate_.tree, posed.state, rest, candidate_.coordinates);
  Eigen::MatrixXd slope(posed.test.map.rows(), candidate_.candidates.size());
  Net moved = net;
  for (std::size_t c = 0; c < candidate_.candidates.size(); ++c) {
    if (EA_all(c) <= 0) {
      slope.col(c).setZero();
      continue;
    }
    NetBand& band = moved.bands[place_of(candidate_, EA_all, c)];
    const double EA = band.EA, step = 1e-5 * EA;
    band.EA = EA + step;
    const NetEquilibrium next =
        NetSolver(moved).solve(posed.state, {posed.test.tension, {}}, &rest.x);
    band.EA = EA;
    slope.col(c) =
        posed.test.map *
        (net_torque(moved, candidate_.tree, posed.state, next, candidate_.coordinates) - tau) /
        step;
  }
  return slope;
}

NetForecast NetForward::predict(const Eigen::VectorXd& EA, Slopes slopes) {
  require(EA.size() == static_cast<Eigen::Index>(candidate_.candidates.size()) && EA.allFinite() &&
              (EA.array() >= 0).all(),
          "wanted {} stiffnesses >= 0, got {}", candidate_.candidates.size(), EA.size());
  Eigen::Index rows = 0, row = 0;
  for (const Posed& posed : tests_) rows += posed.test.map.rows();
  NetForecast out;
  out.value.resize(rows);
  if (slopes == Slopes::kWith) out.by_EA.resize(rows, EA.size());
  const Net net = net_of(candidate_, EA);
  NetSolver solver(net);
  for (const Posed& posed : tests_) {
    const NetEquilibrium rest = solver.solve(posed.state, {posed.test.tension, {}}, &posed.x);
    ++solves_;
    if (!holds(net, rest)) return out;
    const Eigen::Index n = posed.test.map.rows();
    Eigen::VectorXd tau =
        net_torque(net, candidate_.tree, posed.state, rest, candidate_.coordinates);
    if (posed.test.tau_own.size()) tau += posed.test.tau_own;
    out.value.segment(row, n) = posed.test.map * tau;
    if (slopes == Slopes::kWith) out.by_EA.middleRows(row, n) = slope_of(net, posed, rest, EA);
    row += n;
  }
  out.holds = true;
  return out;
}

}  // namespace thenar
