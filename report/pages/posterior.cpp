#include "report/pages/posterior.h"

#include <cctype>

#include <fmt/format.h>

namespace thenar {
namespace {

const char* const kNotConverged = "This run has NOT converged";

/// "H01: what was learnt", or "What was learnt" where there is but one posterior.
std::string titled(const PosteriorPicture& picture, std::string text) {
  if (!picture.title.empty()) return picture.title + ": " + text;
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

void add(const PosteriorPicture& picture, const std::string& id, const std::string& title,
         const std::string& text, Json blocks, Json& sections) {
  if (blocks.empty()) return;
  // A reader may come by a link to any section.
  if (!sections.empty() && !picture.convergence.warnings.empty()) {
    const Json warning{{"type", "banner"}, {"ok", false}, {"title", kNotConverged}};
    blocks.insert(blocks.begin(), warning);
  }
  sections.push_back(section(picture.prefix + id, titled(picture, title), text, std::move(blocks)));
}

/// A banner of warnings, if there are any.
void add_doubts(const std::string& title, const std::vector<std::string>& warnings, Json& blocks) {
  if (!warnings.empty())
    blocks.push_back({{"type", "banner"}, {"ok", false}, {"title", title}, {"reasons", warnings}});
}

Json convergence_blocks(const PosteriorPicture& picture) {
  Json blocks = Json::array({convergence_banner(picture.convergence, picture.run)});
  add_doubts("Before trusting the predictions", picture.warnings, blocks);
  if (picture.quantities.empty()) return blocks;
  blocks.push_back(chains_block(
      picture.quantities,
      "Chains after warm-up, the largest R-hat first. Left the draws in order; right how many of "
      "each chain's ranks among all draws fall into each twentieth, over the band that holds 95 % "
      "of such counts; below how long a chain remembers"));
  blocks.push_back(
      estimate_table(picture.quantities,
                     "Estimates with their Monte Carlo standard errors, the largest R-hat "
                     "first"));
  return blocks;
}

Json learnt_blocks(const PosteriorPicture& picture) {
  Json blocks = Json::array();
  Json forest = forest_block(
      picture.quantities,
      "50 % (thick) and 90 % (thin) intervals in prior sds over the prior's (grey), the best known "
      "first. At the right mean and sd; learnt is by how much the sd shrank");
  if (!forest["rows"].empty()) blocks.push_back(std::move(forest));
  if (picture.quantities.size() > 1)
    blocks.push_back(corner_block(
        picture.quantities,
        "Densities of single quantities and of pairs: regions that hold 50 and 90 % of the draws, "
        "and the draws outside",
        picture.corner));
  return blocks;
}

Json axis_blocks(const PosteriorPicture& picture) {
  if (!picture.digit || picture.clouds.empty()) return Json::array();
  return Json::array({axis_cloud_scene(
      *picture.digit, picture.posture, picture.clouds, picture.truth,
      "Every line is an axis at one draw, through the point nearest to the bones; the axes before "
      "the fit are named")});
}

Json forces_blocks(const PosteriorPicture& picture) {
  Json blocks = Json::array();
  for (const PredictedForces& predicted : picture.predicted)
    blocks.push_back(predictive_block(predicted));
  if (picture.left_out) {
    add_doubts("Leaving observations out is doubtful", picture.left_out->result.warnings, blocks);
    blocks.push_back(pareto_chart(*picture.left_out));
  }
  return blocks;
}

Json mode_blocks(const PosteriorPicture& picture) {
  Json blocks = Json::array();
  add_doubts("The shares of the modes are not to be trusted", picture.modes->warnings, blocks);
  blocks.push_back(mode_table(*picture.modes, picture.quantities));
  return blocks;
}

Json calibration_blocks(const PosteriorPicture& picture) {
  Json blocks = Json::array();
  add_doubts("The sampler is not calibrated", picture.calibration->warnings, blocks);
  blocks.push_back(calibration_chart(*picture.calibration));
  return blocks;
}

}  // namespace

Json convergence_banner(const Convergence& convergence, const std::string& run) {
  const bool ok = convergence.warnings.empty();
  Json banner{{"type", "banner"},
              {"ok", ok},
              {"title", ok ? "The chains agree" : kNotConverged},
              {"reasons", convergence.warnings}};
  banner["text"] =
      ok ? fmt::format("Largest R-hat {:.4f}, least bulk ESS {:.0f}, least tail ESS {:.0f}. {}",
                       convergence.worst_r_hat, convergence.min_bulk_ess, convergence.min_tail_ess,
                       run)
         : "No number of this posterior may be relied on: chains that disagree, or remember too "
           "long, do not describe the distribution they were sent to. " +
               run;
  return banner;
}

Json posterior_sections(const PosteriorPicture& picture) {
  Json sections = Json::array();
  add(picture, "convergence", "may the draws be believed?", "", convergence_blocks(picture),
      sections);
  if (picture.modes) add(picture, "modes", "modes", "", mode_blocks(picture), sections);
  add(picture, "learnt", "what was learnt", "", learnt_blocks(picture), sections);
  add(picture, "axes", "axes in space", "", axis_blocks(picture), sections);
  add(picture, "predictions", "measured and predicted forces", "", forces_blocks(picture),
      sections);
  if (picture.calibration)
    add(picture, "calibration", "calibration of the method", "", calibration_blocks(picture),
        sections);
  if (!picture.samplers.empty())
    add(picture, "samplers", "speed and accuracy of the samplers", "",
        Json::array({sampler_chart(picture.samplers)}), sections);
  return sections;
}

}  // namespace thenar
