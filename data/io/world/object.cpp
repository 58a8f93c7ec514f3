#include "base/error.h"
#include "data/io/world/body_toml.h"

namespace thenar {

BodySpec parse_object(const std::string& text, const std::string& path) {
  const TomlFile file(text, path);
  TomlTable top = file.top();
  BodySpec body = internal::read_body_keys(top, path);
  top.done();
  return body;
}

BodySpec read_object(const std::string& path) { return parse_object(read_text_file(path), path); }

std::string object_toml(const BodySpec& body) {
  BodySpec sourced = body;
  if (sourced.source.empty()) sourced.source = "Unstated";
  const std::string lines = internal::body_lines(sourced, "");
  const std::size_t shapes = lines.find("\n[[shape]]");
  return internal::text_line("name", body.name) + lines.substr(0, shapes) +
         internal::sources_table({sourced.source}, {}) + lines.substr(shapes);
}

}  // namespace thenar
