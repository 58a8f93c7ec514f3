#include "report/answers/hood_rows.h"

#include <optional>
#include <vector>

#include <fmt/format.h>

#include "base/words.h"
#include "data/io/net_description.h"
#include "kinematics_fit/hood_rows.h"

namespace thenar {
namespace {

/// One experiment, predicted in one way.
struct HoodRow {
  std::string experiment, what;
  HoodRowErrors errors;
  std::optional<HoodRowErrors> fractions;  // errors of the same trials by the fit with fractions
};

/// The prediction of the same experiment in the other fit.
std::optional<HoodRowErrors> errors_beside(const std::vector<Prediction>* others,
                                           const Prediction& one,
                                           const std::vector<std::string>& muscles) {
  if (others == nullptr) return {};
  for (const Prediction& other : *others)
    if (other.experiment == one.experiment && other.trials.size() == one.trials.size())
      return hood_row_errors(other, muscles);
  return {};
}

std::vector<HoodRow> hood_rows(const FitResult& result) {
  std::vector<HoodRow> rows;
  if (result.left_out.empty()) return rows;
  const std::vector<std::string> muscles = hood_muscles(result.fit.problem.digit());
  const auto add = [&](const std::vector<Prediction>& all, const std::vector<Prediction>* others,
                       const std::string& what) {
    for (const Prediction& one : all)
      if (std::optional<HoodRowErrors> errors = hood_row_errors(one, muscles))
        rows.push_back(
            {one.experiment, what, std::move(*errors), errors_beside(others, one, muscles)});
  };
  // Add rows in sample, then left out.
  const FractionsFit* beside = result.fractions ? &*result.fractions : nullptr;
  add(result.in_sample, beside ? &beside->in_sample : nullptr, "in sample");
  for (std::size_t k = 0; k < result.left_out.size(); ++k)
    add(result.left_out[k].experiments,
        beside && k < beside->left_out.size() ? &beside->left_out[k].experiments : nullptr,
        name_of(result.left_out[k].what));
  return rows;
}

/// All muscles of the rows, in the order in which they appear.
std::vector<std::string> muscles_of(const std::vector<HoodRow>& rows) {
  std::vector<std::string> names;
  for (const HoodRow& row : rows)
    for (const MuscleError& one : row.errors.muscles)
      if (!contains(names, one.muscle)) names.push_back(one.muscle);
  return names;
}

/// Relative error of a muscle, or "-".
std::string error_words(const std::optional<HoodRowErrors>& errors, const std::string& muscle) {
  if (errors)
    for (const MuscleError& one : errors->muscles)
      if (one.muscle == muscle) return fmt::format("{:.3f}", one.error.relative);
  return "-";
}

/// Relative errors under a key, or null.
Field errors_field(std::string key, const std::optional<HoodRowErrors>& errors) {
  if (!errors) return {std::move(key), nullptr};
  Fields by_muscle;
  for (const MuscleError& one : errors->muscles) by_muscle.add(one.muscle, one.error.relative);
  return {std::move(key),
          Fields{{"together", errors->total.relative}, {"by_muscle", std::move(by_muscle)}}};
}

/// "net extensor_hood" or "fixed fractions".
std::string hood_name(const Fit& fit) {
  if (!fit.inputs.net) return "fixed fractions";
  return "net " + parse_net(fit.inputs.net->text, fit.inputs.net->path).name;
}

Fields count_fields(const Fit& fit) {
  const HoodCount count = count_hood(fit.covariance);
  return {{"hood", hood_name(fit)},
          {"status", convergence_word(fit.solution)},
          {"free_coordinates", fit.problem.size()},
          {"free_coordinates_of_hood", count.entries},
          {"effective_parameters", fit.covariance.effective_parameters},
          {"effective_parameters_of_hood", count.effective}};
}

}  // namespace

Table hood_row_table(const FitResult& result) {
  const std::vector<HoodRow> rows = hood_rows(result);
  Table table{{"experiment", "predicted"}};
  if (rows.empty()) return table;
  const std::vector<std::string> muscles = muscles_of(rows);
  // Add the fit without the net to each number, if there is one.
  const bool beside = result.fractions.has_value();
  const auto head = [&](const std::string& name) {
    table.header.push_back(name);
    if (beside) table.header.push_back(name + ", fractions");
  };
  head("all");
  for (const std::string& muscle : muscles) head(muscle);
  for (const HoodRow& row : rows) {
    std::vector<std::string> cells{row.experiment, row.what,
                                   fmt::format("{:.3f}", row.errors.total.relative)};
    if (beside)
      cells.push_back(row.fractions ? fmt::format("{:.3f}", row.fractions->total.relative) : "-");
    for (const std::string& muscle : muscles) {
      cells.push_back(error_words(row.errors, muscle));
      if (beside) cells.push_back(error_words(row.fractions, muscle));
    }
    table.add(std::move(cells));
  }
  return table;
}

std::string hood_count_words(const Fit& fit) {
  const HoodCount count = count_hood(fit.covariance);
  return fmt::format(
      "{} ({}): {} free, {} of them of the hood; the data determine {:.1f} parameters, "
      "{:.1f} of them of the hood",
      hood_name(fit), convergence_word(fit.solution), counted(fit.problem.size(), "coordinate"),
      count.entries, fit.covariance.effective_parameters, count.effective);
}

std::string hood_row_text(const FitResult& result) {
  const Table table = hood_row_table(result);
  if (table.rows.empty()) return "";
  const bool beside = result.fractions.has_value();
  std::string text = fmt::format("\nrelative errors of trials under one muscle of the hood{}:\n",
                                 beside ? ", with the net / with fractions" : "");
  const std::size_t step = beside ? 2 : 1;
  for (const std::vector<std::string>& row : table.rows) {
    text += fmt::format("  {:<20} {:<23}", row[0], row[1]);
    for (std::size_t i = 2; i < row.size(); i += step)
      text += fmt::format("  {} {}{}", table.header[i], row[i], beside ? " / " + row[i + 1] : "");
    text += "\n";
  }
  text += fmt::format("  {}\n", hood_count_words(result.fit));
  if (beside) text += fmt::format("  {}\n", hood_count_words(result.fractions->fit));
  return text;
}

Fields hood_row_fields(const FitResult& result) {
  const std::vector<HoodRow> all = hood_rows(result);
  if (all.empty()) return {};
  std::vector<Fields> rows, fits{count_fields(result.fit)};
  for (const HoodRow& row : all) {
    Fields& fields = rows.emplace_back(Fields{{"experiment", row.experiment},
                                              {"what", row.what},
                                              errors_field("relative_error", row.errors)});
    if (result.fractions) fields.add(errors_field("relative_error_with_fractions", row.fractions));
  }
  if (result.fractions) fits.push_back(count_fields(result.fractions->fit));
  return {{"fits", std::move(fits)}, {"rows", std::move(rows)}};
}

}  // namespace thenar
