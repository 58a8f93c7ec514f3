#include "data/io/toml_table.h"

#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "base/enum_names.h"
#include "base/lists.h"
#include "base/nearest_name.h"
#include "data/io/toml_text.h"

namespace thenar {
namespace {

std::string key_of(const std::string& base, const Unit& unit) {
  return unit.suffix.empty() ? base : base + "_" + unit.suffix;
}

std::vector<std::string> keys_of(const std::string& base, Dimension dimension) {
  return transformed(units_of(dimension), [&](const Unit& unit) { return key_of(base, unit); });
}

bool holds(Range range, double value) {
  if (range == Range::kAny) return true;
  return range == Range::kPositive ? value > 0
                                   : value >= 0 && (range == Range::kNotNegative || value <= 1);
}

constexpr std::array kRangeNames{
    EnumName{Range::kAny, "finite"}, EnumName{Range::kNotNegative, ">= 0"},
    EnumName{Range::kPositive, "> 0"}, EnumName{Range::kFraction, "in 0..1"}};

}  // namespace

std::string with_si_unit(double value, Dimension dimension) {
  for (const Unit& unit : units_of(dimension))
    if (unit.to_si == 1) return fmt::format("{:g} {}", value, unit.suffix);
  return fmt::format("{:g}", value);
}

std::string si_key(const std::string& base, Dimension dimension) {
  for (const Unit& unit : units_of(dimension))
    if (unit.to_si == 1) return key_of(base, unit);
  return base;
}

TomlTable::TomlTable(const TomlFile& file, const TomlNode& node, std::string title,
                     std::vector<std::string> sources)
    : file_(&file), node_(&node), title_(std::move(title)), sources_(std::move(sources)) {
  if (node.kind != TomlKind::kTable)
    fail_at(node.line, fmt::format("wanted {} as a table, got {}", title_, kind_name(node.kind)));
  // Citations in force: its own, or those around it.
  const TomlNode* own = node.find("source");
  ignore("source");
  if (own == nullptr) return;
  sources_ = own->kind == TomlKind::kArray ? texts("source") : std::vector{text("source")};
  for (const std::string& key : sources_)
    if (!contains(file.sources(), key))
      fail(fmt::format("source '{}' is neither in data/sources.bib nor in this file's [sources]{}",
                       key, did_you_mean(key, file.sources())),
           "source");
}

bool TomlTable::has(const std::string& key) {
  ignore(key);
  return node_->find(key) != nullptr;
}

std::string TomlTable::text(const std::string& key) { return need(key, TomlKind::kText).text; }

std::string TomlTable::text_or(const std::string& key, const std::string& fallback) {
  return has(key) ? text(key) : fallback;
}

std::string TomlTable::choice(const std::string& key, const std::vector<std::string>& of) {
  std::string got = text(key);
  if (!contains(of, got))
    fail(fmt::format("wanted '{}' to be one of {}, got '{}'", key, fmt::join(of, ", "), got), key);
  return got;
}

std::vector<std::string> TomlTable::texts(const std::string& key) {
  std::vector<std::string> found;
  for (const TomlNode& item : need(key, TomlKind::kArray).items) {
    if (item.kind != TomlKind::kText)
      fail(fmt::format("wanted '{}' as a list of texts, got {} in it", key, kind_name(item.kind)),
           key);
    found.push_back(item.text);
  }
  return found;
}

bool TomlTable::has(Dimension dimension, const std::string& base) {
  return find(dimension, base).has_value();
}

double TomlTable::number(Dimension dimension, const std::string& base, Range range) {
  const Found found = need(dimension, base);
  return in_si(*found.node, found, value(*found.node, found.key, range), dimension);
}

double TomlTable::number_or(Dimension dimension, const std::string& base, double fallback,
                            Range range) {
  return number_if(*this, dimension, base, range).value_or(fallback);
}

std::vector<double> TomlTable::numbers(Dimension dimension, const std::string& base, int count,
                                       Range range) {
  const Found found = need(dimension, base);
  std::vector<double> result = values(*found.node, found.key, count, range);
  for (double& entry : result) entry = in_si(*found.node, found, entry, dimension);
  return result;
}

Eigen::Vector3d TomlTable::vector(Dimension dimension, const std::string& base) {
  const std::vector<double> v = numbers(dimension, base, 3);
  return {v[0], v[1], v[2]};
}

Eigen::Vector3d TomlTable::vector_or(Dimension dimension, const std::string& base,
                                     const Eigen::Vector3d& fallback) {
  return has(dimension, base) ? vector(dimension, base) : fallback;
}

Eigen::Matrix3d TomlTable::rows3(const std::string& key) {
  // Three rows of three numbers.
  const TomlNode& node = need(key, TomlKind::kArray);
  if (node.items.size() != 3)
    fail(fmt::format("wanted '{}' as 3 rows, got {}", key, node.items.size()), key);
  Eigen::Matrix3d rows;
  for (int i = 0; i < 3; ++i) {
    const std::vector<double> row = values(node.items[i], key, 3, Range::kAny);
    rows.row(i) << row[0], row[1], row[2];
  }
  return rows;
}

std::map<std::string, double> TomlTable::named(Dimension dimension, const std::string& base,
                                               Range range) {
  std::map<std::string, double> result;
  // Absent: no names at all.
  const std::optional<Found> found = find(dimension, base);
  if (!found) return result;
  if (found->node->kind != TomlKind::kTable)
    fail(fmt::format("wanted '{}' as a table, got {}", found->key, kind_name(found->node->kind)),
         found->key);
  // Each name with its value in SI.
  for (const auto& [name, node] : found->node->members)
    result[name] =
        in_si(node, *found, value(node, fmt::format("{}.{}", found->key, name), range), dimension);
  return result;
}

std::map<std::string, double> TomlTable::all(Dimension dimension) {
  std::map<std::string, double> result;
  for (const auto& [key, node] : node_->members) {
    if (key == "source") continue;
    const std::size_t underscore = key.rfind('_');
    result[key.substr(0, underscore)] = number(dimension, key.substr(0, underscore));
  }
  return result;
}

std::vector<NamedNumbers> TomlTable::lists(const std::string& key) {
  std::vector<NamedNumbers> result;
  for (const auto& [name, node] : need(key, TomlKind::kTable).members)
    result.push_back({name, values(node, fmt::format("{}.{}", key, name), 0, Range::kAny)});
  return result;
}

std::optional<TomlTable> TomlTable::table(const std::string& key) {
  if (!has(key)) return std::nullopt;
  return inner(need(key, TomlKind::kTable), "[" + key + "]");
}

std::vector<TomlTable> TomlTable::tables(const std::string& key) {
  std::vector<TomlTable> result;
  if (!has(key)) return result;
  for (const TomlNode& node : need(key, TomlKind::kArray).items)
    result.push_back(inner(node, "[[" + key + "]]"));
  return result;
}

std::string TomlTable::source() const { return fmt::format("{}", fmt::join(sources_, ", ")); }

void TomlTable::done() const {
  // A known quantity with a wrong unit deserves its own message.
  for (const Quantity& wanted : asked_) refuse_wrong_unit(wanted);
  for (const auto& [key, node] : node_->members)
    if (known_.count(key) == 0)
      fail_at(node.line, fmt::format("unknown key '{}'{}", key,
                                     did_you_mean(key, {known_.begin(), known_.end()})));
}

void TomlTable::fail(const std::string& what, const std::string& key) const {
  // At the line of the key, with or without its unit.
  for (const auto& [name, node] : node_->members)
    if (name == key || (!key.empty() && name.rfind(key + "_", 0) == 0)) fail_at(node.line, what);
  fail_at(node_->line, what);
}

std::optional<TomlTable::Found> TomlTable::find(Dimension dimension, const std::string& base) {
  asked_.push_back({dimension, base});
  // Any unit of the dimension, but only one of them.
  std::optional<Found> found;
  for (const Unit& unit : units_of(dimension)) {
    const std::string key = key_of(base, unit);
    ignore(key);
    const TomlNode* node = node_->find(key);
    if (node == nullptr) continue;
    if (found) fail(fmt::format("given twice: '{}' and '{}'", found->key, key), key);
    found = Found{key, node, unit.to_si};
  }
  return found;
}

TomlTable::Found TomlTable::need(Dimension dimension, const std::string& base) {
  const std::optional<Found> found = find(dimension, base);
  if (found) return *found;
  // Explain the likely mistakes before saying that it is missing.
  refuse_wrong_unit({dimension, base});
  for (const std::string& key : keys_of(base, dimension)) refuse_misspelt(key);
  fail(fmt::format("{} needs {} ({})", title_, dimension_name(dimension),
                   fmt::join(keys_of(base, dimension), ", ")));
}

const TomlNode& TomlTable::need(const std::string& key, TomlKind kind) {
  ignore(key);
  const TomlNode* node = node_->find(key);
  if (node == nullptr) {
    refuse_misspelt(key);
    fail(fmt::format("{} needs '{}' ({})", title_, key, kind_name(kind)));
  }
  if (node->kind != kind)
    fail(fmt::format("wanted '{}' as {}, got {}", key, kind_name(kind), kind_name(node->kind)),
         key);
  return *node;
}

double TomlTable::value(const TomlNode& node, const std::string& key, Range range) const {
  // A number, finite, in its range, and with a source.
  if (node.kind != TomlKind::kNumber)
    fail_at(node.line, fmt::format("wanted '{}' as a number, got {}", key, kind_name(node.kind)));
  if (!std::isfinite(node.number))
    fail_at(node.line, fmt::format("wanted '{}' as a finite number, got {}", key, node.number));
  if (!holds(range, node.number))
    fail_at(node.line,
            fmt::format("wanted '{}' {}, got {}", key, name_in(kRangeNames, range), node.number));
  if (sources_.empty())
    fail_at(node.line, fmt::format("'{}' has no source: add source = \"Key\" to its table or to "
                                   "the top of the file",
                                   key));
  return node.number;
}

/// A number times its unit; its size must be plausible for hands, robots and objects.
double TomlTable::in_si(const TomlNode& node, const Found& found, double value,
                        Dimension dimension) const {
  const double si = value * found.to_si, most = largest_of(dimension);
  if (!(std::abs(si) <= most))
    fail_at(node.line, fmt::format("wanted '{}' of at most {} in size, got {:g}", found.key,
                                   with_si_unit(most, dimension), value));
  return si;
}

std::vector<double> TomlTable::values(const TomlNode& node, const std::string& key, int count,
                                      Range range) const {
  if (node.kind != TomlKind::kArray)
    fail_at(node.line, fmt::format("wanted '{}' as a list, got {}", key, kind_name(node.kind)));
  const int size = static_cast<int>(node.items.size());
  if (count > 0 && size != count)
    fail_at(node.line, fmt::format("wanted {} numbers in '{}', got {}", count, key, size));
  return transformed(node.items, [&](const TomlNode& item) { return value(item, key, range); });
}

TomlTable TomlTable::inner(const TomlNode& node, const std::string& title) const {
  return {*file_, node, title, sources_};
}

/// Refuses a key that is nearly the wanted one and was not asked for: a misspelling.
void TomlTable::refuse_misspelt(const std::string& wanted) const {
  const int near = wanted.size() < 6 ? 1 : 2;  // letters that may differ
  for (const auto& [key, node] : node_->members)
    if (known_.count(key) == 0 && edit_distance(key, wanted) <= near)
      fail_at(node.line, fmt::format("unknown key '{}', did you mean '{}'?", key, wanted));
}

/// Refuses the wanted key with no unit, or with a unit of another dimension.
void TomlTable::refuse_wrong_unit(const Quantity& wanted) const {
  for (const Unit& unit : all_units()) {
    const std::string key = key_of(wanted.base, unit);
    if (node_->find(key) == nullptr || known_.count(key) > 0) continue;
    fail(fmt::format("wanted {} ({}), got '{}'", dimension_name(wanted.dimension),
                     fmt::join(keys_of(wanted.base, wanted.dimension), ", "), key),
         key);
  }
}

void TomlTable::fail_at(int line, const std::string& what) const {
  throw DataError(file_->path(), line, what);
}

TomlFile::TomlFile(const std::string& text, std::string path)
    : path_(std::move(path)), root_(parse_toml(text, path_)), sources_(known_sources()) {
  // Sources that the file brings itself.
  const TomlNode* own = root_.find("sources");
  if (own == nullptr) return;
  for (const auto& [key, reference] : own->members) {
    if (reference.kind != TomlKind::kText)
      throw DataError(path_, reference.line,
                      fmt::format("wanted the reference of source '{}' as a text, got {}", key,
                                  kind_name(reference.kind)));
    sources_.push_back(key);
    own_sources_[key] = reference.text;
  }
}

TomlTable TomlFile::top() const {
  TomlTable table(*this, root_, "the top level", {});
  table.ignore("sources");
  return table;
}

std::optional<double> number_if(TomlTable& table, Dimension dimension, const std::string& base,
                                Range range) {
  if (!table.has(dimension, base)) return std::nullopt;
  return table.number(dimension, base, range);
}

Eigen::Vector3d read_direction(TomlTable& table, const std::string& key) {
  const Eigen::Vector3d d = table.vector(Dimension::kNumber, key);
  if (d.norm() < 1e-9)
    table.fail(fmt::format("wanted '{}' as a direction, got a zero vector", key), key);
  return d.normalized();
}

double read_sign(TomlTable& table, const std::string& key) {
  const double sign = table.number_or(Dimension::kNumber, key, 1);
  if (std::abs(sign) != 1)
    table.fail(fmt::format("wanted '{}' to be 1 or -1, got {}", key, sign), key);
  return sign;
}

Eigen::Matrix3d read_quaternion(TomlTable& table, const std::string& key) {
  constexpr double kQuaternionTolerance = 1e-3;  // largest error of the length of a printed one [1]
  const std::vector<double> q = table.numbers(Dimension::kNumber, key, 4);
  const Eigen::Quaterniond quaternion(q[0], q[1], q[2], q[3]);
  if (std::abs(quaternion.norm() - 1) > kQuaternionTolerance)
    table.fail(fmt::format("wanted '{}' of length 1, got {:.6g}", key, quaternion.norm()), key);
  return quaternion.normalized().toRotationMatrix();
}

TomlTable needed_table(TomlTable& table, const std::string& key, const std::string& complaint) {
  if (std::optional<TomlTable> found = table.table(key)) return *found;
  table.fail(complaint);
}

}  // namespace thenar
