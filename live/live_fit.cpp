#include "live/live_fit.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "base/lists.h"
#include "base/units.h"
#include "kinematics_fit/model/net_trials.h"
#include "tendons/linear_tendons.h"
#include "tendons/net/net_continuation.h"

namespace thenar {
namespace {

constexpr double kDrawnAxis = 0.03;  // length of an axis of a draw [m]
constexpr double kSameAxis = 1e-9;   // from draw to draw [m]

/// Tendons of a fitted digit: through the points of its model, with a net if it has one.
std::shared_ptr<const DigitTendons> tendons_of_fit(const TendonDigit& digit) {
  std::shared_ptr<const DigitTendons> linear = straight_tendons(digit);
  if (!digit.net) return linear;
  return std::make_shared<NetTendons>(std::move(linear), *digit.net);
}

/// Axes of draws, from end to end about where the bone of the fitted digit crosses them, on the
/// link that carries each hinge.
std::vector<LiveCloud> axis_clouds(const std::vector<TendonModel<double>>& drawn,
                                   const TendonDigit& digit, const DigitBodies& bodies) {
  // Middles on the axes of the fitted digit keep the drawn lines side by side.
  const std::vector<std::string>& hinges = digit.names.hinges;
  const std::vector<Eigen::Vector3d> middles = axis_points(
      digit.model,
      pose_tree(digit.model.tree, Eigen::VectorXd::Zero(digit.model.coordinates).eval()));
  std::vector<LiveCloud> clouds(hinges.size());
  for (const TendonModel<double>& model : drawn) {
    const TreeState<double> state =
        pose_tree(model.tree, Eigen::VectorXd::Zero(model.coordinates).eval());
    for (std::size_t i = 0; i < hinges.size(); ++i) {
      const LinkState<double>& hinge = state[i];
      const Eigen::Vector3d middle =
          hinge.point + hinge.axis * hinge.axis.dot(middles[i] - hinge.point);
      const int parent = model.tree[i].parent;
      // The base may have no body: then it is the world that carries them.
      clouds[i].body = place_in(bodies.links, parent);
      const Pose<double> X = parent >= 0          ? state[parent].X.inverse()
                             : clouds[i].body < 0 ? bodies.X_WS
                                                  : Pose<double>();
      for (const double side : {-0.5, 0.5})
        clouds[i].segments.emplace_back(X *
                                        Eigen::Vector3d(middle + side * kDrawnAxis * hinge.axis));
    }
  }
  for (std::size_t i = 0; i < hinges.size(); ++i) clouds[i].name = hinges[i];
  // Axes that no draw has moved are no clouds.
  const auto still = [](const LiveCloud& cloud) {
    for (std::size_t k = 2; k < cloud.segments.size(); ++k)
      if ((cloud.segments[k] - cloud.segments[k % 2]).norm() > kSameAxis) return false;
    return true;
  };
  clouds.erase(std::remove_if(clouds.begin(), clouds.end(), still), clouds.end());
  return clouds;
}

/// Offsets of neighbouring axes: means and quantiles of all draws where they move, else of the
/// model.
std::vector<LiveAxisPair> pairs_of(const TendonDigit& digit, const SpecimenValues& values) {
  std::vector<LiveAxisPair> pairs;
  // Neighbouring axes may cross or miss each other; their angle and distance are what anatomists
  // measure.
  for (const NeighbouringAxes& axes : neighbouring_axes(digit)) {
    const AxisOffset fitted = axis_offset(digit.model, axes);
    LiveAxisPair pair{axes, fitted, fitted, fitted};
    for (const PosteriorAxes& drawn : values.axes) {
      if (drawn.axes.name != axes.name) continue;
      const auto offset = [&](double Estimate::*of) {
        return AxisOffset{radians(drawn.angle.*of), 1e-3 * (drawn.distance.*of),
                          1e-3 * (drawn.beyond.*of)};
      };
      pair = {axes, offset(&Estimate::mean), offset(&Estimate::q05), offset(&Estimate::q95)};
    }
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

}  // namespace

LiveFit::LiveFit(const std::string& path) : source_(read_fit_source(path)) {
  // List all trials of all experiments, each with the specimen that it belongs to.
  const FitProblem& problem = source_.problem;
  for (std::size_t e = 0; e < problem.experiments().size(); ++e)
    for (std::size_t i = 0; i < problem.experiments()[e].trials.size(); ++i)
      trials_.push_back(
          {static_cast<int>(e), static_cast<int>(i), problem.specimen_of(static_cast<int>(e))});
  require(!trials_.empty(), "'{}' was fitted to no trials, only to activations", path);
  // Build one picture for each specimen, whose geometry the fit may have changed.
  for (std::size_t s = 0; s < source_.specimens.size(); ++s)
    looks_.push_back(look_of(static_cast<int>(s)));
  for (const std::string& warning : looks_.front().picture->warnings())
    source_.warnings.push_back(warning);
  show(0);
  shape_changes_ = changes_ = 0;
}

LiveFit::Look LiveFit::look_of(int specimen) const {
  const FitProblem& problem = source_.problem;
  // Start from the digit before the fit, which parameters shift.
  const TendonDigit& before = problem.digit_of(specimen);
  const SpecimenValues& values = source_.specimens[specimen];
  const std::string& name = problem.experiments().front().digit;
  // The fitted digit, with bones of the subject where it has its size.
  Look look;
  look.model = specimen_model<double>(before, problem.parameters(), values.estimate);
  const TendonDigit digit = specimen_digit(before, look.model);
  look.picture = std::make_unique<DigitPicture>(
      source_.subject, name, tendons_of_fit(digit), Eigen::VectorXd::Zero(digit.model.coordinates),
      problem.scaling() == Scaling::kSubject ? DigitLook::kAnatomy : DigitLook::kCapsules);
  // Axes of some draws.
  std::vector<TendonModel<double>> drawn;
  for (const std::vector<double>& draw : values.drawn)
    drawn.push_back(specimen_model<double>(before, problem.parameters(), draw).digit);
  look.pairs = pairs_of(digit, values);
  look.shape = look.picture->shape();
  look.shape.arrows.push_back({"measured", LiveArrowKind::kMeasured});
  look.shape.arrows.push_back({"predicted", LiveArrowKind::kPredicted});
  if (!drawn.empty()) look.shape.clouds = axis_clouds(drawn, digit, look.picture->bodies());
  return look;
}

const ExperimentPlan& LiveFit::plan() const {
  const LiveTrial& at = trials_[shown_];
  return source_.problem.plans()[at.experiment];
}

const PredictedTrial& LiveFit::predicted(int trial) const {
  require(trial >= 0 && trial < static_cast<int>(trials_.size()),
          "wanted one of {} trials, counted from 0, got {}", trials_.size(), trial);
  const LiveTrial& at = trials_[trial];
  return source_.predictions[at.experiment].trials[at.trial];
}

void LiveFit::show(int trial) {
  (void)predicted(trial);  // refuses one that is not there
  // Another specimen has other bones, so the viewer has to rebuild its shapes.
  const std::size_t before = specimen();
  shown_ = trial;
  const Look& look = looks_[specimen()];
  const auto i = static_cast<std::size_t>(trials_[trial].trial);
  // The posture with its errors, and the tensions that arrive.
  posed_ = pose_specimen(look.model, plan(), static_cast<std::size_t>(plan().posture_of_trial[i]));
  tension_ = look.model.gain.cwiseProduct(plan().tension[i]);
  // A net at rest under them.
  rest_ = {};
  net_trouble_.clear();
  if (const auto* net = dynamic_cast<const NetTendons*>(&look.picture->tendons())) {
    rest_ = follow_from_straight(*net, posed_.angles, tension_).rest;
    net_trouble_ = net_warning(net->net().net, posed_.state, rest_);
  }
  ++changes_;
  if (specimen() != before) ++shape_changes_;
}

LiveFit::ForcePlace LiveFit::force_place() const {
  const LiveTrial& at = trials_[shown_];
  const TendonModel<double>& model = digit().model;
  const auto axes = [&](int link) -> Eigen::Matrix3d {
    return link < 0 ? model.tip_axes : Eigen::Matrix3d(posed_.state[link].X.R * model.tip_axes);
  };
  // At the tip, on a segment that is held in its place, or on the mount.
  const int other = site_of(plan(), static_cast<std::size_t>(at.trial));
  if (other < 0)
    return {moved(posed_.state, model.tip_link, model.tip),
            axes(model.tip_link) * posed_.cell.transpose()};
  const PlannedSite& site = plan().sites[other];
  const Eigen::Vector3d from = site.link >= 0 ? moved(posed_.state, site.link, site.point)
                                              : axis_points(model, posed_.state).front();
  return {from, axes(site.axes_link) * plan().components.transpose()};
}

std::vector<std::string> LiveFit::warnings() const {
  std::vector<std::string> all = source_.warnings;
  if (!net_trouble_.empty()) all.push_back("in this trial: " + net_trouble_);
  return all;
}

LiveInstant LiveFit::instant() const {
  LiveInstant instant = looks_[specimen()].picture->instant(posed_.angles, tension_, rest_);
  const ForcePlace place = force_place();
  const PredictedTrial& trial = predicted(shown_);
  for (const Eigen::Vector3d* force : {&trial.measured, &trial.predicted})
    instant.arrows.push_back({placed() * place.from, placed().R * (place.to_frame * *force)});
  return instant;
}

}  // namespace thenar
