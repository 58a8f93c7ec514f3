#pragma once

/// Files changed at random, as crafted ones are: numbers, words and lines, not only bytes.

#include <random>
#include <string>
#include <vector>

#include "tests/data/broken_files.h"

namespace thenar {

/// One number of a text in place of another, which no reader expects.
inline std::string number_replaced(std::string text, std::mt19937& rng) {
  static const std::vector<std::string> numbers{
      "0",     "-1",  "1e308",      "-1e308",     "1e-320",
      "nan",   "inf", "4294967296", "2147483647", "99999999999999999999",
      "0.1.2", "",    "1e9"};
  const std::string digits = "0123456789";
  std::size_t begin = text.find_first_of(digits, below(rng, text.size()));
  if (begin == std::string::npos) return text;
  const std::size_t end = std::min(text.find_first_not_of("0123456789.eE+-", begin), text.size());
  return text.replace(begin, end - begin, numbers[below(rng, numbers.size())]);
}

/// A line twice, lost, or in the place of another.
inline std::string lines_shuffled(const std::string& text, std::mt19937& rng) {
  std::vector<std::string> lines(1);
  for (const char c : text) {
    lines.back() += c;
    if (c == '\n') lines.emplace_back();
  }
  const std::size_t from = below(rng, lines.size()), to = below(rng, lines.size());
  const std::string line = lines[from];
  if (rng() % 2 == 0) lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(from));
  lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(std::min(to, lines.size())), line);
  std::string all;
  for (const std::string& each : lines) all += each;
  return all;
}

/// A piece of another file of the same kind, or many times one of its own.
inline std::string spliced(std::string text, const std::string& other, std::mt19937& rng) {
  const std::size_t at = below(rng, text.size() + 1);
  const std::size_t from = below(rng, other.size()), length = 1 + below(rng, 200);
  const std::string piece = other.substr(from, length);
  std::string inserted;
  for (std::size_t i = rng() % 8 == 0 ? 1 + below(rng, 500) : 1; i-- > 0;) inserted += piece;
  return text.insert(at, inserted);
}

/// One to four such changes.
inline std::string mutated(std::string text, const std::string& other, std::mt19937& rng) {
  for (std::size_t i = 1 + below(rng, 4); i-- > 0;) {
    const std::size_t kind = below(rng, 4);
    if (text.empty()) return text;
    text = kind == 0   ? broken(std::move(text), rng)
           : kind == 1 ? number_replaced(std::move(text), rng)
           : kind == 2 ? lines_shuffled(text, rng)
                       : spliced(std::move(text), other, rng);
  }
  return text;
}

}  // namespace thenar
