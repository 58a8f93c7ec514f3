#include "server/access.h"

#include <algorithm>
#include <array>
#include <cctype>

#include <fmt/format.h>
#include <sys/random.h>

#include "base/error.h"
#include "base/lists.h"

namespace thenar {
namespace {

constexpr std::size_t kMinTokenLength = 16;  // smallest length of a token [characters]

/// Returns an address as part of a URL: IPv6 addresses get brackets.
std::string in_url(const std::string& address) {
  return address.find(':') == std::string::npos ? address : "[" + address + "]";
}

bool is_everywhere(const std::string& address) { return address == "0.0.0.0" || address == "::"; }

/// Returns true if a name is a numeric address, which DNS does not resolve: digits and dots, or
/// text in brackets.
bool is_numeric(const std::string& name) {
  if (name.size() > 2 && name.front() == '[' && name.back() == ']') return true;
  return !name.empty() &&
         all_of(name, [](unsigned char c) { return std::isdigit(c) != 0 || c == '.'; });
}

/// Removes the port of a host: "[::1]:80" becomes "[::1]".
std::string without_port(const std::string& host) {
  const std::size_t colon = host.rfind(':');
  if (colon == std::string::npos || host.find(']', colon) != std::string::npos) return host;
  const bool digits = std::all_of(host.begin() + static_cast<std::ptrdiff_t>(colon) + 1, host.end(),
                                  [](unsigned char c) { return std::isdigit(c) != 0; });
  return digits ? host.substr(0, colon) : host;
}

}  // namespace

bool is_loopback(const std::string& address) {
  return address == "::1" || (address.rfind("127.", 0) == 0 && is_numeric(address));
}

void require_safe(const ServerAccess& access) {
  require(is_loopback(access.address) || !access.token.empty(),
          "--bind {} lets other machines in: wanted --token TEXT or --token auto as well",
          access.address);
  if (access.token.empty()) return;
  require(access.token.size() >= kMinTokenLength, "--token: wanted at least {} characters, got {}",
          kMinTokenLength, access.token.size());
  require(all_of(access.token,
                 [](unsigned char c) {
                   return (std::isalnum(c) != 0 && c < 0x80) || c == '-' || c == '_';
                 }),
          "--token: wanted letters, digits, '-' and '_' alone");
}

std::string random_token() {
  std::array<unsigned char, 16> bytes{};
  require(getrandom(bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size()),
          "the machine gives no random numbers for a token: wanted --token TEXT");
  std::string token;
  for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

bool same_token(const std::string& a, const std::string& b) {
  // Compare all characters of b, whatever a is.
  unsigned char differ = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < b.size(); ++i)
    differ |= static_cast<unsigned char>(a.empty() ? 1 : a[i % a.size()] ^ b[i]);
  return differ == 0;
}

std::string url_of(const ServerAccess& access, int port) {
  const std::string& address = access.address;
  const std::string reachable =
      address == "0.0.0.0" ? "127.0.0.1" : (address == "::" ? "::1" : address);
  return fmt::format("http://{}:{}", in_url(reachable), port);
}

bool is_host_ours(const ServerAccess& access, const std::string& host) {
  const std::string name = without_port(host);
  if (name == in_url(access.address)) return true;
  if (is_everywhere(access.address)) return is_numeric(name) || name == "localhost";
  return is_loopback(access.address) &&
         (name == "localhost" || name == "127.0.0.1" || name == "[::1]");
}

bool is_origin_ours(const std::string& origin, const std::string& host) {
  return origin.empty() || origin == "http://" + host;
}

std::string value_in(const std::string& list, char separator, const std::string& name) {
  std::size_t begin = 0;
  while (begin < list.size()) {
    std::size_t end = list.find(separator, begin);
    if (end == std::string::npos) end = list.size();
    while (begin < end && list[begin] == ' ') ++begin;
    const std::size_t equals = list.find('=', begin);
    if (equals < end && list.compare(begin, equals - begin, name) == 0)
      return list.substr(equals + 1, end - equals - 1);
    begin = end + 1;
  }
  return "";
}

}  // namespace thenar
