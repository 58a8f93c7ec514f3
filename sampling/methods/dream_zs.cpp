#include <array>
#include <cmath>

#include "base/error.h"
#include "sampling/methods/metropolis.h"
#include "sampling/methods/saved_shape.h"

namespace thenar::internal {
namespace {

// Purposes of the random streams of proposals and of the initial archive
constexpr std::uint32_t kCandidateStream = 0, kArchiveStream = 1;
constexpr int kArchiveInterval = 10;  // steps between states added to the archive [Vrugt2016]
constexpr int kFirstStates = 10;      // number of initial states of the archive, over n
// Number of crossover probabilities: an entry changes with probability 1/3, 2/3 or 1
constexpr int kCrossoverCount = 3;
constexpr int kMaxPairs = 3;           // maximum number of differences in a jump
constexpr double kSnookerShare = 0.1;  // share of snooker updates [1]
// Share of jumps by a full difference, between modes [1]
constexpr double kLongJumpShare = 0.2;
constexpr double kStretchSpread = 0.1;  // maximum relative deviation of the factor on a jump [1]
// Sd of the noise added to a jump, relative to the root of the initial covariance
constexpr double kJitterSd = 1e-6;

/// DREAM(ZS): differential evolution with an archive of past states  [TerBraak2008, Vrugt2009]:
/// x' = x + (1 + e) g sum_pairs (z_a - z_b) + jitter  in a random subset of the entries,
///   with g = 2.38 / sqrt(2 pairs entries);
///   x' = x + z_a - z_b + jitter, between modes; or
///   x' = x + g P(z_a - z_b), P onto the line x - z,  accepted by (|x' - z| / |x - z|)^(n-1) p'/p.
///
/// During warm-up, every tenth state is added to the archive, of which the older half of the added
/// states is ignored, and the crossover probabilities are adapted to the distance that they
/// achieve. Afterwards both are fixed: the archive is constant, jumps are symmetric, and the chain
/// is an ordinary Metropolis chain with the exact limit, which [TerBraak2008] proves only for a
/// growing archive.
class DreamZs final : public Metropolis {
 public:
  DreamZs(const Eigen::MatrixXd& starts, const SamplerOptions& options)
      : Metropolis(starts, options), root_(initial_covariance_factor(options, size())) {
    require(chains() >= 3, "differential evolution needs at least 3 chains, got {}", chains());
    // Fill the archive with the starts plus noise of the initial covariance.
    first_ = std::max(kFirstStates * size(), 2 * kMaxPairs + 1);
    RandomStream draw = random(0, kArchiveStream);
    for (int i = 0; i < first_; ++i) {
      Eigen::VectorXd w(size());
      for (double& entry : w) entry = draw.normal();
      append(starts.col(i % chains()) + root_ * w);
    }
    // Start with equal crossover probabilities.
    carried_.setZero(kCrossoverCount);
    used_.setZero(kCrossoverCount);
    share_.setConstant(kCrossoverCount, 1.0 / kCrossoverCount);
    crossover_.assign(static_cast<std::size_t>(chains()), -1);
  }

 private:
  [[nodiscard]] int states() const { return static_cast<int>(archive_.size()) / size(); }
  [[nodiscard]] Eigen::Map<const Eigen::VectorXd> state(int i) const {
    return {archive_.data() + std::size_t(i) * std::size_t(size()), size()};
  }
  void append(const Eigen::VectorXd& x) {
    archive_.insert(archive_.end(), x.data(), x.data() + x.size());
  }

  /// Picks different states of the archive, except from the older half of the added ones.
  template <std::size_t count>
  [[nodiscard]] std::array<int, count> pick(RandomStream& draw) const {
    // Draw again until the state differs from the previous ones.
    const int all = states(), oldest = (all - first_) / 2;
    std::array<int, count> picked;
    for (std::size_t i = 0; i < count; ++i) {
      bool again = true;
      while (again) {
        picked[i] = oldest + draw.index(all - oldest);
        again = false;
        for (std::size_t j = 0; j < i; ++j) again = again || picked[i] == picked[j];
      }
    }
    return picked;
  }

  /// Returns a sum of differences of the archive in a random subset of entries, at least one.
  Eigen::VectorXd jump(int k, RandomStream& draw) {
    // Draw the crossover.
    int& m = crossover_[static_cast<std::size_t>(k)];
    double left = draw.uniform();
    for (m = 0; m < kCrossoverCount - 1 && left >= share_[m]; ++m) left -= share_[m];

    // Sum differences between states.
    const int pairs = 1 + draw.index(kMaxPairs), sure = draw.index(size());
    const auto picked = pick<2 * kMaxPairs>(draw);
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(size());
    for (std::size_t i = 0; i < 2 * std::size_t(pairs); i += 2)
      sum += state(picked[i]) - state(picked[i + 1]);

    // Keep a random subset of entries; the scale is optimal for their number.
    int entries = 0;
    for (int i = 0; i < size(); ++i) {
      const bool moves = draw.uniform() * kCrossoverCount < m + 1 || i == sure;
      entries += moves ? 1 : 0;
      if (!moves) sum[i] = 0;
    }
    const double stretch = 1 + kStretchSpread * (2 * draw.uniform() - 1);
    return stretch * 2.38 / std::sqrt(2.0 * pairs * entries) * sum;
  }

  /// Returns one full difference, to jump between modes.
  Eigen::VectorXd long_jump(int k, RandomStream& draw) {
    crossover_[static_cast<std::size_t>(k)] = -1;
    const auto [a, b] = pick<2>(draw);
    return state(a) - state(b);
  }

  /// Returns a jump along the line to a state of the archive, and its log_proposal_ratio.
  std::pair<Eigen::VectorXd, double> snooker(int k, RandomStream& draw) {
    crossover_[static_cast<std::size_t>(k)] = -1;
    const auto [anchor, a, b] = pick<3>(draw);
    // Project on the line from the anchor to the chain.
    const Eigen::VectorXd line = positions().col(k) - state(anchor);
    const double length = line.norm(), g = 1.2 + draw.uniform();
    if (length == 0) return {Eigen::VectorXd::Zero(size()), 0};
    const double along =
        g * line.dot(state(a) - state(b)) / (length * length);  // relative to the length
    return {along * line, (size() - 1) * std::log(std::abs(1 + along))};
  }

  Proposals propose(int /*round*/) override {
    Proposals to{{}, positions(), Eigen::VectorXd::Zero(chains())};
    for (int k = 0; k < chains(); ++k) {
      // Choose the kind of jump.
      RandomStream draw = random(k, kCandidateStream);
      to.chain.push_back(k);
      const double kind = draw.uniform();
      if (kind < kSnookerShare) {
        const auto [step, log_proposal_ratio] = snooker(k, draw);
        to.x.col(k) += step;
        to.log_proposal_ratio[k] = log_proposal_ratio;
        continue;
      }
      to.x.col(k) += kind < kSnookerShare + kLongJumpShare ? long_jump(k, draw) : jump(k, draw);
      // Add jitter, so that every point can be reached.
      Eigen::VectorXd w(size());
      for (double& entry : w) entry = kJitterSd * draw.normal();
      to.x.col(k) += root_ * w;
    }
    return to;
  }

  void learn(const Eigen::MatrixXd& before) override {
    // Measure the squared jump distance of each crossover, in sds of the chains.
    const Eigen::VectorXd mean = positions().rowwise().mean();
    const Eigen::VectorXd variance =
        (positions().colwise() - mean).rowwise().squaredNorm() / (chains() - 1);
    for (int k = 0; k < chains(); ++k) {
      const int m = crossover_[static_cast<std::size_t>(k)];
      if (m < 0 || !has_density(k)) continue;
      const Eigen::VectorXd moved = positions().col(k) - before.col(k);
      for (int i = 0; i < size(); ++i)
        if (variance[i] > 0) carried_[m] += moved[i] * moved[i] / variance[i];
      used_[m] += 1;
    }
    // Set the probabilities in proportion, once all have been used.
    if (used_.minCoeff() > 0 && carried_.minCoeff() > 0) {
      share_ = carried_.cwiseQuotient(used_);
      share_ /= share_.sum();
    }
    // Add every tenth state to the archive.
    if ((steps() + 1) % kArchiveInterval != 0) return;
    for (int k = 0; k < chains(); ++k)
      if (has_density(k)) append(positions().col(k));
  }

  void save_learnt(StateWriter& to) const override {
    to.write(Eigen::Map<const Eigen::MatrixXd>(archive_.data(), size(), states()));
    to.write(carried_);
    to.write(used_);
    to.write(share_);
  }

  void restore_learnt(StateReader& from) override {
    const Eigen::MatrixXd archive = from.matrix();
    require(archive.rows() == size() && archive.cols() >= first_,
            "saved state, archive: wanted {} rows and at least {} columns, got {} x {}", size(),
            first_, archive.rows(), archive.cols());
    archive_.assign(archive.data(), archive.data() + archive.size());
    carried_ = saved_vector(from, "distances of crossovers", kCrossoverCount);
    used_ = saved_vector(from, "jumps of crossovers", kCrossoverCount);
    share_ = saved_vector(from, "shares of crossovers", kCrossoverCount);
  }

  Eigen::MatrixXd root_;            // Cholesky factor of the initial covariance (n, n)
  int first_ = 0;                   // number of initial states of the archive
  std::vector<double> archive_;     // states stored one after another (n * states)
  Eigen::VectorXd carried_, used_;  // squared distance and number of jumps of each crossover
  Eigen::VectorXd share_;           // probability of each crossover, sum 1
  std::vector<int>
      crossover_;  // crossover of each chain's current proposal; -1: another kind of jump
};

}  // namespace

std::unique_ptr<Sampler> dream_zs(const Eigen::MatrixXd& starts, const SamplerOptions& options) {
  return std::make_unique<DreamZs>(starts, options);
}

}  // namespace thenar::internal
