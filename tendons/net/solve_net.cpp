#include "tendons/net/solve_net.h"

#include <algorithm>

#include "base/error.h"
#include "tendons/net/net_descent.h"

namespace thenar {

namespace {

/// Finds passive bands loaded beyond their limits in a balanced net.
void find_overstrained(const Net& net, NetEquilibrium& rest) {
  constexpr double kNoLoad = 0.1;  // tension below which its ratio to the pull is meaningless [N]
  if (rest.status != NetStatus::kBalanced) return;
  double pull = 0;
  for (std::size_t b = 0; b < net.bands.size(); ++b)
    if (net.bands[b].muscle >= 0) pull += rest.tension[b];
  for (std::size_t b = 0; b < net.bands.size(); ++b) {
    const NetBand& band = net.bands[b];
    const auto i = static_cast<Eigen::Index>(b);
    if (band.muscle >= 0 || rest.tension[i] <= 0) continue;
    const bool loaded = rest.tension[i] > std::max(net.max_load * pull, kNoLoad);
    if (loaded || rest.length[i] > (1 + band.max_strain) * band.slack)
      rest.overstrained.push_back(static_cast<int>(b));
  }
  if (!rest.overstrained.empty()) rest.status = NetStatus::kOverstrained;
}

}  // namespace

struct NetSolver::Workspace {
  Workspace(const Net& net, const NetSolverOptions& options) : descent(net, options) {}
  internal::NetDescent descent;
};

NetSolver::NetSolver(const Net& net, const NetSolverOptions& options)
    : work_(std::make_unique<Workspace>(net, options)) {}
NetSolver::~NetSolver() = default;
NetSolver::NetSolver(NetSolver&&) noexcept = default;
NetSolver& NetSolver::operator=(NetSolver&&) noexcept = default;

NetEquilibrium NetSolver::solve(const TreeState<double>& state, const NetDrive& drive,
                                const Eigen::Matrix3Xd* start) {
  const Net& net = work_->descent.plan().net;
  check_drive(net, drive);
  check_state(net, state);
  check_start(net, start);
  NetEquilibrium rest = work_->descent.run(state, drive, start);
  find_overstrained(net, rest);
  return rest;
}

}  // namespace thenar
