// From entries of x to the coordinates of specimens.

#include <cmath>
#include <limits>

#include "posterior/hand_posterior_parts.h"
#include "posterior/lane_loops.h"

namespace thenar::internal {
namespace {

using Eigen::Index;

/// Points eight by eight; the last one fills up.
LaneRows lanes_of(const Eigen::Ref<const Eigen::MatrixXd>& x) {
  LaneRows out(x.rows(), x.cols());
  for (Index b = 0; b < out.blocks(); ++b)
    for (int k = 0; k < kBlock; ++k) {
      const double* column = x.col(std::min<Index>(b * kBlock + k, x.cols() - 1)).data();
      double* to = out.row(b, 0) + k;
      for (Index i = 0; i < x.rows(); ++i) to[i * kBlock] = column[i];
    }
  return out;
}

/// Logarithms of factors beyond these are no numbers to compute with.
double sane(double log_factor) {
  return std::abs(log_factor) < 50 ? log_factor : std::numeric_limits<double>::quiet_NaN();
}

/// An entry with a spread factor, at one point.
void move_spread(const CoordinateEntry& entry, Index i, Index p, double k, EntryMotion& out) {
  const double x = out.x(i, p), scale = k * entry.sd;
  out.y(i, p) = out.by_spread(i, p) = scale * x;
  out.by_x(i, p) = scale;
  const auto bounds = std::isnan(k) ? std::nullopt : entry.bounds(k);
  if (!bounds) return;
  const BoundedNormal::Image image = bounds->at(x);
  out.y(i, p) = out.by_spread(i, p) = scale * image.z;
  out.by_x(i, p) = scale * image.by_x;
  if (std::isfinite(entry.lower)) out.by_spread(i, p) -= entry.sd * image.by_lower * entry.lower;
  if (std::isfinite(entry.upper)) out.by_spread(i, p) -= entry.sd * image.by_upper * entry.upper;
}

/// An entry whose bounds count from its population's, at one point. @param k  its spread factor
void move_about_centre(const PosteriorParts& parts, Index i, Index p, double k, EntryMotion& out) {
  const CoordinateEntry& entry = parts.entries.coordinates[i];
  const double centre = out.y(entry.centre, p), x = out.x(i, p);
  SpecimenDeviation own{std::nan(""), std::nan(""), std::nan(""), std::nan("")};
  if (std::isfinite(k) && std::isfinite(centre) && std::isfinite(x))
    own = specimen_deviation(parts.problem.entries(entry.coordinate), centre, x, k);
  out.y(i, p) = own.u;
  out.by_x(i, p) = own.by_x;
  out.by_centre(i, p) = own.by_population;
  if (entry.spread >= 0) out.by_spread(i, p) = own.by_log_factor;
}

}  // namespace

EntryMotion move(const PosteriorParts& parts, const Eigen::Ref<const Eigen::MatrixXd>& x) {
  const PosteriorEntries& entries = parts.entries;
  const auto n = static_cast<Index>(entries.coordinates.size());
  const auto experiments = static_cast<Index>(parts.data.size());
  const auto kinds = static_cast<Index>(entries.spreads.size());
  EntryMotion out{lanes_of(x),
                  LaneRows(n, x.cols()),
                  LaneRows(n, x.cols()),
                  LaneRows(kinds > 0 ? n : 0, x.cols()),
                  LaneRows(parts.entries.has_centres() ? n : 0, x.cols()),
                  Eigen::MatrixXd::Zero(experiments, x.cols()),
                  Eigen::MatrixXd(kinds, x.cols())};
  for (Index p = 0; p < x.cols(); ++p) {
    for (Index e = 0; e < experiments && entries.noises > 0; ++e)
      out.log_noise(e, p) = sane(parts.options.noise_sd * x(entries.noise_at() + e, p));
    for (Index k = 0; k < kinds; ++k)
      out.spread(k, p) = std::exp(sane(parts.options.spread_sd * x(entries.spread_at() + k, p)));
  }
  for (Index i = 0; i < n; ++i) {
    const CoordinateEntry& entry = entries.coordinates[i];
    if (entry.centre >= 0) {
      for (Index p = 0; p < x.cols(); ++p)
        move_about_centre(parts, i, p, entry.spread < 0 ? 1 : out.spread(entry.spread, p), out);
      continue;
    }
    for (Index b = 0; b < out.x.blocks() && entry.spread < 0; ++b) {
      if (entry.table)
        entry.table->at_lanes(out.x.row(b, i), entry.sd, out.y.row(b, i), out.by_x.row(b, i));
      else
        scale_lanes(out.x.row(b, i), entry.sd, out.y.row(b, i), out.by_x.row(b, i));
    }
    for (Index p = 0; p < x.cols() && entry.spread >= 0; ++p)
      move_spread(entry, i, p, out.spread(entry.spread, p), out);
  }
  return out;
}

Displaced displace(const PosteriorParts& parts, const EntryMotion& motion) {
  const Index points = motion.log_noise.cols();
  Displaced out;
  out.broken.assign(points, 0);
  for (std::size_t s = 0; s < parts.rest.size(); ++s) {
    out.u.push_back(parts.rest[s].replicate(1, points));
    Eigen::MatrixXd& u = out.u.back();
    for (std::size_t i = 0; i < parts.entries.coordinates.size(); ++i) {
      const CoordinateEntry& entry = parts.entries.coordinates[i];
      if (entry.specimen >= 0 && entry.specimen != static_cast<int>(s)) continue;
      double* to = u.data() + entry.coordinate;
      for (Index p = 0; p < points; ++p) to[p * u.rows()] += motion.y(static_cast<Index>(i), p);
    }
    for (Index p = 0; p < points; ++p) {
      double probe = 0;  // NaN if any is not finite
      for (Index c = 0; c < u.rows(); ++c) probe += 0 * u(c, p);
      if (probe == 0) continue;
      out.broken[p] = 1;
      u.col(p).setZero();
    }
  }
  return out;
}

}  // namespace thenar::internal
