#pragma once

/// JSON texts, parsed strictly, and the lines on which their values stand, for messages about them.

#include <map>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace thenar {

/// Steps from the root of a JSON text to a value: names of members, numbers of entries.
using JsonPath = std::vector<std::string>;

/// Parses strictly: no repeated members, no NaN or infinite numbers, no comments; within the limits
/// of data/io/file_guard.h.
/// @param first_line  number of the text's first line, for messages
/// @throws DataError `path:line: ...` saying what was wanted and what came.
[[nodiscard]] nlohmann::json parse_json(const std::string& path, const std::string& text,
                                        int first_line = 1);

/// Line on which a value starts, counted from 1; of a value that is not there, the line of the
/// innermost one around it that is.
/// @param text  that parse_json() accepts
[[nodiscard]] int line_of(const std::string& text, const JsonPath& value);

/// Members of the object at `value` that are a text, or a list of nothing but texts; none where no
/// object stands. @throws DataError as parse_json()
[[nodiscard]] std::map<std::string, std::vector<std::string>> text_members(const std::string& path,
                                                                           const std::string& text,
                                                                           const JsonPath& value);

}  // namespace thenar
