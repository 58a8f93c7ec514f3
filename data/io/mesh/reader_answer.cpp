#include "data/io/mesh/reader_answer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>

#include "base/error.h"

namespace thenar {
namespace {

// One word, then for triangles a count and nine floats each, for a refusal its text; then the end.
constexpr std::string_view kTriangles = "thenar triangles\n", kRefusal = "thenar refusal\n",
                           kEnd = "end\n";
constexpr std::size_t kCount = sizeof(std::uint64_t), kTriangle = 9 * sizeof(float);  // [bytes]
constexpr std::size_t kLongest = 500;  // of a message [bytes]

bool starts_with(std::string_view text, std::string_view beginning) {
  return text.substr(0, beginning.size()) == beginning;
}

/// What stands between the first word and the end. @return false if the end is missing
bool take_body(std::string_view& text, std::string_view word) {
  if (!starts_with(text, word) || text.size() < word.size() + kEnd.size() ||
      text.substr(text.size() - kEnd.size()) != kEnd)
    return false;
  text = text.substr(word.size(), text.size() - word.size() - kEnd.size());
  return true;
}

/// "path:line: what" keeps its line; other messages stand at line 1.
[[noreturn]] void refuse(std::string message, const std::string& path) {
  message.resize(std::min(message.size(), path.size() + kLongest));
  for (char& c : message)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  int line = 1;
  if (starts_with(message, path + ":")) {
    const char* const begin = message.data() + path.size() + 1;
    const auto [stop, error] = std::from_chars(begin, message.data() + message.size(), line);
    if (error == std::errc() && line > 0 && starts_with(stop, ": "))
      message.erase(0, static_cast<std::size_t>(stop - message.data()) + 2);
    else
      line = 1;
  }
  throw DataError(path, line, message);
}

}  // namespace

std::string answer_of(const TriangleSoup& soup) {
  const std::uint64_t count = soup.corners.size() / 3;
  std::string answer(kTriangles);
  answer.reserve(kTriangles.size() + kCount + count * kTriangle + kEnd.size());
  std::array<char, kCount> bytes;
  std::memcpy(bytes.data(), &count, kCount);
  answer.append(bytes.data(), kCount);
  for (const Eigen::Vector3d& corner : soup.corners) {
    const Eigen::Vector3f p = corner.cast<float>();
    std::array<char, 3 * sizeof(float)> place;
    std::memcpy(place.data(), p.data(), place.size());
    answer.append(place.data(), place.size());
  }
  return answer.append(kEnd);
}

std::string answer_of(const std::string& message) {
  return std::string(kRefusal).append(message).append(kEnd);
}

TriangleSoup parse_answer(const std::string& answer, const std::string& path) {
  std::string_view body = answer;
  if (take_body(body, kRefusal)) refuse(std::string(body), path);
  body = answer;
  std::uint64_t count = 0;
  const bool whole = take_body(body, kTriangles) && body.size() >= kCount;
  if (whole) std::memcpy(&count, body.data(), kCount);
  if (!whole || count > kMostTriangles || body.size() != kCount + count * kTriangle)
    throw DataError(path, 1, "the program that read this file broke off before it had all of it");
  TriangleSoup soup;
  soup.corners.reserve(3 * count);
  for (std::size_t at = kCount; at < body.size(); at += 3 * sizeof(float)) {
    Eigen::Vector3f p;
    std::memcpy(p.data(), body.data() + at, 3 * sizeof(float));
    soup.corners.emplace_back(p.cast<double>());
  }
  return soup;
}

}  // namespace thenar
