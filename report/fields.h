#pragma once

/// Results as named numbers with units, from which JSON of commands and replies of servers are
/// made.

#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "base/lists.h"
#include "base/units.h"
#include "report/json.h"
#include "report/table.h"

namespace thenar {

/// Unit of a number in SI and in print: printed = si * numerator / denominator.
struct FieldUnit {
  const char* si = "";       // ending of keys: "N_m"
  const char* printed = "";  // "N_mm"
  double numerator = 1, denominator = 1;
  bool is_measured = false;  // measured by a clock: differs from run to run
};

/// Units by the name in which they are printed.
namespace units {
inline constexpr FieldUnit kOne{};
inline constexpr FieldUnit kNewton{"N", "N"};
inline constexpr FieldUnit kMetre{"m", "m"};
inline constexpr FieldUnit kMillimetre{"m", "mm", 1, kMm};
inline constexpr FieldUnit kSquareMetre{"m2", "m2"};
inline constexpr FieldUnit kSquareMillimetre{"m2", "mm2", 1, 1e-6};
inline constexpr FieldUnit kRadian{"rad", "rad"};
inline constexpr FieldUnit kDegree{"rad", "deg", 1, thenar::kDegree};
inline constexpr FieldUnit kNewtonMetre{"N_m", "Nm"};
inline constexpr FieldUnit kNewtonMillimetre{"N_m", "N_mm", 1, thenar::kNewtonMillimetre};
inline constexpr FieldUnit kNewtonPerDegree{"N_per_rad", "N_per_deg", thenar::kDegree};
inline constexpr FieldUnit kNewtonMetrePerDegree{"N_m_per_rad", "Nm_per_deg", thenar::kDegree};
inline constexpr FieldUnit kSecond{"s", "s"};
inline constexpr FieldUnit kCpuSecond{"s", "s", 1, 1, true};  // processor time of a computation
inline constexpr FieldUnit kMillisecond{"s", "ms", 1, 1e-3};
inline constexpr FieldUnit kMetrePerSquareSecond{"m_per_s2", "m_per_s2"};
inline constexpr FieldUnit kJointDamping{"N_m_s_per_rad", "N_m_s_per_rad"};
inline constexpr FieldUnit kPercent{"", "percent", 100};
inline constexpr FieldUnit kMillimetrePerSecond{"m_per_s", "mm_per_s", 1, kMm};
inline constexpr FieldUnit kKilopascal{"Pa", "kPa", 1, 1e3};
inline constexpr FieldUnit kPascal{"Pa", "Pa"};
inline constexpr FieldUnit kJoule{"J", "J"};
inline constexpr FieldUnit kKilogram{"kg", "kg"};
inline constexpr FieldUnit kBit{"bit", "bit"};
inline constexpr FieldUnit kKilogramSquareMetre{"kg_m2", "kg_m2"};
inline constexpr FieldUnit kCubicMetre{"m3", "m3"};
inline constexpr FieldUnit kInertiaOfDensityOne{"m5", "m5"};
inline constexpr FieldUnit kMillimetrePerRadian{"m_per_rad", "mm_per_rad", 1, kMm};
inline constexpr FieldUnit kNewtonPerMetre{"N_per_m", "N_per_m"};
inline constexpr FieldUnit kNewtonPerMillimetre{"N_per_m", "N_per_mm", kMm};
// Printed under keys of earlier versions.
inline constexpr FieldUnit kMeasuredSeconds{"", "", 1, 1, true};  // see kCpuSecond
inline constexpr FieldUnit kMetrePerSecondShort{"m_per_s", "m_s"};
inline constexpr FieldUnit kRadianPerSecondShort{"rad_per_s", "rad_s"};
inline constexpr FieldUnit kDegreePerSecondShort{"rad_per_s", "deg_s", 1, thenar::kDegree};
inline constexpr FieldUnit kMetreBare{"m", ""};
inline constexpr FieldUnit kRadianBare{"rad", ""};
inline constexpr FieldUnit kMetrePerSecondBare{"m_per_s", ""};
inline constexpr FieldUnit kRadianPerSecondBare{"rad_per_s", ""};
inline constexpr FieldUnit kMillimetrePerSecondShort{"m_per_s", "mm_s", 1, kMm};
inline constexpr FieldUnit kNewtonBare{"N", ""};
inline constexpr FieldUnit kNewtonMetreBare{"N_m", ""};
inline constexpr FieldUnit kSecondBare{"s", ""};
inline constexpr FieldUnit kJouleBare{"J", ""};
inline constexpr FieldUnit kPascalBare{"Pa", ""};
inline constexpr FieldUnit kSquareMetreBare{"m2", ""};
}  // namespace units

/// Units in which fields are written.
enum class UnitSystem {
  kSi,      // servers and machine-readable files
  kPrinted  // text and JSON of commands
};

/// Returns a key with its unit: "tip_force_N".
[[nodiscard]] std::string key_with(const std::string& key, const FieldUnit& unit,
                                   UnitSystem system);

class Fields;

/// One named value of a result.
struct Field {
  /// @param value  in SI: a number, a text, or lists and objects of them
  Field(std::string name, const FieldUnit& its_unit, OrderedJson si);
  Field(std::string name, OrderedJson si) : Field(std::move(name), units::kOne, std::move(si)) {}
  Field(std::string name, const FieldUnit& its_unit, double si)
      : Field(std::move(name), its_unit, OrderedJson(si)) {}
  /// Number, or null if absent.
  Field(std::string name, const FieldUnit& its_unit, const std::optional<double>& si);
  /// Vector as a list, or matrix as a list of rows.
  template <typename Derived>
  Field(std::string name, const FieldUnit& its_unit, const Eigen::MatrixBase<Derived>& si)
      : Field(std::move(name), its_unit, OrderedJson(to_json(si))) {}
  /// Numbers by name.
  template <typename Derived>
  Field(std::string name, const FieldUnit& its_unit, const std::vector<std::string>& names,
        const Eigen::MatrixBase<Derived>& si)
      : Field(std::move(name), its_unit, to_json(names, si)) {}
  /// Part with its own fields.
  Field(std::string name, Fields part);
  /// List of parts.
  Field(std::string name, std::vector<Fields> list);

  std::string key;            // key without its unit: "tip_force"
  FieldUnit unit;             // unit of all numbers in `value`
  OrderedJson value;          // value in SI
  std::vector<Fields> parts;  // members, instead of a value
  bool is_list = false;       // a list of parts, even if there is one
};

/// Fields of a result in the order in which they are written.
class Fields {
 public:
  Fields() = default;
  Fields(std::initializer_list<Field> fields) : fields_(fields) {}
  /// Adds Field(arguments ..).
  template <typename... Arguments>
  Field& add(Arguments&&... arguments) {
    return fields_.emplace_back(std::forward<Arguments>(arguments)...);
  }
  /// Adds a list, unless it is empty.
  void add_some(std::string key, std::vector<Fields> list);
  /// Appends all fields of another result.
  void append(Fields more);

  [[nodiscard]] const std::vector<Field>& all() const { return fields_; }

 private:
  std::vector<Field> fields_;
};

/// Returns the fields of each item. @param make  returns the fields of one item
template <typename Items, typename Make>
[[nodiscard]] std::vector<Fields> fields_of_each(const Items& items, const Make& make) {
  return transformed(items, make);
}

/// Returns a value in the unit of a system, with null for numbers that are not finite.
[[nodiscard]] OrderedJson value_in(const OrderedJson& si, const FieldUnit& unit, UnitSystem system);

/// Returns the fields as an object, the unit in each key; numbers that are not finite are null. In
/// SI processor times are left out, so that the same request gives the same text.
[[nodiscard]] OrderedJson json_of(const Fields& fields, UnitSystem system);

/// Returns an object for one result, a list of objects for several.
[[nodiscard]] OrderedJson json_of(const std::vector<Fields>& results, UnitSystem system);

/// Returns JSON of any result that has fields, in printed units.
template <typename Result>
[[nodiscard]] auto json_of(const Result& result)
    -> decltype(json_of(fields_of(result), UnitSystem::kPrinted)) {
  return json_of(fields_of(result), UnitSystem::kPrinted);
}

}  // namespace thenar
