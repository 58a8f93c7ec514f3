#pragma once

/// Access to a server: for programs of this machine, and pages that the server itself has sent.
///
/// A page of somebody else in the same browser can send requests to any port of this machine. Its
/// Origin gives it away where it opens a WebSocket; where a name of its own has been turned into
/// 127.0.0.1 (DNS rebinding), its Host does.

#include <string>

namespace thenar {

/// Address at which a server listens, and the token that it requires.
struct ServerAccess {
  std::string address = "127.0.0.1";  // numeric, IPv4 or IPv6
  int port = 0;                       // 0: any that is free
  std::string token;                  // empty: none is wanted
};

/// Returns true if only this machine can reach an address: 127.x.x.x or ::1.
[[nodiscard]] bool is_loopback(const std::string& address);

/// @throws InputError where other machines could come in without a token, or a token is shorter
///         than 16 characters or has other ones than letters, digits, '-' and '_'.
void require_safe(const ServerAccess& access);

/// A token of 128 random bits, in hexadecimal. @throws InputError if the machine gives none.
[[nodiscard]] std::string random_token();

/// Returns true if two tokens are equal, in a time that does not depend on where they differ.
[[nodiscard]] bool same_token(const std::string& a, const std::string& b);

/// "http://127.0.0.1:8080": what a browser takes.
/// @param port  that the server got
[[nodiscard]] std::string url_of(const ServerAccess& access, int port);

/// Returns true if the header Host names this server: the address it listens at, names of this
/// machine if that address is one of this machine, or, if it listens everywhere, any numeric
/// address. The port may differ, as behind port forwarding.
[[nodiscard]] bool is_host_ours(const ServerAccess& access, const std::string& host);

/// Returns true if the header Origin of a WebSocket is a page of this server. Programs that are no
/// browsers send no Origin.
[[nodiscard]] bool is_origin_ours(const std::string& origin, const std::string& host);

/// The value of `name` in "a=1&b=2" or "a=1; b=2", for tokens, whose letters nothing escapes; ""
/// where it is not there.
[[nodiscard]] std::string value_in(const std::string& list, char separator,
                                   const std::string& name);

}  // namespace thenar
