#include "server/session_log.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file_io.h"
#include "base/outside_path.h"
#include "base/provenance.h"

namespace thenar {
namespace {

constexpr std::size_t kMaxTextBytes = 32UL << 20U;  // largest log in a reply [bytes]

std::string line_of(const LoggedRequest& request) {
  OrderedJson line{{"client", request.client},
                   {"request", {{"method", request.method}, {"params", request.params}}},
                   {"reply", request.reply}};
  if (request.stopped_at) line["stopped_at"] = *request.stopped_at;
  return json_text(line, -1) + "\n";
}

/// Parses a line. @throws Json::exception for an invalid line
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
  const std::array kAsk{"session.hello", "session.stop", "session.status", "session.log",
                        "job.state",     "job.list",     "job.stop",       "job.result"};
  return std::find(kAsk.begin(), kAsk.end(), method) == kAsk.end();
}

std::vector<LoggedRequest> read_log(const std::string& path) {
  std::istringstream lines(read_file(outside_path(path, OutsideUse::kRead), kMaxLogBytes));
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
  const std::string before = read_all();
  // Refuse a dangling link, whose target is unknown.
  std::error_code none;
  const bool dangles = std::filesystem::is_symlink(outside_path(path, OutsideUse::kRead), none) &&
                       !std::filesystem::exists(path, none);
  require(!dangles, "cannot write {}: it is a link to a file that is not there", path);
  // Create the file, and copy the previous lines.
  require_writable(path);
  std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "w+"));
  require(file != nullptr, "cannot write {}: {}", path, std::strerror(errno));
  require(write(*file, before) && std::fflush(file.get()) == 0, "cannot write {}: {}", path,
          std::strerror(errno));
  path_ = path;
  file_ = std::move(file);
}

bool SessionLog::write(std::FILE& file, const std::string& lines) {
  return std::fwrite(lines.data(), 1, lines.size(), &file) == lines.size();
}

void SessionLog::add(const LoggedRequest& request) {
  if (is_incomplete_) return;
  const std::string line = line_of(request);
  if (!path_.empty()) {
    // Refuse a line that does not fit, so that the log can be replayed up to here.
    is_incomplete_ = bytes_ + line.size() > max_bytes_;
    require(!is_incomplete_,
            "the log {} is full ({} bytes): this request and those after it are not in it", path_,
            bytes_);
    // Flush each line, so that the file can be read at any time.
    is_incomplete_ = !write(*file_, line) || std::fflush(file_.get()) != 0;
    require(!is_incomplete_, "cannot write {}: {}; nothing more is logged", path_,
            std::strerror(errno));
  } else {
    // Discard a temporary log that is too long or cannot be written; this is no error.
    if (file_ == nullptr) file_.reset(std::tmpfile());
    is_incomplete_ =
        file_ == nullptr || bytes_ + line.size() > kMaxTextBytes || !write(*file_, line);
    if (is_incomplete_) file_ = nullptr;
  }
  bytes_ += line.size();
}

std::string SessionLog::read_all() const {
  require(!is_incomplete_ || !path_.empty(),
          "the log became longer than {} MB, or there was no room for it: start with --log FILE to "
          "have it",
          kMaxTextBytes >> 20U);
  if (file_ == nullptr) return "";
  std::string text(bytes_, '\0');
  std::rewind(file_.get());
  const bool read = std::fread(text.data(), 1, bytes_, file_.get()) == bytes_;
  const bool back = std::fseek(file_.get(), 0, SEEK_END) == 0;
  require(read && back, "cannot read the log: {}", std::strerror(errno));
  return text;
}

std::string SessionLog::text() const {
  require(path_.empty() || bytes_ <= kMaxTextBytes, "the log is longer than {} MB: it is in {}",
          kMaxTextBytes >> 20U, path_);
  return read_all();
}

}  // namespace thenar
