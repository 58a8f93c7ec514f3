#pragma once

/// Explanation of an input file: its kept and dropped parts, assumptions, costs, and fitted values.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "api/named/things.h"
#include "base/fidelity.h"
#include "kinematics_fit/model/fit_parameters.h"
#include "kinematics_fit/prediction.h"
#include "solvers/status.h"
#include "tendons/explain_digit.h"
#include "tendons/linear_tendons.h"

namespace thenar {

/// Options of explain(): a file or name, and the part of it to explain.
struct ExplainRequest {
  std::string thing;         // a file, or the name of something that comes with thenar; required
  std::string digit;         // digit of a subject; empty: its only one
  std::string settings;      // fit settings for a subject, file or name; empty: the built-in ones
  std::optional<Path> path;  // tendon paths of a subject; absent: default_path()
  std::string data;          // folder with subjects/ ..; empty: the usual ones
};

/// Cost of one question about a digit on this machine, in the middle of the joints' ranges.
struct QuestionCost {
  std::string question;  // "tip force, pinned"
  std::string rung;      // model that answers it: "static"
  double seconds;        // median wall time of a call, one thread [s]
};

/// One digit of a subject, built and measured.
struct DigitExplained {
  std::string digit;                            // name of the digit
  std::shared_ptr<const DigitTendons> tendons;  // null where nothing but tip maps are known
  DigitExplanation parts;                       // kept and dropped
  std::vector<QuestionCost> costs;              // cost of each question on each rung
  std::string settings;                         // path of the fit settings
  std::string settings_message;  // why the settings do not fit the digit; empty: they do
  FitParameters parameters;      // parameters under these settings, or with all fixed
};

/// Predictions and values of a fit, recomputed.
struct FitExplained {
  std::vector<Prediction> predictions;            // predictions of the fitted experiments
  std::vector<FittedValues> values;               // values of the population, then of each specimen
  std::map<std::string, std::string> written_by;  // program -> version
};

/// Thing with its explanation.
struct ThingExplained {
  ExplainRequest request;               // request that was answered
  Outcome outcome;                      // warnings: a result without a checksum
  std::string path;                     // path of the file
  Thing thing;                          // content of the file
  std::optional<DigitExplained> digit;  // present for a subject
  std::optional<FitExplained> fit;      // present for a fit
};

/// Placeholder in parameter names for every posture of an experiment.
inline constexpr const char* kEachPosture = "<posture>";

/// Reads a thing; builds the digit of a subject and measures the time of each question about it.
/// @throws InputError or DataError if an input is not found or wrong.
[[nodiscard]] ThingExplained explain_thing(const ExplainRequest& request);

}  // namespace thenar
