#pragma once

/// Result files in which something is another thing than what was written.

#include <string>

#include "base/error.h"
#include "data/io/result_file.h"

namespace thenar {

/// A change that sets one number of an array.
inline auto set_number(const char* key, std::size_t at, double value) {
  return [=](ResultFile& file) { file.arrays.at(key).values.at(at) = value; };
}

/// A change that sets a text.
inline auto set_text(const char* key, const char* value) {
  return [=](ResultFile& file) { file.texts[key] = {value}; };
}

/// What reading says once a file was changed.
/// @param changed  where the changed file is written;  @param read  what reads it
template <typename Change, typename Read>
std::string trouble_with_change(const std::string& path, const std::string& changed,
                                const Change& change, const Read& read) {
  ResultFile file = read_result(path);
  change(file);
  write_result(file, changed);
  try {
    read(changed);
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing was thrown";
}

}  // namespace thenar
