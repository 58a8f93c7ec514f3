#include "report/fields.h"

#include <algorithm>
#include <array>
#include <iterator>

#include <fmt/format.h>

namespace thenar {
namespace {

constexpr std::array kAxisNames{"x", "y", "z"};

// NOLINTNEXTLINE(misc-no-recursion): as deep as the fields
OrderedJson list_of(const std::vector<Fields>& parts, UnitSystem system) {
  OrderedJson list = OrderedJson::array();
  for (const Fields& part : parts) list.push_back(json_of(part, system));
  return list;
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the fields
OrderedJson value_of(const Field& field, UnitSystem system) {
  if (!field.is_list && field.parts.empty()) return value_in(field.value, field.unit, system);
  return field.is_list ? list_of(field.parts, system) : json_of(field.parts.front(), system);
}

using Cells = std::vector<std::pair<std::string, std::string>>;  // column, text

std::string cell_of(const OrderedJson& value, int decimals) {
  if (value.is_null()) return "-";
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (!value.is_number_float()) return json_text(value, -1);
  return decimals >= 0 ? shown(value.get<double>(), decimals)
                       : fmt::format("{:.9g}", value.get<double>() + 0.0);
}

/// Columns of a field: its key, or one for each of its numbers: "force_x_N", "arm_PIP3_mm".
// NOLINTNEXTLINE(misc-no-recursion): as deep as the fields
void add_cells(const Field& field, const std::string& before, Cells& cells) {
  // Lists have no column; parts of a field share its prefix.
  if (field.is_list) return;
  if (!field.parts.empty()) {
    for (const Field& each : field.parts.front().all())
      add_cells(each, before + field.key + "_", cells);
    return;
  }
  const OrderedJson value = value_of(field, UnitSystem::kPrinted);
  const std::string unit =
      *field.unit.printed == '\0' ? "" : fmt::format("_{}", field.unit.printed);
  const auto name_of = [&](std::size_t i, const std::string& part) {
    if (i < field.columns.size()) return field.columns[i];
    return before + field.key + (part.empty() ? "" : "_" + part) + unit;
  };
  // Objects make a column for each name, arrays one for each entry.
  std::size_t i = 0;
  if (value.is_object()) {
    for (const auto& [name, each] : value.items())
      cells.emplace_back(name_of(i++, name), cell_of(each, field.decimals));
  } else if (value.is_array()) {
    for (const OrderedJson& each : value) {
      const bool is_point = value.size() == 3;
      cells.emplace_back(name_of(i, is_point ? kAxisNames[i] : std::to_string(i + 1)),
                         cell_of(each, field.decimals));
      ++i;
    }
  } else {
    cells.emplace_back(name_of(0, ""), cell_of(value, field.decimals));
  }
}

}  // namespace

Field::Field(std::string name, const FieldUnit& its_unit, OrderedJson si)
    : key(std::move(name)), unit(its_unit), value(std::move(si)) {}

Field::Field(std::string name, const FieldUnit& its_unit, const std::optional<double>& si)
    : Field(std::move(name), its_unit, si ? OrderedJson(*si) : OrderedJson()) {}

Field::Field(std::string name, Fields part)
    : key(std::move(name)), unit(units::kOne), parts{std::move(part)} {}

Field::Field(std::string name, std::vector<Fields> list)
    : key(std::move(name)), unit(units::kOne), parts(std::move(list)), is_list(true) {}

std::string key_with(const std::string& key, const FieldUnit& unit, UnitSystem system) {
  const char* const name = system == UnitSystem::kSi ? unit.si : unit.printed;
  return *name == '\0' ? key : fmt::format("{}_{}", key, name);
}

void Fields::add_some(std::string key, std::vector<Fields> list) {
  if (!list.empty()) add(std::move(key), std::move(list));
}

void Fields::append(Fields more) {
  std::move(more.fields_.begin(), more.fields_.end(), std::back_inserter(fields_));
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the value
OrderedJson value_in(const OrderedJson& si, const FieldUnit& unit, UnitSystem system) {
  if (si.is_number_float()) {
    const double value = si.get<double>();
    return number_or_null(system == UnitSystem::kSi ? value
                                                    : value * unit.numerator / unit.denominator);
  }
  OrderedJson out = si;
  if (si.is_array())
    for (OrderedJson& each : out) each = value_in(each, unit, system);
  if (si.is_object())
    for (auto& [name, each] : out.items()) each = value_in(each, unit, system);
  return out;
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the fields
OrderedJson json_of(const Fields& fields, UnitSystem system) {
  OrderedJson json = OrderedJson::object();
  for (const Field& field : fields.all()) {
    if (field.unit.is_measured && system == UnitSystem::kSi) continue;
    json[key_with(field.key, field.unit, system)] = value_of(field, system);
    if (!field.alias.empty()) json[field.alias] = value_of(field, system);
  }
  return json;
}

OrderedJson json_of(const std::vector<Fields>& results, UnitSystem system) {
  return results.size() == 1 ? json_of(results.front(), system) : list_of(results, system);
}

Table table_of(const std::vector<Fields>& rows) {
  Table table;
  std::vector<Cells> all;
  for (const Fields& row : rows) {
    Cells cells;
    for (const Field& field : row.all()) add_cells(field, "", cells);
    // A column stands behind the one that it follows in the first row that has it.
    auto at = table.header.begin();
    for (const auto& [column, text] : cells) {
      const auto found = std::find(table.header.begin(), table.header.end(), column);
      at = (found == table.header.end() ? table.header.insert(at, column) : found) + 1;
    }
    all.push_back(std::move(cells));
  }
  // Rows without a column have a dash there.
  for (const Cells& cells : all) {
    std::vector<std::string>& row = table.rows.emplace_back(table.header.size(), "-");
    for (const auto& [column, text] : cells) {
      const auto found = std::find(table.header.begin(), table.header.end(), column);
      row[static_cast<std::size_t>(found - table.header.begin())] = text;
    }
  }
  return table;
}

}  // namespace thenar
