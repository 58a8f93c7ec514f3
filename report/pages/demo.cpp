#include "report/pages/demo.h"

#include <cmath>

#include <fmt/format.h>

#include "report/pages/fit_study.h"
#include "report/pages/posterior.h"
#include "report/pages/tendons.h"
#include "report/pages/thumb_study.h"
#include "report/provenance.h"
#include "report/scene/digit_layers.h"
#include "tendons/forces/feasible_force_set.h"
#include "tendons/forces/max_tip_force.h"
#include "tendons/tendon_model.h"

namespace thenar {
namespace {

constexpr double kMmPerNewton = 0.4;
constexpr const char* kDirectionNames[] = {"proximal", "distal", "dorsal",
                                           "palmar",   "radial", "ulnar"};

/// A thumb with all that is shown of it.
struct ShownThumb {
  const DemoThumb& of;
  TendonDigit digit;
  Eigen::VectorXd q;
  TipStatics statics;
  FeasibleForceSet set;
};

ShownThumb prepare(const DemoThumb& of) {
  TendonDigit digit = build_tendon_digit(of.subject, "thumb");
  const Eigen::VectorXd q = posture(digit.skeleton, of.posture);
  TipStatics statics = tip_statics(digit, q);
  FeasibleForceSet set = feasible_force_set(statics);
  return {of, std::move(digit), q, std::move(statics), std::move(set)};
}

Json thumb_scene(const ShownThumb& thumb) {
  return {
      {"type", "scene"},
      {"caption", fmt::format("{}: joint axes and feasible thumbtip forces, {} mm per newton",
                              thumb.of.title, kMmPerNewton)},
      // Scenes of one frame turn together.
      {"link", fmt::format("thumbs-{}", thumb.of.dorsal.z() > thumb.of.dorsal.y() ? "z" : "y")},
      {"up", numbers3(thumb.of.dorsal)},
      {"layers",
       Json::array({bone_layer(thumb.digit, thumb.q, "#b8a48a"),
                    axis_layer(thumb.digit, thumb.q, "joint axes", "#0072b2", 0.03, true),
                    tendon_layer(thumb.digit, thumb.q, "tendons", "#cc79a7", false),
                    force_set_layer(thumb.digit, thumb.q, thumb.set, kMmPerNewton, "#e69f00")})}};
}

/// Largest force along the six directions of the tip [N].
Json thumb_row(const ShownThumb& thumb) {
  const TreeState<double> state = pose_tree(thumb.digit.model.tree, thumb.q);
  const Eigen::Matrix3d axes = state[thumb.digit.model.tip_link].X.R * thumb.digit.model.tip_axes;
  Json cells = Json::array(
      {thumb.of.title, thumb.set.dimension, thumb.set.vertices.rows(), thumb.set.volume});
  for (int k = 0; k < 6; ++k) {
    const MaxTipForce most =
        max_tip_force(thumb.statics, (k % 2 == 0 ? 1.0 : -1.0) * axes.col(k / 2));
    cells.push_back(most.status == Status::kSolved ? Json(std::round(1e6 * most.component) / 1e6)
                                                   : Json(nullptr));
  }
  return cells;
}

Json posterior_row(const DemoPosterior& posterior, const Prediction& prediction,
                   const std::string& how) {
  const ForceError& error = prediction.error;
  return {posterior.name,
          prediction.experiment,
          prediction.calibrated_on_specimen ? how + "; the subject has seen it" : how,
          error.relative,
          error.relative_flexion,
          100 * error.covered.value_or(0)};
}

Json chains_row(const DemoPosterior& posterior) {
  const LeaveOneOut& loo = posterior.left_out.result;
  const Convergence& c = posterior.run.convergence;
  return {posterior.name,
          posterior.run.posterior->size(),
          c.worst_r_hat,
          c.min_bulk_ess,
          c.divergent,
          posterior.run.modes.size(),
          loo.elpd,
          loo.se,
          loo.effective_parameters,
          (loo.k.array() > loo.good_k).count(),
          posterior.run.draws.seconds};
}

Json provenance_of(const DemoResult& demo, double seconds) {
  const StudyInputs& inputs = demo.inputs;
  std::vector<SourceText> sources{inputs.specimen.subject, inputs.specimen.settings,
                                  inputs.population_subject};
  for (const auto* experiments : {&inputs.specimen.experiments, &inputs.unseen})
    sources.insert(sources.end(), experiments->begin(), experiments->end());
  for (const SimulatedScene* scene : {&demo.motion.glass, &demo.motion.thumb})
    sources.insert(sources.end(), scene->sources.begin(), scene->sources.end());
  Json out = provenance_json(sources, demo.specimens.front().fit.problem.digit().fidelity);
  out["seed"] = fmt::format("{}", SolveOptions{}.seed);
  out["wall time of the whole"] = fmt::format("{:.1f} s", seconds);
  return out;
}

}  // namespace

Json thumb_page(const std::vector<DemoThumb>& thumbs) {
  Json scenes = Json::array(), rows = Json::array();
  for (const DemoThumb& of : thumbs) {
    const ShownThumb thumb = prepare(of);
    scenes.push_back(thumb_scene(thumb));
    rows.push_back(thumb_row(thumb));
  }
  std::vector<BlockColumn> columns{
      {"thumb", "", -1}, {"dimension", "", 0}, {"corners", "", 0}, {"volume", "N\u00b3", 0}};
  for (const char* direction : kDirectionNames) columns.push_back({direction, "N", 1});
  return section(
      "thumbs", "The thumb: orthogonal and skewed axes",
      "Every force that the pinned thumbtip can make with tendon tensions between zero and their "
      "largest, every joint torque balanced. The first two thumbs bend 30 degrees at MCP and IP "
      "and have the same seven tendons, constant moment arms [Nakajima2022] and largest forces "
      "[McFarland2023]; their axes differ: four that cross or run parallel, and five that do "
      "neither [GraspIt]. The arms are borrowed from yet another thumb, so compare shapes, not "
      "newtons. The third has measured axes and straight tendon runs [Mirakhorlo2016], in the "
      "posture in which it was digitised.\n\nThe more axes must be balanced at once by the same "
      "tendons, the smaller the set: a fifth axis costs force. Scenes of one frame turn together; "
      "the back of the hand is up.",
      Json::array(
          {row_block(scenes),
           table_block("Feasible thumbtip forces: the set, and the largest pure force along "
                       "the thumb's own directions; 0 where no tensions make a pure "
                       "force that way with every joint in balance",
                       columns, rows)}));
}

Json posteriors_at_a_glance(const std::vector<DemoPosterior>& posteriors) {
  Json rows = Json::array(), runs = Json::array();
  for (const DemoPosterior& posterior : posteriors) {
    for (const Prediction& prediction : posterior.fitted)
      rows.push_back(posterior_row(posterior, prediction, "in sample"));
    for (const Prediction& prediction : posterior.unseen)
      rows.push_back(posterior_row(posterior, prediction, "never fitted: a stranger"));
    runs.push_back(chains_row(posterior));
  }
  return section(
      "posteriors", "Posteriors at a glance",
      "Draws instead of one best point: how sure the forces make us. Errors are of the posterior "
      "mean; the interval is the predictive one, noise included.",
      Json::array({table_block("Predicted forces",
                               {{"posterior", ""},
                                {"experiment", ""},
                                {"how", ""},
                                {"relative error", "", 3},
                                {"in flexion", "", 3},
                                {"within 95 %", "%", 0}},
                               rows),
                   table_block("Runs of the sampler (NUTS, 4 chains)",
                               {{"posterior", ""},
                                {"entries", "", 0},
                                {"worst R-hat", "", 4},
                                {"least bulk ESS", "", 0},
                                {"divergent", "", 0},
                                {"modes", "", 0},
                                {"elpd, one trial left out", "", 1},
                                {"se", "", 1},
                                {"effective parameters", "", 1},
                                {"Pareto k too large", "", 0},
                                {"sampling", "s", 1}},
                               runs)}));
}

Json demo_page(const DemoResult& demo, const Json& more, double seconds) {
  Json sections =
      Json::array({accuracy_page(demo.specimens), force_page(demo.specimens),
                   solver_page(demo.specimens), parameter_page(demo.specimens),
                   finger_page(demo.specimens), population_page(demo.population, demo.specimens),
                   hood_page(demo.hood.sweep, demo.hood.rungs), thumb_page(demo.thumbs),
                   posteriors_at_a_glance(demo.posteriors)});
  for (const DemoPosterior& posterior : demo.posteriors) {
    PictureOptions options;
    options.title = "Posterior of " + posterior.name;
    options.prefix = "posterior-" + posterior.name + "-";
    for (Json& part : posterior_sections(posterior_picture(posterior.run, options)))
      sections.push_back(std::move(part));
  }
  sections.push_back(thumb_study_section(demo.thumb_study.study));
  MeshTable meshes;
  for (Json& part : moving_scene_sections(demo.motion, meshes)) sections.push_back(std::move(part));
  sections.insert(sections.end(), more.begin(), more.end());
  return {
      {"title", "thenar: a finger fitted to its forces"},
      {"subtitle", "Middle fingers of two human hands [Synek2019], thumbs, and hands in motion"},
      {"provenance", provenance_of(demo, seconds)},
      {"meshes", meshes.json()},
      {"sections", sections}};
}

std::string demo_text(const DemoResult& demo, const std::string& page, double seconds) {
  std::string text;
  for (const SpecimenStudy& study : demo.specimens)
    text += fmt::format("{}: relative error {:.3f} in sample, {:.3f} with one posture left out\n",
                        study.in_sample.experiment, study.in_sample.error.relative,
                        study.postures.experiments.front().error.relative);
  return text + fmt::format("wrote {} in {:.1f} s\n", page, seconds);
}

}  // namespace thenar
