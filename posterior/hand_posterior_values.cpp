// Between a posterior's x, the z of its fit, and the numbers that people read.

#include <cmath>

#include "base/error.h"
#include "posterior/hand_posterior_parts.h"
#include "posterior/tilt_density.h"
#include "sampling/random_stream.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr std::uint32_t kPriorStream = 0x7072696f;  // purpose of random numbers

/// Values of some parameters [SI].
VectorXd values_of(const FitParameters& parameters, const std::vector<int>& which,
                   const VectorXd& u) {
  const std::vector<double> all = parameter_values<double>(parameters, u);
  VectorXd some(static_cast<Index>(which.size()));
  for (Index i = 0; i < some.size(); ++i) some[i] = all[which[i]];
  return some;
}

/// z(x) of an entry, where its spread factor is k.
double entry_image(const CoordinateEntry& entry, double k, double x) {
  if (entry.table) return entry.table->at(x).z;
  const auto bounds = entry.bounds(k);
  return bounds ? bounds->at(x).z : x;
}

/// z of an entry whose bounds count from its population's, where the latter's z is set already.
double centred_entry(const internal::PosteriorParts& parts, const CoordinateEntry& entry, double k,
                     const VectorXd& z, double x) {
  const CoordinateEntries& of = parts.problem.entries(entry.coordinate);
  const double population = of.population_sd * z[of.population];
  if (k == 1) return x;
  return deviation_entry(of, population, specimen_deviation(of, population, x, k).u);
}

/// Finds x of an entry from what it adds to its coordinate.
double entry_from(const CoordinateEntry& entry, double k, double y) {
  const double z = y / (k * entry.sd);
  if (entry.table) return entry.table->inverse(z);
  const auto bounds = entry.bounds(k);
  return bounds ? bounds->inverse(z) : z;
}

}  // namespace

std::vector<std::string> HandPosterior::names() const {
  const std::vector<std::string> all = parts_->problem.names();
  std::vector<std::string> names;
  for (const CoordinateEntry& entry : parts_->entries.coordinates) names.push_back(all[entry.z]);
  if (parts_->entries.noises > 0)
    for (const Experiment& experiment : parts_->problem.experiments())
      names.push_back("noise/" + experiment.name);
  for (const std::string& kind : spread_kinds()) names.push_back("spread/" + kind);
  return names;
}

std::vector<std::string> HandPosterior::spread_kinds() const {
  std::vector<std::string> kinds;
  for (const ParameterKind kind : parts_->entries.spreads) kinds.push_back(name_of(kind));
  return kinds;
}

std::vector<int> HandPosterior::moving_parameters() const {
  const FitParameters& parameters = parts_->problem.parameters();
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
  const PosteriorEntries& entries = parts_->entries;
  VectorXd z = VectorXd::Zero(parts_->problem.size());
  for (const int held : entries.held) z[held] = parts_->problem.lower()[held];
  for (std::size_t i = 0; i < entries.coordinates.size(); ++i) {
    const CoordinateEntry& entry = entries.coordinates[i];
    const double k =
        entry.spread < 0
            ? 1
            : std::exp(parts_->options.spread_sd * x[entries.spread_at() + entry.spread]);
    const double own = x[static_cast<Index>(i)];
    z[entry.z] = entry.centre < 0 ? k * entry_image(entry, k, own)
                                  : centred_entry(*parts_, entry, k, z, own);
  }
  return z;
}

VectorXd HandPosterior::from_fit(const VectorXd& z) const {
  require(z.size() == parts_->problem.size() && z.allFinite(),
          "the fit has {} coordinates, all finite; got {}", parts_->problem.size(), z.size());
  const PosteriorEntries& entries = parts_->entries;
  const VectorXd at = without_gauges(parts_->problem, entries.gauges, z);
  VectorXd x = VectorXd::Zero(size());
  for (std::size_t i = 0; i < entries.coordinates.size(); ++i) {
    const CoordinateEntry& entry = entries.coordinates[i];
    x[static_cast<Index>(i)] =
        entry.centre < 0 ? entry_from(entry, 1, entry.sd * at[entry.z]) : at[entry.z];
  }
  return x;
}

PosteriorValues HandPosterior::values(const Eigen::Ref<const Eigen::MatrixXd>& x) const {
  require(x.rows() == size(), "the posterior has {} entries, got {}", size(), x.rows());
  const FitProblem& problem = parts_->problem;
  const PosteriorEntries& entries = parts_->entries;
  const std::vector<int> moving = moving_parameters();
  const auto rows = static_cast<Index>(moving.size());
  PosteriorValues out;
  out.population.resize(rows, x.cols());
  out.specimens.assign(problem.specimens().size(), Eigen::MatrixXd(rows, x.cols()));
  for (Index p = 0; p < x.cols(); ++p) {
    const VectorXd z = fit_coordinates(x.col(p));
    const auto row = [&](int specimen) {
      return values_of(problem.parameters(), moving, problem.displacements(z, specimen));
    };
    out.population.col(p) = row(-1);
    for (std::size_t s = 0; s < out.specimens.size(); ++s)
      out.specimens[s].col(p) = row(static_cast<int>(s));
  }
  const auto experiments = static_cast<Index>(problem.experiments().size());
  out.noise = Eigen::MatrixXd::Ones(experiments, x.cols());
  if (entries.noises > 0)
    out.noise =
        (parts_->options.noise_sd * x.middleRows(entries.noise_at(), experiments)).array().exp();
  out.spread =
      (parts_->options.spread_sd * x.bottomRows(static_cast<Index>(entries.spreads.size())))
          .array()
          .exp();
  return out;
}

VectorXd HandPosterior::draw_prior(unsigned seed, unsigned number) const {
  RandomStream random(seed, number, 0, kPriorStream);
  const PosteriorEntries& entries = parts_->entries;
  VectorXd x(size());
  for (Index i = 0; i < x.size(); ++i) x[i] = random.normal();

  // Axis directions: from the sphere, until they are within the bounds of their tilts.
  const auto y = [&](int i) {
    const CoordinateEntry& entry = entries.coordinates[i];
    return entry.sd * fit_coordinates(x)[entry.z];
  };
  for (const TiltPair& pair : entries.tilts) {
    const CoordinateEntry& first = entries.coordinates[pair.x[0]];
    const double k =
        first.spread < 0
            ? 1
            : std::exp(parts_->options.spread_sd * x[entries.spread_at() + first.spread]);
    Eigen::Vector2d centre(pair.mean[0], pair.mean[1]);
    for (int c = 0; c < 2; ++c)
      if (pair.centre[c] >= 0) centre[c] += y(pair.centre[c]);
    const double concentration = 1 / (k * k * first.sd * first.sd);
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
