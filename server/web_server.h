#pragma once

/// The page of a live view and the WebSocket behind it, on one port.
///
/// GET / is the page, /live.js and /live.css belong to it, /mesh/ID is a mesh of the scene
/// (mesh_store.h), /ws the WebSocket: JSON-RPC as text in both directions, frames (frame.h) as
/// binary messages to the client. A token comes as ?token=, or as the cookie that the page was sent
/// with. What does not begin with a method of HTTP is hung up on.

#include <memory>
#include <string>

#include "server/access.h"
#include "server/engine.h"

namespace thenar {

/// Serves pages from a thread of its own for as long as it lives.
class WebServer {
 public:
  /// @throws InputError if the address is none of this machine, or its port is taken.
  WebServer(Engine& engine, const ServerAccess& access);
  /// Sends what waits for at most 0.3 s, and closes all connections.
  ~WebServer();
  WebServer(const WebServer&) = delete;
  WebServer& operator=(const WebServer&) = delete;

  /// That it listens at.
  [[nodiscard]] int port() const;
  /// The target of the page for the browser that is opened here: it counts once, so that the list
  /// of processes tells nobody the token. "/" where none is wanted.
  [[nodiscard]] std::string opening() const;

 private:
  class Network;
  std::unique_ptr<Network> network_;
};

}  // namespace thenar
