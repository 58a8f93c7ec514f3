#pragma once

/// Lines and words of a mesh file in text.

#include <cstddef>
#include <string>
#include <string_view>

#include <Eigen/Core>

namespace thenar {

/// Iterates over lines with content, and over the words of each. Comments from # to the end of a
/// line are left out; a line that ends in a backslash continues in the next. Takes no memory.
class TextLines {
 public:
  /// @param text  must outlive this
  /// @param path  names the file in messages; must outlive this
  TextLines(std::string_view text, const std::string& path) : text_(text), path_(path) {}

  /// Moves to the next line. @returns false at the end of the text
  [[nodiscard]] bool next();

  /// Returns the next word of the line; empty at its end.
  [[nodiscard]] std::string_view word();

  /// Returns the next word as a finite number. @throws DataError
  [[nodiscard]] double number();
  /// Returns the next three numbers.
  [[nodiscard]] Eigen::Vector3d vector3();

  /// Returns the next word as a whole number in lower..upper. @throws DataError
  [[nodiscard]] int whole(int lower, int upper);

  /// Returns the line number of the current line, from 1.
  [[nodiscard]] int line() const { return line_; }

  /// Returns the number of bytes behind the line.
  [[nodiscard]] std::size_t bytes_left() const { return text_.size() - next_; }

  [[noreturn]] void fail(const std::string& what) const;

 private:
  std::string_view text_;
  const std::string& path_;
  std::string_view rest_;  // rest of the current line
  std::size_t next_ = 0;   // start of the next line
  int line_ = 0, next_line_ = 1;
};

/// Returns a word in quotes for a message, cut if it is long.
[[nodiscard]] std::string in_quotes(std::string_view word);

/// Parses a whole word as a finite decimal number, with or without a sign; "1e-400" is 0.
/// @returns false if it is no such number
[[nodiscard]] bool parse_decimal(std::string_view word, double& value);

}  // namespace thenar
