#include "tendons/linear_tendons.h"

#include <limits>
#include <utility>

#include "base/error.h"
#include "tendons/path.h"
#include "tendons/strand_paths.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Checks a posture and tensions.
void check_input(const TendonDigit& digit, const VectorXd& q, const VectorXd& t) {
  check_posture(digit, q);
  const auto muscles = static_cast<Eigen::Index>(digit.names.muscles.size());
  require(t.size() == muscles, "there are {} tensions for {} muscles", t.size(), muscles);
  for (Eigen::Index m = 0; m < muscles; ++m)
    require(t[m] >= 0 && t[m] <= std::numeric_limits<double>::max(),
            "tension of muscle '{}' must be finite and >= 0, got {} N", digit.names.muscles[m],
            t[m]);
}

/// Strands with straight runs through via points, or constant arms, from the digit's own model.
class StraightStrands : public StrandPaths {
 public:
  explicit StraightStrands(const TendonModel<double>& model) : model_(model) {
    model_.friction.setZero();
  }
  [[nodiscard]] StrandArms arms(const TreeState<double>& state, const VectorXd& q) const override {
    return {strand_arms(model_, state, q), "", TendonStatus::kValid};
  }
  [[nodiscard]] StrandDerivatives derivatives(const TreeState<double>& state, const VectorXd& q,
                                              StrandWorkspace* /*workspace*/) const override {
    // Compute arms, lengths, and second derivatives of every path.
    StrandDerivatives slopes{true, strand_arms(model_, state, q), lengths(state, q), {}};
    for (const TendonPath<double>& path : model_.paths)
      slopes.dR.push_back(arm_derivatives(model_.tree, state, path, model_.coordinates));
    return slopes;
  }
  [[nodiscard]] VectorXd lengths(const TreeState<double>& state, const VectorXd& q) const override {
    // Compute lengths: linear in the posture for constant arms.
    VectorXd length = -model_.constant_arms * q;
    for (std::size_t s = 0; s < model_.paths.size(); ++s)
      if (!model_.paths[s].empty()) length[s] = path_length(state, model_.paths[s]);
    return length;
  }

 private:
  TendonModel<double> model_;
};

/// Computes d(strand tensions)/d(knuckle angle) for muscle tensions t (strands) [N/rad]: the share
/// c of the central slip changes by  slope c (1 - c).
VectorXd hood_rate(const TendonModel<double>& model, const VectorXd& q, const VectorXd& t) {
  VectorXd rate = VectorXd::Zero(static_cast<Eigen::Index>(model.paths.size()));
  if (!model.hood) return rate;
  for (const HoodShare<double>& share : model.hood_shares) {
    // Compute the rate of the central slip's tension.
    const double by = share.slope * (mcp_angle(model, q) - kHoodAngle);
    const double c = shift_fraction(share.to_central, by);
    const double more = share.into_hood * share.slope * c * (1 - c) * t[share.muscle];
    // Subtract it from the bands, each by its part.
    const double radial = share.side == HoodSide::kRadial  ? more
                          : share.side == HoodSide::kUlnar ? 0
                                                           : 0.5 * more;
    rate[model.hood->central_slip] += more;
    rate[model.hood->radial_band] -= radial;
    rate[model.hood->ulnar_band] -= more - radial;
    rate[model.hood->terminal_slip] -= more;
  }
  return rate;
}

/// Computes d(bending up to each coordinate)/dq, for the sum in remaining_tension() [1]
/// (coordinates, coordinates).
MatrixXd bend_rate(const TendonModel<double>& model, const VectorXd& q) {
  MatrixXd rate = MatrixXd::Zero(model.coordinates, model.coordinates);
  for (const SheathBend& bend : model.bends) {
    const int k = bend.angle.coordinate;
    if (k < 0) continue;
    const double slope = bend.angle.ratio * angle_at(bend.angle, q) / bend_size(bend.angle, q);
    for (int j = bend.first_coordinate_beyond; j < model.coordinates; ++j) rate(j, k) += slope;
  }
  return rate;
}

/// Tendons whose torque is linear in the tensions, with any paths.
class LinearTendons : public DigitTendons {
 public:
  LinearTendons(TendonDigit digit, std::unique_ptr<StrandPaths> paths)
      : digit_(std::move(digit)), paths_(std::move(paths)) {}

  [[nodiscard]] const TendonDigit& digit() const override { return digit_; }

  TendonTorque evaluate(const VectorXd& q, const VectorXd& t,
                        const Eigen::Matrix3Xd& /*start*/) const override {
    // Compute the arms, then torque and slips.
    check_input(digit_, q, t);
    const TendonModel<double>& model = digit_.model;
    TendonTorque pull;
    Workspace workspace{paths_->make_workspace(), {}, {}};
    set_arms(q, workspace, pull);
    pull.tau = pull.R.transpose() * t;
    pull.slips = slip_tension(model, q, t);
    return pull;
  }

  [[nodiscard]] std::unique_ptr<ArmSolver> arm_solver() const override {
    return std::make_unique<Arms>(*this);
  }

  /// Workspace of set_arms(); it does not affect results.
  struct Workspace {
    std::unique_ptr<StrandWorkspace> paths;
    TreeState<double> state;
    StrandArms arms;
  };

  /// Sets R, warning and status of a torque.
  void set_arms(const VectorXd& q, Workspace& workspace, TendonTorque& pull) const {
    const TendonModel<double>& model = digit_.model;
    StrandArms& arms = workspace.arms;
    pose_tree_over(model.tree, q, workspace.state);
    paths_->set_arms(workspace.state, q, workspace.paths.get(), arms);
    for (Eigen::Index s = 0; s < arms.R.rows(); ++s)
      if (model.friction[s] != 0)
        arms.R.row(s) =
            arms.R.row(s).cwiseProduct(remaining_tension(model, q, model.friction[s]).transpose());
    // Distribute the strands' arms over muscles by the hood; without one, each muscle has its own.
    if (model.hood) {
      pull.R = strand_matrix(model, q).transpose() * arms.R;
    } else {
      pull.R.resize(static_cast<Eigen::Index>(model.pulls.size()), arms.R.cols());
      for (Eigen::Index c = 0; c < arms.R.cols(); ++c)
        for (std::size_t m = 0; m < model.pulls.size(); ++m)
          pull.R(static_cast<Eigen::Index>(m), c) = arms.R(model.pulls[m], c);
    }
    pull.warning = arms.warning;
    pull.status = arms.status;
  }

  [[nodiscard]] VectorXd lengths(const VectorXd& q, const VectorXd& t,
                                 const TendonTorque& /*at*/) const override {
    check_input(digit_, q, t);
    const TendonModel<double>& model = digit_.model;
    return strand_matrix(model, q).transpose() * paths_->lengths(pose_tree(model.tree, q), q);
  }

  /// Solver for arms at many postures.
  class Arms final : public ArmSolver {
   public:
    explicit Arms(const LinearTendons& of)
        : of_(&of), workspace_{of.paths_->make_workspace(), {}, {}} {}
    void solve(const VectorXd& q, TendonTorque& out) override {
      check_posture(of_->digit_, q);
      of_->set_arms(q, workspace_, out);
    }
    void slopes(const VectorXd& q, ArmSlopes& out) override {
      check_posture(of_->digit_, q);
      of_->set_slopes(q, workspace_, out);
    }

   private:
    const LinearTendons* of_;
    Workspace workspace_;
  };

  /// Computes the derivatives of  tau_j = sum over strands of f_s remaining_sj R_sj,  f = S t; each
  /// factor may change with posture.
  [[nodiscard]] TendonDerivatives derivatives(const VectorXd& q, const VectorXd& t) const override {
    check_input(digit_, q, t);
    const TendonModel<double>& model = digit_.model;
    // Compute shares, arms and their derivatives at this posture.
    const MatrixXd S = strand_matrix(model, q);
    const StrandDerivatives strands = paths_->derivatives(pose_tree(model.tree, q), q, nullptr);
    TendonDerivatives out{strands.exist, MatrixXd::Zero(q.size(), q.size()),
                          S.transpose() * strands.length};
    if (!out.exist) return out;
    // Add each strand with its tension and the tension's derivative by the knuckle's angle.
    const VectorXd f = S * t, f_rate = hood_rate(model, q, t);
    const MatrixXd bending = bend_rate(model, q);
    for (Eigen::Index s = 0; s < f.size(); ++s)
      add_strand({s, f[s], f_rate[s]}, q, strands, bending, out.by_posture);
    return out;
  }

  /// Computes ArmSlopes at a posture.
  void set_slopes(const VectorXd& q, Workspace& workspace, ArmSlopes& out) const {
    const TendonModel<double>& model = digit_.model;
    pose_tree_over(model.tree, q, workspace.state);
    const StrandDerivatives strands =
        paths_->derivatives(workspace.state, q, workspace.paths.get());
    out.exist = strands.exist;
    if (!out.exist) return;
    // Add each muscle's strands under its unit tension.
    const MatrixXd S = strand_matrix(model, q), bending = bend_rate(model, q);
    const Eigen::Index n = q.size(), muscles = S.cols();
    out.of_pair.resize(n * (n + 1) / 2, muscles);
    MatrixXd by_posture(n, n);
    for (Eigen::Index m = 0; m < muscles; ++m) {
      const VectorXd f_rate = hood_rate(model, q, VectorXd::Unit(muscles, m));
      by_posture.setZero();
      for (Eigen::Index s = 0; s < S.rows(); ++s)
        if (S(s, m) != 0 || f_rate[s] != 0)
          add_strand({s, S(s, m), f_rate[s]}, q, strands, bending, by_posture);
      for (Eigen::Index k = 0, pair = 0; k < n; ++k)
        for (Eigen::Index j = 0; j <= k; ++j, ++pair)
          out.of_pair(pair, m) = -0.5 * (by_posture(j, k) + by_posture(k, j));
    }
  }

 private:
  /// Strand under tension.
  struct PulledStrand {
    Eigen::Index number;  // row of the strand matrix
    double tension;       // [N]
    double rate;          // derivative of the tension by the knuckle's angle [N/rad]
  };

  /// Adds the part of a strand in d tau/dq: product rule over share, friction and arm.
  void add_strand(const PulledStrand& strand, const VectorXd& q, const StrandDerivatives& strands,
                  const MatrixXd& bending, MatrixXd& by_posture) const {
    const auto& [s, f, f_rate] = strand;
    const TendonModel<double>& model = digit_.model;
    const MatrixXd& dR = strands.dR[s];
    const double mu = model.friction[s];
    if (mu == 0 && f_rate == 0) {
      by_posture += f * dR;
      return;
    }
    const VectorXd left = mu == 0 ? VectorXd::Ones(q.size()) : remaining_tension(model, q, mu);
    const VectorXd arm = left.cwiseProduct(strands.R.row(s).transpose());
    by_posture += f * (left.asDiagonal() * dR - mu * MatrixXd(arm.asDiagonal() * bending));
    if (model.knuckle.coordinate >= 0)
      by_posture.col(model.knuckle.coordinate) += model.knuckle.ratio * f_rate * arm;
  }

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

std::unique_ptr<DigitTendons> straight_tendons(TendonDigit digit) {
  auto paths = std::make_unique<StraightStrands>(digit.model);
  return std::make_unique<LinearTendons>(std::move(digit), std::move(paths));
}

std::unique_ptr<DigitTendons> build_linear_tendons(const Subject& subject, const std::string& digit,
                                                   const TendonOptions& options) {
  // Check that the hood model is linear.
  require(options.hood <= Hood::kFractions,
          "a floating hood is not a linear map of tensions: build a net");
  TendonDigit built = build_tendon_digit(subject, digit, options);
  // Build the requested paths.
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
