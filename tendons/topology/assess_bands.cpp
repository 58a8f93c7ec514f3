#include "tendons/topology/assess_bands.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Eigenvalues>

#include "base/numbers.h"

namespace thenar {
namespace {

// The data do not feel a band with less chi^2 per unit of log EA [1]
constexpr double kBlindSlope = 1e-3;

double evidence(const FittedNets& tried, int band) {
  const double without = tried.min_misfit(band, false), with = tried.min_misfit(band, true);
  return std::isinf(without) && std::isinf(with) ? 0 : without - with;
}

/// Reads convergence and residuals of the fits behind the evidence on one band.
void state_fits(const FittedNets& tried, int band, BandVerdict& verdict, InferredNet& out) {
  for (bool present : {false, true})
    if (const FittedNet* net = tried.best_where(band, present)) {
      verdict.converged = verdict.converged && net->fit.converged;
      out.residual = std::max(out.residual, net->fit.residual);
    }
}

/// Bands of little evidence, least first.
std::vector<int> doubtful(const FittedNets& tried, int bands, double below) {
  std::vector<int> open;
  for (int c = 0; c < bands; ++c)
    if (std::abs(evidence(tried, c)) < below) open.push_back(c);
  std::sort(open.begin(), open.end(), [&](int a, int b) {
    return std::abs(evidence(tried, a)) < std::abs(evidence(tried, b));
  });
  return open;
}

/// Single changes of the best net, again from whatever is better.
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

void try_pairs(FittedNets& tried, const AssessOptions& options, double below,
               const Progress& progress) {
  const FittedNet here = *tried.best();
  // Pairs of bands with little evidence.
  const std::vector<int> open = doubtful(tried, static_cast<int>(here.bands.size()), below);
  int left = options.max_pairs;
  for (std::size_t b = 1; b < open.size(); ++b)
    for (std::size_t a = 0; a < b && left > 0 && !progress.stop(); ++a, --left)
      (void)tried.fit(flipped(flipped(here.bands, open[a]), open[b]), here.fit.s);
}

void try_combinations(FittedNets& tried, const AssessOptions& options, double below,
                      const Progress& progress) {
  const FittedNet here = *tried.best();
  // All combinations of the most doubtful bands.
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
  // The best net itself, then its best rival in each band.
  tried.settle(tried.best()->bands, tried.best()->fit.s);
  const FittedNet here = *tried.best();
  for (int c = 0; c < static_cast<int>(here.bands.size()) && !progress.stop(); ++c) {
    const FittedNet* rival = tried.best_where(c, !here.bands[c]);
    tried.settle(Topology(rival ? rival->bands : flipped(here.bands, c)), here.fit.s);
  }
}

/// Changes of the best net, until none is better by more than a fit's tolerance.
void search_around(FittedNets& tried, const AssessOptions& options, const Progress& progress) {
  constexpr double kBetterMisfit = 0.1;  // Least fall of chi^2 of a better net [1]
  for (int round = 0; round < options.max_rounds && !progress.stop(); ++round) {
    progress(0.7 + 0.3 * round / options.max_rounds, "changes of the best net");
    const double before = tried.best()->fit.misfit;
    // Single changes, then pairs and combinations where the evidence is small.
    try_singles(tried);
    const double error = std::pow(model_error(tried), 2);
    try_pairs(tried, options, options.screen * error, progress);
    try_combinations(tried, options, options.doubt * error, progress);
    settle_rivals(tried, progress);
    if (tried.best()->fit.misfit > before - kBetterMisfit) return;
  }
}

/// Information on log EA in the best net (candidates, candidates).
Eigen::MatrixXd information(const BandFit& fit) {
  const Eigen::MatrixXd J = fit.J * fit.s.asDiagonal();
  return J.transpose() * J;
}

/// Standard deviations of log EA, others free; infinite along blind directions.
void state_stiffness(FittedNets& tried, InferredNet& out) {
  const FittedNet& best = *tried.best();
  // Eigenvectors of the information with no eigenvalue are not felt by any reading.
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(information(best.fit));
  const Eigen::VectorXd& lambda = eigen.eigenvalues();
  Eigen::VectorXd variance = Eigen::VectorXd::Zero(lambda.size());
  for (Eigen::Index k = 0; k < lambda.size(); ++k) {
    // Variance along each eigenvector.
    const Eigen::VectorXd v = eigen.eigenvectors().col(k);
    const bool present = best.fit.s.cwiseProduct(v).norm() > 1e-9;
    if (lambda(k) < kBlindSlope && present) out.blind.push_back(v);
    for (Eigen::Index c = 0; c < v.size(); ++c)
      if (std::abs(v(c)) > 1e-6) variance(c) += v(c) * v(c) / std::max(lambda(k), 1e-300);
  }
  // Stiffness in the best net, its deviation, and whether the data say more than the bounds.
  for (std::size_t c = 0; c < out.verdicts.size(); ++c) {
    const auto i = static_cast<Eigen::Index>(c);
    out.verdicts[c].EA = best.fit.s(i) * tried.fitter().typical_EA()(i);
    const double sd = out.inflation * std::sqrt(variance(i));
    out.verdicts[c].EA_sd = best.bands[c] && sd < 1e3 ? sd : kInfinity;
    const CandidateBand& bounds = tried.fitter().candidate().candidates[c];
    out.verdicts[c].EA_told =
        out.verdicts[c].EA_sd < std::log(bounds.max_EA / bounds.min_EA) / std::sqrt(12.0);
  }
}

/// Returns whether, of the four ways to have or lack two bands in the best net, one was tried and
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

/// A root for each band: undecided bands that depend on each other share it.
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

/// The sets of these bands that equally good nets have, each once.
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

std::vector<BandGroup> groups_of(FittedNets& tried, const InferredNet& found, double limit) {
  const int n = static_cast<int>(found.verdicts.size());
  const std::vector<int> root = roots_of(tried, found.verdicts, limit);
  // One group for each root with several bands.
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
  // Try what is missing, then take stock of the best net.
  search_around(tried, options, progress);
  const FittedNet& best = *tried.best();
  out.inflation = model_error(tried);
  const double weight = 1 / (out.inflation * out.inflation);
  out.found = true;
  out.bands = best.bands;
  out.misfit = best.fit.misfit;
  out.converged = best.fit.converged;
  const std::vector<std::string> names = candidate_names(tried.fitter().candidate());
  // Evidence on each candidate, and its verdict.
  for (int c = 0; c < static_cast<int>(names.size()); ++c) {
    BandVerdict band;
    band.name = names[c];
    band.evidence = weight * evidence(tried, c);
    if (std::abs(band.evidence) >= options.doubt)
      band.verdict = band.evidence > 0 ? Verdict::kYes : Verdict::kNo;
    state_fits(tried, c, band, out);
    out.verdicts.push_back(band);
  }
  // Nets that the data cannot tell from the best one.
  out.alike = tried.nets_within(options.doubt / weight);
  state_stiffness(tried, out);
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
