#pragma once

/// Newton's method for the energy minimum of a net with nodes outside of bones. Derivation:
/// docs/theory/extensor_net.md

#include <optional>
#include <vector>

#include "solvers/block_matrix.h"
#include "tendons/net/net_energy.h"
#include "tendons/net/node_contact.h"
#include "tendons/net/solve_net.h"

namespace thenar::internal {

/// Solver with the state and workspace of one solve.
class NetDescent {
 public:
  NetDescent(const Net& net, const NetSolverOptions& options);
  NetDescent(const NetDescent&) = delete;  // the factor points at the plan
  NetDescent& operator=(const NetDescent&) = delete;

  [[nodiscard]] const NetPlan& plan() const { return plan_; }

  /// Places the nodes, moves those inside bones to the surface, and descends to equilibrium.
  [[nodiscard]] NetEquilibrium run(const TreeState<double>& state, const NetDrive& drive,
                                   const Eigen::Matrix3Xd* start);

 private:
  static constexpr double kMaxStep = 0.02;  // largest move of a node in one step [m]
  // Distance within which a force error above the tolerance is attributed to stiffness [m]
  static constexpr double kStiffnessDistance = 1e-4;

  /// Node positions with energy and contacts there.
  struct Place {
    explicit Place(const NetPlan& plan)
        : E(plan), x(plan.net.nodes.size()), contact(plan.pattern.size()) {}
    NetEnergy E;
    std::vector<Eigen::Vector3d> x;    // nodes, world [m]
    std::vector<NodeContact> contact;  // (rows)
  };

  [[nodiscard]] int rows() const { return plan_.pattern.size(); }

  // Placement of the nodes, and descent to equilibrium.
  void place(const TreeState<double>& state, const Eigen::Matrix3Xd* start);
  void project_start(int k);
  void measure(Place& at);
  NetStatus descend(int patience);
  NetStatus settle(const TreeState<double>& state, const NetDrive& drive,
                   const Eigen::Matrix3Xd* start, int patience);
  NetStatus load_continuation(const TreeState<double>& state, const NetDrive& drive);

  // Contact forces on nodes, and the residual.
  [[nodiscard]] double wrap_slop(int k, int surface) const;
  [[nodiscard]] double normal_rounding(int k, int surface, const Eigen::Vector3d& normal) const;
  void balance();

  // Direction of descent.
  void reduce();
  double solve_step();
  bool direction();
  bool add_secant_stiffness();

  // Length of the step.
  void lift(int k, Eigen::Vector3d& there) const;
  std::optional<double> try_step(double part);
  [[nodiscard]] double step_to_exit() const;
  [[nodiscard]] double rounding() const;
  bool line_search();

  // Nodes that a muscle pulls into its exit.
  bool collapse_to_exit(int band);
  bool release_from_exit();
  bool update_multipliers();

  // A minimum or a saddle.
  bool is_minimum();
  bool leave_saddle();
  bool leave_saddle_early();

  // The result.
  [[nodiscard]] std::vector<int> far_side_bands() const;
  void report_band(int b, NetEquilibrium& out) const;
  [[nodiscard]] std::vector<int> undetermined(const NetEquilibrium& at) const;
  NetEquilibrium report(NetStatus status) const;

  NetPlan plan_;
  NetSolverOptions options_;
  NetScene scene_;
  Place here_, next_;  // last accepted state, and trial state
  BlockMatrix reduced_;
  BlockFactor factor_;
  std::vector<Eigen::Vector3d> step_;  // Newton step (rows) [m]
  std::vector<int> pushed_out_;        // nodes that started inside a bone
  std::vector<int> collapse_counts_;   // number of times that each band collapsed its node
  double residual_ = 0;                // largest out-of-balance force [N]
  double radius_ = 0;                  // trust radius of the step [m]
  double largest_move_ = 0;            // largest move of a node in the last step [m]
  bool definite_ = false;              // true: the stiffness was positive definite at the last step
  int iterations_ = 0;
  int evaluations_ = 0;  // evaluations of the energy, in all descents of a run
};

}  // namespace thenar::internal
