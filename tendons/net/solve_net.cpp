#include "tendons/net/solve_net.h"

#include "base/error.h"
#include "tendons/net/check_net.h"
#include "tendons/net/net_descent.h"

namespace thenar {

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
  const auto nodes = static_cast<Eigen::Index>(net.nodes.size());
  require(!start || start->cols() == nodes, "net {} has {} nodes, start has {}", net.name, nodes,
          start ? start->cols() : 0);
  require(!start || start->allFinite(), "net {}: start is not finite", net.name);
  return work_->descent.run(state, drive, start);
}

}  // namespace thenar
