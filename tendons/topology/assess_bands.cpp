#include "tendons/topology/assess_bands.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Eigenvalues>

#include "base/numbers.h"

namespace thenar {
namespace {

// Information on log EA below which the data do not determine a band [1]
constexpr double kMinInformation = 1e-3;

/// Computes the evidence for a band: the difference of the smallest misfits without and with it.
double evidence(const FittedNets& tried, int band) {
  const double without = tried.min_misfit(band, false), with = tried.min_misfit(band, true);
  return std::isinf(without) && std::isinf(with) ? 0 : without - with;
}

/// Collects convergence and residuals of the fits behind the evidence on one band.
void collect_fit_quality(const FittedNets& tried, int band, BandVerdict& verdict,
                         InferredNet& out) {
  for (bool present : {false, true})
    if (const FittedNet* net = tried.best_where(band, present)) {
      verdict.converged = verdict.converged && net->fit.converged;
      out.residual = std::max(out.residual, net->fit.residual);
    }
}

/// Returns the bands of little evidence, smallest first.
std::vector<int> doubtful(const FittedNets& tried, int bands, double below) {
  std::vector<int> open;
  for (int c = 0; c < bands; ++c)
    if (std::abs(evidence(tried, c)) < below) open.push_back(c);
  std::sort(open.begin(), open.end(), [&](int a, int b) {
    return std::abs(evidence(tried, a)) < std::abs(evidence(tried, b));
  });
  return open;
}

/// Tries single changes of the best net, again from every better one.
void try_singles(FittedNets& tried) {
  for (const FittedNet* best = tried.best(); best;) {
    // Fit every net that differs in one band.
    const FittedNet here = *best;
    for (int c = 0; c < static_cast<int>(here.bands.size()); ++c)
      (void)tried.fit(flipped(here.bands, c), here.fit.s);
    // Continue from the best one if it is clearly better.
    best = tried.best();
    if (best->fit.misfit > here.fit.misfit - 0.5) return;
  }
}

/// Tries pairs of changes of bands with little evidence.
void try_pairs(FittedNets& tried, const AssessOptions& options, double below,
               const Progress& progress) {
  const FittedNet here = *tried.best();
  // Fit nets that differ in two bands with little evidence.
  const std::vector<int> open = doubtful(tried, static_cast<int>(here.bands.size()), below);
  int left = options.max_pairs;
  for (std::size_t b = 1; b < open.size(); ++b)
    for (std::size_t a = 0; a < b && left > 0 && !progress.stop(); ++a, --left)
      (void)tried.fit(flipped(flipped(here.bands, open[a]), open[b]), here.fit.s);
}

/// Tries all combinations of the most doubtful bands.
void try_combinations(FittedNets& tried, const AssessOptions& options, double below,
                      const Progress& progress) {
  const FittedNet here = *tried.best();
  // Fit the nets with every combination of these bands.
  std::vector<int> open = doubtful(tried, static_cast<int>(here.bands.size()), below);
  open.resize(std::min<std::size_t>(open.size(), static_cast<std::size_t>(options.max_open)));
  for (unsigned way = 0; way < 1u << open.size() && !progress.stop(); ++way) {
    Topology bands = here.bands;
    for (std::size_t i = 0; i < open.size(); ++i) bands[open[i]] = (way >> i & 1u) != 0;
    (void)tried.fit(bands, here.fit.s);
  }
}

/// Fits the best net, and the best that differs from it in each band, from all starts.
void settle_rivals(FittedNets& tried, const Progress& progress) {
  // Settle the best net, then its best rival in each band.
  tried.settle(tried.best()->bands, tried.best()->fit.s);
  const FittedNet here = *tried.best();
  for (int c = 0; c < static_cast<int>(here.bands.size()) && !progress.stop(); ++c) {
    const FittedNet* rival = tried.best_where(c, !here.bands[c]);
    tried.settle(Topology(rival ? rival->bands : flipped(here.bands, c)), here.fit.s);
  }
}

/// Tries changes of the best net, until none is better by more than a fit's tolerance.
void search_around(FittedNets& tried, const AssessOptions& options, const Progress& progress) {
  constexpr double kBetterMisfit = 0.1;  // smallest decrease of chi^2 of a better net [1]
  for (int round = 0; round < options.max_rounds && !progress.stop(); ++round) {
    progress(0.7 + 0.3 * round / options.max_rounds, "changes of the best net");
    const double before = tried.best()->fit.misfit;
    // Try single changes, then pairs and combinations where the evidence is small.
    try_singles(tried);
    const double error = std::pow(model_error(tried), 2);
    try_pairs(tried, options, options.screen * error, progress);
    try_combinations(tried, options, options.doubt * error, progress);
    settle_rivals(tried, progress);
    if (tried.best()->fit.misfit > before - kBetterMisfit) return;
  }
}

/// Computes the information on log EA in the best net (candidates, candidates).
Eigen::MatrixXd information(const BandFit& fit) {
  const Eigen::MatrixXd J = fit.J * fit.s.asDiagonal();
  return J.transpose() * J;
}

/// Sets the stiffnesses and the standard deviations of log EA with the others free; infinite along
/// undetermined directions.
void set_stiffness(FittedNets& tried, InferredNet& out) {
  const FittedNet& best = *tried.best();
  // Decompose the information; readings do not depend on eigenvectors of zero eigenvalue.
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(information(best.fit));
  const Eigen::VectorXd& lambda = eigen.eigenvalues();
  Eigen::VectorXd variance = Eigen::VectorXd::Zero(lambda.size());
  for (Eigen::Index k = 0; k < lambda.size(); ++k) {
    // Add the variance along each eigenvector.
    const Eigen::VectorXd v = eigen.eigenvectors().col(k);
    const bool present = best.fit.s.cwiseProduct(v).norm() > 1e-9;
    if (lambda(k) < kMinInformation && present) out.blind.push_back(v);
    for (Eigen::Index c = 0; c < v.size(); ++c)
      if (std::abs(v(c)) > 1e-6) variance(c) += v(c) * v(c) / std::max(lambda(k), 1e-300);
  }
  // Set stiffness, deviation, and whether the data constrain EA more than its bounds.
  for (std::size_t c = 0; c < out.verdicts.size(); ++c) {
    const auto i = static_cast<Eigen::Index>(c);
    out.verdicts[c].EA = best.fit.s(i) * tried.fitter().typical_EA()(i);
    const double sd = out.inflation * std::sqrt(variance(i));
    out.verdicts[c].EA_sd = best.bands[c] && sd < 1e3 ? sd : kInfinity;
    const CandidateBand& bounds = tried.fitter().candidate().candidates[c];
    out.verdicts[c].EA_determined =
        out.verdicts[c].EA_sd < std::log(bounds.max_EA / bounds.min_EA) / std::sqrt(12.0);
  }
}

/// Returns whether one of the four ways to have or lack two bands in the best net was tried and
/// fits worse.
bool linked(FittedNets& tried, double limit, int a, int b) {
  const FittedNet& best = *tried.best();
  for (int way = 0; way < 4; ++way) {
    Topology bands = best.bands;
    bands[a] = (way & 1) != 0, bands[b] = (way & 2) != 0;
    if (!tried.contains(bands)) continue;
    const BandFit& fit = tried.fit(bands, best.fit.s);
    if (!fit.holds || fit.misfit > limit) return true;
  }
  return false;
}

/// Finds a root for each band, shared by undecided bands that depend on each other.
std::vector<int> roots_of(FittedNets& tried, const std::vector<BandVerdict>& verdicts,
                          double limit) {
  const int n = static_cast<int>(verdicts.size());
  std::vector<int> root(static_cast<std::size_t>(n));
  std::iota(root.begin(), root.end(), 0);
  const auto open = [&](int c) { return verdicts[c].verdict == Verdict::kUndecided; };
  for (int a = 0; a < n; ++a)
    for (int b = a + 1; b < n; ++b)
      if (open(a) && open(b) && linked(tried, limit, a, b))
        std::replace(root.begin(), root.end(), int{root[b]}, int{root[a]});
  return root;
}

/// Returns the subsets of these bands in equally good nets, each once.
std::vector<std::vector<int>> ways_of(const std::vector<int>& bands,
                                      const std::vector<FittedNet>& alike) {
  std::vector<std::vector<int>> ways;
  for (const FittedNet& net : alike) {
    std::vector<int> way;
    for (int c : bands)
      if (net.bands[c]) way.push_back(c);
    if (std::find(ways.begin(), ways.end(), way) == ways.end()) ways.push_back(way);
  }
  return ways;
}

/// Finds the groups of undecided bands that depend on each other.
std::vector<BandGroup> groups_of(FittedNets& tried, const InferredNet& found, double limit) {
  const int n = static_cast<int>(found.verdicts.size());
  const std::vector<int> root = roots_of(tried, found.verdicts, limit);
  // Build one group for each root with several bands.
  std::vector<BandGroup> groups;
  for (int r = 0; r < n; ++r) {
    BandGroup group;
    for (int c = 0; c < n; ++c)
      if (root[c] == r) group.bands.push_back(c);
    if (group.bands.size() < 2) continue;
    group.ways = ways_of(group.bands, found.alike);
    groups.push_back(group);
  }
  return groups;
}

}  // namespace

InferredNet assess_bands(FittedNets& tried, const AssessOptions& options,
                         const Progress& progress) {
  InferredNet out;
  out.rows = tried.fitter().rows();
  if (!tried.best()) return out;
  // Try missing topologies, then report the best net.
  search_around(tried, options, progress);
  const FittedNet& best = *tried.best();
  out.inflation = model_error(tried);
  const double weight = 1 / (out.inflation * out.inflation);
  out.found = true;
  out.bands = best.bands;
  out.misfit = best.fit.misfit;
  out.converged = best.fit.converged;
  const std::vector<std::string> names = candidate_names(tried.fitter().candidate());
  // Compute evidence and verdict of each candidate.
  for (int c = 0; c < static_cast<int>(names.size()); ++c) {
    BandVerdict band;
    band.name = names[c];
    band.evidence = weight * evidence(tried, c);
    if (std::abs(band.evidence) >= options.doubt)
      band.verdict = band.evidence > 0 ? Verdict::kYes : Verdict::kNo;
    collect_fit_quality(tried, c, band, out);
    out.verdicts.push_back(band);
  }
  // Report nets that the data cannot distinguish from the best one.
  out.alike = tried.nets_within(options.doubt / weight);
  set_stiffness(tried, out);
  out.groups = groups_of(tried, out, best.fit.misfit + options.doubt / weight);
  out.tried = tried.size();
  out.solves = tried.fitter().solves();
  return out;
}

double model_error(const FittedNets& tried) {
  const FittedNet* best = tried.best();
  if (!best) return 1;
  const auto bands = std::count(best->bands.begin(), best->bands.end(), true);
  const auto spare = best->fit.r.size() - bands;
  return spare > 0 ? std::max(1.0, std::sqrt(best->fit.misfit / static_cast<double>(spare))) : 1;
}

}  // namespace thenar
