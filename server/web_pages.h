#pragma once

/// Answers to requests of HTTP: the page, its script, meshes, or the reason of a refusal.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "server/access.h"

namespace thenar {

/// A request, as far as answers depend on it.
struct WebQuestion {
  std::string method;                // "GET"
  std::string target;                // "/mesh/0123?token=.."
  std::string host, origin, cookie;  // headers; empty: not there
};

/// An answer. The length of the body follows from it.
struct WebAnswer {
  int status = 200;
  std::vector<std::pair<std::string, std::string>> headers;
  std::string body;
  std::shared_ptr<const std::string> mesh;  // in the place of the body; it is not copied
};

/// Gives the bytes of a mesh; null if there is none.
using MeshSource = std::function<std::shared_ptr<const std::string>(const std::string& id)>;

/// Result of http_start(), whether bytes begin with a method of HTTP and a space: not yet, yes, or
/// never.
enum class HttpStart { kOpen, kMethod, kOther };
[[nodiscard]] HttpStart http_start(std::string_view begin);

/// "/mesh/0123": a target without what follows '?'.
[[nodiscard]] std::string path_of(const WebQuestion& question);

/// Returns the refusal of a question; nothing if it may be answered.
/// @param port  that the server listens at
[[nodiscard]] std::optional<WebAnswer> refusal_of(const ServerAccess& access, int port,
                                                  const WebQuestion& question);
/// Returns the refusal of a WebSocket that is to be opened; nothing if it may be opened.
[[nodiscard]] std::optional<WebAnswer> socket_refusal_of(const ServerAccess& access, int port,
                                                         const WebQuestion& question);

/// The file or mesh that is asked for, with headers that let a page load nothing but what this
/// server sends.
[[nodiscard]] WebAnswer answer_to(const ServerAccess& access, int port, const WebQuestion& question,
                                  const MeshSource& meshes);

}  // namespace thenar
