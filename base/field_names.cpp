#include "base/field_names.h"

#include <array>
#include <cctype>

#include "base/lists.h"

namespace thenar {
namespace {

constexpr std::size_t kMaxFieldLength = 63;  // letters of a name in MATLAB

// Words that are no names there.
constexpr std::array kReservedWords{"break",  "case",   "catch",     "classdef", "continue",
                                    "else",   "elseif", "end",       "for",      "function",
                                    "global", "if",     "otherwise", "parfor",   "persistent",
                                    "return", "spmd",   "switch",    "try",      "while"};

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

}  // namespace

std::string field_name(const std::string& name) {
  std::string field;
  bool after_blank = false;
  for (const char c : name) {
    // A blank is dropped, and the letter behind it made upper case.
    if (is_blank(c)) {
      after_blank = true;
      continue;
    }
    const bool stays =
        static_cast<unsigned char>(c) < 128 &&
        (is_letter(c) || std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '_');
    const char kept = stays ? c : '_';
    field += after_blank ? static_cast<char>(std::toupper(static_cast<unsigned char>(kept))) : kept;
    after_blank = false;
  }
  // Reserved words of MATLAB, and names that begin with a digit, get an x in front.
  if (contains(kReservedWords, field)) {
    field[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(field[0])));
    field = "x" + field;
  }
  if (field.empty() || !is_letter(field[0])) field = "x" + field;
  return field.substr(0, kMaxFieldLength);
}

std::string name_of_field(const std::string& field, const std::vector<std::string>& names) {
  if (contains(names, field)) return field;
  // Accept a field only if a single name has it.
  std::string found;
  for (const std::string& name : names) {
    if (field_name(name) != field) continue;
    if (!found.empty()) return "";
    found = name;
  }
  return found;
}

}  // namespace thenar
