#include <fmt/format.h>

#include "report/pages/fit.h"
#include "report/pages/forces.h"

namespace thenar {
namespace {

Json row(const std::string& specimen, const std::string& what, const Prediction& prediction) {
  const ForceError& error = prediction.error;
  return Json::array({specimen, what, prediction.calibrated_on_specimen ? "yes" : "no",
                      error.relative, error.relative_flexion, error.rms,
                      error.covered ? Json(100 * *error.covered) : Json(nullptr)});
}

}  // namespace

Json population_page(const PopulationStudy& study, const std::vector<SpecimenStudy>& studies) {
  Json rows = Json::array();
  for (std::size_t e = 0; e < study.own.size(); ++e) {
    const std::string& specimen = study.fit.problem.experiments()[e].specimen;
    rows.push_back(row(specimen, "by its own parameters, in sample", study.own[e]));
    rows.push_back(row(specimen, "by the population, in sample", study.as_unseen[e]));
    rows.push_back(
        row(specimen, "by the other specimens, left out", study.specimens.experiments[e]));
    for (const BaselinePrediction& baseline : studies[e].baselines)
      rows.push_back(row(specimen, baseline.name, baseline.prediction));
  }
  for (const UnseenSpecimen& unseen : study.unseen) {
    rows.push_back(row(unseen.specimen, "by the population, never fitted", unseen.prediction));
    for (const BaselinePrediction& baseline : unseen.baselines)
      rows.push_back(row(unseen.specimen, baseline.name, baseline.prediction));
  }
  Json blocks = Json::array({table_block("Specimens predicted by what others have taught",
                                         {{"specimen", ""},
                                          {"prediction", ""},
                                          {"subject has seen it", ""},
                                          {"relative error", "", 3},
                                          {"in plane", "", 3},
                                          {"RMS error", "N", 3},
                                          {"in 95 % interval", "%", 0}},
                                         rows)});
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
      "errors, "
      "and those of the bonobo, are no errors of strangers. Fitted together, a specimen's own "
      "error differs a little "
      "from that of its fit alone, because it borrows from the other. B01 is a bonobo, no human, "
      "and is shown for how far the model "
      "carries.",
      blocks);
}

}  // namespace thenar
