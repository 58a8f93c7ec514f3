#include "apps/read_source.h"

#include "data/io/toml_node.h"

namespace thenar {

SourceText read_source(const std::string& path) { return {path, read_text_file(path)}; }

}  // namespace thenar
