#include "api/experiment_check.h"

#include <set>

#include <fmt/format.h>

#include "base/error.h"
#include "base/lists.h"
#include "base/name_hint.h"
#include "base/nearest_name.h"
#include "base/units.h"
#include "data/io/toml_node.h"
#include "kinematics_fit/force_jacobian.h"
#include "kinematics_fit/model/experiment_plan.h"
#include "kinematics_fit/prediction.h"

namespace thenar {
namespace {

/// Lines of the parts of an experiment's file.
struct ExperimentLines {
  std::string path;
  int digit = 1, segment = 1;
  std::vector<int> postures, trials;

  [[nodiscard]] std::string at(int line, const std::string& sentence) const {
    return fmt::format("{}:{}: {}", path, line, sentence);
  }
  [[nodiscard]] int trial(std::size_t i) const { return i < trials.size() ? trials[i] : 1; }
};

std::vector<int> lines_of(const TomlNode* list) {
  std::vector<int> lines;
  if (list != nullptr)
    for (const TomlNode& item : list->items) lines.push_back(item.line);
  return lines;
}

int line_of_member(const TomlNode& table, const std::string& key) {
  const TomlNode* member = table.find(key);
  return member == nullptr ? table.line : member->line;
}

ExperimentLines find_lines(const SourceText& source) {
  const TomlNode top = parse_toml(source.text, source.path);
  ExperimentLines lines;
  lines.path = source.path;
  lines.digit = line_of_member(top, "digit");
  if (const TomlNode* force = top.find("force")) lines.segment = line_of_member(*force, "segment");
  lines.postures = lines_of(top.find("posture"));
  if (const TomlNode* trials = top.find("trials")) lines.trials = lines_of(trials->find("rows"));
  return lines;
}

/// Inputs of a check: an experiment, its lines, and the digit of a subject.
struct CheckedExperiment {
  const Experiment& experiment;
  const TendonDigit& digit;
  const ExperimentLines& lines;
  const std::string& subject;  // its name
};

/// "the digit has no joint 'PIP', did you mean 'PIP3'?"
std::string no_such(const std::string& kind, const std::string& name,
                    const std::vector<std::string>& names) {
  return fmt::format("the digit has no {} '{}'{} it has {}", kind, name,
                     hint_before_list(name, names), listed(names));
}

/// Names that the digit has not, each once.
void check_names(const CheckedExperiment& of, std::vector<std::string>& misfits) {
  const Experiment& experiment = of.experiment;
  const TendonDigit& digit = of.digit;
  const ExperimentLines& lines = of.lines;
  // Each unknown name is reported once, at the first line that uses it.
  std::set<std::string> told;
  const auto check_segment = [&](const std::string& name, int line) {
    if (digit.skeleton.link_of_segment.count(name) > 0 || !told.insert("segment " + name).second)
      return;
    misfits.push_back(
        lines.at(line, no_such("segment", name, map_keys(digit.skeleton.link_of_segment))));
  };
  // Check the segments on which forces act and in whose axes they are stated.
  check_segment(experiment.force_segment, lines.segment);
  for (std::size_t i = 0; i < experiment.trials.size(); ++i)
    if (const std::optional<ForceSite>& site = experiment.trials[i].site) {
      check_segment(site->at, lines.trial(i));
      check_segment(site->axes, lines.trial(i));
    }
  // Check the joints of postures, then the muscles of trials.
  for (std::size_t p = 0; p < experiment.postures.size(); ++p)
    for (const auto& [joint, angle] : experiment.postures[p].angles)
      if (!contains(digit.names.coordinates, joint) && told.insert("joint " + joint).second)
        misfits.push_back(
            lines.at(lines.postures[p], no_such("free joint", joint, digit.names.coordinates)));
  for (std::size_t i = 0; i < experiment.trials.size(); ++i)
    for (const auto& [muscle, tension] : experiment.trials[i].tension)
      if (!contains(digit.names.muscles, muscle) && told.insert("muscle " + muscle).second)
        misfits.push_back(lines.at(lines.trial(i), no_such("muscle", muscle, digit.names.muscles)));
}

/// Puts the line of the posture that a sentence names before it; else the line of the digit.
std::string with_line(const CheckedExperiment& of, const std::string& sentence) {
  for (std::size_t p = 0; p < of.experiment.postures.size(); ++p)
    if (sentence.find(fmt::format("posture '{}'", of.experiment.postures[p].name)) !=
        std::string::npos)
      return of.lines.at(of.lines.postures[p], sentence);
  return of.lines.at(of.lines.digit, sentence);
}

/// Forces beyond what tendons can make, by the tensions of the trial.
void check_forces(const CheckedExperiment& of, std::vector<std::string>& doubts) {
  constexpr double kNoiseSds = 2;  // Largest excess of a force by chance [sds]
  for (std::size_t i = 0; i < of.experiment.trials.size(); ++i) {
    const Trial& trial = of.experiment.trials[i];
    // A pinned tip cannot push harder than all its tendons pull together, since moment arms of
    // tendons are shorter than the finger.
    double pulled = 0;
    for (const auto& [muscle, tension] : trial.tension) pulled += tension;
    if (trial.site) continue;  // a mount feels tendons and tip, a short lever more than the tip
    if (trial.force.norm() > pulled + kNoiseSds * force_sd(of.experiment, trial).norm())
      doubts.push_back(of.lines.at(
          of.lines.trial(i),
          fmt::format("the tip's force, {:.3g} N, is larger than all tensions together, {:.3g} N: "
                      "are the units right?",
                      trial.force.norm(), pulled)));
  }
}

/// Measured forces that point away from those that the subject predicts.
void check_directions(const CheckedExperiment& of, const ExperimentPlan& plan,
                      const FitParameters& parameters, std::vector<std::string>& doubts) {
  // Predict with the subject as it is, before any fit: u = 0.
  const Eigen::VectorXd u = Eigen::VectorXd::Zero(parameters.coordinates());
  const Eigen::Matrix3Xd predicted = force_values(of.digit, parameters, plan, u);
  const Prediction compared =
      compare_forces(of.experiment, predicted, Eigen::Matrix3Xd::Zero(3, predicted.cols()), false);
  // A median beyond 90 deg means swapped signs or axes rather than a poor model.
  if (compared.error.direction > kPi / 2)
    doubts.push_back(of.lines.at(
        of.lines.segment,
        fmt::format("measured forces point {:.0f} deg (median) away from those that subject '{}' "
                    "predicts: are components and signs right?",
                    degrees(compared.error.direction), of.subject)));
}

void check_values(const CheckedExperiment& of, SubjectMatch& found) {
  // Free no parameter: forces are compared with the subject as its file states it.
  const std::vector<std::string> postures = names_of(of.experiment.postures);
  const FitParameters parameters = choose_parameters(of.digit, postures, {});
  try {
    const ExperimentPlan plan = plan_experiment(of.digit, parameters, of.experiment);
    // Warnings carry no line of their own, so find the line by the names that they mention.
    for (const std::string& warning : experiment_warnings(of.digit, plan, of.experiment))
      found.doubts.push_back(with_line(of, warning));
    check_forces(of, found.doubts);
    if (!of.experiment.trials.empty()) check_directions(of, plan, parameters, found.doubts);
  } catch (const InputError& error) {
    found.misfits.push_back(with_line(of, error.what()));  // a singular posture
  }
}

}  // namespace

SubjectMatch check_experiment(const SourceText& source, const Subject& subject) {
  const Experiment experiment = parse_experiment(source.text, source.path);
  const ExperimentLines lines = find_lines(source);
  // Without bones of this digit no other check makes sense.
  SubjectMatch found;
  const std::vector<std::string> digits = names_of(subject.digits);
  if (!contains(digits, experiment.digit)) {
    found.misfits.push_back(
        lines.at(lines.digit, fmt::format("subject '{}' has no bones of the {}; it has those of {}",
                                          subject.name, experiment.digit, listed(digits))));
    return found;
  }
  const TendonDigit digit = build_tendon_digit(subject, experiment.digit);
  const CheckedExperiment of{experiment, digit, lines, subject.name};
  // Values are compared only when all names are known, since the plan is built from names.
  check_names(of, found.misfits);
  if (found.misfits.empty()) check_values(of, found);
  return found;
}

}  // namespace thenar
