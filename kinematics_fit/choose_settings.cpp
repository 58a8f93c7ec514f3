#include "kinematics_fit/choose_settings.h"

#include <algorithm>
#include <utility>

#include "base/error.h"

namespace thenar {
namespace {

constexpr double kBetter = 1e-4;  // relative gain below which a choice stays as it is [1]

/// Mean over experiments of the relative error of what was left out.
double mean_error(const CrossValidation& validation) {
  double sum = 0;
  int count = 0;
  for (const Prediction& prediction : validation.experiments) {
    if (prediction.trials.empty()) continue;
    sum += prediction.error.relative;
    ++count;
  }
  return sum / count;
}

/// Tries settings, each once.
class Chooser {
 public:
  Chooser(const FitProblem& problem, const FitSettings& start,
          const std::vector<std::string>& also_free, SolveOptions options)
      : problem_(problem), also_free_(also_free), options_(std::move(options)) {
    found_.settings = start;
    found_.by = {LeaveOut::kPosture};
    if (problem.specimens().size() > 1) found_.by.push_back(LeaveOut::kSpecimen);
    options_.progress.report = {};  // each try would begin anew
  }

  ChosenSettings choose(const Progress& progress) {
    // Where the search starts.
    const std::vector<SettingChoice>& choices = found_.settings.choices;
    found_.error = error_of(found_.settings);
    // One choice after the other, until a whole round has changed nothing.
    std::size_t since_change = 0;
    for (std::size_t at = 0; since_change < choices.size() && !found_.stopped;
         at = (at + 1) % choices.size()) {
      progress(static_cast<double>(since_change) / static_cast<double>(choices.size()),
               "choosing " + choices[at].name);
      since_change = better(at) ? 1 : since_change + 1;
    }
    return std::move(found_);
  }

 private:
  /// Puts the best value of one choice in force. Returns whether it is another one.
  bool better(std::size_t at) {
    FitSettings best = found_.settings;
    for (std::size_t value = 0; value < best.choices[at].values.size(); ++value) {
      FitSettings other = found_.settings;
      set_choice(other, at, value);
      const double error = error_of(other);
      if (found_.stopped) return false;
      if (error > found_.error * (1 - kBetter)) continue;
      found_.error = error;
      best = std::move(other);
    }
    const bool changed = best.choices[at].chosen != found_.settings.choices[at].chosen;
    found_.settings = std::move(best);
    return changed;
  }

  double error_of(const FitSettings& settings) {
    std::vector<std::size_t> chosen;
    for (const SettingChoice& choice : settings.choices) chosen.push_back(choice.chosen);
    const auto known = std::find_if(found_.tried.begin(), found_.tried.end(),
                                    [&](const TriedSettings& one) { return one.chosen == chosen; });
    if (known != found_.tried.end()) return known->error;
    const FitProblem problem = with_settings(problem_, settings, also_free_);
    double sum = 0;
    for (const LeaveOut what : found_.by) {
      const CrossValidation validation = cross_validate(problem, what, options_);
      found_.stopped = validation.stopped;
      if (found_.stopped) return 0;
      sum += mean_error(validation);
    }
    found_.tried.push_back({std::move(chosen), sum / static_cast<double>(found_.by.size())});
    return found_.tried.back().error;
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
          problem.experiments(), settings.robust_scale, settings.axis_distances};
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
