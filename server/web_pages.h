#pragma once

/// Responses to HTTP requests: the page, its script, meshes, or the reason of a refusal.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "server/access.h"

namespace thenar {

/// Parts of an HTTP request that responses depend on.
struct HttpRequest {
  std::string method;                // "GET"
  std::string target;                // "/mesh/0123?token=.."
  std::string host, origin, cookie;  // headers; empty: missing
};

/// HTTP response.
struct HttpResponse {
  int status = 200;
  std::vector<std::pair<std::string, std::string>> headers;
  std::string body;
  std::shared_ptr<const std::string> mesh;  // shared content in place of the body; null: none
};

/// Function that returns the bytes of a mesh; null if the id is unknown.
using MeshSource = std::function<std::shared_ptr<const std::string>(const std::string& id)>;

/// Kind of the first bytes of a stream: prefix of an HTTP method, HTTP method, or another protocol.
enum class HttpStart { kOpen, kMethod, kOther };
/// Classifies the first bytes of a stream.
[[nodiscard]] HttpStart http_start(std::string_view begin);

/// Returns the path of a target, without the query: "/mesh/0123".
[[nodiscard]] std::string path_of(const HttpRequest& request);

/// Returns the refusal of a request; nothing if the request is allowed.
/// @param port  port at which the server listens
[[nodiscard]] std::optional<HttpResponse> refusal_of(const ServerAccess& access, int port,
                                                     const HttpRequest& request);
/// Returns the refusal of a request to open a WebSocket; nothing if it is allowed.
[[nodiscard]] std::optional<HttpResponse> socket_refusal_of(const ServerAccess& access, int port,
                                                            const HttpRequest& request);

/// Returns the requested file or mesh, or a refusal. Its headers allow a page to load content from
/// this server only.
[[nodiscard]] HttpResponse respond_to(const ServerAccess& access, int port,
                                      const HttpRequest& request, const MeshSource& meshes);

}  // namespace thenar
