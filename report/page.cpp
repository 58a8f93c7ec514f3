#include "report/page.h"

#include <map>
#include <string_view>

#include <nlohmann/json.hpp>

#include "base/file_io.h"

namespace thenar {
namespace internal {
const std::map<std::string, std::string_view>& report_bundle();  // viewer/bundle, by file name
}

namespace {

/// Text with every `from` replaced.
std::string replaced(const std::string& text, char from, const std::string& to) {
  std::string out;
  for (const char c : text) out += c == from ? to : std::string(1, c);
  return out;
}

}  // namespace

std::string report_page(const nlohmann::json& report) {
  const std::string title =
      replaced(replaced(report.value("title", "thenar"), '&', "&amp;"), '<', "&lt;");
  // Escape "</script>" inside the data.
  const std::string data = replaced(
      report.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace), '<', "\\u003c");
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<style>{}</style></head>\n<body><main id=\"report\"></main>\n"
      "<script type=\"application/json\" id=\"thenar-report\">{}</script>\n"
      "<script>{}</script></body></html>\n",
      title, internal::report_bundle().at("report.css"), data,
      internal::report_bundle().at("report.js"));
}

void write_report(const nlohmann::json& report, const std::string& path) {
  write_file(path, report_page(report));
}

}  // namespace thenar
