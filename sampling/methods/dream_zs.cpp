#include <array>
#include <cmath>

#include "base/error.h"
#include "sampling/methods/metropolis.h"
#include "sampling/methods/saved_shape.h"

namespace thenar::internal {
namespace {

// Purposes of the random streams of candidates and of the first archive
constexpr std::uint32_t kCandidateStream = 0, kArchiveStream = 1;
constexpr int kArchiveInterval = 10;  // Steps between states that go to the archive [Vrugt2016]
constexpr int kFirstStates = 10;      // States of the archive before the first step, over n
// Number of crossover probabilities: 1/3, 2/3 and 1 that an entry changes
constexpr int kCrossoverCount = 3;
constexpr int kMaxPairs = 3;           // Most differences that a jump adds
constexpr double kSnookerShare = 0.1;  // Share of snooker updates [1]
// Share of jumps of a whole difference, from mode to mode [1]
constexpr double kLongJumpShare = 0.2;
constexpr double kStretchSpread = 0.1;  // Largest difference from 1 of the factor on a jump [1]
// sd of the noise added to a jump, in roots of the guessed covariance
constexpr double kJitterSd = 1e-6;

/// Differential evolution from an archive of past states  [TerBraak2008, Vrugt2009]:
///   x' = x + (1 + e) g sum_pairs (z_a - z_b) + jitter  in a random part of the entries,
///   with g = 2.38 / sqrt(2 pairs entries);
///   x' = x + z_a - z_b + jitter, from mode to mode; or
///   x' = x + g P(z_a - z_b), P onto the line x - z,  accepted by (|x' - z| / |x - z|)^(n-1) p'/p.
///
/// In warm-up every tenth state joins the archive, of which the older half of what joined is
/// left out, and the shares of the crossovers are learnt from how far they carry. Afterwards both
/// are frozen: the archive is then a constant, jumps are symmetric, and the chain is an ordinary
/// Metropolis chain with an exact limit, as [TerBraak2008] proves only for an archive that grows.
class DreamZs final : public Metropolis {
 public:
  DreamZs(const Eigen::MatrixXd& starts, const SamplerOptions& options)
      : Metropolis(starts, options), root_(initial_covariance_factor(options, size())) {
    require(chains() >= 3, "differential evolution needs at least 3 chains, got {}", chains());
    // The archive begins with the starts, scattered by the guessed covariance.
    first_ = std::max(kFirstStates * size(), 2 * kMaxPairs + 1);
    RandomStream draw = random(0, kArchiveStream);
    for (int i = 0; i < first_; ++i) {
      Eigen::VectorXd w(size());
      for (double& entry : w) entry = draw.normal();
      append(starts.col(i % chains()) + root_ * w);
    }
    // Crossovers with equal shares.
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

  /// Different states of the archive, not older than its first half.
  template <std::size_t count>
  [[nodiscard]] std::array<int, count> pick(RandomStream& draw) const {
    // Drawn again until it differs from those before.
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

  /// Some entries of a sum of differences of the archive; each entry by chance, one at least.
  Eigen::VectorXd jump(int k, RandomStream& draw) {
    // The crossover by its share.
    int& m = crossover_[static_cast<std::size_t>(k)];
    double left = draw.uniform();
    for (m = 0; m < kCrossoverCount - 1 && left >= share_[m]; ++m) left -= share_[m];

    // A sum of differences between states.
    const int pairs = 1 + draw.index(kMaxPairs), sure = draw.index(size());
    const auto picked = pick<2 * kMaxPairs>(draw);
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(size());
    for (std::size_t i = 0; i < 2 * std::size_t(pairs); i += 2)
      sum += state(picked[i]) - state(picked[i + 1]);

    // Only some entries jump; the scale is the best for as many.
    int entries = 0;
    for (int i = 0; i < size(); ++i) {
      const bool moves = draw.uniform() * kCrossoverCount < m + 1 || i == sure;
      entries += moves ? 1 : 0;
      if (!moves) sum[i] = 0;
    }
    const double stretch = 1 + kStretchSpread * (2 * draw.uniform() - 1);
    return stretch * 2.38 / std::sqrt(2.0 * pairs * entries) * sum;
  }

  /// One whole difference: from mode to mode.
  Eigen::VectorXd long_jump(int k, RandomStream& draw) {
    crossover_[static_cast<std::size_t>(k)] = -1;
    const auto [a, b] = pick<2>(draw);
    return state(a) - state(b);
  }

  /// A jump along the line to a state of the archive, and its log_proposal_ratio.
  std::pair<Eigen::VectorXd, double> snooker(int k, RandomStream& draw) {
    crossover_[static_cast<std::size_t>(k)] = -1;
    const auto [anchor, a, b] = pick<3>(draw);
    // Along the line from the anchor to the chain.
    const Eigen::VectorXd line = positions().col(k) - state(anchor);
    const double length = line.norm(), g = 1.2 + draw.uniform();
    if (length == 0) return {Eigen::VectorXd::Zero(size()), 0};
    const double along = g * line.dot(state(a) - state(b)) / (length * length);  // in lengths
    return {along * line, (size() - 1) * std::log(std::abs(1 + along))};
  }

  Proposals propose(int /*round*/) override {
    Proposals to{{}, positions(), Eigen::VectorXd::Zero(chains())};
    for (int k = 0; k < chains(); ++k) {
      // Which of the three kinds?
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
      // A little jitter, so that any point can be reached.
      Eigen::VectorXd w(size());
      for (double& entry : w) entry = kJitterSd * draw.normal();
      to.x.col(k) += root_ * w;
    }
    return to;
  }

  void learn(const Eigen::MatrixXd& before) override {
    // How far each crossover carries, in sds of the chains.
    const Eigen::VectorXd mean = positions().rowwise().mean();
    const Eigen::VectorXd variance =
        (positions().colwise() - mean).rowwise().squaredNorm() / (chains() - 1);
    for (int k = 0; k < chains(); ++k) {
      const int m = crossover_[static_cast<std::size_t>(k)];
      if (m < 0 || !inside(k)) continue;
      const Eigen::VectorXd moved = positions().col(k) - before.col(k);
      for (int i = 0; i < size(); ++i)
        if (variance[i] > 0) carried_[m] += moved[i] * moved[i] / variance[i];
      used_[m] += 1;
    }
    // Shares in proportion to that, once all have been used.
    if (used_.minCoeff() > 0 && carried_.minCoeff() > 0) {
      share_ = carried_.cwiseQuotient(used_);
      share_ /= share_.sum();
    }
    // Every tenth state joins the archive.
    if ((steps() + 1) % kArchiveInterval != 0) return;
    for (int k = 0; k < chains(); ++k)
      if (inside(k)) append(positions().col(k));
  }

  void save_learnt(StateWriter& to) const override {
    to.put(Eigen::Map<const Eigen::MatrixXd>(archive_.data(), size(), states()));
    to.put(carried_);
    to.put(used_);
    to.put(share_);
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

  Eigen::MatrixXd root_;            // of the guessed covariance (n, n)
  int first_ = 0;                   // states of the archive before the first step
  std::vector<double> archive_;     // states one after the other (n states)
  Eigen::VectorXd carried_, used_;  // squared distance and number of jumps of each crossover
  Eigen::VectorXd share_;           // of each crossover, sum 1
  std::vector<int> crossover_;      // of each chain's current proposal; -1: snooker
};

}  // namespace

std::unique_ptr<Sampler> dream_zs(const Eigen::MatrixXd& starts, const SamplerOptions& options) {
  return std::make_unique<DreamZs>(starts, options);
}

}  // namespace thenar::internal
