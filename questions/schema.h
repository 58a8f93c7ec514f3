#pragma once

/// Schemas of requests: types, ranges and units of its parameters, and validation of JSON by it.

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/outside_path.h"
#include "report/json.h"

namespace thenar {

struct SchemaMember;

/// A type of JSON value with its limits. Build one by the functions below.
struct Schema {
  enum class Kind { kNumber, kInteger, kText, kFlag, kList, kObject, kMap };
  Kind kind = Kind::kObject;
  std::string unit = {};                                    // of numbers, "rad or m"; empty: none
  double lower = -std::numeric_limits<double>::infinity();  // of numbers
  double upper = std::numeric_limits<double>::infinity();   // of numbers
  std::size_t least = 0;                         // length of texts (bytes), lists and maps
  std::size_t most = 1000;                       // the same
  std::shared_ptr<const Schema> each = nullptr;  // of the entries of a list, or the values of a map
  bool open = false;                             // of objects: members are not looked at
  bool unnamed = false;  // of maps: a list of the values in a known order will do as well
  bool endless = false;  // of numbers: infinite ones may be given, in JSON as "inf" and "-inf"
  std::vector<std::string> words = {};                // of texts: one of these; empty: any
  std::optional<OutsideUse> use = OutsideUse::kRead;  // of texts; nothing: any bytes
  std::vector<SchemaMember> members = {};             // of an object; no others are allowed
};

/// A member of an object.
struct SchemaMember {
  std::string name;
  Schema schema;
  std::string about;  // one sentence
  bool required = false;
  Json usual = nullptr;  // taken where the member is left out; null: it stays out
};

[[nodiscard]] Schema number_schema(const std::string& unit,
                                   double lower = -std::numeric_limits<double>::infinity(),
                                   double upper = std::numeric_limits<double>::infinity());
/// A number that may be infinite: "inf" or "-inf" in JSON.
[[nodiscard]] Schema endless_schema(const std::string& unit, double lower);
[[nodiscard]] Schema integer_schema(double lower, double upper);
/// A name or a path: without control characters, whatever it is used for.
/// @param most  bytes
[[nodiscard]] Schema text_schema(std::size_t most = 1000);
/// The path of a file to be written in the working folder.
[[nodiscard]] Schema saved_file_schema();
/// A text of several lines, or bytes: never a name.
/// @param most  bytes
[[nodiscard]] Schema content_schema(std::size_t most);
[[nodiscard]] Schema word_schema(std::vector<std::string> words);
[[nodiscard]] Schema flag_schema();
[[nodiscard]] Schema list_schema(const Schema& each, std::size_t least, std::size_t most);
/// map_schema(), or a list of its values in a known order.
[[nodiscard]] Schema map_or_list_schema(const Schema& each);
/// An object whose members have any name and one type: joint -> angle.
[[nodiscard]] Schema map_schema(const Schema& each, std::size_t most = 1000);
/// An object whose members something else checks.
[[nodiscard]] Schema any_object_schema();
[[nodiscard]] Schema object_schema(std::vector<SchemaMember> members);
/// Three numbers.
[[nodiscard]] Schema vector_schema(const std::string& unit);
/// A quaternion [w, x, y, z] of length 1 to 1e-3; it is made exact where it is used.
[[nodiscard]] Schema rotation_schema();

/// Checks a value and fills in what is left out.
/// @param where  how messages call it: "params"
/// @throws InputError "params.position.2: wanted a number [m], got text", or with the nearest name
///         of a member that is not known.
[[nodiscard]] Json checked(const Schema& schema, const Json& value, const std::string& where);

/// The schema in the words of JSON Schema (draft 2020-12), units as "x-unit".
[[nodiscard]] OrderedJson json_schema(const Schema& schema);

}  // namespace thenar
