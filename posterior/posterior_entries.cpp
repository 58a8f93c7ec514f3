#include "posterior/posterior_entries.h"

#include <cmath>

#include "base/lists.h"

namespace thenar {
namespace {

/// Builder of the entries of x.
class EntryLister {
 public:
  EntryLister(const FitProblem& problem, bool learn_specimen_scale)
      : problem_(problem), learn_specimen_scale_(learn_specimen_scale) {
    // Leave out shifts along axes.
    out_.gauges = find_gauges(problem);
    for (const Gauge& gauge : out_.gauges) left_out_.push_back(gauge.along);

    // Add the population's entry of each coordinate, then one for every specimen.
    const int coordinates = problem.parameters().coordinates();
    for (int c = 0; c < coordinates; ++c) {
      const CoordinateEntries coordinate = problem.coordinates().entries(c);
      if (coordinate.population >= 0)
        add(coordinate.population, c, kPopulation, coordinate.population_sd);
      for (int s = 0; s < static_cast<int>(problem.specimens().size()) && coordinate.deviation >= 0;
           ++s)
        add(coordinate.deviation + s * problem.coordinates().deviations(), c, s,
            coordinate.deviation_sd);
    }

    // Sort by z; only then the positions of centres are known.
    std::sort(out_.coordinates.begin(), out_.coordinates.end(),
              [](const CoordinateEntry& a, const CoordinateEntry& b) { return a.z < b.z; });
    for (CoordinateEntry& entry : out_.coordinates) find_centre(entry);
  }

  PosteriorEntries entries() { return std::move(out_); }

  /// Pairs the tilts of every axis, of the population and of every specimen.
  void pair_tilts() {
    const int hinges = static_cast<int>(problem_.digit().names.hinges.size());
    for (int s = kPopulation; s < static_cast<int>(problem_.specimens().size()); ++s)
      for (int hinge = 0; hinge < hinges; ++hinge) pair_tilts(hinge, s);
  }

 private:
  /// Adds an entry unless its coordinate is left out or fixed.
  void add(int z, int c, int specimen, double sd) {
    if (std::count(left_out_.begin(), left_out_.end(), c) > 0) return;
    constexpr double kMinBoundGap =
        1e-12;  // gap below which two bounds are equal to rounding [prior sds]
    const CoordinateEntries& coordinate = problem_.coordinates().entries(c);
    if (specimen >= 0 && coordinate.upper - coordinate.lower <= kMinBoundGap * sd)
      return;  // its population entry is fixed, too
    CoordinateEntry entry{
        z,  c,  specimen, sd, problem_.coordinates().lower()[z], problem_.coordinates().upper()[z],
        {}, -1, -1};
    if (entry.upper - entry.lower <= kMinBoundGap) {
      out_.fixed.push_back(z);
      return;
    }
    // Tabulate the bounds if no factor moves them.
    if (specimen >= 0 && learn_specimen_scale_) entry.specimen_scale = specimen_scale_of(c);
    if (entry.specimen_scale < 0 && entry.bounds(1)) entry.table = table_of(entry);
    out_.coordinates.push_back(std::move(entry));
  }

  /// Sets the centre of a specimen's entry whose sum with the population is bounded.
  void find_centre(CoordinateEntry& entry) const {
    const CoordinateEntries& coordinate = problem_.coordinates().entries(entry.coordinate);
    if (entry.specimen < 0 || (std::isinf(coordinate.lower) && std::isinf(coordinate.upper)))
      return;
    // Find the population's entry of the same coordinate.
    const auto population = std::find_if(
        out_.coordinates.begin(), out_.coordinates.end(), [&](const CoordinateEntry& other) {
          return other.specimen < 0 && other.coordinate == entry.coordinate;
        });
    if (population != out_.coordinates.end())
      entry.centre = static_cast<int>(population - out_.coordinates.begin());
  }

  /// Returns a table that entries with the same bounds share.
  [[nodiscard]] std::shared_ptr<const BoundedTable> table_of(const CoordinateEntry& entry) const {
    for (const CoordinateEntry& other : out_.coordinates)
      if (other.table && other.lower == entry.lower && other.upper == entry.upper)
        return other.table;
    return std::make_shared<const BoundedTable>(*entry.bounds(1));
  }

  /// Returns the index of the factor of a coordinate's kind, which is added if necessary.
  int specimen_scale_of(int c) {
    // All parameters of a kind share a factor.
    const FitParameters& parameters = problem_.parameters();
    const ParameterKind kind = parameters.all[parameters.leader[c]].kind;
    auto& known = out_.specimen_scales;
    if (!contains(known, kind)) known.push_back(kind);
    return place_in(known, kind);
  }

  /// Returns the entry of x of this tilt, of kPopulation or a specimen; -1: none.
  [[nodiscard]] int tilt_entry(int hinge, int component, int specimen, double* mean) const {
    const FitParameters& parameters = problem_.parameters();
    // Any entry of the tilt gives the mean, even that of another specimen.
    for (std::size_t i = 0; i < out_.coordinates.size(); ++i) {
      const CoordinateEntry& entry = out_.coordinates[i];
      const Parameter& p = parameters.all[parameters.leader[entry.coordinate]];
      if (p.kind != ParameterKind::kAxisDirection || p.item != hinge || p.component != component)
        continue;
      *mean = p.mean;
      if (entry.specimen == specimen) return static_cast<int>(i);
    }
    return -1;
  }

  /// Adds the pair of tilts of one axis.
  void pair_tilts(int hinge, int specimen) {
    // Both tilts of the axis must move, with the same sd.
    TiltPair pair{};
    for (int k = 0; k < 2; ++k) {
      pair.x[k] = tilt_entry(hinge, k, specimen, &pair.mean[k]);
      pair.centre[k] = specimen < 0 ? -1 : tilt_entry(hinge, k, kPopulation, &pair.mean[k]);
      if (pair.x[k] < 0) return;
    }
    const auto& all = out_.coordinates;
    const double sd = all[pair.x[0]].sd;
    if (sd != all[pair.x[1]].sd) return;
    pair.log_constant = -std::log1p(-std::exp(-1 / (sd * sd)));
    out_.tilts.push_back(pair);
  }

  const FitProblem& problem_;
  bool learn_specimen_scale_;
  std::vector<int> left_out_;  // coordinates without an entry
  PosteriorEntries out_;
};

}  // namespace

std::optional<BoundedNormal> CoordinateEntry::bounds(double k) const {
  // Distance beyond which a normal distribution has no mass [sds]
  constexpr double kNormalReach = 38;
  if (lower < -kNormalReach * k && upper > kNormalReach * k) return std::nullopt;
  return BoundedNormal(lower / k, upper / k);
}

PosteriorEntries list_entries(const FitProblem& problem, const PosteriorOptions& options) {
  EntryLister lister(problem, options.learn_specimen_scale && problem.specimens().size() > 1);
  if (options.sphere_priors) lister.pair_tilts();
  PosteriorEntries out = lister.entries();
  if (options.learn_noise) out.noise_scales = static_cast<int>(problem.experiments().size());
  return out;
}

}  // namespace thenar
