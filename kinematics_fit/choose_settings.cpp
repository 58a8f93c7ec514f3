#include "kinematics_fit/choose_settings.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/lists.h"

namespace thenar {
namespace {

constexpr double kMinChoiceGain =
    1e-3;  // smallest decrease of the loss that changes a choice [nat]

/// Score of the predictions of left-out forces.
struct LeftOutScore {
  double loss = 0;   // [nat]
  double error = 0;  // relative [1]
};

/// Returns the means over experiments.
LeftOutScore mean_score(const CrossValidation& validation) {
  LeftOutScore sum;
  int count = 0;
  for (const Prediction& prediction : validation.experiments) {
    if (prediction.trials.empty()) continue;
    sum.loss += prediction.error.log_loss.value() + std::log(prediction.error.relative);
    sum.error += prediction.error.relative;
    ++count;
  }
  return {sum.loss / count, sum.error / count};
}

/// Searches the values of all choices, and scores each combination only once.
class Chooser {
 public:
  Chooser(const FitProblem& problem, const FitSettings& start,
          const std::vector<std::string>& also_free, SolveOptions options)
      : problem_(problem), also_free_(also_free), options_(std::move(options)) {
    found_.settings = start;
    found_.by = {LeaveOut::kPosture};
    if (problem.specimens().size() > 1) found_.by.push_back(LeaveOut::kSpecimen);
    options_.progress.report = {};  // progress of a single trial would restart from 0
  }

  ChosenSettings choose(const Progress& progress) {
    // Score the initial settings.
    const std::vector<SettingChoice>& choices = found_.settings.choices;
    store_score(score_of(found_.settings));
    // Improve one choice after the other, until a whole round changes nothing.
    std::size_t since_change = 0;
    for (std::size_t at = 0; since_change < choices.size() && found_.status != Status::kStopped;
         at = (at + 1) % choices.size()) {
      progress(static_cast<double>(since_change) / static_cast<double>(choices.size()),
               "choosing " + choices[at].name);
      since_change = improve_choice(at) ? 1 : since_change + 1;
    }
    return std::move(found_);
  }

 private:
  /// Sets one choice to its best value. Returns whether the value changed.
  bool improve_choice(std::size_t at) {
    FitSettings best = found_.settings;
    for (std::size_t value = 0; value < best.choices[at].values.size(); ++value) {
      FitSettings other = found_.settings;
      set_choice(other, at, value);
      const LeftOutScore score = score_of(other);
      if (found_.status == Status::kStopped) return false;
      if (score.loss > found_.loss - kMinChoiceGain) continue;
      store_score(score);
      best = std::move(other);
    }
    const bool changed = best.choices[at].chosen != found_.settings.choices[at].chosen;
    found_.settings = std::move(best);
    return changed;
  }

  void store_score(const LeftOutScore& score) {
    found_.loss = score.loss;
    found_.error = score.error;
  }

  LeftOutScore score_of(const FitSettings& settings) {
    // Look up the score of settings that were tried before.
    std::vector<std::size_t> chosen = transformed(settings.choices, &SettingChoice::chosen);
    const auto known = std::find_if(found_.tried.begin(), found_.tried.end(),
                                    [&](const TriedSettings& one) { return one.chosen == chosen; });
    if (known != found_.tried.end()) return {known->loss, known->error};
    // Cross-validate with these settings, and average over the kinds of folds.
    const FitProblem problem = with_settings(problem_, settings, also_free_);
    LeftOutScore sum;
    for (const LeaveOut what : found_.by) {
      const CrossValidation validation = cross_validate(problem, what, options_);
      found_.status = validation.status;
      if (found_.status == Status::kStopped) return {};
      const LeftOutScore one = mean_score(validation);
      sum.loss += one.loss / static_cast<double>(found_.by.size());
      sum.error += one.error / static_cast<double>(found_.by.size());
    }
    found_.tried.push_back({std::move(chosen), sum.loss, sum.error});
    return sum;
  }

  const FitProblem& problem_;
  const std::vector<std::string>& also_free_;
  SolveOptions options_;
  ChosenSettings found_;
};

}  // namespace

FitProblem with_settings(const FitProblem& problem, const FitSettings& settings,
                         const std::vector<std::string>& also_free) {
  return {problem.digit(),
          choose_parameters(problem.digit(), problem.parameters().postures, settings, also_free),
          problem.experiments(),
          settings.robust_scale,
          settings.axis_distances,
          problem.scaling()};
}

ChosenSettings choose_settings(const FitProblem& problem, const FitSettings& settings,
                               const std::vector<std::string>& also_free,
                               const SolveOptions& options) {
  require(!settings.choices.empty(),
          "{}: there is nothing to choose; wanted [[choose]] tables, each with a name and values",
          settings.path);
  return Chooser(problem, settings, also_free, options).choose(options.progress);
}

NestedValidation validate_choice(const FitProblem& problem, const FitSettings& settings,
                                 const std::vector<std::string>& also_free, LeaveOut what,
                                 const SolveOptions& options) {
  NestedValidation out;
  const auto prepare = [&](const FitProblem& rest, const std::string& fold) {
    out.folds.push_back({fold, choose_settings(rest, settings, also_free, options)});
    return with_settings(rest, out.folds.back().settings.settings, also_free);
  };
  out.validation = cross_validate(problem, what, options, prepare);
  out.folds.resize(static_cast<std::size_t>(out.validation.folds_done));
  return out;
}

}  // namespace thenar
