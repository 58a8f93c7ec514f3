#include "report/pads/fit_answer.h"

#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "base/provenance.h"
#include "base/units.h"
#include "base/words.h"
#include "report/pads/press_answer.h"

namespace thenar {
namespace {

/// Returns the source of a constant's value: "data", "prior" or "nothing".
std::string known_by(const ConstantEstimate& estimate, const FreeConstant& free) {
  const std::string who = estimate.determined ? "data" : free.prior_factor ? "prior" : "nothing";
  return estimate.at_bound ? who + ", at a bound" : who;
}

/// exp of an sd; "any" where it is infinite.
std::string factor_words(double sd) {
  return std::isinf(sd) ? std::string("any") : shown(std::exp(sd));
}

std::string constant_name(const FittedPad& fitted, std::size_t i) {
  return name_of(fitted.problem.pad, fitted.problem.constants[i].constant);
}

/// Returns the value of a constant at the start of the search.
double start_of(const FittedPad& fitted, std::size_t i) {
  return value_of(fitted.problem.pad, fitted.problem.constants[i].constant);
}

bool has_poisson_ratio(const FittedPad& fitted) {
  return any_of(fitted.problem.constants, [](const FreeConstant& free) {
    return free.constant.kind == PadConstantKind::kPoissonRatio;
  });
}

std::string quantity_words(const PressDatum& datum) {
  return (datum.over ? "part of " : "") + name_of(datum.quantity);
}

/// "1 N", "1 N over 5.2 N": what was imposed when a number was measured.
std::string load_words(const PressRecord& record, const PressDatum& datum) {
  const auto words = [&](int load) {
    const PressLoad& at = nth(record.course.loads, load);
    return at.force ? fmt::format("{:.4g} N", *at.force)
                    : fmt::format("{:.4g} mm", at.indentation / kMm);
  };
  return datum.over ? words(datum.load) + " over " + words(*datum.over) : words(datum.load);
}

/// Returns true if all constants have a finite sd, so that correlations exist.
bool all_known(const FittedPad& fitted) {
  return all_of(fitted.fit.estimates, [](const auto& each) { return !std::isinf(each.sd); });
}

/// Returns the factor by which finer cells would change a constant; empty if it was not computed.
std::optional<double> finer_factor(const FittedPad& fitted, std::size_t i) {
  bool pressed = false;
  for (const std::vector<PressPrediction>& record : fitted.fit.predictions)
    for (const PressPrediction& each : record) pressed = pressed || each.finer;
  if (!pressed || !all_known(fitted)) return {};
  return std::exp(fitted.fit.estimates[i].mesh_shift);
}

std::vector<Fields> constant_fields(const FittedPad& fitted) {
  // Constants in their display units; factors are exponentials of the sds of logarithms.
  std::vector<Fields> list;
  for (std::size_t i = 0; i < fitted.fit.estimates.size(); ++i) {
    const ConstantEstimate& each = fitted.fit.estimates[i];
    const FreeConstant& free = fitted.problem.constants[i];
    const DisplayUnit unit = display_unit(free.constant.kind);
    list.push_back({{"constant", constant_name(fitted, i)},
                    {"unit", unit.name},
                    {"start", start_of(fitted, i) * unit.per_si},
                    {"value", each.value * unit.per_si},
                    {"sd_factor", std::exp(each.sd)},
                    {"sd_factor_by_data", std::exp(each.sd_by_data)},
                    {"prior_factor", units::kOne, free.prior_factor},
                    {"determined", each.determined},
                    {"at_bound", each.at_bound},
                    {"finer_cells_factor", units::kOne, finer_factor(fitted, i)}});
  }
  return list;
}

/// Calls `add` for every datum, with its press, what the pad has of it, and its unit.
template <typename Add>
void for_data(const FittedPad& fitted, const Add& add) {
  for (std::size_t i = 0; i < fitted.fit.predictions.size(); ++i) {
    const PressRecord& record = fitted.problem.records[i];
    for (std::size_t k = 0; k < record.data.size(); ++k)
      add(record, record.data[k], fitted.fit.predictions[i][k], display_unit(record.data[k]));
  }
}

std::vector<Fields> data_fields(const FittedPad& fitted) {
  // Each datum beside the pad's prediction, at the fitted mesh and at the finer one.
  std::vector<Fields> list;
  for_data(fitted, [&](const PressRecord& record, const PressDatum& datum,
                       const PressPrediction& pad, const DisplayUnit& unit) {
    list.push_back(
        {{"press", record.name},
         {"load", load_words(record, datum)},
         {"quantity", quantity_words(datum)},
         {"unit", unit.name},
         {"measured", datum.value * unit.per_si},
         {"sd", datum.sd * unit.per_si},
         {"predicted", pad.value * unit.per_si},
         {"finer_cells", pad.finer ? OrderedJson(*pad.finer * unit.per_si) : OrderedJson()},
         {"source", datum.source}});
  });
  return list;
}

std::vector<Fields> curve_fields(const FittedPad& fitted) {
  std::vector<Fields> list;
  for (std::size_t i = 0; i < fitted.curves.size(); ++i) {
    list.push_back({{"press", fitted.problem.records[i].name},
                    {"points", fields_of_each(fitted.curves[i].points, [](const PressPoint& at) {
                       return Fields{{"depth", units::kMillimetre, at.indentation},
                                     {"force", units::kNewton, at.force},
                                     {"area", units::kSquareMillimetre, at.area}};
                     })}});
  }
  return list;
}

}  // namespace

DisplayUnit display_unit(const PressDatum& datum) {
  if (datum.over) return {};
  switch (datum.quantity) {
    case PressQuantity::kIndentation:
      return {"mm", 1 / kMm};
    case PressQuantity::kArea:
      return {"mm2", 1 / kSquareMm};
    default:
      return {"N", 1};
  }
}

std::string title_of(const FittedPad& fitted) {
  std::size_t data = 0;
  for (const PressRecord& record : fitted.problem.records) data += record.data.size();
  return fmt::format("{} fitted to '{}': {}, {}", fitted.pad.spec.name, fitted.data.title,
                     counted(fitted.problem.constants.size(), "constant"),
                     data == 1 ? "1 datum" : fmt::format("{} data", data));
}

std::string conditions_of(const FittedPad& fitted) {
  if (fitted.fit.estimates.empty()) return "stopped before there was an estimate";
  return fmt::format(
      "search {} after {}; misfit {:.3g} with {} degrees of freedom",
      convergence_word(fitted.fit.solution),
      counted(static_cast<std::size_t>(fitted.fit.solution.evaluations), "evaluation"),
      fitted.fit.misfit, fitted.fit.degrees_of_freedom);
}

Table table_of(const FittedPad& fitted) {
  // Show how much the data say: the sd by the data alone beside the sd with the prior.
  Table table{{"constant", "unit", "start", "value", "sd_factor", "sd_factor_by_data",
               "prior_factor", "known_by", "finer_cells_factor"}};
  for (std::size_t i = 0; i < fitted.fit.estimates.size(); ++i) {
    const ConstantEstimate& each = fitted.fit.estimates[i];
    const FreeConstant& free = fitted.problem.constants[i];
    const DisplayUnit unit = display_unit(free.constant.kind);
    const std::optional<double> finer = finer_factor(fitted, i);
    table.add({constant_name(fitted, i), or_dash(unit.name),
               shown(start_of(fitted, i) * unit.per_si), shown(each.value * unit.per_si),
               factor_words(each.sd), factor_words(each.sd_by_data),
               free.prior_factor ? shown(*free.prior_factor) : "-", known_by(each, free),
               finer ? shown(*finer) : "-"});
  }
  return table;
}

std::string constants_note(const FittedPad& fitted) {
  std::string note = fmt::format(
      "sd_factor: one sd, with priors; sd_factor_by_data: without.\n"
      "known_by: data, if they alone leave less than a factor of {:g} at two sds; else the prior, "
      "or nothing.\n"
      "finer_cells_factor: what cells of half the size would multiply the value by.\n",
      kDetermined);
  if (has_poisson_ratio(fitted)) note += "Factors of a Poisson's ratio nu are those of 1/2 - nu.\n";
  return note;
}

Table data_table(const FittedPad& fitted) {
  Table table{{"press", "load", "quantity", "unit", "measured", "sd", "predicted", "off_by_sds",
               "finer_cells", "source"}};
  for_data(fitted, [&](const PressRecord& record, const PressDatum& datum,
                       const PressPrediction& pad, const DisplayUnit& unit) {
    table.add({record.name, load_words(record, datum), quantity_words(datum), or_dash(unit.name),
               shown(datum.value * unit.per_si), shown(datum.sd * unit.per_si),
               shown(pad.value * unit.per_si), shown((pad.value - datum.value) / datum.sd, 2),
               pad.finer ? shown(*pad.finer * unit.per_si) : "-", datum.source});
  });
  return table;
}

Table correlation_table(const FittedPad& fitted) {
  Table table{{"constant"}};
  const std::size_t count = fitted.fit.estimates.size();
  if (count < 2 || !all_known(fitted)) return table;
  for (std::size_t i = 0; i < count; ++i) table.header.push_back(constant_name(fitted, i));
  for (std::size_t i = 0; i < count; ++i)
    table.add_parts({{constant_name(fitted, i)},
                     cells(fitted.fit.correlations.row(static_cast<Eigen::Index>(i)), 3)});
  return table;
}

std::string text_of(const FittedPad& fitted) {
  std::string text = fmt::format("{}\n{}\n\n", title_of(fitted), conditions_of(fitted));
  if (fitted.fit.estimates.empty()) return text;
  text += titled("Constants", table_of(fitted));
  text += titled("Data", data_table(fitted));
  text += titled("Correlations", correlation_table(fitted));
  return text + constants_note(fitted);
}

Fields fields_of(const FittedPad& fitted) {
  // State the search first, then its estimates, and the origin of the data.
  const PadFitResult& fit = fitted.fit;
  return {{"pad", fitted.pad.spec.name},
          {"presses", fitted.data.path},
          {"title", fitted.data.title},
          {"search", convergence_word(fit.solution)},
          {"message", fit.solution.message},
          {"evaluations", fit.solution.evaluations},
          {"seconds", units::kMeasuredSeconds, fit.solution.seconds},
          {"misfit", fit.misfit},
          {"degrees_of_freedom", fit.degrees_of_freedom},
          {"constants", constant_fields(fitted)},
          {"correlations", all_known(fitted) ? to_json(fit.correlations) : Json()},
          {"data", data_fields(fitted)},
          {"curves", curve_fields(fitted)},
          {"assumed", assumed_words(fitted.spec)},
          {"sources", fitted.data.own_sources},
          {"warnings", fitted.outcome.warnings}};
}

FileDigests files_of(const FittedPad& fitted) {
  FileDigests files = fitted.pad.spec.files;
  files.merge(digests_of({fitted.data.path}));
  return files;
}

}  // namespace thenar
