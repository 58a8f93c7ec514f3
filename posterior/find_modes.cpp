#include "posterior/find_modes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.h"
#include "base/random_stream.h"

namespace thenar {
namespace {

// Purposes of random streams.
constexpr std::uint32_t kSearchStream = 0x6d6f6465, kDispersedStream = 0x73746172;

/// Checks the ranges of the options.
void check_mode_search(const LeastSquares& problem, const ModeSearchOptions& search) {
  require(search.starts >= 0, "starts must be >= 0, got {}", search.starts);
  require(search.global_searches >= 0, "global searches must be >= 0, got {}",
          search.global_searches);
  require(search.start_sd > 0, "start_sd must be > 0, got {}", search.start_sd);
  require(search.same_distance > 0 && search.same_cost > 0,
          "distance and cost of the same mode must be > 0, got {} and {}", search.same_distance,
          search.same_cost);
  require(search.extra_starts.size() == 0 || search.extra_starts.rows() == problem.lower.size(),
          "further starts have {} entries, wanted {}", search.extra_starts.rows(),
          problem.lower.size());
}

/// Draws standard normal entries; those outside their bounds are drawn again and finally clipped.
Eigen::VectorXd prior_draw(const LeastSquares& problem, const ModeSearchOptions& search,
                           int number) {
  constexpr int kMaxEntryTrials = 20;  // maximum number of draws of an entry
  // Use a separate stream for each search.
  RandomStream random(search.seed, static_cast<std::uint32_t>(number), 0, kSearchStream);
  Eigen::VectorXd z(problem.lower.size());
  for (Eigen::Index i = 0; i < z.size(); ++i)
    // Draw again while the entry is outside its bounds.
    for (int trial = 0; trial < kMaxEntryTrials; ++trial) {
      z[i] = search.start_sd * random.normal();
      if (z[i] >= problem.lower[i] && z[i] <= problem.upper[i]) break;
    }
  return z.cwiseMax(problem.lower).cwiseMin(problem.upper);
}

/// Runs one search, or returns the reason why it failed.
Solution search_from(const LeastSquares& problem, const Eigen::VectorXd& start,
                     const SolveOptions& options) {
  // Search if the residuals are finite at the start.
  const Eigen::VectorXd inside = start.cwiseMax(problem.lower).cwiseMin(problem.upper);
  if (problem.residuals(inside, WithJacobian::kNo).r.allFinite())
    return solve(problem, inside, options);
  // Record a failed search.
  Solution none;
  none.z = inside;
  none.cost = std::numeric_limits<double>::infinity();
  none.failed = true;
  none.message = "residuals at the start are not finite";
  none.evaluations = 1;
  return none;
}

/// Runs a global search, polished by the local solver.
Solution search_globally(const LeastSquares& problem, const ModeSearchOptions& search, int number) {
  // Search within the bounds without derivatives.
  SolveOptions global;
  global.method = LeastSquaresMethod::kNloptGlobal;
  global.seed = search.seed + static_cast<unsigned>(number);
  global.progress.stop_requested = search.polish.progress.stop_requested;
  Solution rough =
      search_from(problem, prior_draw(problem, search, search.starts + number), global);
  if (!std::isfinite(rough.cost) || rough.status == Status::kStopped) return rough;
  // Polish the result.
  Solution fine = search_from(problem, rough.z, search.polish);
  fine.evaluations += rough.evaluations;
  fine.seconds += rough.seconds;
  return fine;
}

/// Runs all searches until a stop is requested.
void run_searches(const LeastSquares& problem, const ModeSearchOptions& search, FoundModes& found) {
  // Given starts come first, then draws from the prior, then global searches.
  const int given = static_cast<int>(search.extra_starts.cols());
  const int total = given + search.starts + search.global_searches;
  for (int i = 0; i < total; ++i) {
    if (search.progress.stop()) found.status = Status::kStopped;
    if (found.status == Status::kStopped) return;
    search.progress(double(i) / total, fmt::format("search {} of {} for modes", i + 1, total));
    if (i < given)
      found.searches.push_back(search_from(problem, search.extra_starts.col(i), search.polish));
    else if (i < given + search.starts)
      found.searches.push_back(
          search_from(problem, prior_draw(problem, search, i - given), search.polish));
    else
      found.searches.push_back(search_globally(problem, search, i - given - search.starts));
  }
}

/// Merges the end points of all searches to modes, best first.
void gather(const LeastSquares& problem, const ModeSearchOptions& search, FoundModes& found) {
  // Sort the searches by cost.
  std::vector<int> order(found.searches.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return found.searches[a].cost < found.searches[b].cost; });

  // Assign each end point to the first mode that the data cannot distinguish from it, or to a new
  // one.
  found.mode_of_search.assign(order.size(), -1);
  for (const int i : order) {
    const Solution& end = found.searches[i];
    if (!std::isfinite(end.cost) || end.failed) continue;
    std::size_t m = 0;
    while (m < found.modes.size() &&
           (end.cost - found.modes[m].cost >= search.same_cost ||
            found.modes[m].curvature->squared_norm(end.z - found.modes[m].z) >=
                search.same_distance * search.same_distance))
      ++m;
    // Add a mode, with the logarithm of its Laplace mass.
    if (m == found.modes.size()) {
      found.modes.push_back({end.z, end.cost, ModeCurvature(problem, end.z), 0, 0, end.status});
      Mode& mode = found.modes.back();
      mode.laplace_mass = -end.cost - 0.5 * mode.curvature->log_determinant();
    }
    ++found.modes[m].hits;
    found.mode_of_search[i] = static_cast<int>(m);
  }
}

/// Converts logarithms of masses to shares.
void share_mass(std::vector<Mode>& modes) {
  double top = -std::numeric_limits<double>::infinity(), sum = 0;
  for (const Mode& mode : modes) top = std::max(top, mode.laplace_mass);
  for (Mode& mode : modes) sum += mode.laplace_mass = std::exp(mode.laplace_mass - top);
  for (Mode& mode : modes) mode.laplace_mass /= sum;
}

/// Share of the starts that a mode receives.
struct Share {
  std::size_t mode;
  double share;  // 0..1 [1]
};

/// Returns the modes that a run can be expected to visit, with their shares of the starts.
std::vector<Share> shares_of_starts(const std::vector<Mode>& modes) {
  // Distribute half by mass, half evenly.
  constexpr double kMinMass = 1e-6;  // smallest Laplace mass of a mode that gets starts [1]
  std::vector<Share> shares;
  for (std::size_t m = 0; m < modes.size(); ++m)
    if (modes[m].laplace_mass >= kMinMass) shares.push_back({m, modes[m].laplace_mass});
  require(!shares.empty(), "no mode has a Laplace mass of {} or more", kMinMass);
  const double even = 1 / static_cast<double>(shares.size());
  for (Share& share : shares) share.share = 0.5 * (share.share + even);
  return shares;
}

/// Reflects z at its bounds, and keeps a distance from them.
double reflected(double z, double lower, double upper) {
  if (lower >= upper) return lower;
  // Distance from a bound: a share of a finite range [1], otherwise [prior sds]
  constexpr double kBoundDistance = 0.01;
  const double off =
      std::isfinite(upper - lower) ? kBoundDistance * (upper - lower) : kBoundDistance;
  if (z < lower) z = 2 * lower - z;
  if (z > upper) z = 2 * upper - z;
  return std::min(std::max(z, lower + off), upper - off);
}

}  // namespace

FoundModes find_modes(const LeastSquares& problem, const ModeSearchOptions& search) {
  check_mode_search(problem, search);
  FoundModes found;
  run_searches(problem, search, found);
  gather(problem, search, found);
  share_mass(found.modes);
  return found;
}

Eigen::MatrixXd dispersed_starts(const LeastSquares& problem, const std::vector<Mode>& modes,
                                 int count, double inflation, unsigned seed) {
  require(!modes.empty(), "no modes to start from");
  for (const Mode& mode : modes)
    require(mode.curvature.has_value(), "a mode without curvature: search for it anew");
  require(count >= 1, "count of starts must be >= 1, got {}", count);
  require(inflation > 0, "inflation must be > 0, got {}", inflation);
  const std::vector<Share> shares = shares_of_starts(modes);
  const Eigen::Index n = modes[0].z.size();
  Eigen::MatrixXd starts(n, count);
  for (int k = 0; k < count; ++k) {
    // Multiples of the golden ratio are evenly distributed over 0..1 for any count.
    constexpr double kGoldenSection = 0.6180339887498949;
    double left = std::fmod((k + 0.5) * kGoldenSection, 1.0);
    std::size_t m = 0;
    while (m + 1 < shares.size() && left >= shares[m].share) left -= shares[m++].share;
    // Draw a normal deviation from the mode, and reflect it at the bounds.
    RandomStream random(seed, static_cast<std::uint32_t>(k), 0, kDispersedStream);
    const Mode& mode = modes[shares[m].mode];
    const Eigen::VectorXd normal = Eigen::VectorXd::NullaryExpr(n, [&] { return random.normal(); });
    const Eigen::VectorXd z = mode.z + inflation * mode.curvature->transform_normal(normal);
    for (Eigen::Index i = 0; i < n; ++i)
      starts(i, k) = reflected(z[i], problem.lower[i], problem.upper[i]);
  }
  return starts;
}

}  // namespace thenar
