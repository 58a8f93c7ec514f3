#include "report/fields.h"

#include <iterator>

#include <fmt/format.h>

namespace thenar {
namespace {

// NOLINTNEXTLINE(misc-no-recursion): as deep as the fields
OrderedJson list_of(const std::vector<Fields>& parts, UnitSystem system) {
  return list_of_each<OrderedJson>(parts,
                                   [&](const Fields& part) { return json_of(part, system); });
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the fields
OrderedJson value_of(const Field& field, UnitSystem system) {
  if (!field.is_list && field.parts.empty()) return value_in(field.value, field.unit, system);
  return field.is_list ? list_of(field.parts, system) : json_of(field.parts.front(), system);
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
  }
  return json;
}

OrderedJson json_of(const std::vector<Fields>& results, UnitSystem system) {
  return results.size() == 1 ? json_of(results.front(), system) : list_of(results, system);
}

}  // namespace thenar
