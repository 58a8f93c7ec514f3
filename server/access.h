#pragma once

/// Access control of a server: only programs of this machine and pages of the server itself.
///
/// A foreign page in the same browser can send requests to any port of this machine. The header
/// Origin reveals it when it opens a WebSocket, and the header Host when its own name resolves to
/// 127.0.0.1 (DNS rebinding).

#include <string>

namespace thenar {

/// Address at which a server listens, and the token that it requires.
struct ServerAccess {
  std::string address = "127.0.0.1";  // numeric address, IPv4 or IPv6
  int port = 0;                       // port; 0: any free port
  std::string token;                  // required token; empty: none
};

/// Returns true if only this machine can reach an address: 127.x.x.x or ::1.
[[nodiscard]] bool is_loopback(const std::string& address);

/// Checks that a server is protected from other machines.
/// @throws InputError if other machines could connect without a token, or if the token is shorter
///         than 16 characters or has characters other than letters, digits, '-' and '_'
void require_safe(const ServerAccess& access);

/// Creates a token of 128 random bits, in hexadecimal.
/// @throws InputError if the system has no random numbers
[[nodiscard]] std::string random_token();

/// Returns true if two tokens are equal; the time does not depend on where they differ.
[[nodiscard]] bool same_token(const std::string& a, const std::string& b);

/// Returns the URL of a server for browsers: "http://127.0.0.1:8080".
/// @param port  port at which the server listens
[[nodiscard]] std::string url_of(const ServerAccess& access, int port);

/// Returns true if the header Host names this server: its address, a name of this machine for a
/// loopback address, or any numeric address if it listens on all interfaces. The port may differ,
/// as with port forwarding.
[[nodiscard]] bool is_host_ours(const ServerAccess& access, const std::string& host);

/// Returns true if the header Origin of a WebSocket is a page of this server, or is missing, as for
/// programs other than browsers.
[[nodiscard]] bool is_origin_ours(const std::string& origin, const std::string& host);

/// Finds the value of a name in "a=1&b=2" or "a=1; b=2", without decoding; "" if it is missing.
[[nodiscard]] std::string value_in(const std::string& list, char separator,
                                   const std::string& name);

}  // namespace thenar
