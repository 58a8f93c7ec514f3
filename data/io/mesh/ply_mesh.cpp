#include "data/io/mesh/polygons.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <memory>

#include "base/error.h"
#include "data/io/mesh/text_lines.h"

namespace thenar {
namespace {

enum class Type { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat, kDouble };

struct Property {
  std::string name;
  Type type = Type::kFloat;
  Type count = Type::kUint8;  // of a list
  bool is_list = false;
};

struct Element {
  std::string name;
  std::size_t count = 0;
  int line = 0;  // line of the header that announces it
  std::vector<Property> properties;
};

struct Header {
  enum class Format { kText, kLittle, kBig } format = Format::kText;
  std::vector<Element> elements;
  std::size_t size = 0;  // of the header [bytes]
  int lines = 0;         // of the header
};

std::size_t bytes_of(Type type) {
  constexpr std::array<std::size_t, 8> kBytes{1, 1, 2, 2, 4, 4, 4, 8};
  return kBytes.at(static_cast<std::size_t>(type));
}

/// Reads the header of a PLY file, line by line.
class HeaderReader {
 public:
  HeaderReader(const std::string& text, const std::string& path) : text_(text), path_(path) {}

  Header read() {
    while (next_line()) {
      // The first line names the format, the last one ends the header.
      const std::string_view kind = word();
      if (header_.lines == 1) {
        require_end(kind == "ply");
      } else if (kind == "end_header") {
        require_end(has_format_);
        return std::move(header_);
      } else if (kind == "format") {
        read_format();
      } else if (kind == "element") {
        read_element();
      } else if (kind == "property") {
        read_property();
      } else if (kind != "comment" && kind != "obj_info") {
        fail();
      }
    }
    throw DataError(path_, header_.lines, "the header of this PLY has no end");
  }

 private:
  bool next_line() {
    // The next line without white space at its end.
    if (header_.size >= text_.size()) return false;
    const std::size_t end = std::min(text_.find('\n', header_.size), text_.size());
    line_ = std::string_view(text_).substr(header_.size, end - header_.size);
    const std::size_t last = line_.find_last_not_of(" \t\r");
    line_ = line_.substr(0, last == std::string_view::npos ? 0 : last + 1);
    rest_ = line_;
    header_.size = std::min(end + 1, text_.size());
    ++header_.lines;
    return true;
  }

  std::string_view word() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t"), rest_.size()));
    const std::string_view found = rest_.substr(0, rest_.find_first_of(" \t"));
    rest_.remove_prefix(found.size());
    return found;
  }

  void require_end(bool good) {
    if (!good || !word().empty()) fail();
  }

  [[noreturn]] void fail() const {
    throw DataError(path_, std::max(header_.lines, 1),
                    fmt::format("wanted the header of a PLY, got {}", in_quotes(line_)));
  }

  void read_format() {
    static const std::map<std::string_view, Header::Format> formats{
        {"ascii", Header::Format::kText},
        {"binary_little_endian", Header::Format::kLittle},
        {"binary_big_endian", Header::Format::kBig}};
    const auto found = formats.find(word());
    // Format and version, once.
    if (found == formats.end() || has_format_ || word() != "1.0") fail();
    header_.format = found->second;
    has_format_ = true;
    require_end(true);
  }

  void read_element() {
    Element element;
    element.name = word();
    element.line = header_.lines;
    const std::string_view count = word();
    const auto [stop, error] =
        std::from_chars(count.data(), count.data() + count.size(), element.count);
    require_end(has_format_ && !count.empty() && error == std::errc() &&
                stop == count.data() + count.size());
    header_.elements.push_back(std::move(element));
  }

  [[nodiscard]] Type type(std::string_view name) const {
    static const std::map<std::string_view, Type> types{
        {"char", Type::kInt8},     {"int8", Type::kInt8},     {"uchar", Type::kUint8},
        {"uint8", Type::kUint8},   {"short", Type::kInt16},   {"int16", Type::kInt16},
        {"ushort", Type::kUint16}, {"uint16", Type::kUint16}, {"int", Type::kInt32},
        {"int32", Type::kInt32},   {"uint", Type::kUint32},   {"uint32", Type::kUint32},
        {"float", Type::kFloat},   {"float32", Type::kFloat}, {"double", Type::kDouble},
        {"float64", Type::kDouble}};
    const auto found = types.find(name);
    if (found == types.end()) fail();
    return found->second;
  }

  void read_property() {
    if (header_.elements.empty()) fail();
    Property property;
    // A scalar type, or a list with a type for its length.
    std::string_view kind = word();
    property.is_list = kind == "list";
    if (property.is_list) {
      property.count = type(word());
      kind = word();
    }
    property.type = type(kind);
    property.name = word();
    require_end(!property.name.empty());
    header_.elements.back().properties.push_back(std::move(property));
  }

  const std::string& text_;
  const std::string& path_;
  Header header_;
  bool has_format_ = false;
  std::string_view line_, rest_;
};

/// Numbers of a PLY body, from text or from bytes.
class PlyNumbers {
 public:
  virtual ~PlyNumbers() = default;
  virtual void begin_item() {}
  [[nodiscard]] virtual double next(Type type) = 0;
  [[nodiscard]] virtual int line() const { return 1; }
  [[nodiscard]] virtual std::size_t bytes_left() const = 0;
  /// Least number of bytes that one number takes.
  [[nodiscard]] virtual std::size_t min_bytes(Type type) const = 0;
};

class TextNumbers : public PlyNumbers {
 public:
  TextNumbers(std::string_view text, const std::string& path, int line)
      : lines_(text, path), path_(path), line_(line) {}
  void begin_item() override {
    if (!lines_.next())
      throw DataError(path_, line(), "the file ends before all elements are listed");
  }
  double next(Type /*type*/) override {
    const std::string_view word = lines_.word();
    double value = 0;
    if (!parse_decimal(word, value))
      throw DataError(path_, line(),
                      fmt::format("wanted a finite number, got {}", in_quotes(word)));
    return value;
  }
  [[nodiscard]] int line() const override { return line_ + lines_.line(); }
  [[nodiscard]] std::size_t bytes_left() const override { return lines_.bytes_left(); }
  [[nodiscard]] std::size_t min_bytes(Type /*type*/) const override { return 1; }

 private:
  TextLines lines_;
  const std::string& path_;
  int line_;  // of the header's end
};

class ByteNumbers : public PlyNumbers {
 public:
  ByteNumbers(std::string_view bytes, const std::string& path, bool turned)
      : bytes_(bytes), path_(path), turned_(turned) {}

  double next(Type type) override {
    switch (type) {
      case Type::kInt8:
        return take<std::int8_t>();
      case Type::kUint8:
        return take<std::uint8_t>();
      case Type::kInt16:
        return take<std::int16_t>();
      case Type::kUint16:
        return take<std::uint16_t>();
      case Type::kInt32:
        return take<std::int32_t>();
      case Type::kUint32:
        return take<std::uint32_t>();
      case Type::kFloat:
        return take<float>();
      case Type::kDouble:
        break;
    }
    return take<double>();
  }
  [[nodiscard]] std::size_t bytes_left() const override { return bytes_.size() - at_; }
  [[nodiscard]] std::size_t min_bytes(Type type) const override { return bytes_of(type); }

 private:
  template <typename T>
  T take() {
    if (bytes_left() < sizeof(T))
      throw DataError(path_, 1, "the file ends before its last element");
    std::array<char, sizeof(T)> part;
    std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(at_), sizeof(T), part.begin());
    if (turned_) std::reverse(part.begin(), part.end());
    at_ += sizeof(T);
    T value;
    std::memcpy(&value, part.data(), sizeof(T));  // little-endian, as every target of ours
    return value;
  }

  std::string_view bytes_;
  const std::string& path_;
  bool turned_;
  std::size_t at_ = 0;
};

/// Reads the elements of a PLY body: vertices, faces and strips.
class BodyReader {
 public:
  BodyReader(const Header& header, PlyNumbers& numbers, const std::string& path)
      : header_(header), numbers_(numbers), path_(path) {}

  Polygons read() {
    // Elements in the order of the header.
    for (const Element& element : header_.elements) {
      if (element.properties.empty()) continue;
      require_room(element);
      for (std::size_t i = 0; i < element.count; ++i) {
        numbers_.begin_item();
        read_item(element);
      }
    }
    return std::move(found_);
  }

 private:
  /// Compares the promised count with the bytes that are left.
  void require_room(const Element& element) const {
    std::size_t least = 0;
    for (const Property& property : element.properties)
      least += numbers_.min_bytes(property.is_list ? property.count : property.type);
    if (element.count > numbers_.bytes_left() / least)
      throw DataError(path_, element.line,
                      fmt::format("the header promises {} of '{}', more than {} bytes can hold",
                                  element.count, element.name, numbers_.bytes_left()));
  }

  void read_item(const Element& element) {
    const bool vertex = element.name == "vertex";
    const bool face = element.name == "face" || element.name == "tristrips";
    Eigen::Vector3d p(0, 0, 0);
    for (const Property& property : element.properties) {
      // Scalars: only the coordinates of vertices matter.
      if (!property.is_list) {
        const double value = numbers_.next(property.type);
        const std::size_t axis = std::string_view("xyz").find(property.name);
        if (vertex && property.name.size() == 1 && axis < 3) p[axis] = value;
        continue;
      }
      // Lists: only corners of faces and strips matter.
      const bool corners =
          face && (property.name == "vertex_indices" || property.name == "vertex_index");
      const std::vector<int> list = read_list(property, corners);
      if (corners && element.name == "face") append(list);
      if (corners && element.name == "tristrips") append_strips(list);
    }
    if (vertex) found_.vertices.push_back(p);
  }

  /// Reads a list of vertex indices. @param wanted  whether its numbers matter
  std::vector<int> read_list(const Property& property, bool wanted) {
    const double count = numbers_.next(property.count);
    if (!(count >= 0) || count != std::floor(count))
      throw DataError(path_, numbers_.line(),
                      fmt::format("wanted the length of a list, got {}", count));
    // Numbers that do not matter are read and dropped.
    std::vector<int> list;
    for (double i = 0; i < count; ++i) {
      const double value = numbers_.next(property.type);
      if (!wanted) continue;
      if (value != std::floor(value) || value < -1 || value > std::numeric_limits<int>::max())
        throw DataError(path_, numbers_.line(),
                        fmt::format("wanted the number of a vertex, got {}", value));
      list.push_back(static_cast<int>(value));
    }
    return list;
  }

  void append(const std::vector<int>& face) {
    found_.corners.insert(found_.corners.end(), face.begin(), face.end());
    found_.sizes.push_back(static_cast<int>(face.size()));
    found_.lines.push_back(numbers_.line());
  }

  /// Adds strips: three indices in a row are a triangle, every other one reversed; -1 begins anew.
  void append_strips(const std::vector<int>& strips) {
    std::size_t first = 0;
    for (std::size_t i = 0; i < strips.size(); ++i) {
      if (strips[i] < 0) first = i + 1;
      if (strips[i] < 0 || i < first + 2) continue;
      const bool odd = (i - first) % 2 == 1;
      append({strips[odd ? i - 1 : i - 2], strips[odd ? i - 2 : i - 1], strips[i]});
    }
  }

  const Header& header_;
  PlyNumbers& numbers_;
  const std::string& path_;
  Polygons found_;
};

}  // namespace

Polygons parse_ply(const std::string& text, const std::string& path) {
  const Header header = HeaderReader(text, path).read();
  // The body begins behind the header, as text or bytes.
  const std::string_view body = std::string_view(text).substr(header.size);
  std::unique_ptr<PlyNumbers> numbers;
  if (header.format == Header::Format::kText)
    numbers = std::make_unique<TextNumbers>(body, path, header.lines);
  else
    numbers = std::make_unique<ByteNumbers>(body, path, header.format == Header::Format::kBig);
  return BodyReader(header, *numbers, path).read();
}

}  // namespace thenar
