#include "data/io/mesh/reader_answer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <optional>

#include "base/error.h"
#include "data/io/mesh/transformed_primitive.h"
#include "geometry/cached_mesh.h"

namespace thenar {
namespace {

// A word; then for triangles a count and nine floats each, and for exact shapes a count and sixteen
// doubles each (kind, size, position, rotation); for a refusal its text; then the end.
constexpr std::string_view kTrianglesWord = "thenar triangles\n", kRefusalWord = "thenar refusal\n",
                           kEndWord = "end\n";
// Sizes of a count, of a triangle and of an exact shape [bytes]
constexpr std::size_t kCountBytes = sizeof(std::uint64_t), kTriangleBytes = 9 * sizeof(float),
                      kShapeBytes = 16 * sizeof(double);
constexpr std::size_t kMaxMessageBytes = 500;  // Most bytes of a message beyond its path [bytes]

bool starts_with(std::string_view text, std::string_view beginning) {
  return text.substr(0, beginning.size()) == beginning;
}

/// Reduces a text to the part between its word and the end. @returns false if the end is missing
bool take_body(std::string_view& text, std::string_view word) {
  if (!starts_with(text, word) || text.size() < word.size() + kEndWord.size() ||
      text.substr(text.size() - kEndWord.size()) != kEndWord)
    return false;
  text = text.substr(word.size(), text.size() - word.size() - kEndWord.size());
  return true;
}

/// Throws the message; "path:line: what" keeps its line, other messages are at line 1.
[[noreturn]] void refuse(std::string message, const std::string& path) {
  // Messages are not trusted: cut off, and without control characters.
  message.resize(std::min(message.size(), path.size() + kMaxMessageBytes));
  for (char& c : message)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  int line = 1;
  // A place at the beginning becomes the error's own.
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

/// Removes from the text the count of items of `bytes` each.
/// @returns false if fewer bytes follow, or the count exceeds `most`
bool take_count(std::string_view& text, std::size_t bytes, std::size_t most, std::size_t& count) {
  std::uint64_t said = 0;
  if (text.size() < kCountBytes) return false;
  std::memcpy(&said, text.data(), kCountBytes);
  text.remove_prefix(kCountBytes);
  if (said > most || said * bytes > text.size()) return false;
  count = static_cast<std::size_t>(said);
  return true;
}

void append_shape(std::string& answer, const ShapeSpec& shape) {
  const auto kind = static_cast<double>(shape.kind);
  append_bytes(answer, &kind, 1);
  append_bytes(answer, shape.size.data(), 3);
  append_bytes(answer, shape.X_BS.p.data(), 3);
  append_bytes(answer, shape.X_BS.R.data(), 9);
}

/// A sphere, box or cylinder with its pose; nothing if the bytes describe none.
std::optional<ShapeSpec> parse_shape(const char* bytes) {
  std::array<double, 16> v;
  std::memcpy(v.data(), bytes, kShapeBytes);
  ShapeSpec shape;
  for (const ShapeKind kind : {ShapeKind::kSphere, ShapeKind::kBox, ShapeKind::kCylinder})
    if (v[0] == static_cast<double>(kind)) {
      shape.kind = kind;
      shape.size = Eigen::Map<const Eigen::Vector3d>(&v[1]);
      shape.X_BS = {Eigen::Map<const Eigen::Matrix3d>(&v[7]),
                    Eigen::Map<const Eigen::Vector3d>(&v[4])};
      // A valid solid does not change under the identity.
      return place_primitive(shape, Eigen::Affine3d::Identity());
    }
  return {};
}

}  // namespace

std::string answer_of(const TriangleSoup& soup) {
  // Triangles in single precision.
  const std::uint64_t count = soup.corners.size() / 3;
  std::string answer(kTrianglesWord);
  answer.reserve(kTrianglesWord.size() + kCountBytes + count * kTriangleBytes + kCountBytes +
                 soup.exact.size() * kShapeBytes + kEndWord.size());
  append_bytes(answer, &count, 1);
  for (const Eigen::Vector3d& corner : soup.corners) {
    const Eigen::Vector3f p = corner.cast<float>();
    append_bytes(answer, p.data(), 3);
  }
  // Exact shapes in double precision.
  const std::uint64_t shapes = soup.exact.size();
  append_bytes(answer, &shapes, 1);
  for (const ShapeSpec& shape : soup.exact) append_shape(answer, shape);
  return answer.append(kEndWord);
}

std::string answer_of(const std::string& message) {
  return std::string(kRefusalWord).append(message).append(kEndWord);
}

TriangleSoup parse_answer(const std::string& answer, const std::string& path) {
  std::string_view body = answer;
  // A refusal, or triangles.
  if (take_body(body, kRefusalWord)) refuse(std::string(body), path);
  body = answer;
  const auto require_whole = [&](bool whole) {
    if (!whole)
      throw DataError(path, 1, "the program that read this file broke off before it had all of it");
  };
  // Every count and the end must fit the bytes that came.
  std::size_t count = 0, shapes = 0;
  require_whole(take_body(body, kTrianglesWord) &&
                take_count(body, kTriangleBytes, kMaxTriangles, count));
  TriangleSoup soup;
  soup.corners.reserve(3 * count);
  for (std::size_t at = 0; at < count * kTriangleBytes; at += 3 * sizeof(float)) {
    Eigen::Vector3f p;
    std::memcpy(p.data(), body.data() + at, 3 * sizeof(float));
    soup.corners.emplace_back(p.cast<double>());
  }
  // Exact shapes take exactly the rest.
  body.remove_prefix(count * kTriangleBytes);
  require_whole(take_count(body, kShapeBytes, kMaxExact, shapes) &&
                body.size() == shapes * kShapeBytes);
  for (std::size_t at = 0; at < body.size(); at += kShapeBytes) {
    const std::optional<ShapeSpec> shape = parse_shape(body.data() + at);
    require_whole(shape.has_value());
    soup.exact.push_back(*shape);
  }
  return soup;
}

}  // namespace thenar
