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
constexpr std::string_view kTriangles = "thenar triangles\n", kRefusal = "thenar refusal\n",
                           kEnd = "end\n";
constexpr std::size_t kCount = sizeof(std::uint64_t), kTriangle = 9 * sizeof(float),
                      kShape = 16 * sizeof(double);  // [bytes]
constexpr std::size_t kLongest = 500;                // Most bytes of a message [bytes]

bool starts_with(std::string_view text, std::string_view beginning) {
  return text.substr(0, beginning.size()) == beginning;
}

/// Reduces a text to the part between its word and the end. @returns false if the end is missing
bool take_body(std::string_view& text, std::string_view word) {
  if (!starts_with(text, word) || text.size() < word.size() + kEnd.size() ||
      text.substr(text.size() - kEnd.size()) != kEnd)
    return false;
  text = text.substr(word.size(), text.size() - word.size() - kEnd.size());
  return true;
}

/// Throws the message; "path:line: what" keeps its line, other messages are at line 1.
[[noreturn]] void refuse(std::string message, const std::string& path) {
  // Messages are not trusted: cut off, and without control characters.
  message.resize(std::min(message.size(), path.size() + kLongest));
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
  if (text.size() < kCount) return false;
  std::memcpy(&said, text.data(), kCount);
  text.remove_prefix(kCount);
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
  std::memcpy(v.data(), bytes, kShape);
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
  std::string answer(kTriangles);
  answer.reserve(kTriangles.size() + kCount + count * kTriangle + kCount +
                 soup.exact.size() * kShape + kEnd.size());
  append_bytes(answer, &count, 1);
  for (const Eigen::Vector3d& corner : soup.corners) {
    const Eigen::Vector3f p = corner.cast<float>();
    append_bytes(answer, p.data(), 3);
  }
  // Exact shapes in double precision.
  const std::uint64_t shapes = soup.exact.size();
  append_bytes(answer, &shapes, 1);
  for (const ShapeSpec& shape : soup.exact) append_shape(answer, shape);
  return answer.append(kEnd);
}

std::string answer_of(const std::string& message) {
  return std::string(kRefusal).append(message).append(kEnd);
}

TriangleSoup parse_answer(const std::string& answer, const std::string& path) {
  std::string_view body = answer;
  // A refusal, or triangles.
  if (take_body(body, kRefusal)) refuse(std::string(body), path);
  body = answer;
  const auto require_whole = [&](bool whole) {
    if (!whole)
      throw DataError(path, 1, "the program that read this file broke off before it had all of it");
  };
  // Every count and the end must fit the bytes that came.
  std::size_t count = 0, shapes = 0;
  require_whole(take_body(body, kTriangles) && take_count(body, kTriangle, kMaxTriangles, count));
  TriangleSoup soup;
  soup.corners.reserve(3 * count);
  for (std::size_t at = 0; at < count * kTriangle; at += 3 * sizeof(float)) {
    Eigen::Vector3f p;
    std::memcpy(p.data(), body.data() + at, 3 * sizeof(float));
    soup.corners.emplace_back(p.cast<double>());
  }
  // Exact shapes take exactly the rest.
  body.remove_prefix(count * kTriangle);
  require_whole(take_count(body, kShape, kMaxExact, shapes) && body.size() == shapes * kShape);
  for (std::size_t at = 0; at < body.size(); at += kShape) {
    const std::optional<ShapeSpec> shape = parse_shape(body.data() + at);
    require_whole(shape.has_value());
    soup.exact.push_back(*shape);
  }
  return soup;
}

}  // namespace thenar
