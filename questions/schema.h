#pragma once

/// Schemas of JSON values: types, ranges and units, and validation of requests.

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/outside_path.h"
#include "report/json.h"

namespace thenar {

struct SchemaMember;

/// Language in which a request was written: messages about it use its words.
enum class RequestSyntax { kJson, kToml };

/// Type of a JSON value with its limits. Build one by the functions below.
struct Schema {
  enum class Kind { kNumber, kInteger, kText, kFlag, kList, kObject, kMap };
  Kind kind = Kind::kObject;
  std::string unit = {};                                    // unit of numbers, "rad or m"
  double lower = -std::numeric_limits<double>::infinity();  // smallest number
  double upper = std::numeric_limits<double>::infinity();   // largest number
  std::size_t min_size = 0;     // smallest length of a text [bytes], or size of a list or map
  std::size_t max_size = 1000;  // largest length of a text [bytes], or size of a list or map
  std::shared_ptr<const Schema> element = nullptr;  // schema of list entries or map values
  bool accepts_any_member = false;                  // objects: members are not checked
  bool accepts_list = false;            // maps: a list of the values in a known order is valid, too
  bool accepts_infinity = false;        // numbers: "inf" and "-inf" are valid, too
  std::vector<std::string> words = {};  // allowed texts; empty: any text
  std::optional<OutsideUse> use = OutsideUse::kRead;  // use of a text as a path; absent: any bytes
  std::vector<SchemaMember> members = {};             // allowed members of an object
};

/// Member of an object.
struct SchemaMember {
  std::string name;
  Schema schema;
  std::string description;  // one sentence
  bool required = false;
  Json default_value = nullptr;  // value if the member is missing; null: none
};

/// Returns the schema of a number within bounds.
[[nodiscard]] Schema number_schema(const std::string& unit,
                                   double lower = -std::numeric_limits<double>::infinity(),
                                   double upper = std::numeric_limits<double>::infinity());
/// Returns the schema of a number that may be infinite: "inf" or "-inf" in JSON.
[[nodiscard]] Schema infinite_number_schema(const std::string& unit, double lower);
[[nodiscard]] Schema integer_schema(double lower, double upper);
/// Returns the schema of a name or a path, without control characters.
/// @param max_bytes  largest length
[[nodiscard]] Schema text_schema(std::size_t max_bytes = 1000);
/// Returns the schema of the path of a file that is written in the working folder.
[[nodiscard]] Schema saved_file_schema();
/// Returns the schema of a text of several lines, or of bytes; it is never used as a name.
/// @param max_bytes  largest length
[[nodiscard]] Schema content_schema(std::size_t max_bytes);
[[nodiscard]] Schema word_schema(std::vector<std::string> words);
[[nodiscard]] Schema flag_schema();
[[nodiscard]] Schema list_schema(const Schema& element, std::size_t min_size, std::size_t max_size);
/// Returns the schema of map_schema() that also accepts a list of the values in a known order.
[[nodiscard]] Schema map_or_list_schema(const Schema& element);
/// Returns the schema of an object whose members have any name and one type: joint -> angle.
[[nodiscard]] Schema map_schema(const Schema& element, std::size_t max_size = 1000);
/// Returns the schema of an object whose members are not checked.
[[nodiscard]] Schema any_object_schema();
[[nodiscard]] Schema object_schema(std::vector<SchemaMember> members);
/// Returns the schema of a list of three numbers.
[[nodiscard]] Schema vector_schema(const std::string& unit);
/// Returns the schema of a quaternion [w, x, y, z] of length 1, to 1e-3; users normalise it.
[[nodiscard]] Schema rotation_schema();

/// Checks a value, and adds default values of missing members.
/// @param where   name of the value in messages: "params"
/// @param syntax  kToml: "wanted a table", kJson: "wanted an object"
/// @throws InputError "params.position.2: wanted a number [m], got text", or with the nearest name
///         of an unknown member
[[nodiscard]] Json validated(const Schema& schema, const Json& value, const std::string& where,
                             RequestSyntax syntax = RequestSyntax::kJson);

/// Converts a schema to JSON Schema (draft 2020-12), with units as "x-unit".
[[nodiscard]] OrderedJson json_schema(const Schema& schema);

}  // namespace thenar
