#include "server/web_pages.h"

#include <map>

#include <fmt/format.h>

namespace thenar {
namespace internal {
const std::map<std::string, std::string_view>& live_bundle();
}  // namespace internal

namespace {

constexpr const char* kPlain = "text/plain; charset=utf-8";

std::string cookie_name(int port) { return fmt::format("thenar_{}", port); }

bool has_token(const ServerAccess& access, int port, const WebQuestion& question) {
  if (access.token.empty()) return true;
  const std::size_t mark = question.target.find('?');
  const std::string query = mark == std::string::npos ? "" : question.target.substr(mark + 1);
  const bool by_query = same_token(value_in(query, '&', "token"), access.token);
  const bool by_cookie =
      same_token(value_in(question.cookie, ';', cookie_name(port)), access.token);
  return by_query || by_cookie;
}

/// Headers of every answer: nothing but the server's own is loaded, framed or told to others.
WebAnswer protected_answer(int status, const std::string& type, std::string body,
                           const std::string& host) {
  return {status,
          {{"Content-Type", type},
           {"Content-Security-Policy",
            "default-src 'self'; connect-src 'self'" + (host.empty() ? "" : " ws://" + host) +
                "; img-src 'self' blob: data:; object-src 'none'; base-uri 'none'; "
                "form-action 'none'; frame-ancestors 'none'"},
           {"X-Content-Type-Options", "nosniff"},
           {"Cross-Origin-Resource-Policy", "same-origin"},
           {"Cross-Origin-Opener-Policy", "same-origin"},
           {"Referrer-Policy", "no-referrer"}},
          std::move(body),
          nullptr};
}

WebAnswer refusal(int status, const std::string& why) {
  WebAnswer answer = protected_answer(status, kPlain, "thenar: " + why + "\n", "");
  answer.headers.emplace_back("Cache-Control", "no-store");
  return answer;
}

const char* type_of(const std::string& file) {
  if (file == "live.js") return "text/javascript; charset=utf-8";
  return file == "live.css" ? "text/css; charset=utf-8" : "text/html; charset=utf-8";
}

}  // namespace

HttpStart http_start(std::string_view begin) {
  HttpStart found = HttpStart::kOther;
  for (const std::string_view method :
       {"GET ", "HEAD ", "POST ", "PUT ", "DELETE ", "CONNECT ", "OPTIONS ", "TRACE ", "PATCH "}) {
    if (begin.substr(0, method.size()) == method) return HttpStart::kMethod;
    if (method.substr(0, begin.size()) == begin) found = HttpStart::kOpen;
  }
  return found;
}

std::string path_of(const WebQuestion& question) {
  return question.target.substr(0, question.target.find('?'));
}

std::optional<WebAnswer> refusal_of(const ServerAccess& access, int port,
                                    const WebQuestion& question) {
  if (!is_host_ours(access, question.host)) return refusal(403, "this server has another name");
  if (!has_token(access, port, question))
    return refusal(401, "wanted ?token=.., as it was printed where the server was started");
  if (question.method != "GET" && question.method != "HEAD") return refusal(405, "wanted GET");
  return std::nullopt;
}

std::optional<WebAnswer> socket_refusal_of(const ServerAccess& access, int port,
                                           const WebQuestion& question) {
  // Browsers open WebSockets to anybody: it is for the server to look where they come from.
  if (!is_origin_ours(question.origin, question.host))
    return refusal(403, "this page comes from somewhere else");
  return refusal_of(access, port, question);
}

WebAnswer answer_to(const ServerAccess& access, int port, const WebQuestion& question,
                    const MeshSource& meshes) {
  if (auto refused = refusal_of(access, port, question)) return *std::move(refused);
  const std::string path = path_of(question);
  // Meshes never change: their names are hashes of them.
  if (path.rfind("/mesh/", 0) == 0) {
    const auto bytes = meshes(path.substr(6));
    if (bytes == nullptr) return refusal(404, "no such mesh is shown");
    WebAnswer answer = protected_answer(200, "application/octet-stream", "", question.host);
    answer.mesh = bytes;
    answer.headers.emplace_back("Cache-Control", "private, max-age=31536000, immutable");
    return answer;
  }
  // Pages of the viewer are built into the program; all other paths are refused.
  if (path == "/favicon.ico") return protected_answer(204, "image/x-icon", "", question.host);
  const std::string file = path == "/" ? "live.html" : path.substr(path.empty() ? 0 : 1);
  const auto& files = internal::live_bundle();
  const auto found = files.find(file);
  if (found == files.end()) return refusal(404, "there is no such page");
  WebAnswer answer =
      protected_answer(200, type_of(file), std::string(found->second), question.host);
  answer.headers.emplace_back("Cache-Control", "no-store");
  // The page's own requests show the token, too.
  if (file == "live.html" && !access.token.empty())
    answer.headers.emplace_back(
        "Set-Cookie",
        fmt::format("{}={}; Path=/; HttpOnly; SameSite=Strict", cookie_name(port), access.token));
  return answer;
}

}  // namespace thenar
