// Computation of the coordinates of specimens from the entries of x.

#include "posterior/posterior_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/units.h"
#include "kinematics_fit/specimen_prior.h"
#include "posterior/tilt_density.h"

namespace thenar::internal {
namespace {

using Eigen::Index;

/// Stores points in blocks of eight; the last point pads the last block.
SimdRows lanes_of(const Eigen::Ref<const Eigen::MatrixXd>& x) {
  SimdRows out(x.rows(), x.cols());
  for (Index b = 0; b < out.blocks(); ++b)
    for (int k = 0; k < kBlockPoints; ++k) {
      const double* column = x.col(std::min<Index>(b * kBlockPoints + k, x.cols() - 1)).data();
      // Columns become lanes.
      double* to = out.row(b, 0) + k;
      for (Index i = 0; i < x.rows(); ++i) to[i * kBlockPoints] = column[i];
    }
  return out;
}

/// Returns NaN for logarithms of factors that would overflow.
double checked_log_factor(double log_factor) {
  return std::abs(log_factor) < 50 ? log_factor : std::numeric_limits<double>::quiet_NaN();
}

/// Computes an entry with a specimen_scale factor, at one point.
void move_scaled(const CoordinateEntry& entry, Index i, Index p, double k, EntryMotion& out) {
  // Without bounds the map is linear.
  const double x = out.x(i, p), scale = k * entry.sd;
  out.y(i, p) = out.by_log_specimen_scale(i, p) = scale * x;
  out.by_x(i, p) = scale;
  const auto bounds = std::isnan(k) ? std::nullopt : entry.bounds(k);
  if (!bounds) return;
  // Bounds in sds depend on the factor.
  const BoundedNormal::Image image = bounds->evaluate(x);
  out.y(i, p) = out.by_log_specimen_scale(i, p) = scale * image.z;
  out.by_x(i, p) = scale * image.by_x;
  if (std::isfinite(entry.lower))
    out.by_log_specimen_scale(i, p) -= entry.sd * image.by_lower * entry.lower;
  if (std::isfinite(entry.upper))
    out.by_log_specimen_scale(i, p) -= entry.sd * image.by_upper * entry.upper;
}

/// Computes an entry whose bounds are relative to its population's entry, at one point.
/// @param k  its specimen_scale factor
void move_about_centre(const PosteriorParts& parts, Index i, Index p, double k, EntryMotion& out) {
  // The result is NaN where the map is not defined.
  const CoordinateEntry& entry = parts.entries.coordinates[i];
  const double centre = out.y(entry.centre, p), x = out.x(i, p);
  SpecimenDeviation own{std::nan(""), std::nan(""), std::nan(""), std::nan("")};
  if (std::isfinite(k) && std::isfinite(centre) && std::isfinite(x))
    own = specimen_deviation(parts.problem.coordinates().entries(entry.coordinate), centre, x, k);
  out.y(i, p) = own.u;
  out.by_x(i, p) = own.by_x;
  out.by_centre(i, p) = own.by_population;
  if (entry.specimen_scale >= 0) out.by_log_specimen_scale(i, p) = own.by_log_factor;
}

/// Computes the factors of noise and between specimens.
void move_scales(const PosteriorParts& parts, const Eigen::Ref<const Eigen::MatrixXd>& x,
                 EntryMotion& out) {
  const PosteriorEntries& entries = parts.entries;
  const Index experiments = out.log_noise.rows(), kinds = out.specimen_scale.rows();
  for (Index p = 0; p < x.cols(); ++p) {
    for (Index e = 0; e < experiments && entries.noise_scales > 0; ++e)
      out.log_noise(e, p) =
          checked_log_factor(parts.options.noise_sd * x(entries.noise_scale_offset() + e, p));
    for (Index k = 0; k < kinds; ++k)
      out.specimen_scale(k, p) = std::exp(checked_log_factor(
          parts.options.specimen_scale_sd * x(entries.specimen_scale_offset() + k, p)));
  }
}

/// Computes an entry without a factor, in blocks of eight points.
void move_blocks(const CoordinateEntry& entry, Index i, EntryMotion& out) {
  for (Index b = 0; b < out.x.blocks(); ++b) {
    if (entry.table)
      entry.table->evaluate_block(out.x.row(b, i), entry.sd, out.y.row(b, i), out.by_x.row(b, i));
    else
      scale_block(out.x.row(b, i), entry.sd, out.y.row(b, i), out.by_x.row(b, i));
  }
}

}  // namespace

EntryMotion move_entries(const PosteriorParts& parts, const Eigen::Ref<const Eigen::MatrixXd>& x) {
  // Allocate the results.
  const PosteriorEntries& entries = parts.entries;
  const auto n = static_cast<Index>(entries.coordinates.size());
  const auto experiments = static_cast<Index>(parts.data.size());
  const auto kinds = static_cast<Index>(entries.specimen_scales.size());
  EntryMotion out{lanes_of(x),
                  SimdRows(n, x.cols()),
                  SimdRows(n, x.cols()),
                  SimdRows(kinds > 0 ? n : 0, x.cols()),
                  SimdRows(parts.entries.has_centres() ? n : 0, x.cols()),
                  Eigen::MatrixXd::Zero(experiments, x.cols()),
                  Eigen::MatrixXd(kinds, x.cols())};
  move_scales(parts, x, out);
  // Compute the entries: relative to a centre, in blocks of eight points, or with a factor.
  for (Index i = 0; i < n; ++i) {
    const CoordinateEntry& entry = entries.coordinates[i];
    if (entry.centre >= 0) {
      for (Index p = 0; p < x.cols(); ++p)
        move_about_centre(
            parts, i, p, entry.specimen_scale < 0 ? 1 : out.specimen_scale(entry.specimen_scale, p),
            out);
      continue;
    }
    if (entry.specimen_scale < 0) move_blocks(entry, i, out);
    for (Index p = 0; p < x.cols() && entry.specimen_scale >= 0; ++p)
      move_scaled(entry, i, p, out.specimen_scale(entry.specimen_scale, p), out);
  }
  return out;
}

SpecimenCoordinates displace_specimens(const PosteriorParts& parts, const EntryMotion& motion) {
  // For each specimen, add the contributions of its entries to the constant part.
  const Index points = motion.log_noise.cols();
  SpecimenCoordinates out;
  out.non_finite.assign(points, 0);
  for (std::size_t s = 0; s < parts.rest.size(); ++s) {
    out.u.emplace_back(parts.rest[s].replicate(1, points));
    Eigen::MatrixXd& u = out.u.back();
    for (std::size_t i = 0; i < parts.entries.coordinates.size(); ++i) {
      const CoordinateEntry& entry = parts.entries.coordinates[i];
      if (entry.specimen >= 0 && entry.specimen != static_cast<int>(s)) continue;
      double* to = u.data() + entry.coordinate;
      for (Index p = 0; p < points; ++p) to[p * u.rows()] += motion.y(static_cast<Index>(i), p);
    }
    for (Index p = 0; p < points; ++p) {
      // Kernels must not see NaN: such points are set to zero and marked.
      double probe = 0;  // NaN if any coordinate is not finite
      for (Index c = 0; c < u.rows(); ++c) probe += 0 * u(c, p);
      if (probe == 0) continue;
      out.non_finite[p] = 1;
      u.col(p).setZero();
    }
  }
  return out;
}

// Priors in x: normal for every entry, times von Mises-Fisher over normal for axis directions.
namespace {

using Lane = std::array<double, kBlockPoints>;

/// Prior of one pair of tilts at one point.
class TiltTerm {
 public:
  TiltTerm(const PosteriorEntries& entries, const TiltPair& pair, const EntryMotion& motion,
           Eigen::Index point)
      : entries_(entries), pair_(pair), motion_(motion), point_(point) {
    // Compute the tilts, and the centre of their prior.
    Eigen::Vector2d tilt, centre;
    for (int k = 0; k < 2; ++k) {
      centre[k] = pair.mean[k] + (pair.centre[k] < 0 ? 0 : motion.y(pair.centre[k], point));
      tilt[k] = centre[k] + motion.y(pair.x[k], point);
    }
    // Evaluate the density on the sphere with the inferred scale.
    const CoordinateEntry& first = entries.coordinates[pair.x[0]];
    scale_ = first.sd *
             (first.specimen_scale < 0 ? 1 : motion.specimen_scale(first.specimen_scale, point));
    z_ = (tilt - centre) / scale_;
    density_ = tilt_density(tilt, centre, 1 / (scale_ * scale_));
  }

  /// Returns the log density on the sphere minus that of the two normal tilts.
  [[nodiscard]] double log_ratio() const {
    return density_.log_density + 2 * std::log(scale_) + 0.5 * z_.squaredNorm() + std::log(2 * kPi);
  }

  /// Adds the derivatives of log_ratio() by x.
  void add_gradient(double specimen_scale_sd, Eigen::MatrixXd& gradient) const {
    // Derivatives by the tilts and by their centre.
    const int specimen_scale = entries_.coordinates[pair_.x[0]].specimen_scale;
    double by_log_scale = 2 - 2 * density_.by_log_concentration;
    for (int k = 0; k < 2; ++k) {
      const int i = pair_.x[k], centre = pair_.centre[k];
      const double by_own = density_.by_tilt[k] + z_[k] / scale_;
      gradient(i, point_) += by_own * motion_.by_x(i, point_);
      if (centre >= 0)
        gradient(centre, point_) +=
            (density_.by_tilt[k] + density_.by_centre[k]) * motion_.by_x(centre, point_);
      // Derivative by the scale factor, which changes tilts and concentration.
      if (specimen_scale >= 0)
        by_log_scale += by_own * motion_.by_log_specimen_scale(i, point_) - z_[k] * z_[k];
    }
    if (specimen_scale >= 0)
      gradient(entries_.specimen_scale_offset() + specimen_scale, point_) +=
          specimen_scale_sd * by_log_scale;
  }

 private:
  const PosteriorEntries& entries_;
  const TiltPair& pair_;
  const EntryMotion& motion_;
  Eigen::Index point_;
  double scale_;
  Eigen::Vector2d z_;
  TiltDensity density_;
};

/// Returns whether the prior of this pair is independent of all other entries.
bool is_independent(const PosteriorEntries& entries, const TiltPair& pair) {
  return pair.centre[0] < 0 && pair.centre[1] < 0 &&
         entries.coordinates[pair.x[0]].specimen_scale < 0;
}

/// Log prior of the eight points of a block.
class PriorBlock {
 public:
  PriorBlock(const PosteriorParts& parts, const EntryMotion& motion, Index block, Index points)
      : parts_(parts),
        motion_(motion),
        block_(block),
        first_(block * kBlockPoints),
        count_(std::min<Index>(kBlockPoints, points - first_)) {
    sum_.fill(-0.5 * std::log(2 * kPi) * static_cast<double>(parts.entries.size()));
    product_.fill(1);
  }

  /// Computes the log prior and, if `gradient` has columns, its gradient.
  void set(Eigen::VectorXd& log_prior, Eigen::MatrixXd& gradient) {
    // Standard normal entries.
    const PosteriorEntries& entries = parts_.entries;
    for (Index i = 0; i < entries.size(); ++i)
      subtract_half_square(motion_.x.row(block_, i), sum_.data());
    if (gradient.size() > 0)
      for (Index k = 0; k < count_; ++k)
        for (Index i = 0; i < entries.size(); ++i)
          gradient(i, first_ + k) = -motion_.x.row(block_, i)[k];
    // Axis directions on the sphere.
    for (const TiltPair& pair : entries.tilts) {
      if (is_independent(entries, pair))
        add_alone(pair, gradient);
      else
        add_hierarchical(pair, gradient);
    }
    // Take one logarithm for all factors of a point.
    for (Index k = 0; k < count_; ++k)
      log_prior[first_ + k] = sum_[k] - (product_[k] == 1 ? 0 : 1.5 * std::log(product_[k]));
  }

 private:
  void add_alone(const TiltPair& pair, Eigen::MatrixXd& gradient) {
    // Compute sums, products and derivatives of eight points at once.
    const double sd = parts_.entries.coordinates[pair.x[0]].sd, concentration = 1 / (sd * sd);
    Lane by[2];
    tilt_block({{pair.mean[0], pair.mean[1]}, sd, concentration}, motion_.y.row(block_, pair.x[0]),
               motion_.y.row(block_, pair.x[1]), sum_.data(), product_.data(), by[0].data(),
               by[1].data());
    for (double& sum : sum_) sum += pair.log_constant;
    for (int t = 0; t < 2 && gradient.size() > 0; ++t)
      for (Index k = 0; k < count_; ++k)
        gradient(pair.x[t], first_ + k) += by[t][k] * motion_.by_x.row(block_, pair.x[t])[k];
  }

  void add_hierarchical(const TiltPair& pair, Eigen::MatrixXd& gradient) {
    for (Index k = 0; k < count_; ++k) {
      const TiltTerm term(parts_.entries, pair, motion_, first_ + k);
      sum_[k] += term.log_ratio();
      if (gradient.size() > 0) term.add_gradient(parts_.options.specimen_scale_sd, gradient);
    }
  }

  const PosteriorParts& parts_;
  const EntryMotion& motion_;
  Index block_, first_, count_;
  Lane sum_, product_;  // log prior without the logarithm of `product_`
};

}  // namespace

void set_prior(const PosteriorParts& parts, const EntryMotion& motion, Eigen::VectorXd& log_prior,
               Eigen::MatrixXd& gradient) {
  for (Index b = 0; b < motion.x.blocks(); ++b)
    PriorBlock(parts, motion, b, log_prior.size()).set(log_prior, gradient);
}

}  // namespace thenar::internal
