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

bool has_token(const ServerAccess& access, int port, const HttpRequest& request) {
  if (access.token.empty()) return true;
  const std::size_t mark = request.target.find('?');
  const std::string query = mark == std::string::npos ? "" : request.target.substr(mark + 1);
  const bool by_query = same_token(value_in(query, '&', "token"), access.token);
  const bool by_cookie = same_token(value_in(request.cookie, ';', cookie_name(port)), access.token);
  return by_query || by_cookie;
}

/// Returns a response whose headers allow content of this server only, no frames and no referrers.
HttpResponse protected_response(int status, const std::string& type, std::string body,
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

HttpResponse refused_response(int status, const std::string& why) {
  HttpResponse answer = protected_response(status, kPlain, "thenar: " + why + "\n", "");
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

std::string path_of(const HttpRequest& request) {
  return request.target.substr(0, request.target.find('?'));
}

std::optional<HttpResponse> refusal_of(const ServerAccess& access, int port,
                                       const HttpRequest& request) {
  if (!is_host_ours(access, request.host))
    return refused_response(403, "this server has another name");
  if (!has_token(access, port, request))
    return refused_response(401,
                            "wanted ?token=.., as it was printed where the server was started");
  if (request.method != "GET" && request.method != "HEAD")
    return refused_response(405, "wanted GET");
  return std::nullopt;
}

std::optional<HttpResponse> socket_refusal_of(const ServerAccess& access, int port,
                                              const HttpRequest& request) {
  // Browsers let any page open a WebSocket, so the server must check the origin.
  if (!is_origin_ours(request.origin, request.host))
    return refused_response(403, "this page comes from somewhere else");
  return refusal_of(access, port, request);
}

HttpResponse respond_to(const ServerAccess& access, int port, const HttpRequest& request,
                        const MeshSource& meshes) {
  if (auto refused = refusal_of(access, port, request)) return *std::move(refused);
  const std::string path = path_of(request);
  // Return a mesh; browsers may cache it forever, because its id is a hash.
  if (path.rfind("/mesh/", 0) == 0) {
    const auto bytes = meshes(path.substr(6));
    if (bytes == nullptr) return refused_response(404, "no such mesh is shown");
    HttpResponse answer = protected_response(200, "application/octet-stream", "", request.host);
    answer.mesh = bytes;
    answer.headers.emplace_back("Cache-Control", "private, max-age=31536000, immutable");
    return answer;
  }
  // Find the file among those that are built into the program.
  if (path == "/favicon.ico") return protected_response(204, "image/x-icon", "", request.host);
  const std::string file = path == "/" ? "live.html" : path.substr(path.empty() ? 0 : 1);
  const auto& files = internal::live_bundle();
  const auto found = files.find(file);
  if (found == files.end()) return refused_response(404, "there is no such page");
  HttpResponse answer =
      protected_response(200, type_of(file), std::string(found->second), request.host);
  answer.headers.emplace_back("Cache-Control", "no-store");
  // Set the cookie with the token for the page's own requests.
  if (file == "live.html" && !access.token.empty())
    answer.headers.emplace_back(
        "Set-Cookie",
        fmt::format("{}={}; Path=/; HttpOnly; SameSite=Strict", cookie_name(port), access.token));
  return answer;
}

}  // namespace thenar
