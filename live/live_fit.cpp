#include "live/live_fit.h"

#include <utility>

#include "base/error.h"
#include "base/lists.h"
#include "base/units.h"
#include "kinematics_fit/model/net_trials.h"
#include "tendons/linear_tendons.h"
#include "tendons/net/net_continuation.h"

namespace thenar {
namespace {

constexpr double kDrawnAxisLength = 0.03;  // length of the line of a drawn axis [m]
constexpr double kAxisTolerance = 1e-9;    // distance below which the axes of two draws agree [m]

/// Builds the tendons of a fitted digit: straight between its points, with a net if it has one.
std::shared_ptr<const DigitTendons> tendons_of_fit(const TendonDigit& digit) {
  std::shared_ptr<const DigitTendons> linear = straight_tendons(digit);
  if (!digit.net) return linear;
  return std::make_shared<NetTendons>(std::move(linear), *digit.net);
}

/// Builds one cloud for each hinge: the axes of all draws, as lines on the parent link of the
/// hinge, centred near the point where the bone of the fitted digit crosses the axis.
std::vector<LiveCloud> axis_clouds(const std::vector<TendonModel<double>>& draws,
                                   const TendonDigit& digit, const DigitBodies& bodies) {
  // Find the points where the bone of the fitted digit crosses its axes.
  const std::vector<std::string>& hinges = digit.names.hinges;
  const std::vector<Eigen::Vector3d> middles = axis_points(
      digit.model,
      pose_tree(digit.model.tree, Eigen::VectorXd::Zero(digit.model.coordinates).eval()));
  // Add the axes of each draw, centred at the projections of these points.
  std::vector<LiveCloud> clouds(hinges.size());
  for (const TendonModel<double>& model : draws) {
    const TreeState<double> state =
        pose_tree(model.tree, Eigen::VectorXd::Zero(model.coordinates).eval());
    for (std::size_t i = 0; i < hinges.size(); ++i) {
      const LinkState<double>& hinge = state[i];
      const Eigen::Vector3d middle =
          hinge.point + hinge.axis * hinge.axis.dot(middles[i] - hinge.point);
      const int parent = model.tree[i].parent;
      // Transform to the frame of the parent's body, or to the world if the base has no body.
      clouds[i].body = place_in(bodies.links, parent);
      const Pose<double> X = parent >= 0          ? state[parent].X.inverse()
                             : clouds[i].body < 0 ? bodies.X_WS
                                                  : Pose<double>();
      for (const double side : {-0.5, 0.5})
        clouds[i].segments.emplace_back(
            X * Eigen::Vector3d(middle + side * kDrawnAxisLength * hinge.axis));
    }
  }
  for (std::size_t i = 0; i < hinges.size(); ++i) clouds[i].name = hinges[i];
  // Remove clouds whose axis is equal in all draws.
  erase_where(clouds, [](const LiveCloud& cloud) {
    for (std::size_t k = 2; k < cloud.segments.size(); ++k)
      if ((cloud.segments[k] - cloud.segments[k % 2]).norm() > kAxisTolerance) return false;
    return true;
  });
  return clouds;
}

/// Computes the offsets of neighbouring axes: means and quantiles over the draws if parameters move
/// them, else the fitted offset.
std::vector<LiveAxisPair> axis_pairs_of(const TendonDigit& digit, const SpecimenValues& values) {
  std::vector<LiveAxisPair> pairs;
  for (const NeighbouringAxes& axes : neighbouring_axes(digit)) {
    const AxisOffset fitted = axis_offset(digit.model, axes);
    LiveAxisPair pair{axes, fitted, fitted, fitted};
    for (const PosteriorAxes& drawn : values.axes) {
      if (drawn.axes.name != axes.name) continue;
      // PosteriorAxes are in degrees and millimetres.
      const auto offset = [&](double Estimate::*number) {
        return AxisOffset{radians(drawn.angle.*number), 1e-3 * (drawn.distance.*number),
                          1e-3 * (drawn.beyond.*number)};
      };
      pair = {axes, offset(&Estimate::mean), offset(&Estimate::q05), offset(&Estimate::q95)};
    }
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

}  // namespace

LiveFit::LiveFit(const std::string& path) : source_(read_fit_source(path)) {
  // List the trials of all experiments with their specimens.
  const FitProblem& problem = source_.problem;
  for (std::size_t e = 0; e < problem.experiments().size(); ++e)
    for (std::size_t i = 0; i < problem.experiments()[e].trials.size(); ++i)
      trials_.push_back(
          {static_cast<int>(e), static_cast<int>(i), problem.specimen_of(static_cast<int>(e))});
  require(!trials_.empty(), "'{}' was fitted to no trials, only to activations", path);
  // Build one picture for each specimen, and show the first trial.
  for (std::size_t s = 0; s < source_.specimens.size(); ++s)
    pictures_.push_back(draw_specimen(static_cast<int>(s)));
  append_all(source_.warnings, pictures_.front().picture->warnings());
  show_trial(0);
  shape_changes_ = changes_ = 0;
}

LiveFit::SpecimenPicture LiveFit::draw_specimen(int specimen) const {
  const FitProblem& problem = source_.problem;
  const TendonDigit& before = problem.digit_of(specimen);
  const SpecimenValues& values = source_.specimens[specimen];
  const std::string& name = problem.experiments().front().digit;
  // Build the fitted digit and its picture; capsules if it does not have the subject's size.
  SpecimenPicture drawn;
  drawn.model = specimen_model<double>(before, problem.parameters(), values.estimate);
  const TendonDigit digit = specimen_digit(before, drawn.model);
  drawn.picture = std::make_unique<DigitPicture>(
      source_.subject, name, tendons_of_fit(digit), Eigen::VectorXd::Zero(digit.model.coordinates),
      problem.scaling() == Scaling::kSubject ? DigitLook::kAnatomy : DigitLook::kCapsules);
  // Build the digits of the draws.
  std::vector<TendonModel<double>> draws;
  for (const std::vector<double>& draw : values.draws)
    draws.push_back(specimen_model<double>(before, problem.parameters(), draw).digit);
  // Add axis offsets, force arrows and axis clouds.
  drawn.pairs = axis_pairs_of(digit, values);
  drawn.shape = drawn.picture->shape();
  drawn.shape.arrows.push_back({"measured", LiveArrowKind::kMeasured});
  drawn.shape.arrows.push_back({"predicted", LiveArrowKind::kPredicted});
  if (!draws.empty()) drawn.shape.clouds = axis_clouds(draws, digit, drawn.picture->bodies());
  return drawn;
}

const ExperimentPlan& LiveFit::plan() const {
  const LiveTrial& at = trials_[shown_trial_];
  return source_.problem.plans()[at.experiment];
}

const PredictedTrial& LiveFit::predicted(int trial) const {
  require(trial >= 0 && trial < static_cast<int>(trials_.size()),
          "wanted one of {} trials, counted from 0, got {}", trials_.size(), trial);
  const LiveTrial& at = trials_[trial];
  return source_.predictions[at.experiment].trials[at.trial];
}

void LiveFit::show_trial(int trial) {
  (void)predicted(trial);  // throws if there is no such trial
  const std::size_t before = specimen();
  shown_trial_ = trial;
  const SpecimenPicture& drawn = pictures_[specimen()];
  const int i = trials_[trial].trial;
  // Pose the specimen with its fitted errors of angles, and scale the tensions by the fitted gains.
  posed_ = pose_specimen(drawn.model, plan(), static_cast<std::size_t>(plan().posture_of_trial[i]));
  tension_ = drawn.model.gain.cwiseProduct(plan().tension[i]);
  // Find the equilibrium of the net.
  rest_ = {};
  net_warning_.clear();
  if (const auto* net = dynamic_cast<const NetTendons*>(&drawn.picture->tendons())) {
    rest_ = follow_from_straight(*net, posed_.angles, tension_).rest;
    net_warning_ = net_warning(net->net().net, posed_.state, rest_);
  }
  // Another specimen has another shape.
  ++changes_;
  if (specimen() != before) ++shape_changes_;
}

LiveFit::ForceFrame LiveFit::force_frame() const {
  const LiveTrial& at = trials_[shown_trial_];
  const TendonModel<double>& model = digit().model;
  const auto axes = [&](int link) -> Eigen::Matrix3d {
    return link < 0 ? model.tip_axes : Eigen::Matrix3d(posed_.state[link].X.R * model.tip_axes);
  };
  // The force acts at the tip unless the trial measured another site.
  const int other = site_of(plan(), static_cast<std::size_t>(at.trial));
  if (other < 0)
    return {moved(posed_.state, model.tip_link, model.tip),
            axes(model.tip_link) * posed_.cell.transpose()};
  // The other site is a point of a segment, or the first axis for the mount.
  const PlannedSite& site = plan().sites[other];
  const Eigen::Vector3d from = site.link >= 0 ? moved(posed_.state, site.link, site.point)
                                              : axis_points(model, posed_.state).front();
  return {from, axes(site.axes_link) * plan().components.transpose()};
}

std::vector<std::string> LiveFit::warnings() const {
  std::vector<std::string> all = source_.warnings;
  if (!net_warning_.empty()) all.push_back("in this trial: " + net_warning_);
  return all;
}

LiveInstant LiveFit::instant() const {
  LiveInstant instant = pictures_[specimen()].picture->instant(posed_.angles, tension_, rest_);
  const ForceFrame frame = force_frame();
  const PredictedTrial& trial = predicted(shown_trial_);
  for (const Eigen::Vector3d* force : {&trial.measured, &trial.predicted})
    instant.arrows.push_back({subject_pose() * frame.point, subject_pose().R * (frame.R * *force)});
  return instant;
}

}  // namespace thenar
