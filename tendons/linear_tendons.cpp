#include "tendons/linear_tendons.h"

#include <limits>
#include <utility>

#include "base/error.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

void check(const TendonDigit& digit, const VectorXd& q, const VectorXd& t) {
  require(q.size() == digit.model.coordinates, "posture has {} angles, the digit {} joints",
          q.size(), digit.model.coordinates);
  require(q.allFinite(), "posture has an angle that is not finite");
  const auto muscles = static_cast<Eigen::Index>(digit.names.muscles.size());
  require(t.size() == muscles, "there are {} tensions for {} muscles", t.size(), muscles);
  for (Eigen::Index m = 0; m < muscles; ++m)
    require(t[m] >= 0 && t[m] <= std::numeric_limits<double>::max(),
            "tension of muscle '{}' must be finite and >= 0, got {} N",
            digit.names.muscles[static_cast<std::size_t>(m)], t[m]);
}

/// Moment arms from the digit's own model: constant, or of straight runs through via points.
class LinearTendons : public DigitTendons {
 public:
  explicit LinearTendons(TendonDigit digit) : digit_(std::move(digit)) {}

  [[nodiscard]] const TendonDigit& digit() const override { return digit_; }

  TendonPull pull(const VectorXd& q, const VectorXd& t,
                  const Eigen::Matrix3Xd& /*start*/) const override {
    check(digit_, q, t);
    const TendonModel<double>& model = digit_.model;
    TendonPull pull;
    pull.R = muscle_arms(model, pose_tree(model.tree, q), q);
    pull.tau = pull.R.transpose() * t;
    pull.slips = slip_tension(model, q, t);
    return pull;
  }

 private:
  TendonDigit digit_;
};

}  // namespace

SlipTension slip_tension(const TendonModel<double>& model, const VectorXd& q, const VectorXd& t) {
  if (!model.hood) return {};
  const VectorXd strands = strand_matrix(model, q) * t;
  return {strands[model.hood->central_slip], strands[model.hood->radial_band],
          strands[model.hood->ulnar_band], strands[model.hood->terminal_slip]};
}

std::unique_ptr<DigitTendons> build_linear_tendons(const Subject& subject, const std::string& digit,
                                                   const TendonOptions& options) {
  require(options.hood <= Hood::kFractions,
          "a hood that floats is no linear map of tensions: build a net");
  require(options.path <= Path::kViaPoint, "no linear tendons on this rung of paths yet");
  return std::make_unique<LinearTendons>(build_tendon_digit(subject, digit, options));
}

}  // namespace thenar
