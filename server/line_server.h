#pragma once

/// JSON-RPC as lines of text over TCP, for programs.
///
/// A message is a line of at most 1 MB; a reply is a line. There are no notifications. A connection
/// whose first character is not '{', '[' or white space is closed, so that pages of a browser and
/// clients of other protocols are refused.

#include <memory>

#include "server/access.h"
#include "server/engine.h"

namespace thenar {

/// TCP server on its own thread, for the lifetime of the object.
class LineServer {
 public:
  /// @throws InputError if the server cannot listen at the address and port
  LineServer(Engine& engine, const ServerAccess& access);
  /// Sends pending replies for at most 0.3 s, and closes all connections.
  ~LineServer();
  LineServer(const LineServer&) = delete;
  LineServer& operator=(const LineServer&) = delete;

  /// Returns the port at which the server listens.
  [[nodiscard]] int port() const;

 private:
  class Network;
  std::unique_ptr<Network> network_;
};

/// Returns true if a line is session.hello with the server's token, the required first line of a
/// connection to a server with a token.
[[nodiscard]] bool is_hello_with_token(const std::string& line, const std::string& token);

/// Returns the reply to a line that is too long.
[[nodiscard]] std::string too_long_reply();

/// Largest length of a line [bytes].
inline constexpr std::size_t kMaxLineBytes = 1UL << 20U;

}  // namespace thenar
