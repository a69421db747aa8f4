// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include "glisson/openigtlink/address.h"

/// @file
/// Sockets that never wait. The library's own server listens at every address of the computer and its own
/// sends and receives wait, so that its messages are used here and its sockets are not.

namespace glisson::openigtlink {

/// A file descriptor that is closed with this object.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor();
  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }

 private:
  int number_ = -1;
};

/// Wakes a thread that polls.
class Bell {
 public:
  Bell();
  void ring() const;
  void quiet() const;
  int number() const { return descriptor_.number(); }

 private:
  Descriptor descriptor_;
};

/// Waits for peers. @throws InputError another program is there, no such address of this computer.
Descriptor listen_at(const Address& address);
/// Where it listens.
int port_of(const Descriptor& listener);
/// The next peer that waits; not open: there is none.
Descriptor accept_peer(const Descriptor& listener);

/// On its way to a server; has_connected() once it can be written to.
Descriptor begin_to_connect(const Address& address);
bool has_connected(const Descriptor& socket);

/// How much went through. `gone`: the other end has closed, or the connection broke.
struct Passed {
  std::size_t bytes = 0;
  bool gone = false;
};
/// As much as goes without waiting.
Passed send_some(const Descriptor& socket, const char* bytes, std::size_t count);
Passed receive_some(const Descriptor& socket, char* bytes, std::size_t count);

}  // namespace glisson::openigtlink
