// Priors in x: normal for every entry, times von Mises-Fisher over normal for axis directions.

#include <algorithm>
#include <array>
#include <cmath>

#include "base/units.h"
#include "posterior/hand_posterior_parts.h"
#include "posterior/lane_loops.h"
#include "posterior/tilt_density.h"

namespace thenar::internal {
namespace {

using Eigen::Index;
using Lane = std::array<double, kBlock>;

/// One pair of tilts at one point: where it is, and by what it is moved.
class TiltTerm {
 public:
  TiltTerm(const PosteriorEntries& entries, const TiltPair& pair, const EntryMotion& motion,
           Eigen::Index point)
      : entries_(entries), pair_(pair), motion_(motion), point_(point) {
    Eigen::Vector2d tilt, centre;
    for (int k = 0; k < 2; ++k) {
      centre[k] = pair.mean[k] + (pair.centre[k] < 0 ? 0 : motion.y(pair.centre[k], point));
      tilt[k] = centre[k] + motion.y(pair.x[k], point);
    }
    const CoordinateEntry& first = entries.coordinates[pair.x[0]];
    scale_ = first.sd * (first.spread < 0 ? 1 : motion.spread(first.spread, point));
    z_ = (tilt - centre) / scale_;
    density_ = tilt_density(tilt, centre, 1 / (scale_ * scale_));
  }

  /// log of the density on the sphere over that of the two normal tilts.
  [[nodiscard]] double log_ratio() const {
    return density_.log_density + 2 * std::log(scale_) + 0.5 * z_.squaredNorm() + std::log(2 * kPi);
  }

  void add_gradient(double spread_sd, Eigen::MatrixXd& gradient) const {
    const int spread = entries_.coordinates[pair_.x[0]].spread;
    double by_log_spread = 2 - 2 * density_.by_log_concentration;
    for (int k = 0; k < 2; ++k) {
      const int i = pair_.x[k], centre = pair_.centre[k];
      const double by_own = density_.by_tilt[k] + z_[k] / scale_;
      gradient(i, point_) += by_own * motion_.by_x(i, point_);
      if (centre >= 0)
        gradient(centre, point_) +=
            (density_.by_tilt[k] + density_.by_centre[k]) * motion_.by_x(centre, point_);
      if (spread >= 0) by_log_spread += by_own * motion_.by_spread(i, point_) - z_[k] * z_[k];
    }
    if (spread >= 0) gradient(entries_.spread_at() + spread, point_) += spread_sd * by_log_spread;
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

/// Is the prior of this pair the same whatever the other entries are?
bool alone(const PosteriorEntries& entries, const TiltPair& pair) {
  return pair.centre[0] < 0 && pair.centre[1] < 0 && entries.coordinates[pair.x[0]].spread < 0;
}

/// Eight points of a block.
class PriorBlock {
 public:
  PriorBlock(const PosteriorParts& parts, const EntryMotion& motion, Index block, Index points)
      : parts_(parts),
        motion_(motion),
        block_(block),
        first_(block * kBlock),
        count_(std::min<Index>(kBlock, points - first_)) {
    sum_.fill(-0.5 * std::log(2 * kPi) * static_cast<double>(parts.entries.size()));
    product_.fill(1);
  }

  void set(Eigen::VectorXd& log_prior, Eigen::MatrixXd& gradient) {
    const PosteriorEntries& entries = parts_.entries;
    for (Index i = 0; i < entries.size(); ++i)
      subtract_half_square(motion_.x.row(block_, i), sum_.data());
    if (gradient.size() > 0)
      for (Index k = 0; k < count_; ++k)
        for (Index i = 0; i < entries.size(); ++i)
          gradient(i, first_ + k) = -motion_.x.row(block_, i)[k];
    for (const TiltPair& pair : entries.tilts) {
      if (alone(entries, pair))
        add_alone(pair, gradient);
      else
        add_hierarchical(pair, gradient);
    }
    for (Index k = 0; k < count_; ++k)
      log_prior[first_ + k] = sum_[k] - (product_[k] == 1 ? 0 : 1.5 * std::log(product_[k]));
  }

 private:
  void add_alone(const TiltPair& pair, Eigen::MatrixXd& gradient) {
    const double sd = parts_.entries.coordinates[pair.x[0]].sd, concentration = 1 / (sd * sd);
    Lane by[2];
    tilt_lanes({{pair.mean[0], pair.mean[1]}, sd, concentration}, motion_.y.row(block_, pair.x[0]),
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
      if (gradient.size() > 0) term.add_gradient(parts_.options.spread_sd, gradient);
    }
  }

  const PosteriorParts& parts_;
  const EntryMotion& motion_;
  Index block_, first_, count_;
  Lane sum_, product_;  // log prior; what is left of it as a product
};

}  // namespace

void set_prior(const PosteriorParts& parts, const EntryMotion& motion, Eigen::VectorXd& log_prior,
               Eigen::MatrixXd& gradient) {
  for (Index b = 0; b < motion.x.blocks(); ++b)
    PriorBlock(parts, motion, b, log_prior.size()).set(log_prior, gradient);
}

}  // namespace thenar::internal
