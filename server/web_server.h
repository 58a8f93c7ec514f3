#pragma once

/// HTTP server for the page of a live view and its WebSocket, on one port.
///
/// GET / is the page with /live.js and /live.css, /mesh/ID a mesh of the scene (mesh_store.h), and
/// /ws the WebSocket: JSON-RPC as text in both directions, frames (frame.h) as binary messages to
/// the client. The token is given as ?token=, or in the cookie of the page. Connections that do not
/// begin with an HTTP method are closed.

#include <memory>
#include <string>

#include "server/access.h"
#include "server/engine.h"

namespace thenar {

/// HTTP server on its own thread, for the lifetime of the object.
class WebServer {
 public:
  /// @throws InputError if the server cannot listen at the address and port
  WebServer(Engine& engine, const ServerAccess& access);
  /// Sends pending texts for at most 0.3 s, and closes all connections.
  ~WebServer();
  WebServer(const WebServer&) = delete;
  WebServer& operator=(const WebServer&) = delete;

  /// Returns the port at which the server listens.
  [[nodiscard]] int port() const;
  /// Returns the target of the page for the browser that the program opens. It is valid once, so
  /// that the command line of the browser does not reveal the token. "/" without a token.
  [[nodiscard]] std::string opening_target() const;

 private:
  class Network;
  std::unique_ptr<Network> network_;
};

}  // namespace thenar
