#include "posterior/hand_posterior.h"

#include <cmath>

#include "base/error.h"
#include "base/lists.h"
#include "base/random_stream.h"
#include "kinematics_fit/specimen_prior.h"
#include "posterior/posterior_parts.h"
#include "posterior/tilt_density.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using internal::EntryMotion;
using internal::PosteriorParts;
using internal::SpecimenCoordinates;
using Points = Eigen::Ref<const MatrixXd>;

/// Transforms derivatives by u of each specimen to derivatives by x.
void add_by_entries(const PosteriorParts& parts, const EntryMotion& motion,
                    const std::vector<MatrixXd>& by_u, MatrixXd& gradient) {
  for (Index p = 0; p < motion.log_noise.cols(); ++p)
    for (std::size_t i = 0; i < parts.entries.coordinates.size(); ++i) {
      const CoordinateEntry& entry = parts.entries.coordinates[i];
      const auto at = static_cast<Index>(i);
      // Sum over the specimens that the entry moves.
      double by_y = 0;
      for (std::size_t s = 0; s < by_u.size(); ++s)
        if (entry.specimen < 0 || entry.specimen == static_cast<int>(s))
          by_y += by_u[s](entry.coordinate, p);
      // Apply the chain rule to the entry, to the centre of its bounds and to its scale factor.
      gradient(at, p) += by_y * motion.by_x(at, p);
      if (entry.centre >= 0)
        gradient(entry.centre, p) += by_y * motion.by_centre(at, p) * motion.by_x(entry.centre, p);
      if (entry.specimen_scale >= 0)
        gradient(parts.entries.specimen_scale_offset() + entry.specimen_scale, p) +=
            parts.options.specimen_scale_sd * by_y * motion.by_log_specimen_scale(at, p);
    }
}

/// Adds one experiment to the likelihood and, if requested, to its derivatives.
void add_experiment(const PosteriorParts& parts, int e, const SpecimenCoordinates& displaced,
                    const EntryMotion& motion, std::vector<MatrixXd>& by_u, Densities& at) {
  // Predict the forces at all points; record a tape only for derivatives.
  const int s = parts.problem.specimen_of(e);
  const MatrixXd& u = displaced.u[s];
  const ForceKernel& kernel = parts.kernels[e];
  const bool wanted = at.likelihood_gradient.size() > 0;
  const ForceKernel::Recorded recorded =
      wanted ? kernel.record(u) : ForceKernel::Recorded{kernel.forces(u), nullptr};

  // Add the log likelihood of each point, with its derivatives by forces and by log noise.
  MatrixXd by_force(recorded.forces.rows(), u.cols());
  for (Index p = 0; p < u.cols(); ++p) {
    const DataDensity one = data_density(parts.model, parts.data[e], recorded.forces.col(p).data(),
                                         motion.log_noise(e, p), by_force.col(p).data(), nullptr);
    at.log_likelihood[p] += one.log_density;
    if (wanted && parts.entries.noise_scales > 0)
      at.likelihood_gradient(parts.entries.noise_scale_offset() + e, p) +=
          parts.options.noise_sd * one.by_log_noise;
  }

  // Propagate the derivatives from forces to the coordinates of the specimen.
  if (wanted) by_u[s] += kernel.adjoint_product(recorded, by_force);
}

/// Returns u of each specimen if all entries of x are zero; zero in coordinates that an entry
/// moves.
std::vector<Eigen::VectorXd> constant_coordinates(const FitProblem& problem,
                                                  const PosteriorEntries& entries) {
  // Entries between equal bounds have the value of the bound.
  Eigen::VectorXd z = Eigen::VectorXd::Zero(problem.size());
  for (const int i : entries.fixed) z[i] = problem.coordinates().lower()[i];
  std::vector<Eigen::VectorXd> rest;
  for (std::size_t s = 0; s < problem.specimens().size(); ++s) {
    // Coordinates that an entry of x moves are computed later.
    rest.push_back(displacements(problem.coordinates(), z, static_cast<int>(s)));
    for (const CoordinateEntry& entry : entries.coordinates) rest.back()[entry.coordinate] = 0;
  }
  return rest;
}

}  // namespace

PosteriorOptions posterior_options(const PosteriorPriors& beliefs) {
  PosteriorOptions options;
  options.learn_noise = beliefs.noise_sd > 0;
  options.noise_sd = beliefs.noise_sd;
  options.learn_specimen_scale = beliefs.specimen_scale_sd > 0;
  options.specimen_scale_sd = beliefs.specimen_scale_sd;
  options.sphere_priors = beliefs.sphere_priors;
  return options;
}

HandPosterior::HandPosterior(FitProblem problem, const PosteriorOptions& options)
    : parts_(new Parts{{std::move(problem), options, {}, ForceNoise(0), {}, {}, {}}}) {
  Parts& parts = *parts_;
  require(
      !parts.problem.digit().net,
      "a posterior has no nets: its force kernel is written for tendons that are linear in their "
      "tensions; fit the net, or sample with the subject's own hood");
  for (const ExperimentPlan& plan : parts.problem.plans())
    require(plan.sites.empty(),
            "a posterior knows forces of the tip alone; leave out the trials that were measured at "
            "other segments ('at'), or ask `thenar fit` and `thenar predict`");
  require(parts.problem.scaling() == Scaling::kSubject,
          "a posterior has one size for all specimens, not those measured outside");
  require(!options.learn_noise || options.noise_sd > 0, "noise_sd must be > 0, got {}",
          options.noise_sd);
  require(!options.learn_specimen_scale || options.specimen_scale_sd > 0,
          "spread_sd must be > 0, got {}", options.specimen_scale_sd);

  // List the entries of x.
  const FitProblem& fit = parts.problem;
  parts.entries = list_entries(fit, options);
  require(!parts.entries.coordinates.empty(),
          "nothing to sample: every free parameter shifts an axis along itself, or is held by its "
          "bounds");

  // Prepare measurements and force kernel of every experiment.
  parts.model = ForceNoise(fit.robust_scale());
  for (std::size_t e = 0; e < fit.experiments().size(); ++e) {
    parts.data.push_back(
        observed_forces(fit.digit(), fit.plans()[e], fit.experiments()[e], parts.model));
    parts.kernels.emplace_back(fit.digit(), fit.parameters(), parts.data.back().plan);
  }
  parts.rest = constant_coordinates(fit, parts.entries);
}

HandPosterior::~HandPosterior() = default;

int HandPosterior::size() const { return parts_->entries.size(); }
int HandPosterior::preferred_batch_size() const { return ForceKernel::lanes(); }
const FitProblem& HandPosterior::problem() const { return parts_->problem; }
const PosteriorOptions& HandPosterior::options() const { return parts_->options; }

Densities HandPosterior::evaluate(const Points& x, WithGradient want) const {
  require(x.rows() == size(), "the posterior has {} entries, got {}", size(), x.rows());
  const bool wanted = want == WithGradient::kYes;
  // Compute the coordinates of every specimen from x.
  const EntryMotion motion = internal::move_entries(*parts_, x);
  const SpecimenCoordinates displaced = internal::displace_specimens(*parts_, motion);
  Densities at{Eigen::VectorXd(x.cols()), Eigen::VectorXd::Zero(x.cols()), {}, {}};
  if (wanted) {
    at.prior_gradient.resize(x.rows(), x.cols());
    at.likelihood_gradient = MatrixXd::Zero(x.rows(), x.cols());
  }

  internal::set_prior(*parts_, motion, at.log_prior, at.prior_gradient);

  // Add the likelihood of each experiment, then transform derivatives by coordinates to derivatives
  // by x.
  std::vector<MatrixXd> by_u;
  for (const MatrixXd& u : displaced.u)
    by_u.emplace_back(MatrixXd::Zero(wanted ? u.rows() : 0, wanted ? u.cols() : 0));
  for (int e = 0; e < static_cast<int>(parts_->data.size()); ++e)
    add_experiment(*parts_, e, displaced, motion, by_u, at);
  if (wanted) add_by_entries(*parts_, motion, by_u, at.likelihood_gradient);
  // Mark points whose coordinates are not finite.
  for (Index p = 0; p < x.cols(); ++p)
    if (displaced.non_finite[p] != 0) at.log_likelihood[p] = std::nan("");
  return at;
}

MatrixXd HandPosterior::forces(const Points& x, int e) const {
  require(x.rows() == size(), "the posterior has {} entries, got {}", size(), x.rows());
  // Predict the trials only, without the unit pulls of tasks.
  const SpecimenCoordinates displaced =
      internal::displace_specimens(*parts_, internal::move_entries(*parts_, x));
  MatrixXd forces = parts_->kernels.at(e)
                        .forces(displaced.u[parts_->problem.specimen_of(e)])
                        .topRows(3 * parts_->data[e].trials);
  for (Index p = 0; p < x.cols(); ++p)
    if (displaced.non_finite[p] != 0) forces.col(p).setConstant(std::nan(""));
  return forces;
}

MatrixXd HandPosterior::pointwise(const Points& x) const {
  require(x.rows() == size(), "the posterior has {} entries, got {}", size(), x.rows());
  // Compute the coordinates of every specimen, and allocate rows for trials first, then tasks.
  const EntryMotion motion = internal::move_entries(*parts_, x);
  const SpecimenCoordinates displaced = internal::displace_specimens(*parts_, motion);
  Index trials = 0, tasks = 0;
  for (const ObservedForces& data : parts_->data) {
    trials += data.trials;
    tasks += static_cast<Index>(data.tasks.size());
  }
  MatrixXd out(trials + tasks, x.cols());
  Index trial = 0, task = trials;
  for (std::size_t e = 0; e < parts_->data.size(); ++e) {
    // Predict the forces of the experiment at all points.
    const ObservedForces& data = parts_->data[e];
    const MatrixXd forces =
        parts_->kernels[e].forces(displaced.u[parts_->problem.specimen_of(static_cast<int>(e))]);
    Eigen::VectorXd by_force(forces.rows());
    const auto own = static_cast<Index>(data.tasks.size());
    Eigen::VectorXd summands(data.trials + own);
    // Split the summands of each point into trials and tasks.
    for (Index p = 0; p < x.cols(); ++p) {
      (void)data_density(parts_->model, data, forces.col(p).data(),
                         motion.log_noise(static_cast<Index>(e), p), by_force.data(),
                         summands.data());
      if (displaced.non_finite[p] != 0) summands.setConstant(std::nan(""));
      out.block(trial, p, data.trials, 1) = summands.head(data.trials);
      out.block(task, p, own, 1) = summands.tail(own);
    }
    trial += data.trials;
    task += own;
  }
  return out;
}

// Conversions between a posterior's x, the z of its fit, and parameters.
namespace {

using Eigen::VectorXd;

constexpr std::uint32_t kPriorStream = 0x7072696f;  // purpose of the random stream of prior draws

/// Returns the values of some parameters [SI].
VectorXd values_of(const FitParameters& parameters, const std::vector<int>& which,
                   const VectorXd& u) {
  const std::vector<double> all = parameter_values<double>(parameters, u);
  VectorXd some(static_cast<Index>(which.size()));
  for (Index i = 0; i < some.size(); ++i) some[i] = all[which[i]];
  return some;
}

/// Returns z(x) of an entry with specimen_scale factor k.
double entry_image(const CoordinateEntry& entry, double k, double x) {
  if (entry.table) return entry.table->evaluate(x).z;
  const auto bounds = entry.bounds(k);
  return bounds ? bounds->evaluate(x).z : x;
}

/// Returns z of an entry whose bounds are relative to its population's entry, which must be set in
/// z.
double centred_entry(const internal::PosteriorParts& parts, const CoordinateEntry& entry, double k,
                     const VectorXd& z, double x) {
  const CoordinateEntries& coordinate = parts.problem.coordinates().entries(entry.coordinate);
  const double population = coordinate.population_sd * z[coordinate.population];
  if (k == 1) return x;
  return deviation_entry(coordinate, population,
                         specimen_deviation(coordinate, population, x, k).u);
}

/// Returns x of an entry from its contribution to the coordinate.
double entry_from(const CoordinateEntry& entry, double k, double y) {
  const double z = y / (k * entry.sd);
  if (entry.table) return entry.table->inverse(z);
  const auto bounds = entry.bounds(k);
  return bounds ? bounds->inverse(z) : z;
}

}  // namespace

std::vector<std::string> HandPosterior::names() const {
  // Name the entries of the fit, then the factors of noise and between specimens.
  const std::vector<std::string> all = parts_->problem.coordinates().names();
  std::vector<std::string> names;
  for (const CoordinateEntry& entry : parts_->entries.coordinates) names.push_back(all[entry.z]);
  if (parts_->entries.noise_scales > 0)
    for (const Experiment& experiment : parts_->problem.experiments())
      names.push_back("noise/" + experiment.name);
  for (const std::string& kind : specimen_scale_kinds()) names.push_back("spread/" + kind);
  return names;
}

std::vector<std::string> HandPosterior::specimen_scale_kinds() const {
  return transformed(parts_->entries.specimen_scales,
                     [](ParameterKind kind) { return name_of(kind); });
}

std::vector<int> HandPosterior::moving_parameters() const {
  const FitParameters& parameters = parts_->problem.parameters();
  // Collect all parameters of the coordinates that some entry moves.
  std::vector<char> moves(parameters.coordinates(), 0);
  for (const CoordinateEntry& entry : parts_->entries.coordinates) moves[entry.coordinate] = 1;
  std::vector<int> moving;
  for (std::size_t p = 0; p < parameters.all.size(); ++p)
    if (parameters.coordinate[p] >= 0 && moves[parameters.coordinate[p]] != 0)
      moving.push_back(static_cast<int>(p));
  return moving;
}

VectorXd HandPosterior::fit_coordinates(const VectorXd& x) const {
  require(x.size() == size(), "the posterior has {} entries, got {}", size(), x.size());
  // Entries between equal bounds have the value of the bound.
  const PosteriorEntries& entries = parts_->entries;
  VectorXd z = VectorXd::Zero(parts_->problem.size());
  for (const int fixed : entries.fixed) z[fixed] = parts_->problem.coordinates().lower()[fixed];
  for (std::size_t i = 0; i < entries.coordinates.size(); ++i) {
    // Apply the map of each entry with the factor of its kind.
    const CoordinateEntry& entry = entries.coordinates[i];
    const double k = entry.specimen_scale < 0
                         ? 1
                         : std::exp(parts_->options.specimen_scale_sd *
                                    x[entries.specimen_scale_offset() + entry.specimen_scale]);
    const double own = x[i];
    z[entry.z] = entry.centre < 0 ? k * entry_image(entry, k, own)
                                  : centred_entry(*parts_, entry, k, z, own);
  }
  return z;
}

VectorXd HandPosterior::from_fit_coordinates(const VectorXd& z) const {
  require(z.size() == parts_->problem.size() && z.allFinite(),
          "the fit has {} coordinates, all finite; got {}", parts_->problem.size(), z.size());
  // Remove the gauges, for which x has no entries.
  const PosteriorEntries& entries = parts_->entries;
  const VectorXd at = without_gauges(parts_->problem, entries.gauges, z);
  VectorXd x = VectorXd::Zero(size());
  for (std::size_t i = 0; i < entries.coordinates.size(); ++i) {
    const CoordinateEntry& entry = entries.coordinates[i];
    x[i] = entry.centre < 0 ? entry_from(entry, 1, entry.sd * at[entry.z]) : at[entry.z];
  }
  return x;
}

PosteriorValues HandPosterior::values(const Eigen::Ref<const Eigen::MatrixXd>& x) const {
  require(x.rows() == size(), "the posterior has {} entries, got {}", size(), x.rows());
  // Compute the parameters that move, of the population and of each specimen.
  const FitProblem& problem = parts_->problem;
  const PosteriorEntries& entries = parts_->entries;
  const std::vector<int> moving = moving_parameters();
  const auto rows = static_cast<Index>(moving.size());
  PosteriorValues out;
  out.population.resize(rows, x.cols());
  out.specimens.assign(problem.specimens().size(), Eigen::MatrixXd(rows, x.cols()));
  for (Index p = 0; p < x.cols(); ++p) {
    // Convert each point to the fit's z.
    const VectorXd z = fit_coordinates(x.col(p));
    const auto row = [&](int specimen) {
      return values_of(problem.parameters(), moving,
                       displacements(problem.coordinates(), z, specimen));
    };
    out.population.col(p) = row(kPopulation);
    for (std::size_t s = 0; s < out.specimens.size(); ++s)
      out.specimens[s].col(p) = row(static_cast<int>(s));
  }

  // Compute the factors of noise and between specimens; 1 if they are not inferred.
  const auto experiments = static_cast<Index>(problem.experiments().size());
  out.noise = Eigen::MatrixXd::Ones(experiments, x.cols());
  if (entries.noise_scales > 0)
    out.noise = (parts_->options.noise_sd * x.middleRows(entries.noise_scale_offset(), experiments))
                    .array()
                    .exp();
  out.specimen_scale = (parts_->options.specimen_scale_sd *
                        x.bottomRows(static_cast<Index>(entries.specimen_scales.size())))
                           .array()
                           .exp();
  return out;
}

VectorXd HandPosterior::draw_prior(unsigned seed, unsigned number) const {
  // Draw standard normal entries.
  RandomStream random(seed, number, 0, kPriorStream);
  const PosteriorEntries& entries = parts_->entries;
  VectorXd x(size());
  for (Index i = 0; i < x.size(); ++i) x[i] = random.normal();

  // Draw axis directions from the sphere until they are within the bounds of their tilts.
  const auto y = [&](int i) {
    const CoordinateEntry& entry = entries.coordinates[i];
    return entry.sd * fit_coordinates(x)[entry.z];
  };
  for (const TiltPair& pair : entries.tilts) {
    const CoordinateEntry& first = entries.coordinates[pair.x[0]];
    // Centre: the population's tilts if the pair has them; concentration: by the inferred scale.
    const double k = first.specimen_scale < 0
                         ? 1
                         : std::exp(parts_->options.specimen_scale_sd *
                                    x[entries.specimen_scale_offset() + first.specimen_scale]);
    Eigen::Vector2d centre(pair.mean[0], pair.mean[1]);
    for (int c = 0; c < 2; ++c)
      if (pair.centre[c] >= 0) centre[c] += y(pair.centre[c]);
    const double concentration = 1 / (k * k * first.sd * first.sd);
    // Draw again while the tilts are outside their bounds.
    for (bool inside = false; !inside;) {
      const Eigen::Vector2d shift = draw_tilt(centre, concentration, random) - centre;
      inside = true;
      for (int c = 0; c < 2; ++c) {
        const CoordinateEntry& entry = entries.coordinates[pair.x[c]];
        const double z = shift[c] / entry.sd;
        inside &= entry.lower <= z && z <= entry.upper;
        x[pair.x[c]] = entry_from(entry, k, shift[c]);
      }
    }
  }
  return x;
}

}  // namespace thenar
