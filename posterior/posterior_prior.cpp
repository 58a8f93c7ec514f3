#include <cmath>

#include "base/angles.h"
#include "posterior/hand_posterior_parts.h"
#include "posterior/tilt_density.h"

namespace thenar::internal {
namespace {

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
    scale_ = motion.scale(pair.x[0], point);
    z_ = (tilt - centre) / scale_;
    density_ = tilt_density(tilt, centre, 1 / (scale_ * scale_));
  }

  /// log of the density on the sphere over that of the two normal tilts.
  [[nodiscard]] double log_ratio() const {
    return density_.log_density + 2 * std::log(scale_) + 0.5 * z_.squaredNorm() + std::log(2 * kPi);
  }

  void add_gradient(double spread_sd, Eigen::MatrixXd& gradient) const {
    double by_log_spread = 2 - 2 * density_.by_log_concentration;
    for (int k = 0; k < 2; ++k) {
      const int i = pair_.x[k], centre = pair_.centre[k];
      gradient(i, point_) += (density_.by_tilt[k] + z_[k] / scale_) * motion_.by_x(i, point_);
      if (centre >= 0)
        gradient(centre, point_) +=
            (density_.by_tilt[k] + density_.by_centre[k]) * motion_.by_x(centre, point_);
      by_log_spread +=
          (density_.by_tilt[k] + z_[k] / scale_) * motion_.by_spread(i, point_) - z_[k] * z_[k];
    }
    const int spread = entries_.coordinates[pair_.x[0]].spread;
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

}  // namespace

void add_prior(const PosteriorEntries& entries, double spread_sd, const EntryMotion& motion,
               const Eigen::Ref<const Eigen::MatrixXd>& x, Eigen::VectorXd& log_prior,
               Eigen::MatrixXd& gradient) {
  const double constant = -0.5 * std::log(2 * kPi) * static_cast<double>(x.rows());
  for (Eigen::Index p = 0; p < x.cols(); ++p) {
    // A plain loop: sums in an order that hangs on nothing but the number of entries.
    double sum = constant;
    for (Eigen::Index i = 0; i < x.rows(); ++i) sum -= 0.5 * x(i, p) * x(i, p);
    if (gradient.size() > 0)
      for (Eigen::Index i = 0; i < x.rows(); ++i) gradient(i, p) = -x(i, p);
    for (const TiltPair& pair : entries.tilts) {
      const TiltTerm term(entries, pair, motion, p);
      sum += term.log_ratio();
      if (gradient.size() > 0) term.add_gradient(spread_sd, gradient);
    }
    log_prior[p] = sum;
  }
}

}  // namespace thenar::internal
