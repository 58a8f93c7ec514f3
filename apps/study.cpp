// thenar study thumb -o PAGE.html
// thenar study thumb-types -o PAGE.html
//
// Simulated experiments with known ground truth: accuracy of models, and information gain.

#include "studies/questions/study.h"

#include <memory>

#include "apps/commands.h"
#include "apps/options.h"
#include "apps/outputs.h"
#include "apps/terminal.h"
#include "base/error.h"
#include "base/progress_parts.h"
#include "studies/pages/study_answer.h"
#include "studies/pages/thumb_study.h"
#include "studies/pages/thumb_types.h"
#include "studies/pages/thumb_types_answer.h"

namespace thenar {
namespace {

struct StudyArguments : Arguments<ThumbStudyRequest> {
  bool allow_unconverged = false;
};

void run_thumb(const StudyArguments& options) {
  const ThumbStudyResult result = compute_thumb_study(options.request, terminal_progress());
  deliver(options.outputs, result);
  if (result.outcome.stopped()) throw Stopped("stopped; what was finished by then is kept");
  const std::string complaint = study_complaint(result);
  if (!complaint.empty() && !options.allow_unconverged)
    throw Error(complaint + "; --allow-unconverged accepts them");
}

void run_types(const Arguments<ThumbTypesRequest>& options) {
  const ThumbTypesResult result = compute_thumb_types(options.request, terminal_progress());
  deliver(options.outputs, result);
  if (!result.types.complete)
    throw Stopped("stopped; the draws that were done by then are counted");
}

void add_types(CLI::App& study) {
  auto options = std::make_shared<Arguments<ThumbTypesRequest>>();  // lives as long as the callback
  CLI::App* types = study.add_subcommand("thumb-types",
                                         "Sample the thumb types that result from the variation of "
                                         "joint axes, and how many there are");
  ThumbTypesRequest& request = options->request;
  add_data_option(*types, request.data);
  types->add_option("--draws", request.draws, "Thumbs to draw")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  types->add_option("--seed", request.seed, "Seed of the draws");
  add_output_options(*types, options->outputs, {true, true, true});
  add_examples(*types, {"study thumb-types -o out/types.html"});
  types->callback([options] { run_types(*options); });
}

}  // namespace

void add_study(CLI::App& app) {
  auto options = std::make_shared<StudyArguments>();  // lives as long as the callback
  CLI::App* study =
      app.add_subcommand("study", "Run simulated experiments with known ground truth");
  study->require_subcommand(1);
  CLI::App* thumb = study->add_subcommand(
      "thumb", "Test whether forces distinguish skewed from orthogonal thumb axes, and which do");
  ThumbStudyRequest& request = options->request;
  add_data_option(*thumb, request.data);
  // Length of the chains, and simulations that calibrate them.
  thumb
      ->add_option("--draws", request.draws,
                   "Draws of each of 4 chains, and of their warm-up (0: as set)")
      ->check(CLI::NonNegativeNumber);
  thumb
      ->add_option("--simulations", request.simulations,
                   "Number of simulated thumbs for calibration (0: none)")
      ->check(CLI::NonNegativeNumber);
  thumb->add_option("--seed", request.seed, "Seed of noise and chains");
  thumb->add_flag("--quick", request.quick,
                  "Assume known moment arms and one skewness: takes seconds rather than minutes");
  thumb->add_flag("--allow-unconverged", options->allow_unconverged,
                  "Exit with success although some chains disagree");
  add_output_options(*thumb, options->outputs, {true, true, true});
  add_examples(*thumb, {"study thumb --quick -o out/thumb.html"});
  thumb->callback([options] { run_thumb(*options); });
  add_types(*study);
  // Last: a command made later would begin with the examples of the one above.
  add_examples(*study, {"study thumb --quick -o out/thumb.html"});
}

}  // namespace thenar
