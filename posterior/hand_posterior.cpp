#include "posterior/hand_posterior.h"

#include <cmath>
#include <limits>

#include "base/error.h"
#include "posterior/hand_posterior_parts.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using internal::Displaced;
using internal::EntryMotion;
using internal::PosteriorParts;
using Points = Eigen::Ref<const MatrixXd>;

/// d/dx from d/du of each specimen.
void add_by_entries(const PosteriorParts& parts, const EntryMotion& motion,
                    const std::vector<MatrixXd>& by_u, MatrixXd& gradient) {
  for (Index p = 0; p < motion.log_noise.cols(); ++p)
    for (std::size_t i = 0; i < parts.entries.coordinates.size(); ++i) {
      const CoordinateEntry& entry = parts.entries.coordinates[i];
      const auto at = static_cast<Index>(i);
      double by_y = 0;
      for (std::size_t s = 0; s < by_u.size(); ++s)
        if (entry.specimen < 0 || entry.specimen == static_cast<int>(s))
          by_y += by_u[s](entry.coordinate, p);
      gradient(at, p) += by_y * motion.by_x(at, p);
      if (entry.centre >= 0)
        gradient(entry.centre, p) += by_y * motion.by_centre(at, p) * motion.by_x(entry.centre, p);
      if (entry.spread >= 0)
        gradient(parts.entries.spread_at() + entry.spread, p) +=
            parts.options.spread_sd * by_y * motion.by_spread(at, p);
    }
}

/// Adds one experiment to the likelihood, and to its derivatives if they are wanted.
void add_experiment(const PosteriorParts& parts, int e, const Displaced& displaced,
                    const EntryMotion& motion, std::vector<MatrixXd>& by_u, Densities& at) {
  const int s = parts.problem.specimen_of(e);
  const MatrixXd& u = displaced.u[s];
  const ForceKernel& kernel = parts.kernels[e];
  const bool wanted = at.likelihood_gradient.size() > 0;
  const ForceKernel::Recorded recorded =
      wanted ? kernel.record(u) : ForceKernel::Recorded{kernel.forces(u), nullptr};
  MatrixXd by_force(recorded.forces.rows(), u.cols());
  for (Index p = 0; p < u.cols(); ++p) {
    const DataDensity one = data_density(parts.model, parts.data[e], recorded.forces.col(p).data(),
                                         motion.log_noise(e, p), by_force.col(p).data(), nullptr);
    at.log_likelihood[p] += one.log_density;
    if (wanted && parts.entries.noises > 0)
      at.likelihood_gradient(parts.entries.noise_at() + e, p) +=
          parts.options.noise_sd * one.by_log_noise;
  }
  if (wanted) by_u[s] += kernel.pull_back(recorded, by_force);
}

/// u of each specimen where bounds hold some coordinates; zero where an entry of x moves it.
std::vector<Eigen::VectorXd> resting(const FitProblem& problem, const PosteriorEntries& entries) {
  Eigen::VectorXd z = Eigen::VectorXd::Zero(problem.size());
  for (const int i : entries.held) z[i] = problem.lower()[i];
  std::vector<Eigen::VectorXd> rest;
  for (std::size_t s = 0; s < problem.specimens().size(); ++s) {
    rest.push_back(problem.displacements(z, static_cast<int>(s)));
    for (const CoordinateEntry& entry : entries.coordinates) rest.back()[entry.coordinate] = 0;
  }
  return rest;
}

}  // namespace

PosteriorOptions posterior_options(const PosteriorBeliefs& beliefs) {
  PosteriorOptions options;
  options.learn_noise = beliefs.noise_sd > 0;
  options.noise_sd = beliefs.noise_sd;
  options.learn_spread = beliefs.spread_sd > 0;
  options.spread_sd = beliefs.spread_sd;
  options.sphere_priors = beliefs.sphere_priors;
  return options;
}

HandPosterior::HandPosterior(FitProblem problem, const PosteriorOptions& options)
    : parts_(new Parts{{std::move(problem), options, {}, ForceNoise(0), {}, {}, {}}}) {
  Parts& parts = *parts_;
  require(!options.learn_noise || options.noise_sd > 0, "noise_sd must be > 0, got {}",
          options.noise_sd);
  require(!options.learn_spread || options.spread_sd > 0, "spread_sd must be > 0, got {}",
          options.spread_sd);
  const FitProblem& fit = parts.problem;
  parts.entries =
      list_entries(fit, options.learn_noise, options.learn_spread, options.sphere_priors);
  require(!parts.entries.coordinates.empty(),
          "nothing to sample: every free parameter shifts an axis along itself, or is held by its "
          "bounds");
  parts.model = ForceNoise(fit.robust_scale());
  for (std::size_t e = 0; e < fit.experiments().size(); ++e) {
    parts.data.push_back(
        observed_forces(fit.digit(), fit.plans()[e], fit.experiments()[e], parts.model));
    parts.kernels.emplace_back(fit.digit(), fit.parameters(), parts.data.back().plan);
  }
  parts.rest = resting(fit, parts.entries);
}

HandPosterior::~HandPosterior() = default;

int HandPosterior::size() const { return parts_->entries.size(); }
int HandPosterior::lanes() const { return ForceKernel::lanes(); }
const FitProblem& HandPosterior::problem() const { return parts_->problem; }
const PosteriorOptions& HandPosterior::options() const { return parts_->options; }

Densities HandPosterior::evaluate(const Points& x, WithGradient want) const {
  require(x.rows() == size(), "the posterior has {} entries, got {}", size(), x.rows());
  const bool wanted = want == WithGradient::kYes;
  const EntryMotion motion = internal::move(*parts_, x);
  const Displaced displaced = internal::displace(*parts_, motion);
  Densities at{Eigen::VectorXd(x.cols()), Eigen::VectorXd::Zero(x.cols()), {}, {}};
  if (wanted) {
    at.prior_gradient.resize(x.rows(), x.cols());
    at.likelihood_gradient = MatrixXd::Zero(x.rows(), x.cols());
  }
  internal::set_prior(*parts_, motion, at.log_prior, at.prior_gradient);
  std::vector<MatrixXd> by_u;
  for (const MatrixXd& u : displaced.u)
    by_u.push_back(MatrixXd::Zero(wanted ? u.rows() : 0, wanted ? u.cols() : 0));
  for (int e = 0; e < static_cast<int>(parts_->data.size()); ++e)
    add_experiment(*parts_, e, displaced, motion, by_u, at);
  if (wanted) add_by_entries(*parts_, motion, by_u, at.likelihood_gradient);
  for (Index p = 0; p < x.cols(); ++p)
    if (displaced.broken[p] != 0) at.log_likelihood[p] = std::nan("");
  return at;
}

MatrixXd HandPosterior::forces(const Points& x, int e) const {
  require(x.rows() == size(), "the posterior has {} entries, got {}", size(), x.rows());
  const Displaced displaced = internal::displace(*parts_, internal::move(*parts_, x));
  MatrixXd forces = parts_->kernels.at(e)
                        .forces(displaced.u[parts_->problem.specimen_of(e)])
                        .topRows(3 * parts_->data[e].trials);
  for (Index p = 0; p < x.cols(); ++p)
    if (displaced.broken[p] != 0) forces.col(p).setConstant(std::nan(""));
  return forces;
}

MatrixXd HandPosterior::pointwise(const Points& x) const {
  require(x.rows() == size(), "the posterior has {} entries, got {}", size(), x.rows());
  const EntryMotion motion = internal::move(*parts_, x);
  const Displaced displaced = internal::displace(*parts_, motion);
  Index trials = 0, tasks = 0;
  for (const ObservedForces& data : parts_->data) {
    trials += data.trials;
    tasks += static_cast<Index>(data.tasks.size());
  }
  MatrixXd out(trials + tasks, x.cols());
  Index trial = 0, task = trials;
  for (std::size_t e = 0; e < parts_->data.size(); ++e) {
    const ObservedForces& data = parts_->data[e];
    const MatrixXd forces =
        parts_->kernels[e].forces(displaced.u[parts_->problem.specimen_of(static_cast<int>(e))]);
    Eigen::VectorXd by_force(forces.rows());
    const auto own = static_cast<Index>(data.tasks.size());
    Eigen::VectorXd summands(data.trials + own);
    for (Index p = 0; p < x.cols(); ++p) {
      (void)data_density(parts_->model, data, forces.col(p).data(),
                         motion.log_noise(static_cast<Index>(e), p), by_force.data(),
                         summands.data());
      if (displaced.broken[p] != 0) summands.setConstant(std::nan(""));
      out.block(trial, p, data.trials, 1) = summands.head(data.trials);
      out.block(task, p, own, 1) = summands.tail(own);
    }
    trial += data.trials;
    task += own;
  }
  return out;
}

}  // namespace thenar
