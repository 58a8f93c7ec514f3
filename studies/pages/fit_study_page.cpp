#include "studies/pages/fit_study_page.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.h"
#include "kinematics_fit/trivial_prediction.h"
#include "report/pages/fit.h"
#include "report/pages/prediction.h"

namespace thenar {
namespace {

Json error_row(const std::string& specimen, const std::string& what, const std::string& seen,
               const Prediction& prediction) {
  const ForceError& error = prediction.error;
  return Json::array({specimen, what,
                      prediction.calibrated_on_specimen ? "all rows, in its calibration" : seen,
                      error.relative, error.relative_flexion, error.rms, degrees(error.direction)});
}

/// All predictions of one specimen, best known first.
Json rows_of(const SpecimenStudy& study) {
  // Begin with what the fit has seen, then what it has not, then predictions without a fit.
  const std::string specimen = study.fit.problem.specimens().front();
  Json rows = Json::array({error_row(specimen, "Fit, in sample", "all rows", study.in_sample),
                           error_row(specimen, "Fit, posture left out", "other postures",
                                     study.postures.experiments.front()),
                           error_row(specimen, "Fit, tendon left out", "other tendons",
                                     study.tendons.experiments.front())});
  for (const BaselinePrediction& baseline : study.baselines)
    rows.push_back(error_row(specimen, baseline.name, baseline.data_seen, baseline.prediction));
  return rows;
}

Json bars(const std::vector<SpecimenStudy>& studies) {
  // One group of bars for each specimen, in the order of the table.
  const auto bar = [](const Json& row) {
    return Json{{"series", row[1]}, {"value", std::round(1000 * row[3].get<double>()) / 1000}};
  };
  const Json groups = list_of_each(studies, [&](const SpecimenStudy& study) {
    return Json{{"name", study.fit.problem.specimens().front()},
                {"values", list_of_each(rows_of(study), bar)}};
  });
  return {{"type", "bars"},
          {"caption", "Relative error of predicted fingertip forces: RMS residual over RMS force"},
          {"x_label", "relative error"},
          {"groups", groups},
          {"reference_lines", Json::array({{{"value", 0.106}, {"label", "noise floor"}}})}};
}

/// Rise of the cost while one parameter is held and all others make up for it.
Json profiles(const SpecimenStudy& study) {
  // A profile holds one parameter at a value and fits all others again.
  const Json series = list_of_each(study.profiles, [](const Profile& profile) {
    return curve_of_each(profile.name, profile.points, &ProfilePoint::z, &ProfilePoint::rise,
                         "both");
  });
  return with(
      lines_block(fmt::format("{}: profiles of the best known parameters, priors included; a "
                              "profile is inside the line within its 95 % interval",
                              study.fit.problem.specimens().front()),
                  "held at [prior sds]", "rise of the cost", series),
      {{"reference_lines", Json::array({{{"value", 1.92}, {"label", "95 %"}}})}});
}

Json population_row(const std::string& specimen, const std::string& what,
                    const Prediction& prediction) {
  const ForceError& error = prediction.error;
  return Json::array({specimen, what, prediction.calibrated_on_specimen ? "yes" : "no",
                      error.relative, error.relative_flexion, error.rms,
                      error.covered ? Json(100 * *error.covered) : Json(nullptr)});
}

}  // namespace

Json accuracy_page(const std::vector<SpecimenStudy>& studies) {
  // Rows of all specimens, one below the other.
  Json rows = Json::array();
  for (const SpecimenStudy& study : studies) rows = joined(std::move(rows), rows_of(study));
  Json table = table_block(
      "Errors on the same 24 force vectors of each specimen: in space, in the flexion plane alone, "
      "and the median angle between predicted and measured",
      {"specimen", "prediction", "has seen", "relative error:3", "in plane:3", "RMS error [N]:3",
       "angle [deg]:1"},
      rows);
  return section(
      "accuracy", "How well the forces are predicted",
      "Six tendons were loaded one at a time in four postures, and the force of the clamped "
      "fingertip was measured [Synek2019]. A fit moves path points, hood fractions, axes, the load "
      "cell and the postures within anatomical priors. What counts is the error on postures and "
      "tendons that the fit has not seen.\n\nThe noise floor is the mean error of linearity of the "
      "same data: no linear map can honestly do better on unseen loads. The published calibrated "
      "model was calibrated on these specimens, so its error is in sample. The normative finger is "
      "the average of many hands [An1979]; the last row predicts a force by the mean of the same "
      "tendon's forces in the other postures, without any model.\n\nMuscles: FDS and FDP, the "
      "superficial and deep flexors; EDC, the extensor; LU, lumbrical; RI and UI, radial and ulnar "
      "interosseous. Bands of the extensor hood: LE, long extensor at the knuckle; ES, central "
      "slip; RB and UB, radial and ulnar lateral band; TE, terminal slip.",
      Json::array({bars(studies), table}));
}

Json force_page(const std::vector<SpecimenStudy>& studies) {
  // In sample first, then each posture predicted by a fit to the others.
  Json blocks = Json::array();
  for (const SpecimenStudy& study : studies) {
    const std::string specimen = study.fit.problem.specimens().front();
    blocks.push_back(force_panels(
        study.in_sample, fmt::format("{}, in sample. Measured solid, predicted dashed; ellipses "
                                     "hold 95 % of the predictive distribution",
                                     specimen)));
    blocks.push_back(force_panels(
        study.postures.experiments.front(),
        fmt::format("{}, each posture predicted by a fit to the other three", specimen)));
  }
  return section("forces", "Measured and predicted forces",
                 "Forces of the fingertip on the load cell, in the axes of the distal phalanx.",
                 blocks);
}

Json solver_page(const std::vector<SpecimenStudy>& studies) {
  // Compare costs with the least that any solver reached, so that a local minimum shows.
  Json rows = Json::array(), series = Json::array();
  for (const SpecimenStudy& study : studies) {
    const std::string specimen = study.fit.problem.specimens().front();
    double best = study.fit.solution.cost;
    for (const SolverRun& run : study.runs) best = std::min(best, run.solution.cost);
    for (const SolverRun& run : study.runs) {
      const Solution& s = run.solution;
      rows.push_back({specimen, name_of(run.method), convergence_word(s), s.cost,
                      run.error.relative, s.evaluations, s.seconds});
      series.push_back(curve_json(fmt::format("{} {}", specimen, name_of(run.method)),
                                  Json::array({s.seconds}),
                                  Json::array({std::max(s.cost / best - 1, 1e-12)}), "points"));
    }
  }
  return section(
      "solvers", "Speed and accuracy of the solvers",
      "Every solver minimises the same function from the same start. Ceres and Ipopt use exact "
      "derivatives; the two of NLopt use none.",
      Json::array(
          {table_block("Solvers on the same problem",
                       {"specimen", "method", "status", "cost:4", "relative error:3",
                        "evaluations:0", "time [s]:3"},
                       rows),
           with(lines_block("Cost above the best known, over wall time (1e-12 stands for none)",
                            "wall time [s]", "relative excess of cost", series),
                {{"log_x", true}, {"log_y", true}})}));
}

Json parameter_page(const std::vector<SpecimenStudy>& studies) {
  // Estimates of each parameter, profiles, and directions that no force determines.
  Json blocks = Json::array();
  for (const SpecimenStudy& study : studies) {
    blocks.push_back(learnt_forest(study.fit, study.fit.problem.specimens().front()));
    blocks.push_back(profiles(study));
    blocks.push_back(open_directions(study.fit, study.fit.problem.specimens().front()));
  }
  return section("parameters", "What the forces tell about the finger",
                 "Every parameter has a prior from anatomy; its sd is the unit here, and an "
                 "interval as wide as the prior means that nothing was learnt. Directions along "
                 "which no measured force changes are named, not hidden.\n\n" +
                     (studies.empty() ? "" : name_rules(studies.front().fit)),
                 blocks);
}

Json finger_page(const std::vector<SpecimenStudy>& studies, MeshTable& meshes) {
  const auto scene = [&](const SpecimenStudy& study) { return fitted_scene(study.fit, 0, meshes); };
  return section(
      "finger", "The fitted finger",
      "Joint axes and straight tendon runs within the skin; the layers can be switched. The "
      "scenes turn together.",
      Json::array({row_block(list_of_each(studies, scene))}));
}

Json population_page(const PopulationStudy& study, const std::vector<SpecimenStudy>& studies) {
  // Each specimen by its own parameters, by the population, and left out.
  Json rows = Json::array();
  for (std::size_t e = 0; e < study.own.size(); ++e) {
    const std::string& specimen = study.fit.problem.experiments()[e].specimen;
    rows.push_back(population_row(specimen, "by its own parameters, in sample", study.own[e]));
    rows.push_back(population_row(specimen, "by the population, in sample", study.as_unseen[e]));
    const Prediction& left_out = study.specimens.experiments[e];
    rows.push_back(population_row(specimen, "by the other specimens, left out", left_out));
    if (const std::optional<BesideTrivial> beside = beside_trivial(left_out))
      rows.push_back(population_row(specimen, "the other specimens' forces as they are",
                                    {left_out.experiment, {}, beside->trivial}));
    for (const BaselinePrediction& baseline : studies[e].baselines)
      rows.push_back(population_row(specimen, baseline.name, baseline.prediction));
  }
  // Specimens that were never fitted are predicted by the population alone.
  for (const UnseenSpecimen& unseen : study.unseen) {
    rows.push_back(
        population_row(unseen.specimen, "by the population, never fitted", unseen.prediction));
    for (const BaselinePrediction& baseline : unseen.baselines)
      rows.push_back(population_row(unseen.specimen, baseline.name, baseline.prediction));
  }
  Json blocks =
      Json::array({table_block("Specimens predicted by what others have taught",
                               {"specimen", "prediction", "subject has seen it", "relative error:3",
                                "in plane:3", "RMS error [N]:3", "in 95 % interval [%]:0"},
                               rows)});
  for (std::size_t e = 0; e < study.own.size(); ++e)
    if (std::optional<Json> table = beside_trivial_table(
            in_digit_axes(study.specimens.experiments[e], study.fit.problem.experiments()[e])))
      blocks.push_back(*table);
  // Draw the forces of unseen specimens, whose ellipses should hold 95 % of them.
  for (const UnseenSpecimen& unseen : study.unseen)
    blocks.push_back(force_panels(
        unseen.prediction,
        fmt::format("{}, never fitted; ellipses hold 95 % of the predictive distribution",
                    unseen.specimen)));
  return section(
      "population", "A population, and a specimen that was not fitted",
      "All specimens are fitted together as people who differ from their population; an unseen "
      "specimen is predicted by the population alone, and its interval holds what is not known of "
      "the population, how people differ, and the noise.\n\nThe population starts from the "
      "published calibrated model, which was calibrated on all three specimens: its left-out "
      "errors, and those of the bonobo, are not errors of unseen hands. Fitted together, a "
      "specimen's own error differs a little from that of its fit alone, because it borrows from "
      "the other. B01 is the hand of a bonobo: it shows how far the model carries to another "
      "species.",
      blocks);
}

}  // namespace thenar
