#include "server/session_log.h"

#include <cerrno>
#include <cstring>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file_io.h"
#include "base/provenance.h"

namespace thenar {
namespace {

constexpr std::size_t kKept = 32UL << 20U;  // of a log in memory [bytes]
constexpr std::size_t kMost = 1UL << 30U;   // of a log that is read [bytes]

std::string line_of(const LoggedRequest& request) {
  OrderedJson line{{"client", request.client},
                   {"request", {{"method", request.method}, {"params", request.params}}},
                   {"reply", request.reply}};
  if (request.stopped_at) line["stopped_at"] = *request.stopped_at;
  return json_text(line, -1) + "\n";
}

/// Throws where a line lacks something, or has something else in its place.
LoggedRequest request_of_line(const std::string& text) {
  const Json line = Json::parse(text);
  LoggedRequest request;
  request.client = line.at("client").get<int>();
  request.method = line.at("request").at("method").get<std::string>();
  request.params = line.at("request").at("params");
  request.reply = line.at("reply").get<std::string>();
  if (line.contains("stopped_at")) request.stopped_at = line["stopped_at"].get<long>();
  return request;
}

}  // namespace

std::string reply_hash(const OrderedJson& result_or_error) {
  return sha256(json_text(result_or_error, -1));
}

bool is_logged(const std::string& method) {
  return method != "session.hello" && method != "session.stop" && method != "session.log";
}

std::vector<LoggedRequest> read_log(const std::string& path) {
  std::istringstream lines(read_file(path, kMost));
  std::vector<LoggedRequest> requests;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    try {
      requests.push_back(request_of_line(line));
    } catch (const Json::exception& error) {
      throw DataError(path, number, fmt::format("no line of a session's log: {}", error.what()));
    }
  }
  return requests;
}

void SessionLog::open(const std::string& path) {
  require(!too_long_, "the log is too long to begin a file now");
  require_writable(path);
  file_.reset(std::fopen(path.c_str(), "w"));
  require(file_ != nullptr, "cannot write {}: {}", path, std::strerror(errno));
  path_ = path;
  write(text_);
}

void SessionLog::write(const std::string& lines) {
  const bool written = std::fwrite(lines.data(), 1, lines.size(), file_.get()) == lines.size() &&
                       std::fflush(file_.get()) == 0;
  require(written, "cannot write {}: {}", path_, std::strerror(errno));
}

void SessionLog::add(const LoggedRequest& request) {
  const std::string line = line_of(request);
  if (file_ != nullptr) write(line);
  // Memory is bounded: a session may play for days.
  too_long_ = too_long_ || text_.size() + line.size() > kKept;
  if (too_long_)
    text_ = std::string();
  else
    text_ += line;
}

const std::string& SessionLog::text() const {
  require(!too_long_, "the log is longer than {} MB: start with --log FILE to keep all of it",
          kKept >> 20U);
  return text_;
}

}  // namespace thenar
