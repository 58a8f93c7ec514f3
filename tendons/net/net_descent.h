#pragma once

/// Newton's method on the energy of a net, outside of bones. Derivation:
/// docs/theory/extensor_net.md

#include <vector>

#include "tendons/net/block_matrix.h"
#include "tendons/net/net_energy.h"
#include "tendons/net/node_contact.h"
#include "tendons/net/solve_net.h"

namespace thenar::internal {

/// State and workspace of one solve.
class NetDescent {
 public:
  NetDescent(const Net& net, const NetSolverOptions& options);
  NetDescent(const NetDescent&) = delete;  // the factor points at the plan
  NetDescent& operator=(const NetDescent&) = delete;

  const NetPlan& plan() const { return plan_; }

  /// Places the nodes, pushes those inside bones out, and goes down to rest.
  [[nodiscard]] NetEquilibrium run(const TreeState<double>& state, const NetDrive& drive,
                                   const Eigen::Matrix3Xd* start);

 private:
  int rows() const { return plan_.pattern.size(); }
  void place(const TreeState<double>& state, const Eigen::Matrix3Xd* start);
  void settle_start(int k);
  double clasp(int k, int surface) const;
  double stray(int k, int surface, const Eigen::Vector3d& normal) const;
  void lift(int k, Eigen::Vector3d& there) const;
  void balance();
  void reduce();
  double solve_step();
  bool direction();
  bool try_step(double part, double& slope);
  [[nodiscard]] double rounding() const;
  bool look_ahead();
  bool search();
  double part_at_exit() const;
  bool draw_in(int band);
  bool let_out();
  bool grip();
  bool steady();
  bool escape();
  bool leave_ridge();
  void accept();
  NetStatus descend(int patience);
  NetStatus settle(const TreeState<double>& state, const NetDrive& drive,
                   const Eigen::Matrix3Xd* start, int patience);
  NetStatus ease(const TreeState<double>& state, const NetDrive& drive);
  std::vector<int> wound() const;
  NetEquilibrium report(NetStatus status) const;

  NetPlan plan_;
  NetSolverOptions options_;
  NetScene scene_;
  NetEnergy at_, next_;
  BlockMatrix reduced_;
  BlockFactor factor_;
  std::vector<Eigen::Vector3d> x_, x_next_, step_;
  std::vector<NodeContact> contact_, contact_next_;
  std::vector<int> pushed_out_;
  std::vector<int> draws_;  // how often each band drew its node in
  double residual_ = 0;     // largest out-of-balance force [N]
  double radius_ = 0;       // within which steps are good [m]
  double longest_ = 0;      // move of a node in the last step [m]
  bool definite_ = false;   // stiffness at the last step
  int iterations_ = 0;
};

}  // namespace thenar::internal
