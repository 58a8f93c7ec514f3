#include "report/explain/explanation.h"

#include <utility>

#include "report/blocks.h"
#include "report/summary.h"

namespace thenar {
namespace {

/// Rows as objects; the unit "1" stays a text.
OrderedJson rows_json(const Table& table) {
  OrderedJson rows = OrderedJson::array();
  for (const auto& cells : table.rows) {
    OrderedJson object;
    for (std::size_t c = 0; c < cells.size(); ++c)
      object[table.header[c]] = table.header[c] == "unit" ? Json(cells[c]) : json_of_cell(cells[c]);
    rows.push_back(object);
  }
  return rows;
}

/// Explains settings and proportions, which have no effect alone, by a line.
Explanation explain_plain(const ThingExplained& explained) {
  Section section{"file", summary_of(explained.thing)};
  if (std::holds_alternative<FitSettings>(explained.thing))
    section.lines.push_back("see what they do: thenar explain SUBJECT --settings " +
                            explained.path);
  return {section};
}

Explanation sections_of(const ThingExplained& explained) {
  const Thing& thing = explained.thing;
  if (const auto* subject = std::get_if<Subject>(&thing))
    return explain(*subject, *explained.digit);
  if (const auto* fit = std::get_if<Fit>(&thing)) return explain(*fit, *explained.fit);
  if (const auto* experiment = std::get_if<Experiment>(&thing)) return explain(*experiment);
  if (const auto* net = std::get_if<NetDescription>(&thing)) return explain(*net);
  if (const auto* body = std::get_if<BodySpec>(&thing)) return explain(*body);
  if (const auto* world = std::get_if<WorldSpec>(&thing)) return explain(*world);
  if (const auto* robot = std::get_if<RobotSpec>(&thing)) return explain(*robot);
  if (const auto* scene = std::get_if<SceneSpec>(&thing)) return explain(*scene);
  if (const auto* materials = std::get_if<Materials>(&thing)) return explain(*materials);
  return explain_plain(explained);
}

}  // namespace

std::string text_of(const ThingExplained& explained) {
  const Explanation explanation = sections_of(explained);
  std::string text;
  for (const Section& section : explanation) {
    if (!text.empty() && section.lines.empty() && section.table.rows.empty()) continue;
    text += section.title + "\n";
    for (const std::string& line : section.lines) text += "  " + line + "\n";
    if (!section.table.rows.empty()) text += aligned(section.table);
    text += "\n";
  }
  return text;
}

Fields fields_of(const ThingExplained& explained) {
  Fields fields;
  for (const Section& section : sections_of(explained)) {
    Fields part;
    if (!section.lines.empty()) part.add("notes", section.lines);
    part.add("rows", rows_json(section.table));
    fields.add(section.key, std::move(part));
  }
  return fields;
}

}  // namespace thenar
