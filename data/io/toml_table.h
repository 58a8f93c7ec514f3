#pragma once

/// Reads one table of a data file: typed, with units, and with errors on which a user can act.
///
/// The unit of a quantity stands at the end of its key: the length "point" is read in metres from
/// `point_mm`, `point_cm` or `point_m`. A number needs a citation: a `source` key in its table or
/// in one around it. Every getter notes its key, so that done() can throw for unknown keys.

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/enum_names.h"
#include "base/error.h"
#include "data/io/toml_node.h"
#include "data/io/units.h"

namespace thenar {

class TomlTable;

/// A parsed file: its tree, its name for messages, and the sources it may cite. It must outlive its
/// tables.
class TomlFile {
 public:
  /// Parses `text`; `path` only names it in messages.
  /// @throws DataError at the first syntax error.
  TomlFile(const std::string& text, std::string path);

  TomlFile(const TomlFile&) = delete;
  TomlFile& operator=(const TomlFile&) = delete;

  /// Returns the top level of the file. Its `[sources]` table, if any, is read already.
  [[nodiscard]] TomlTable top() const;

  [[nodiscard]] const std::string& path() const { return path_; }

  /// Returns the citation keys of data/sources.bib, then those of the file's own `[sources]`.
  [[nodiscard]] const std::vector<std::string>& sources() const { return sources_; }
  /// Returns the file's own `[sources]`: what each key means.
  [[nodiscard]] const std::map<std::string, std::string>& own_sources() const {
    return own_sources_;
  }

 private:
  std::string path_;
  TomlNode root_;
  std::vector<std::string> sources_;
  std::map<std::string, std::string> own_sources_;
};

/// Returns the key of a quantity in SI: "force_N".
[[nodiscard]] std::string si_key(const std::string& base, Dimension dimension);

/// Admissible range of a number.
enum class Range { kAny, kNotNegative, kPositive, kFraction };

/// A named list of numbers.
struct NamedNumbers {
  std::string name;
  std::vector<double> values;
};

/// A reader of one table; the file must outlive it. Getters throw DataError `path:line: what was
/// wanted, what came`.
class TomlTable {
 public:
  /// @param title    its name in messages: "[[joint]]"
  /// @param sources  citation keys in force around it
  TomlTable(const TomlFile& file, const TomlNode& node, std::string title,
            std::vector<std::string> sources);

  /// Read keys without unit: texts, choices of words, lists of texts.
  [[nodiscard]] bool has(const std::string& key);
  [[nodiscard]] std::string text(const std::string& key);
  [[nodiscard]] std::string text_or(const std::string& key, const std::string& fallback);
  [[nodiscard]] std::string choice(const std::string& key, const std::vector<std::string>& of);
  /// Returns the value of a word in a table of names.
  template <typename Enum, std::size_t size>
  [[nodiscard]] Enum choice(const std::string& key, const std::array<EnumName<Enum>, size>& of) {
    return value_in(of, choice(key, names_in(of)), key);
  }
  [[nodiscard]] std::vector<std::string> texts(const std::string& key);

  /// Read quantities in SI; `base` is the key without its unit.
  [[nodiscard]] bool has(Dimension dimension, const std::string& base);
  [[nodiscard]] double number(Dimension dimension, const std::string& base,
                              Range range = Range::kAny);
  [[nodiscard]] double number_or(Dimension dimension, const std::string& base, double fallback,
                                 Range range = Range::kAny);
  /// @param count  number of entries wanted; 0: any
  [[nodiscard]] std::vector<double> numbers(Dimension dimension, const std::string& base,
                                            int count = 0, Range range = Range::kAny);
  [[nodiscard]] Eigen::Vector3d vector(Dimension dimension, const std::string& base);
  [[nodiscard]] Eigen::Vector3d vector_or(Dimension dimension, const std::string& base,
                                          const Eigen::Vector3d& fallback);
  [[nodiscard]] Eigen::Matrix3d rows3(const std::string& key);  // three rows of three

  /// Names to quantities, `arms_mm = {PIP3 = 5.6}`. Empty if absent.
  [[nodiscard]] std::map<std::string, double> named(Dimension dimension, const std::string& base,
                                                    Range range = Range::kAny);
  /// Returns all keys of this table as quantities, by name without unit: for tables of free names.
  [[nodiscard]] std::map<std::string, double> all(Dimension dimension);
  /// Reads named lists in file order, `rows = {Fx = [..], Fy = [..]}`.
  [[nodiscard]] std::vector<NamedNumbers> lists(const std::string& key);

  /// Return tables within this one.
  [[nodiscard]] std::optional<TomlTable> table(const std::string& key);
  [[nodiscard]] std::vector<TomlTable> tables(const std::string& key);  // none if absent

  [[nodiscard]] const std::string& title() const { return title_; }
  [[nodiscard]] int line() const { return node_->line; }
  [[nodiscard]] std::string source() const;  // citation keys in force, "A, B"
  /// Accepts a key without reading it.
  void ignore(const std::string& key) { known_.insert(key); }

  /// @throws DataError for the first key that no getter requested.
  void done() const;

  /// Throws a DataError at this table, or at one of its keys (with or without unit).
  [[noreturn]] void fail(const std::string& what, const std::string& key = "") const;

 private:
  struct Found {
    std::string key;
    const TomlNode* node;
    double to_si;
  };
  struct Quantity {
    Dimension dimension;
    std::string base;
  };
  [[nodiscard]] std::optional<Found> find(Dimension dimension, const std::string& base);
  [[nodiscard]] Found need(Dimension dimension, const std::string& base);
  [[nodiscard]] const TomlNode& need(const std::string& key, TomlKind kind);
  [[nodiscard]] double value(const TomlNode& node, const std::string& key, Range range) const;
  [[nodiscard]] std::vector<double> values(const TomlNode& node, const std::string& key, int count,
                                           Range range) const;
  [[nodiscard]] double in_si(const TomlNode& node, const Found& found, double value,
                             Dimension dimension) const;
  [[nodiscard]] TomlTable inner(const TomlNode& node, const std::string& title) const;
  void refuse_misspelt(const std::string& wanted) const;
  void refuse_wrong_unit(const Quantity& wanted) const;
  [[noreturn]] void fail_at(int line, const std::string& what) const;

  const TomlFile* file_;
  const TomlNode* node_;
  std::string title_;
  std::vector<std::string> sources_;
  std::set<std::string> known_;  // requested keys
  std::vector<Quantity> asked_;  // requested quantities
};

/// Returns a quantity, or nothing if it is absent.
[[nodiscard]] std::optional<double> number_if(TomlTable& table, Dimension dimension,
                                              const std::string& base, Range range = Range::kAny);

/// Returns a vector that is not zero, normalised (3).
[[nodiscard]] Eigen::Vector3d read_direction(TomlTable& table, const std::string& key);

/// Returns a sign, 1 or -1; 1 if it is absent.
[[nodiscard]] double read_sign(TomlTable& table, const std::string& key);

/// Returns the rotation of a quaternion w, x, y, z, whose length may deviate from 1 by rounding.
[[nodiscard]] Eigen::Matrix3d read_quaternion(TomlTable& table, const std::string& key);

/// Returns a table within `table`. @throws DataError with a complaint if it is absent.
[[nodiscard]] TomlTable needed_table(TomlTable& table, const std::string& key,
                                     const std::string& complaint);

/// Adds read(table, arguments..) of each table [[key]] to a list, and refuses its unread keys.
template <typename List, typename Read, typename... Arguments>
void read_each(TomlTable& table, const std::string& key, List& list, const Read& read,
               Arguments&&... arguments) {
  for (TomlTable& each : table.tables(key)) {
    list.push_back(read(each, arguments...));
    each.done();
  }
}

namespace internal {
/// Runs a check that throws InputError, and reports it at the table, or at one of its keys.
template <typename Check>
void check_here(const TomlTable& table, const Check& check, const std::string& key = "") {
  try {
    check();
  } catch (const InputError& error) {
    table.fail(error.what(), key);
  }
}
}  // namespace internal

}  // namespace thenar
