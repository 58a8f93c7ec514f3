#include "data/io/mesh/off_text.h"

#include <cmath>
#include <cstdlib>
#include <regex>
#include <sstream>
#include <vector>

#include "base/error.h"

namespace thenar {
namespace {

/// The lines of a text that hold something, without their comments.
class Lines {
 public:
  Lines(const std::string& text, const std::string& path) : text_(text), path_(path) {}

  /// The next line's words. @throws DataError at the end of the text.
  std::vector<std::string> next() {
    for (std::string line; std::getline(text_, line);) {
      ++number_;
      std::istringstream rest(line.substr(0, line.find('#')));
      std::vector<std::string> words;
      for (std::string word; rest >> word;) words.push_back(word);
      if (!words.empty()) return words;
    }
    fail("the file ends before all corners and faces are told");
  }

  /// The first words of a line as numbers. @param words  more than `count` are fine
  std::vector<double> numbers(const std::vector<std::string>& words, std::size_t count) const {
    if (words.size() < count) fail(fmt::format("wanted {} numbers, got {}", count, words.size()));
    std::vector<double> found;
    for (std::size_t i = 0; i < count; ++i) {
      char* end = nullptr;
      found.push_back(std::strtod(words[i].c_str(), &end));
      if (*end != '\0' || !std::isfinite(found.back()))
        fail(fmt::format("wanted a finite number, got '{}'", words[i]));
    }
    return found;
  }

  /// A whole number in lower..upper.
  int whole(double number, double lower, double upper) const {
    if (number != std::floor(number) || number < lower || number > upper)
      fail(fmt::format("wanted a whole number in {}..{}, got {}", lower, upper, number));
    return static_cast<int>(number);
  }

  [[noreturn]] void fail(const std::string& what) const { throw DataError(path_, number_, what); }

 private:
  std::istringstream text_;
  std::string path_;
  int number_ = 0;
};

constexpr double kMost = 1e8;  // corners or faces: anything above is no count

}  // namespace

std::string off_as_obj(const std::string& text, const std::string& path) {
  Lines lines(text, path);
  std::vector<std::string> head = lines.next();
  if (!std::regex_match(head[0], std::regex("(ST)?C?N?OFF")))
    lines.fail(fmt::format("wanted an OFF in text, got '{}'", head[0]));
  head.erase(head.begin());
  const std::vector<double> counts = lines.numbers(head.empty() ? lines.next() : head, 2);
  const int corners = lines.whole(counts[0], 0, kMost), faces = lines.whole(counts[1], 0, kMost);

  std::string obj;
  for (int i = 0; i < corners; ++i) {
    const std::vector<double> p = lines.numbers(lines.next(), 3);
    obj += fmt::format("v {} {} {}\n", p[0], p[1], p[2]);
  }
  for (int i = 0; i < faces; ++i) {
    const std::vector<std::string> words = lines.next();
    const int sides = lines.whole(lines.numbers(words, 1)[0], 1, kMost);
    const std::vector<double> face = lines.numbers(words, static_cast<std::size_t>(sides) + 1);
    obj += "f";
    for (std::size_t k = 1; k < face.size(); ++k)
      obj += fmt::format(" {}", lines.whole(face[k], 0, corners - 1) + 1);
    obj += "\n";
  }
  return obj;
}

}  // namespace thenar
