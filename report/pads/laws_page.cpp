// The page of laws of a pad that were calibrated.

#include <algorithm>
#include <utility>

#include "report/blocks.h"
#include "report/pads/laws_answer.h"
#include "report/provenance.h"

namespace thenar {
namespace {

/// Forces of a law over those of the elements, of presses that were fitted or checked.
Json law_series(const PadLaws& found, const std::string& name, double LawForces::*law,
                bool fitted) {
  Json x = Json::array(), y = Json::array();
  for (const LawPress& press : found.presses) {
    if (press.fitted != fitted || !press.laws) continue;
    x.push_back(press.elements.force);
    y.push_back(*press.laws.*law);
  }
  return curve_json(name, std::move(x), std::move(y), "points");
}

Json force_chart(const PadLaws& found, bool fitted) {
  double most = 0;
  for (const LawPress& press : found.presses) most = std::max(most, press.elements.force);
  Json series = Json::array({{{"name", "elements"}, {"x", {0, most}}, {"y", {0, most}}},
                             law_series(found, "power law", &LawForces::power, fitted),
                             law_series(found, "soft finger", &LawForces::soft_finger, fitted),
                             law_series(found, "foundation bed", &LawForces::bed, fitted)});
  return lines_block(fitted ? "Presses that were fitted" : "Presses that were checked",
                     "force by elements [N]", "force by law [N]", std::move(series));
}

}  // namespace

Json page_of(const PadLaws& found) {
  Json blocks = Json::array({refusal_banner(
      refusal_of(found), found.outcome.warnings, "Laws were NOT found",
      found.outcome.stopped() ? "The calibration was stopped: these are the presses by then"
                              : "All fits are at a minimum")});
  // Errors of the laws, then their forces over those of the elements.
  if (found.has_laws()) {
    blocks.push_back(table_block("Errors of laws", table_of(found)));
    blocks.push_back(text_block(errors_note()));
    blocks.push_back(row_block({force_chart(found, true), force_chart(found, false)}));
  }
  Json sections =
      Json::array({section("errors", "Laws and their errors", "", std::move(blocks)),
                   section("presses", "Presses of the elements",
                           "At once and without friction; laws at the same depths beside them.",
                           Json::array({table_block("Presses", press_table(found))}))});
  return {{"title", title_of(found)},
          {"subtitle", conditions_of(found)},
          {"provenance", provenance_json(files_of(found))},
          {"sections", std::move(sections)}};
}

}  // namespace thenar
