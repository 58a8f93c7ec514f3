#include "report/provenance.h"

namespace thenar {

nlohmann::json provenance_json(const FileDigests& files) {
  nlohmann::json out = nlohmann::json::object();
  for (const auto& [path, digest] : files) out[path] = "sha256 " + digest;
  for (const auto& [name, version] : versions()) out[name] = version;
  return out;
}

nlohmann::json provenance_json(const std::vector<SourceText>& sources) {
  return provenance_json(source_digests(sources));
}

nlohmann::json provenance_json(const std::vector<SourceText>& sources, const Fidelity& fidelity) {
  nlohmann::json out = provenance_json(sources);
  out["fidelity"] = describe(fidelity);
  return out;
}

}  // namespace thenar
