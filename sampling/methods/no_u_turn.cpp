#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "sampling/methods/hamiltonian_trajectory.h"

namespace thenar::internal {
namespace {

/// Momenta of consecutive points, in the order in which they were reached.
struct TreeSpan {
  Eigen::VectorXd begin, end;  // momenta of the first and the last point (n)
  Eigen::VectorXd sum;         // sum of the momenta (n)
  long points = 0;             // number of points

  void assign(const Eigen::VectorXd& r) {
    begin = end = sum = r;
    points = 1;
  }
  /// Appends the span that follows; `next` is invalid afterwards.
  void append(TreeSpan& next) {
    end.swap(next.end);
    sum += next.sum;
    points += next.points;
  }
};

/// Returns whether a trajectory makes a U-turn in the generalised sense:  rho . v <= 0  at an end,
/// with rho the sum of momenta and v the velocity, which equals the momentum in whitened units.
/// Checks a and b together, and each with the adjacent point of the other, because a trajectory may
/// turn between two halves that do not.
bool turns(const TreeSpan& a, const TreeSpan& b) {
  const auto straight = [](const auto& rho, const auto& first, const auto& last) {
    return rho.dot(first) > 0 && rho.dot(last) > 0;
  };
  if (!straight(a.sum + b.sum, a.begin, b.end)) return true;
  if (a.points == 1) return false;  // the other checks are the same
  return !straight(a.sum + b.begin, a.begin, b.begin) || !straight(a.end + b.sum, a.end, b.end);
}

double log_add_exp(double log_a, double log_b) {
  const double larger = std::max(log_a, log_b), smaller = std::min(log_a, log_b);
  return larger + std::log1p(std::exp(smaller - larger));
}

/// No-U-turn trajectories.
class NoUTurn : public HamiltonianTrajectory {
 public:
  NoUTurn(int n, int max_depth) : max_depth_(max_depth) {
    // Allocate the tree and the subtrees of one doubling.
    const TreeSpan none{Eigen::VectorXd(n), Eigen::VectorXd(n), Eigen::VectorXd(n), 0};
    tree_ = none;
    halves_.assign(static_cast<std::size_t>(max_depth) + 1, none);
  }

  void start(const PhasePoint& from, double step, RandomStream& random) override {
    step_ = step;
    // Start with a tree of one point.
    ends_[0] = ends_[1] = from;
    tree_.assign(from.r);
    log_weight_ = acceptance_sum_ = 0;
    depth_ = point_count_ = 0;
    start_doubling(random);
  }

  PhasePoint& moving_point() override { return ends_[forward_]; }
  [[nodiscard]] double leapfrog_length() const override { return forward_ == 1 ? step_ : -step_; }

  PointVerdict assess_point(double energy_error, RandomStream& random) override {
    ++point_count_;
    // A divergent trajectory ends; the point selected so far is the draw.
    if (!(energy_error <= kMaxEnergyError)) return {false, false, true};
    acceptance_sum_ += std::min(1.0, std::exp(-energy_error));
    // Sample the candidate among the new points, and check for U-turns.
    PointVerdict verdict;
    verdict.is_candidate = weigh(-energy_error, random);
    verdict.is_complete = !push();
    if (verdict.is_complete || halves_[0].points < tree_.points) return verdict;
    // If the new half is complete, select its candidate by weight, and extend the tree.
    verdict.selects_candidate = std::log(random.uniform()) < new_log_weight_ - log_weight_;
    verdict.is_complete = !join() || depth_ == max_depth_;
    if (!verdict.is_complete) start_doubling(random);
    return verdict;
  }

  [[nodiscard]] double acceptance() const override {
    return acceptance_sum_ / static_cast<double>(point_count_);
  }
  [[nodiscard]] int depth() const override { return depth_; }

 private:
  void start_doubling(RandomStream& random) {
    const int forward = random.uniform() < 0.5 ? 1 : 0;
    // Orient the tree towards the growing end.
    if (depth_ > 0 && forward != forward_) tree_.begin.swap(tree_.end);
    forward_ = forward;
    pending_ = 0;
    new_log_weight_ = -std::numeric_limits<double>::infinity();
  }

  /// Selects one of the new points with probability in proportion to its density.
  bool weigh(double log_weight, RandomStream& random) {
    const bool first = pending_ == 0;
    new_log_weight_ = first ? log_weight : log_add_exp(new_log_weight_, log_weight);
    return first || std::log(random.uniform()) < log_weight - new_log_weight_;
  }

  /// Adds the latest point to the new half. Its complete binary subtrees that wait for their
  /// siblings are stored in `halves_`, longest first. Returns false if two siblings make a U-turn.
  bool push() {
    // Merge subtrees of equal length, like carries of a binary counter.
    halves_[pending_++].assign(moving_point().r);
    while (pending_ > 1 && halves_[pending_ - 2].points == halves_[pending_ - 1].points) {
      TreeSpan &a = halves_[pending_ - 2], &b = halves_[pending_ - 1];
      if (turns(a, b)) return false;
      a.append(b);
      --pending_;
    }
    return true;
  }

  /// Merges the new half into the tree. Returns false if they make a U-turn.
  bool join() {
    ++depth_;
    log_weight_ = log_add_exp(log_weight_, new_log_weight_);
    const bool straight = !turns(tree_, halves_[0]);
    tree_.append(halves_[0]);
    return straight;
  }

  int max_depth_;
  double step_ = 0;                  // length of a leapfrog step [1]
  std::array<PhasePoint, 2> ends_;   // backward and forward end
  int forward_ = 1;                  // index of the moving end
  TreeSpan tree_;                    // accepted points
  std::vector<TreeSpan> halves_;     // subtrees of the new points (max_depth + 1)
  std::size_t pending_ = 0;          // number of entries of halves_ in use
  double log_weight_ = 0;            // log weight of the tree, relative to the start [1]
  double new_log_weight_ = 0;        // log weight of the new points [1]
  double acceptance_sum_ = 0;        // sum of acceptance probabilities [1]
  int depth_ = 0, point_count_ = 0;  // complete doublings, and points so far
};

}  // namespace

std::unique_ptr<HamiltonianTrajectory> no_u_turn_trajectory(int n, int max_depth) {
  return std::make_unique<NoUTurn>(n, max_depth);
}

}  // namespace thenar::internal
