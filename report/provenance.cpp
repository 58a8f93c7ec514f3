#include "report/provenance.h"

#include "base/provenance.h"

namespace thenar {

nlohmann::json provenance_json(const std::vector<SourceText>& sources, const Fidelity& fidelity) {
  nlohmann::json out = nlohmann::json::object();
  for (const SourceText& source : sources) out[source.path] = "sha256 " + sha256(source.text);
  for (const auto& [name, version] : versions()) out[name] = version;
  out["fidelity"] = describe(fidelity);
  return out;
}

}  // namespace thenar
