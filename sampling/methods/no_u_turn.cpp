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
  Eigen::VectorXd begin, end;  // of the first and the last (n)
  Eigen::VectorXd sum;         // of all (n)
  long points = 0;

  void assign(const Eigen::VectorXd& r) {
    begin = end = sum = r;
    points = 1;
  }
  /// Appends the span that follows; `next` is of no use afterwards.
  void append(TreeSpan& next) {
    end.swap(next.end);
    sum += next.sum;
    points += next.points;
  }
};

/// Generalised U-turn:  rho . v <= 0  at an end, rho being the sum of momenta and v the velocity,
/// which is the momentum in whitened units. Asked of a and b together, and of each with the first
/// point of the other, since a trajectory may turn between two halves that do not.
bool turns(const TreeSpan& a, const TreeSpan& b) {
  const auto straight = [](const auto& rho, const auto& first, const auto& last) {
    return rho.dot(first) > 0 && rho.dot(last) > 0;
  };
  if (!straight(a.sum + b.sum, a.begin, b.end)) return true;
  if (a.points == 1) return false;  // the rest would be the same
  return !straight(a.sum + b.begin, a.begin, b.begin) || !straight(a.end + b.sum, a.end, b.end);
}

double log_add_exp(double log_a, double log_b) {
  const double most = std::max(log_a, log_b), least = std::min(log_a, log_b);
  return most + std::log1p(std::exp(least - most));
}

class NoUTurn : public HamiltonianTrajectory {
 public:
  NoUTurn(int n, int max_depth) : max_depth_(max_depth) {
    // Memory for the tree and for the subtrees of one doubling.
    const TreeSpan none{Eigen::VectorXd(n), Eigen::VectorXd(n), Eigen::VectorXd(n), 0};
    tree_ = none;
    halves_.assign(static_cast<std::size_t>(max_depth) + 1, none);
  }

  void start(const PhasePoint& from, double step, RandomStream& random) override {
    step_ = step;
    // A tree of one point.
    ends_[0] = ends_[1] = from;
    tree_.assign(from.r);
    log_weight_ = acceptance_sum_ = 0;
    depth_ = told_ = 0;
    start_doubling(random);
  }

  PhasePoint& moving() override { return ends_[forward_]; }
  [[nodiscard]] double leap() const override { return forward_ == 1 ? step_ : -step_; }

  Verdict judge(double energy_error, RandomStream& random) override {
    ++told_;
    // A divergent trajectory ends; the choice so far is the draw.
    if (!(energy_error <= kMaxEnergyError)) return {false, false, true};
    acceptance_sum_ += std::min(1.0, std::exp(-energy_error));
    // One of the new points is the candidate; they end the trajectory if they turn.
    Verdict verdict;
    verdict.take = weigh(-energy_error, random);
    verdict.end = !push();
    if (verdict.end || halves_[0].points < tree_.points) return verdict;
    // The new half is complete: its candidate is adopted by its weight, and the tree grows.
    verdict.adopt = std::log(random.uniform()) < new_log_weight_ - log_weight_;
    verdict.end = !join() || depth_ == max_depth_;
    if (!verdict.end) start_doubling(random);
    return verdict;
  }

  [[nodiscard]] double acceptance() const override {
    return acceptance_sum_ / static_cast<double>(told_);
  }
  [[nodiscard]] int depth() const override { return depth_; }

 private:
  void start_doubling(RandomStream& random) {
    const int forward = random.uniform() < 0.5 ? 1 : 0;
    // The tree's span ends where it is to grow.
    if (depth_ > 0 && forward != forward_) tree_.begin.swap(tree_.end);
    forward_ = forward;
    pending_ = 0;
    new_log_weight_ = -std::numeric_limits<double>::infinity();
  }

  /// Keeps one of the new points, each with a probability in proportion to its density.
  bool weigh(double log_weight, RandomStream& random) {
    const bool first = pending_ == 0;
    new_log_weight_ = first ? log_weight : log_add_exp(new_log_weight_, log_weight);
    return first || std::log(random.uniform()) < log_weight - new_log_weight_;
  }

  /// Adds the latest point to the new half. Complete binary subtrees of it that await their
  /// sibling stand in `halves_`, longest first; false if two siblings turn.
  bool push() {
    // Subtrees of equal length join, as carries of a binary counter.
    halves_[pending_++].assign(moving().r);
    while (pending_ > 1 && halves_[pending_ - 2].points == halves_[pending_ - 1].points) {
      TreeSpan &a = halves_[pending_ - 2], &b = halves_[pending_ - 1];
      if (turns(a, b)) return false;
      a.append(b);
      --pending_;
    }
    return true;
  }

  /// Makes the new half a part of the tree. False if they turn.
  bool join() {
    ++depth_;
    log_weight_ = log_add_exp(log_weight_, new_log_weight_);
    const bool straight = !turns(tree_, halves_[0]);
    tree_.append(halves_[0]);
    return straight;
  }

  int max_depth_;
  double step_ = 0;                 // length of a leapfrog [1]
  std::array<PhasePoint, 2> ends_;  // backward, forward
  int forward_ = 1;                 // which of them moves
  TreeSpan tree_;                   // of the points that are safe
  std::vector<TreeSpan> halves_;    // of the new points (max_depth + 1)
  std::size_t pending_ = 0;         // entries of halves_ in use
  double log_weight_ = 0;           // of the tree, relative to the start [1]
  double new_log_weight_ = 0;       // of the new points [1]
  double acceptance_sum_ = 0;       // [1]
  int depth_ = 0, told_ = 0;
};

}  // namespace

std::unique_ptr<HamiltonianTrajectory> no_u_turn(int n, int max_depth) {
  return std::make_unique<NoUTurn>(n, max_depth);
}

}  // namespace thenar::internal
