#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "kinematics_fit/fit_residuals.h"
#include "kinematics_fit/specimen_model.h"
#include "kinematics_fit/specimen_prior.h"
#include "report/pages/fit.h"
#include "report/scene/digit_layers.h"

namespace thenar {
namespace {

constexpr std::size_t kShown = 24;  // rows of the forest plot

/// One coordinate of a single-specimen fit, in units of its prior sd.
Json interval_row(const Fit& fit, int coordinate) {
  const auto c = static_cast<std::size_t>(coordinate);
  const CoordinateEstimate& learnt = fit.covariance.learnt[c];
  const Parameter& p = fit.problem.parameters().all[fit.problem.parameters().leader[c]];
  const double unit = std::hypot(p.sd, p.between_sd) * display_scale(p);
  const double value = p.mean * display_scale(p) + unit * learnt.z;
  return {{"name", learnt.name},
          {"estimate", learnt.z},
          {"low", learnt.z - 1.96 * learnt.sd},
          {"high", learnt.z + 1.96 * learnt.sd},
          {"prior_low", -1.96},
          {"prior_high", 1.96},
          {"null", learnt.null_share > 0.99},
          {"display", fmt::format("{:+.2f} \u00b1 {:.2f} {}", value, unit * learnt.sd,
                                  display_unit(p) == "1" ? "" : display_unit(p))}};
}

/// The coordinates that the data pinned down most, then some that they do not know.
Json forest(const SpecimenStudy& study) {
  const std::vector<int> order = sorted_by_sd(study.fit.covariance);
  Json rows = Json::array();
  for (std::size_t k = 0; k < std::min(kShown, order.size()); ++k)
    rows.push_back(interval_row(study.fit, order[k]));
  for (std::size_t k = order.size() - std::min<std::size_t>(4, order.size()); k < order.size(); ++k)
    if (k >= kShown) rows.push_back(interval_row(study.fit, order[k]));
  return {{"type", "interval"},
          {"caption", fmt::format("{}: the {} parameters that the forces taught most about, and "
                                  "four they taught least. Bars are 95 % intervals in prior sds; "
                                  "at the right estimate and sd",
                                  study.fit.problem.specimens().front(), kShown)},
          {"x_label", "estimate in prior standard deviations"},
          {"rows", rows}};
}

/// Rise of the cost while one parameter is held and all others make up for it.
Json profiles(const SpecimenStudy& study) {
  Json series = Json::array();
  for (const Profile& profile : study.profiles) {
    Json x = Json::array(), y = Json::array();
    for (const ProfilePoint& point : profile.points) {
      x.push_back(point.z);
      y.push_back(point.rise);
    }
    series.push_back({{"name", profile.name}, {"style", "both"}, {"x", x}, {"y", y}});
  }
  return {{"type", "lines"},
          {"caption", fmt::format("{}: profiles of the best known parameters, priors included; a "
                                  "profile is inside the line within its 95 % interval",
                                  study.fit.problem.specimens().front())},
          {"x_label", "held at [prior sds]"},
          {"y_label", "rise of the cost"},
          {"series", series},
          {"reference_lines", Json::array({{{"value", 1.92}, {"label", "95 %"}}})}};
}

Json null_table(const SpecimenStudy& study) {
  Json rows = Json::array();
  for (const NullDirection& null : study.fit.covariance.null_directions)
    rows.push_back({null.text});
  return table_block(
      fmt::format(
          "{}: {} of {} directions are known from the prior alone ({} forces were measured)",
          study.fit.problem.specimens().front(), rows.size(), study.fit.problem.size(),
          data_rows(study.fit.problem)),
      {{"direction, in prior sds", ""}}, rows);
}

/// The digit as fitted, for drawing.
TendonDigit fitted_digit(const Fit& fit) {
  TendonDigit digit = fit.problem.digit();
  const FitParameters& parameters = fit.problem.parameters();
  digit.model =
      specimen_model(digit, parameters,
                     parameter_values<double>(
                         parameters, displacements(fit.problem.coordinates(), fit.solution.z, 0)))
          .digit;
  return digit;
}

Json scene(const SpecimenStudy& study) {
  const TendonDigit& before = study.fit.problem.digit();
  const TendonDigit after = fitted_digit(study.fit);
  const Eigen::VectorXd q = study.fit.problem.plans().front().postures.front();
  return {
      {"type", "scene"},
      {"caption",
       fmt::format("{} in posture {}: grey before the fit; tendons orange and axes blue after it",
                   study.fit.problem.specimens().front(),
                   study.fit.problem.plans().front().posture_names.front())},
      {"link", "fingers"},
      {"up", {0, 1, 0}},
      {"layers", Json::array({bone_layer(before, q, "#b8a48a"),
                              axis_layer(before, q, "axes before", "#999999", 0.03, false),
                              axis_layer(after, q, "axes fitted", "#0072b2", 0.03, true),
                              tendon_layer(before, q, "tendons before", "#999999", false),
                              tendon_layer(after, q, "tendons fitted", "#d55e00", true)})}};
}

}  // namespace

Json parameter_page(const std::vector<SpecimenStudy>& studies) {
  Json blocks = Json::array();
  for (const SpecimenStudy& study : studies) {
    blocks.push_back(forest(study));
    blocks.push_back(profiles(study));
    blocks.push_back(null_table(study));
  }
  return section(
      "parameters", "What the forces tell about the finger",
      "Every parameter has a prior from anatomy; its sd is the unit here, and an "
      "interval as wide as the prior means that nothing was learnt. Directions along "
      "which no measured force changes are named, not hidden.\n\nNames: path/RI/2/dorsal "
      "is how far the second point of the radial interosseous, counted from its "
      "insertion, lies dorsal of where the subject file has it; axis/DIP3/direction/1 "
      "tilts a joint axis; hood/EDC/central and /slope say how much of a tension goes "
      "to the central slip, and how that changes as the knuckle bends (both on the "
      "logit scale); angle/DIP3/Hook is the error of one joint in one posture; sensor/ "
      "tilts the load cell.",
      blocks);
}

Json finger_page(const std::vector<SpecimenStudy>& studies) {
  Json scenes = Json::array();
  for (const SpecimenStudy& study : studies) scenes.push_back(scene(study));
  return section("finger", "The fitted finger",
                 "Joint axes and straight tendon runs; the layers can be switched. The scenes turn "
                 "together.",
                 Json::array({row_block(scenes)}));
}

}  // namespace thenar
