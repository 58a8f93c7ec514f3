#pragma once

/// JSON-RPC as lines of text, for programs: over TCP, or through standard input and output.
///
/// A line is a message, of at most 1 MB; a reply is a line. There are no notifications. What begins
/// with anything but '{', '[' or white space is hung up on, so that no page of a browser, and
/// nobody else who means another server, reaches a server of lines.

#include <functional>
#include <memory>

#include "server/access.h"
#include "server/engine.h"

namespace thenar {

/// Serves programs over TCP from a thread of its own for as long as it lives.
class LineServer {
 public:
  /// @throws InputError if the address is none of this machine, or its port is taken.
  LineServer(Engine& engine, const ServerAccess& access);
  /// Sends what waits for at most 0.3 s, and closes all connections.
  ~LineServer();
  LineServer(const LineServer&) = delete;
  LineServer& operator=(const LineServer&) = delete;

  /// That it listens at.
  [[nodiscard]] int port() const;

 private:
  class Network;
  std::unique_ptr<Network> network_;
};

/// Returns true if a line is session.hello with the token of a server. Connections to a server with
/// a token begin with this line.
[[nodiscard]] bool greets_with(const std::string& line, const std::string& token);

/// The reply to a line that is too long.
[[nodiscard]] std::string too_long_reply();

/// Longest line [bytes].
inline constexpr std::size_t kLongestLine = 1UL << 20U;

}  // namespace thenar
