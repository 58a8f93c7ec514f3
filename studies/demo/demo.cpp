#include "studies/demo/demo.h"

#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "posterior/hand_posterior.h"
#include "report/pads/press_answer.h"
#include "report/pages/compare_rungs.h"
#include "report/pages/comparison.h"
#include "report/pages/posterior.h"
#include "report/pages/tendons.h"
#include "report/picture/digit_layers.h"
#include "report/picture/skin_layer.h"
#include "report/provenance.h"
#include "studies/demo/demo_findings.h"
#include "studies/pages/fit_study_page.h"
#include "studies/pages/measured_lessons.h"
#include "studies/pages/thumb_recovery.h"
#include "studies/pages/thumb_study.h"
#include "tendons/forces/max_tip_force.h"

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

Json thumb_scene(const ShownThumb& thumb, MeshTable& meshes) {
  // Bones, axes, tendons and the set of forces that the tip can make, drawn at the tip.
  Json layers =
      Json::array({bone_layer(thumb.digit, thumb.q, "#b8a48a"),
                   axis_layer(thumb.digit, thumb.q, "joint axes", "#0072b2", 0.03, true),
                   tendon_layer(thumb.digit, thumb.q, "tendons", "#cc79a7", false),
                   force_set_layer(thumb.digit, thumb.q, thumb.set, kMmPerNewton, "#e69f00")});
  // Add the skin where the subject has an anatomy.
  add_skin({thumb.of.subject, thumb.digit, pose_tree(thumb.digit.model.tree, thumb.q)}, meshes,
           layers);
  Eigen::Matrix3d palm = Eigen::Matrix3d::Zero();
  palm.col(1) = thumb.of.dorsal;
  return {{"type", "scene"},
          {"caption", fmt::format("{}: joint axes and feasible thumbtip forces, {} mm per newton",
                                  thumb.of.title, kMmPerNewton)},
          // Scenes of one frame turn together.
          {"link", fmt::format("thumbs-{}", thumb.of.dorsal.z() > thumb.of.dorsal.y() ? "z" : "y")},
          {"up", numbers3(thumb.of.dorsal)},
          {"axes", axis_words(palm)},
          {"layers", std::move(layers)}};
}

/// Largest force along the six directions of the tip [N].
Json thumb_row(const ShownThumb& thumb) {
  // Turn the directions of the tip with its link.
  const TreeState<double> state = pose_tree(thumb.digit.model.tree, thumb.q);
  const Eigen::Matrix3d axes = state[thumb.digit.model.tip_link].X.R * thumb.digit.model.tip_axes;
  Json cells = Json::array(
      {thumb.of.title, thumb.set.dimension, thumb.set.vertices.rows(), thumb.set.volume});
  // Ask for the largest force along each direction and against it; a component is rounded to a
  // micronewton.
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
  // Worst values of the chains, then the expected log predictive density by leaving out one trial
  // at a time.
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
  // Collect every file that was read: subjects, settings, experiments and scenes.
  std::vector<SourceText> sources{inputs.specimen.subject, inputs.specimen.settings,
                                  inputs.population_subject};
  for (const auto* experiments : {&inputs.specimen.experiments, &inputs.unseen})
    sources.insert(sources.end(), experiments->begin(), experiments->end());
  for (const SceneResult* scene : {&demo.motion.glass, &demo.motion.thumb})
    sources.insert(sources.end(), scene->sources.begin(), scene->sources.end());
  Json out = provenance_json(sources, demo.specimens.front().fit.problem.digit().fidelity);
  out["seed"] = fmt::format("{}", SolveOptions{}.seed);
  out["wall time of the whole"] = fmt::format("{:.1f} s", seconds);
  return out;
}

/// Files of the made-up thumb and of the measurements.
Json provenance_of(const ThumbRecoveryResult& result) {
  const ThumbStudyInputs& made_up = result.recovery.inputs;
  const MeasuredThumbInputs& measured = result.lessons.inputs;
  Json out = provenance_json(
      {made_up.truth, made_up.start, made_up.skewed, measured.force, measured.losses},
      result.recovery.truth.fidelity);
  out["seed"] = fmt::format("{}", result.recovery.settings.seed);
  return out;
}

/// A page of some sections. @param figure  type of the block that stands for it
SetPage question(const std::string& file, const std::string& title, const Finding& finding,
                 Json sections, const char* figure, const MeshTable& meshes = {}) {
  return page_for(file, title, finding,
                  {{"title", title}, {"meshes", meshes.json()}, {"sections", std::move(sections)}},
                  figure);
}

/// Pages on the fitted fingers.
std::vector<SetPage> finger_pages(const DemoResult& demo) {
  const std::vector<SpecimenStudy>& studies = demo.specimens;
  MeshTable meshes;
  Json in_space = finger_page(studies, meshes);
  return {
      question("forces.html", "How well are fingertip forces predicted?", force_finding(studies),
               Json::array({accuracy_page(studies), force_page(studies), solver_page(studies)}),
               "bars"),
      question("finger.html", "What do forces tell about a finger?", finger_finding(studies),
               Json::array({std::move(in_space), parameter_page(studies)}), "scene", meshes),
      question("population.html", "Does it carry to another hand?",
               population_finding(*demo.population),
               Json::array({population_page(*demo.population, studies)}), "vectors")};
}

/// All posteriors at a glance, and a page of each.
std::vector<SetPage> posterior_pages(const std::vector<DemoPosterior>& posteriors) {
  std::vector<SetPage> pages{question("posteriors.html", "How sure are we?",
                                      posterior_finding(posteriors),
                                      Json::array({posteriors_at_a_glance(posteriors)}), "")};
  for (const DemoPosterior& posterior : posteriors) {
    PictureOptions options;
    options.title = "Posterior of " + posterior.name;
    pages.push_back(question("posterior_" + posterior.name + ".html", options.title,
                             posterior_finding(posterior),
                             posterior_sections(posterior_picture(posterior.run, options)), ""));
    if (pages.front().figure.is_null())
      pages.front().figure = first_block(pages.back().page, "corner");
  }
  return pages;
}

/// Pages on hoods and thumbs.
std::vector<SetPage> model_pages(const DemoResult& demo) {
  MeshTable hood_meshes, thumb_meshes;
  Json nets = hood_page(demo.hood.sweep, demo.hood.rungs, hood_meshes);
  const Json thumbs = thumb_page(demo.thumbs, thumb_meshes);
  const ThumbStudy& study = demo.thumb_study.study;
  const ThumbRecoveryResult& recovery = demo.thumb_recovery;
  SetPage founding = question(
      "founding_thumb.html", "Are a thumb's axes found as in [Miller2005]?",
      thumb_recovery_finding(recovery),
      Json::array({thumb_recovery_section(recovery.recovery), measured_lessons_section(recovery)}),
      "scene");
  founding.page["provenance"] = provenance_of(recovery);
  return {question("hood.html", "How should the extensor hood be modelled?",
                   hood_finding(demo.hood), Json::array({std::move(nets)}), "row", hood_meshes),
          question("thumbs.html", "What do skewed axes cost a thumb?", thumb_finding(study, thumbs),
                   Json::array({thumbs, thumb_study_section(study)}), "row", thumb_meshes),
          std::move(founding)};
}

/// Pages on hands that grasp and on pads.
std::vector<SetPage> grasp_and_pad_pages(const DemoResult& demo) {
  return {page_for("hands.html", "How do hands compare when they grasp?",
                   hands_finding(demo.hands.comparison), page_of(demo.hands), "row"),
          page_for("pad.html", "What does a finger pad do under a ball?", pad_finding(demo.pad),
                   page_of(demo.pad), "scene"),
          page_for("pencil_pinch.html", "What do models of pads cost in a pinch?",
                   pencil_finding(demo.pencil), page_of(demo.pencil), "row")};
}

/// The front page, without what sums up the others.
SetPage front_of(double seconds) {
  const char* const title = "thenar: what the demo asked, did and learnt";
  return {
      kFrontPage,
      "Summary",
      {"What do measured fingertip forces tell of a hand, and what can models of hands then do?",
       fmt::format("In {:.0f} s fingers were fitted to measured forces, posteriors were sampled, "
                   "thumbs and hoods compared, scenes moved, objects grasped and pads pressed.",
                   seconds),
       "Each question has one line here, a figure below, and a page of its own."},
      "",
      {{"title", title},
       {"subtitle", "Middle fingers of two human hands [Synek2019], thumbs, and hands in motion"}},
      nullptr};
}

}  // namespace

Json thumb_page(const std::vector<DemoThumb>& thumbs, MeshTable& meshes) {
  // Draw each thumb, and put its largest forces into the table.
  Json scenes = Json::array(), rows = Json::array();
  for (const DemoThumb& of : thumbs) {
    const ShownThumb thumb = prepare(of);
    scenes.push_back(thumb_scene(thumb, meshes));
    rows.push_back(thumb_row(thumb));
  }
  std::vector<BlockColumn> columns{"thumb", "dimension:0", "corners:0", "volume [N\u00b3]:0"};
  for (const char* direction : kDirectionNames) columns.push_back({direction, "N", 1});
  return section(
      "thumbs", "The thumb: orthogonal and skewed axes",
      "Every force that the pinned thumbtip can exert while each tendon tension lies between zero "
      "and its largest and all joint torques are in balance. The first two thumbs bend 30 degrees "
      "at MCP and IP and have the same seven tendons, constant moment arms [Nakajima2022] and "
      "largest forces [McFarland2023]; their axes differ: four that cross or run parallel, and "
      "five that do neither [GraspIt]. The arms are borrowed from yet another thumb, so compare "
      "shapes, not newtons. The third has measured axes and straight tendon runs [Mirakhorlo2016], "
      "in the posture in which it was digitised.\n\nThe more axes the same tendons must balance at "
      "once, the smaller the set: a fifth axis costs force. Scenes of one frame turn together; the "
      "back of the hand is up.",
      Json::array(
          {row_block(scenes),
           table_block("Feasible thumbtip forces: the set, and the largest pure force along "
                       "the thumb's own directions; 0 where no tensions make a pure "
                       "force that way with every joint in balance",
                       columns, rows)}));
}

Json posteriors_at_a_glance(const std::vector<DemoPosterior>& posteriors) {
  // Predictions of fingers that were fitted and of one that was not, side by side.
  Json rows = Json::array(), runs = Json::array();
  for (const DemoPosterior& posterior : posteriors) {
    for (const Prediction& prediction : posterior.fitted)
      rows.push_back(posterior_row(posterior, prediction, "in sample"));
    for (const Prediction& prediction : posterior.unseen)
      rows.push_back(posterior_row(posterior, prediction, "never fitted"));
    runs.push_back(chains_row(posterior));
  }
  return section(
      "posteriors", "Posteriors at a glance",
      "Draws in place of a single best point show how much the forces determine. Errors "
      "are those of the posterior mean; intervals are predictive, noise included.",
      Json::array({table_block("Predicted forces",
                               {"posterior", "experiment", "how", "relative error:3",
                                "in flexion:3", "within 95 % [%]:0"},
                               rows),
                   table_block("Runs of the sampler (NUTS, 4 chains)",
                               {"posterior", "entries:0", "worst R-hat:4", "least bulk ESS:0",
                                "divergent:0", "modes:0", "elpd, one trial left out:1", "se:1",
                                "effective parameters:1", "Pareto k too large:0", "sampling [s]:1"},
                               runs)}));
}

std::vector<SetPage> demo_pages(const DemoResult& demo, double seconds) {
  std::vector<SetPage> pages;
  const auto add = [&](std::vector<SetPage> some) {
    std::move(some.begin(), some.end(), std::back_inserter(pages));
  };
  add(finger_pages(demo));
  add(posterior_pages(demo.posteriors));
  add(model_pages(demo));
  add(moving_scene_pages(demo.motion));
  add(grasp_and_pad_pages(demo));
  // Sum up last, because the front page repeats a line and a figure of every page.
  SetPage front = front_of(seconds);
  fill_front_page(pages, front);
  pages.insert(pages.begin(), std::move(front));
  link_pages(pages);
  // Pages that say nothing of their origin have that of the whole.
  const Json provenance = provenance_of(demo, seconds);
  for (SetPage& page : pages)
    if (!page.page.contains("provenance")) page.page["provenance"] = provenance;
  return pages;
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
