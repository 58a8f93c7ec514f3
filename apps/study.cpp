// thenar study thumb -o PAGE.html
//
// Made-up experiments whose answer is known: how well models explain them, and what is learnt.

#include <memory>

#include <fmt/format.h>

#include "api/data_folders.h"
#include "apps/commands.h"
#include "apps/options.h"
#include "apps/terminal.h"
#include "base/file_io.h"
#include "base/interrupt.h"
#include "base/progress_parts.h"
#include "base/units.h"
#include "report/json.h"
#include "report/page.h"
#include "report/pages/thumb_study.h"
#include "report/provenance.h"
#include "report/table.h"

namespace thenar {
namespace {

struct StudyArguments {
  std::string data, output;
  long draws = 0;
  int simulations = 0;
  unsigned seed = 1;
  bool quick = false, json = false, allow_unconverged = false;
};

Json scores_json(const TaskScores& tasks) {
  return {{"direction_deg", degrees(tasks.direction)},
          {"direction_sd_deg", degrees(tasks.direction_sd)},
          {"torque_Nm", tasks.torque},
          {"torque_sd_Nm", tasks.torque_sd},
          {"explained", tasks.explained}};
}

Json fit_json(const ThumbFit& fit) {
  Json out{{"axes", fit.settings.skewed ? "skewed" : "orthogonal"},
           {"arms", fit.settings.arms == Arms::kFixed ? "known" : "free"},
           {"noise", fit.settings.noise},
           {"postures", fit.settings.postures},
           {"skewness", fit.settings.skewness},
           {"tasks_fitted", fit.settings.with_tasks},
           {"prior_width", fit.settings.prior_width},
           {"converged", fit.converged()},
           {"reasons", fit.run.convergence.warnings},
           {"pulls_direction_deg", degrees(fit.direction)},
           {"pulls_direction_sd_deg", degrees(fit.direction_sd)},
           {"pulls_off_truth", fit.relative_error},
           {"tasks", scores_json(fit.tasks)},
           {"elpd", fit.left_out.elpd},
           {"elpd_se", fit.left_out.se},
           {"modes", fit.run.modes.size()}};
  for (const LearntNumber& number : fit.learnt)
    out["learnt"].push_back({{"name", number.name},
                             {"unit", number.unit},
                             {"mean", number.mean},
                             {"sd", number.sd},
                             {"prior_sd", number.prior_sd},
                             {"truth", number.truth ? Json(*number.truth) : Json(nullptr)}});
  return out;
}

Json study_json(const ThumbStudy& study, const std::optional<ThumbCalibration>& calibration) {
  Json out{{"complete", study.complete}, {"fits", Json::array()}, {"not_fitted", Json::array()}};
  for (const ThumbFit& fit : study.fits) out["fits"].push_back(fit_json(fit));
  for (const ThumbReference& reference : study.references)
    out["not_fitted"].push_back({{"noise", reference.noise},
                                 {"skewness", reference.skewness},
                                 {"start_pulls_direction_deg", degrees(reference.direction)},
                                 {"start_tasks", scores_json(reference.start)},
                                 {"truth_tasks", scores_json(reference.truth)}});
  if (!calibration) return out;
  Json& judged = out["calibration"];
  judged = {{"simulations", calibration->rank.cols()},
            {"not_converged", calibration->not_converged},
            {"covered_90", calibration->covered},
            {"reasons", calibration->judged.warnings}};
  for (const ParameterCalibration& parameter : calibration->judged.parameters)
    judged["parameters"].push_back({{"name", parameter.name},
                                    {"band_p", parameter.band_p},
                                    {"chi_square_p", parameter.chi_square_p}});
  return out;
}

void print_study(const ThumbStudy& study) {
  Table table{{"fit", "pulls_deg", "off_truth_percent", "tasks_deg", "torque_Nm",
               "explained_percent", "elpd", "modes", "R_hat", "chains_agree"},
              {}};
  for (const ThumbFit& fit : study.fits)
    table.rows.push_back(
        {describe_fit(fit.settings), shown(degrees(fit.direction), 1),
         shown(100 * fit.relative_error, 1), shown(degrees(fit.tasks.direction), 1),
         shown(fit.tasks.torque, 3), shown(100 * fit.tasks.explained, 0),
         shown(fit.left_out.elpd, 1), fmt::format("{}", fit.run.modes.size()),
         shown(fit.run.convergence.worst_r_hat, 4), fit.converged() ? "yes" : "NO"});
  fmt::print("{}", titled("Thumbs fitted to forces of a skewed one", table));
}

Json provenance(const ThumbStudy& study, const StudyArguments& options) {
  const ThumbStudyInputs& inputs = study.inputs;
  Json out = provenance_json({inputs.truth, inputs.start, inputs.orthogonal, inputs.skewed},
                             study.truth.fidelity);
  out["seed"] = fmt::format("{}", options.seed);
  return out;
}

std::optional<ThumbCalibration> calibrate(const StudyArguments& options,
                                          const ThumbStudyInputs& inputs) {
  if (options.simulations == 0 || interrupted()) return std::nullopt;
  ThumbCalibrationSettings settings;
  settings.simulations = options.simulations;
  settings.seed = options.seed;
  settings.progress = terminal_progress();
  return calibrate_thumb(inputs, settings);
}

void run_thumb(const StudyArguments& options) {
  require_ending(options.output, {".html"});
  if (!options.output.empty()) require_writable(options.output);
  const ThumbStudyInputs inputs = thumb_study_inputs(data_with("fits", options.data));
  ThumbStudySettings settings = options.quick ? quick_thumb_study() : full_thumb_study();
  if (options.draws > 0) settings.draws = settings.warm_up = options.draws;
  settings.seed = options.seed;
  settings.progress = terminal_progress();
  const ThumbStudy study = study_thumb(inputs, settings);
  const std::optional<ThumbCalibration> calibration = calibrate(options, inputs);

  if (!options.output.empty())
    write_report({{"title", "thenar: what forces tell of a thumb"},
                  {"subtitle", "Orthogonal and skewed axes on made-up forces of a skewed thumb"},
                  {"provenance", provenance(study, options)},
                  {"sections", Json::array({thumb_study_section(study, calibration)})}},
                 options.output);
  if (options.json)
    fmt::print("{}\n", json_text(study_json(study, calibration)));
  else
    print_study(study);
  if (!study.complete || interrupted()) throw Stopped("stopped; what was finished by then is kept");
  std::size_t doubtful = 0;
  for (const ThumbFit& fit : study.fits)
    if (!fit.converged()) ++doubtful;
  require(doubtful == 0 || options.allow_unconverged,
          "{} of {} fits have NOT converged; they are marked (--allow-unconverged accepts that)",
          doubtful, study.fits.size());
}

}  // namespace

void add_study(CLI::App& app) {
  auto options = std::make_shared<StudyArguments>();  // lives as long as the callback
  CLI::App* study = app.add_subcommand("study", "Made-up experiments whose answer is known");
  study->require_subcommand(1);
  CLI::App* thumb = study->add_subcommand(
      "thumb", "Do forces tell skewed thumb axes from orthogonal ones, and which of them?");
  thumb->add_option("-o,--output", options->output, "Report (HTML)");
  add_data_option(*thumb, options->data);
  thumb->add_option("--draws", options->draws, "Of each of 4 chains, and warm-up (0: as set)")
      ->check(CLI::NonNegativeNumber);
  thumb
      ->add_option("--simulations", options->simulations,
                   "Calibrate by so many simulated thumbs (0: do not)")
      ->check(CLI::NonNegativeNumber);
  thumb->add_option("--seed", options->seed, "Of noise and chains");
  thumb->add_flag("--quick", options->quick, "Arms known, one skewness: seconds");
  thumb->add_flag("--allow-unconverged", options->allow_unconverged,
                  "Exit with success although some chains disagree");
  thumb->add_flag("--json", options->json, "Print JSON");
  thumb->callback([options] { run_thumb(*options); });
}

}  // namespace thenar
