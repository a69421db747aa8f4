// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace glisson::openigtlink {

/// The port that OpenIGTLink's programs expect.
inline constexpr int kUsualPort = 18944;

/// One end of a connection.
struct Address {
  std::string host = "127.0.0.1";  ///< numeric, IPv4 or IPv6; never a name: looking names up can take long
  int port = kUsualPort;           ///< 0, to listen at: one that the system chooses
  /// "127.0.0.1:18944", "[::1]:18944".
  std::string text() const;
  /// Whether only programs of this computer reach it.
  bool is_local() const;
  bool operator==(const Address&) const = default;
};

/// "192.168.1.20:18944", "[::1]:18944", "18944" (of this computer), "192.168.1.20" (the usual port),
/// "localhost:18944", "" (this computer, the usual port).
/// @throws InputError a name other than localhost, no number, a port outside 0 to 65535.
Address parse_address(std::string_view text);

}  // namespace glisson::openigtlink
