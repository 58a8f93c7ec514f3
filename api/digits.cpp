#include "api/digits.h"

#include <filesystem>
#include <map>
#include <string_view>

#include "report/table.h"
#include "api/files.h"
#include "base/error.h"
#include "base/file_io.h"

namespace thenar {
namespace internal {
const std::map<std::string, std::string_view>& nets();  // data/nets, by file name
}

std::vector<std::string> known_nets() {
  std::vector<std::string> names;
  for (const auto& [file, text] : internal::nets())
    names.push_back(std::filesystem::path(file).stem());
  return names;
}

SourceText net_source(const std::string& name_or_path) {
  if (is_file(name_or_path)) return read_source(name_or_path);
  const auto found = internal::nets().find(name_or_path + ".toml");
  require(found != internal::nets().end(),
          "there is no net '{}', nor a file of that name; nets: {}", name_or_path,
          listed(known_nets()));
  return {found->first, std::string(found->second)};
}

std::string net_meant(const std::string& hood, const std::string& net) {
  if (net.empty()) return hood == "net" ? "winslow" : "";
  require(hood.empty() || hood == "net",
          "--net {} needs a hood that is a net, got --hood {}; leave one of them out", net, hood);
  return net;
}

NetDescription find_net(const std::string& name_or_path) {
  const SourceText source = net_source(name_or_path);
  return parse_net(source.text, source.path);
}

}  // namespace thenar
