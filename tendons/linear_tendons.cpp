#include "tendons/linear_tendons.h"

#include <limits>
#include <utility>

#include "base/error.h"
#include "tendons/strand_paths.h"

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

/// Moment arms of straight runs through via points, or constant ones, from the digit's own model.
class StraightStrands : public StrandPaths {
 public:
  explicit StraightStrands(const TendonModel<double>& model) : model_(model) {
    model_.friction.setZero();
  }
  [[nodiscard]] StrandArms arms(const TreeState<double>& state, const VectorXd& q) const override {
    return {strand_arms(model_, state, q), ""};
  }

 private:
  TendonModel<double> model_;
};

/// Linear in the tensions, whatever the paths.
class LinearTendons : public DigitTendons {
 public:
  LinearTendons(TendonDigit digit, std::unique_ptr<StrandPaths> paths)
      : digit_(std::move(digit)), paths_(std::move(paths)) {}

  [[nodiscard]] const TendonDigit& digit() const override { return digit_; }

  TendonPull pull(const VectorXd& q, const VectorXd& t,
                  const Eigen::Matrix3Xd& /*start*/) const override {
    check(digit_, q, t);
    const TendonModel<double>& model = digit_.model;
    StrandArms arms = paths_->arms(pose_tree(model.tree, q), q);
    for (Eigen::Index s = 0; s < arms.R.rows(); ++s)
      if (model.friction[s] != 0)
        arms.R.row(s) =
            arms.R.row(s).cwiseProduct(tension_left(model, q, model.friction[s]).transpose());
    TendonPull pull;
    pull.R = strand_matrix(model, q).transpose() * arms.R;
    pull.tau = pull.R.transpose() * t;
    pull.slips = slip_tension(model, q, t);
    pull.trouble = arms.trouble;
    return pull;
  }

 private:
  TendonDigit digit_;
  std::unique_ptr<StrandPaths> paths_;
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
  TendonDigit built = build_tendon_digit(subject, digit, options);
  std::unique_ptr<StrandPaths> paths;
  if (options.path == Path::kWrapped)
    paths = build_wrapped_paths(subject, built);
  else if (options.path == Path::kFitted)
    paths = build_fitted_paths(subject, built);
  else
    paths = std::make_unique<StraightStrands>(built.model);
  if (built.fidelity.path == Path::kViaPoint) built.fidelity.path = options.path;
  return std::make_unique<LinearTendons>(std::move(built), std::move(paths));
}

}  // namespace thenar
