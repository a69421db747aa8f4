// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/openigtlink/address.h"

#include <arpa/inet.h>

#include <charconv>

#include "glisson/core/error.h"

namespace glisson::openigtlink {
namespace {

bool is_numeric(const std::string& host) {
  unsigned char binary[sizeof(in6_addr)];
  return inet_pton(AF_INET, host.c_str(), binary) == 1 || inet_pton(AF_INET6, host.c_str(), binary) == 1;
}

[[noreturn]] void refuse(std::string_view text, const char* field, const std::string& problem) {
  throw InputError(std::string(text.substr(0, 80)), field, problem,
                   "Give ADDRESS:PORT with a numeric address, as 127.0.0.1:18944");
}

int port_in(std::string_view text, std::string_view digits) {
  constexpr int kLast = 65535;
  int port = -1;
  const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), port);
  if (failure != std::errc() || end != digits.data() + digits.size() || port < 0 || port > kLast)
    refuse(text, "port", "is no number from 0 to 65535");
  return port;
}

/// Where the host ends; `text.size()` where no port follows.
std::size_t end_of_host(std::string_view text) {
  if (text.starts_with('[')) {
    const std::size_t close = text.find(']');
    return close == std::string_view::npos ? text.size() : close + 1;
  }
  const std::size_t colon = text.find(':');
  // More than one: a bare IPv6 address without a port.
  if (colon == std::string_view::npos || text.find(':', colon + 1) != std::string_view::npos)
    return text.size();
  return colon;
}

}  // namespace

std::string Address::text() const {
  const bool is_ipv6 = host.find(':') != std::string::npos;
  return (is_ipv6 ? "[" + host + "]" : host) + ":" + std::to_string(port);
}

bool Address::is_local() const { return host.starts_with("127.") || host == "::1"; }

Address parse_address(std::string_view text) {
  Address address;
  if (text.empty()) return address;
  if (text.find_first_not_of("0123456789") == std::string_view::npos) {
    address.port = port_in(text, text);
    return address;
  }
  const std::size_t end = end_of_host(text);
  std::string host(text.substr(0, end));
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  if (!host.empty() && host != "localhost") address.host = host;
  if (!is_numeric(address.host)) refuse(text, "address", "is no numeric address");
  if (end < text.size()) {
    if (text[end] != ':') refuse(text, "address", "is no numeric address");
    address.port = port_in(text, text.substr(end + 1));
  }
  return address;
}

}  // namespace glisson::openigtlink
