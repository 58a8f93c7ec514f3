#include "sampling/diagnostics/uniform_ranks.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace thenar {
namespace {

/// Binomial probabilities from a table of log factorials.
class Binomial {
 public:
  explicit Binomial(int max_trials) : log_factorial_(max_trials + 1) {
    for (int i = 0; i <= max_trials; ++i) log_factorial_[i] = std::lgamma(i + 1.0);
  }

  /// Returns P(count = c) of n trials with probability p in (0, 1).
  [[nodiscard]] double at(int c, int n, double log_p, double log_rest) const {
    return std::exp(log_factorial_[n] - log_factorial_[c] - log_factorial_[n - c] + c * log_p +
                    (n - c) * log_rest);
  }

  /// Returns P(count <= c) for all c (n + 1).
  [[nodiscard]] Eigen::VectorXd cumulative(int n, double p) const {
    Eigen::VectorXd sum(n + 1);
    double total = 0;
    for (int c = 0; c <= n; ++c) sum[c] = total += at(c, n, std::log(p), std::log1p(-p));
    return sum;
  }

 private:
  std::vector<double> log_factorial_;
};

/// Returns evenly spaced points of the ranks 1 .. L.
Eigen::VectorXi evaluation_points(int draws, int points) {
  return Eigen::VectorXi::NullaryExpr(points, [&](Eigen::Index i) {
    return int(std::lround(double(i + 1) * (draws + 1) / (points + 1)));
  });
}

/// Binomial quantiles at gamma / 2 and 1 - gamma / 2.
struct Limits {
  Eigen::VectorXi low, high;  // (points)
};

Limits limits_at(double gamma, const std::vector<Eigen::VectorXd>& cumulative) {
  Limits limits{Eigen::VectorXi(cumulative.size()), Eigen::VectorXi(cumulative.size())};
  for (std::size_t i = 0; i < cumulative.size(); ++i) {
    // Find the smallest counts whose cumulative probability reaches the share.
    const Eigen::VectorXd& F = cumulative[i];
    const auto quantile = [&F](double share) {
      const auto found = std::lower_bound(F.begin(), F.end(), share) - F.begin();
      return int(std::min<Eigen::Index>(found, F.size() - 1));
    };
    limits.low[i] = quantile(gamma / 2);
    limits.high[i] = quantile(1 - gamma / 2);
  }
  return limits;
}

/// Returns the probability that the counts of N uniform ranks stay within limits. Counts form a
/// Markov chain: each rank not yet counted falls into the next interval independently.
double stay_inside(const Limits& limits, const Eigen::VectorXi& below, int N, int draws,
                   const Binomial& binomial) {
  // Start with a count of zero.
  Eigen::VectorXd now = Eigen::VectorXd::Zero(N + 1), next;
  now[0] = 1;
  int first = 0, last = 0, before = 0;
  for (Eigen::Index i = 0; i < below.size(); ++i) {
    // Probability that a rank not yet counted falls into this interval.
    const double p = double(below[i] - before) / (draws + 1 - before);
    const double log_p = std::log(p), log_rest = std::log1p(-p);
    // Propagate the counts within the limits.
    next = Eigen::VectorXd::Zero(N + 1);
    for (int c = first; c <= last; ++c)
      for (int to = std::max(c, limits.low[i]); now[c] > 0 && to <= limits.high[i]; ++to)
        next[to] += now[c] * binomial.at(to - c, N - c, log_p, log_rest);
    now = next;
    first = limits.low[i];
    last = limits.high[i];
    before = below[i];
  }
  return now.sum();
}

std::vector<Eigen::VectorXd> cumulative_at(const Eigen::VectorXi& below, int N, int draws,
                                           const Binomial& binomial) {
  std::vector<Eigen::VectorXd> distributions;
  for (const int point : below)
    distributions.push_back(binomial.cumulative(N, double(point) / (draws + 1)));
  return distributions;
}

void check(int ranks, int draws, int points) {
  require(ranks > 0 && draws > 0 && points > 0 && points <= draws,
          "a rank band needs ranks, draws and at most as many points, got {}, {} and {}", ranks,
          draws, points);
}

}  // namespace

Eigen::VectorXi count_below(const Eigen::VectorXi& rank, const Eigen::VectorXi& below) {
  return below.unaryExpr([&rank](int point) { return int((rank.array() < point).count()); });
}

RankBand uniform_rank_band(int ranks, int draws, int points, double level) {
  check(ranks, draws, points);
  require(level > 0 && level < 1, "a band's level lies in (0, 1), got {}", level);
  // Compute the distribution of the count at each evaluation point.
  const Binomial binomial(ranks);
  RankBand band{evaluation_points(draws, points), {}, {}, 0};
  const auto cumulative = cumulative_at(band.below, ranks, draws, binomial);

  // The probability of leaving anywhere is at most the sum over the points, which brackets gamma.
  double narrow = 1 - level, wide = (1 - level) / points;
  for (int i = 0; i < 25; ++i) {
    const double gamma = std::sqrt(narrow * wide);
    const double inside =
        stay_inside(limits_at(gamma, cumulative), band.below, ranks, draws, binomial);
    (inside >= level ? wide : narrow) = gamma;
  }
  // Take the largest feasible gamma.
  const Limits limits = limits_at(wide, cumulative);
  band.low = limits.low;
  band.high = limits.high;
  band.pointwise = 1 - wide;
  return band;
}

double uniform_rank_p(const Eigen::VectorXi& rank, int draws, int points) {
  check(int(rank.size()), draws, points);
  require(rank.minCoeff() >= 0 && rank.maxCoeff() <= draws, "ranks lie in 0..{}, got {} to {}",
          draws, rank.minCoeff(), rank.maxCoeff());
  // Count at the evaluation points.
  const int N = int(rank.size());
  const Binomial binomial(N);
  const Eigen::VectorXi below = evaluation_points(draws, points);
  const auto cumulative = cumulative_at(below, N, draws, binomial);
  const Eigen::VectorXi count = count_below(rank, below);

  // Find the smallest tail probability at any point, including the count itself.
  double tail = 1;
  for (Eigen::Index i = 0; i < below.size(); ++i) {
    const Eigen::VectorXd& F = cumulative[i];
    tail = std::min({tail, F[count[i]], 1 - (count[i] > 0 ? F[count[i] - 1] : 0)});
  }

  // Find the limits just inside: counts with a larger tail probability.
  Limits inside{Eigen::VectorXi(below.size()), Eigen::VectorXi(below.size())};
  const double more = tail * (1 + 1e-9);
  for (std::size_t i = 0; i < cumulative.size(); ++i) {
    const Eigen::VectorXd& F = cumulative[i];
    int low = 0, high = N;
    while (low <= N && F[low] <= more) ++low;
    while (high > 0 && 1 - F[high - 1] <= more) --high;
    inside.low[i] = low;
    inside.high[i] = high;
  }
  return std::clamp(1 - stay_inside(inside, below, N, draws, binomial), 0.0, 1.0);
}

}  // namespace thenar
