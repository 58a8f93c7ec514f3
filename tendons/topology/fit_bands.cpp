#include "tendons/topology/fit_bands.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/lists.h"

namespace thenar {
namespace {

/// Appends entries.
void append(Eigen::VectorXd& to, const Eigen::VectorXd& what) {
  to.conservativeResize(to.size() + what.size());
  to.tail(what.size()) = what;
}

/// Converts s to the fit's unknown of one band,  x = log(1 + s / kSoftRatio),  and back.
double unknown_of(double s) { return std::log1p(s / kSoftRatio); }
Eigen::VectorXd stiffness_of(const Eigen::VectorXd& x) {
  return x.unaryExpr([](double u) { return kSoftRatio * std::expm1(u); });
}

}  // namespace

BandFitter::BandFitter(const CandidateNet& candidate, const std::vector<TendonRecord>& records,
                       const BoundedFitOptions& options)
    : forward_(candidate, {}),
      options_(options),
      typical_EA_(static_cast<Eigen::Index>(candidate.candidates.size())) {
  for (Eigen::Index c = 0; c < typical_EA_.size(); ++c)
    typical_EA_(c) = candidate.net.bands[candidate.candidates[c].band].EA;
  for (const TendonRecord& record : records) add(record);
}

void BandFitter::add(const TendonRecord& record) {
  check_record(candidate(), record);
  forward_.add(record.test);
  append(measured_, record.measured);
  append(sd_, record.sd);
}

FitResiduals BandFitter::residuals(const NetPrediction& forecast) const {
  FitResiduals out;
  // Return no residuals where the net does not carry the loads.
  out.possible = forecast.holds;
  if (!out.possible) return out;
  out.r = (forecast.value - measured_).cwiseQuotient(sd_);
  if (forecast.by_EA.size())
    out.J = sd_.cwiseInverse().asDiagonal() * forecast.by_EA * typical_EA_.asDiagonal();
  return out;
}

Eigen::VectorXd BandFitter::stiffness(double CandidateBand::*EA) const {
  return Eigen::VectorXd::NullaryExpr(typical_EA_.size(), [&](Eigen::Index c) {
    return candidate().candidates[c].*EA / typical_EA_(c);
  });
}

BandFit BandFitter::fit(const Presences& presence, const Eigen::VectorXd& start,
                        const Eigen::VectorXd& price) {
  const Eigen::Index n = typical_EA_.size();
  require(static_cast<Eigen::Index>(presence.size()) == n && start.size() == n,
          "wanted {} presences and stiffnesses, got {} and {}", n, presence.size(), start.size());
  // Set the bounds of the unknowns by presence.
  BoundedFit problem;
  problem.lower = problem.upper = Eigen::VectorXd::Zero(n);
  problem.price = price.size() ? price : Eigen::VectorXd::Zero(n);
  for (Eigen::Index c = 0; c < n; ++c) {
    const CandidateBand& band = candidate().candidates[c];
    if (presence[c] == Presence::kYes) problem.lower(c) = unknown_of(band.min_EA / typical_EA_(c));
    if (presence[c] == Presence::kEither) problem.lower(c) = unknown_of(kGhostRatio);
    if (presence[c] != Presence::kNo) problem.upper(c) = unknown_of(band.max_EA / typical_EA_(c));
  }
  // Fit with warm starts; fit again without them if a net followed the wrong equilibrium.
  const Eigen::VectorXd x0 = start.unaryExpr(&unknown_of);
  Followed warm = follow(problem, x0, WarmStart::kKept);
  if (!warm.strayed) return std::move(warm.fit);
  BandFit cold = follow(problem, x0, WarmStart::kNone).fit;
  const bool better = cold.holds && (!warm.fit.holds || cold.misfit < warm.fit.misfit);
  return better ? std::move(cold) : std::move(warm.fit);
}

BandFitter::Followed BandFitter::follow(BoundedFit problem, const Eigen::VectorXd& x0,
                                        WarmStart warm_start) {
  // Define the residuals by the unknowns; each net starts near the previous one.
  NetPrediction near;
  problem.residuals = [&](const Eigen::VectorXd& x, Sensitivities slopes) {
    const Eigen::VectorXd s = stiffness_of(x);
    NetPrediction forecast = forward_.predict(s.cwiseProduct(typical_EA_), slopes, &near);
    FitResiduals at = residuals(forecast);
    if (at.J.size()) at.J = at.J * Eigen::VectorXd(s.array() + kSoftRatio).asDiagonal();
    if (forecast.holds && warm_start == WarmStart::kKept) near = std::move(forecast);
    return at;
  };
  // Solve by least squares within bounds.
  const BoundedFitResult found = bounded_least_squares(problem, x0, options_);
  Followed out;
  if (!found.possible) return out;
  BandFit& fit = out.fit;
  fit.s = stiffness_of(found.x);
  // Predict the result again without a warm start.
  const NetPrediction forecast =
      forward_.predict(fit.s.cwiseProduct(typical_EA_), Sensitivities::kWith);
  FitResiduals at = residuals(forecast);
  fit.holds = at.possible;
  out.strayed = !at.possible;
  if (!fit.holds) return out;
  // Report the quality of the fit.
  fit.converged = found.converged;
  fit.residual = forecast.residual;
  fit.misfit = at.r.squaredNorm();
  fit.r = std::move(at.r);
  fit.J = std::move(at.J);
  out.strayed = std::abs(fit.misfit - found.residuals.r.squaredNorm()) >
                std::max(options_.tolerance, options_.relative_tolerance * fit.misfit);
  return out;
}

Presences topology_presences(const std::vector<bool>& bands) {
  return transformed(bands, [](bool band) { return band ? Presence::kYes : Presence::kNo; });
}

}  // namespace thenar
