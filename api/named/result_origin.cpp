#include "api/named/result_origin.h"

#include <fmt/format.h>

namespace thenar {

void add_origin(const std::vector<SourceText>& sources, const RunRecord& run, ResultFile& file) {
  int k = 0;
  for (const SourceText& source : sources) {
    const std::string key = fmt::format("inputs/{}", ++k);
    file.add(key + "/path", source.path);
    file.add(key + "/text", source.text);
    file.add(key + "/sha256", sha256(source.text));
  }
  for (const auto& [name, version] : versions()) file.add("provenance/versions/" + name, version);
  for (const auto& [name, text] : texts_of(run)) file.add("provenance/" + name, text);
}

}  // namespace thenar
