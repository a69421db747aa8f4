// SPDX-License-Identifier: GPL-3.0-or-later
#include "socket.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>

#include "glisson/core/error.h"

namespace glisson::openigtlink {
namespace {

/// An address as the system has it.
struct Place {
  sockaddr_storage storage = {};
  socklen_t size = 0;
  const sockaddr* address() const { return reinterpret_cast<const sockaddr*>(&storage); }
};

Place place_of(const Address& address) {
  Place place;
  const auto port = htons(static_cast<std::uint16_t>(address.port));
  sockaddr_in four = {};
  if (inet_pton(AF_INET, address.host.c_str(), &four.sin_addr) == 1) {
    four.sin_family = AF_INET;
    four.sin_port = port;
    std::memcpy(&place.storage, &four, sizeof four);
    place.size = sizeof four;
    return place;
  }
  sockaddr_in6 six = {};
  require(inet_pton(AF_INET6, address.host.c_str(), &six.sin6_addr) == 1, "an address is numeric");
  six.sin6_family = AF_INET6;
  six.sin6_port = port;
  std::memcpy(&place.storage, &six, sizeof six);
  place.size = sizeof six;
  return place;
}

void set_option(int socket, int level, int option, int value) {
  ::setsockopt(socket, level, option, &value, sizeof value);
}

Descriptor new_socket(const Place& place) {
  Descriptor made(::socket(place.storage.ss_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (!made.is_open())
    throw FileError(std::string("network: no socket can be made (") + std::strerror(errno) +
                    "). Close other programs.");
  return made;
}

/// What is on its way to a peer that reads slowly is old: little may be.
void make_prompt(const Descriptor& socket) {
  constexpr int kOnItsWay = 512 * 1024;
  set_option(socket.number(), IPPROTO_TCP, TCP_NODELAY, 1);
  set_option(socket.number(), SOL_SOCKET, SO_SNDBUF, kOnItsWay);
}

Passed passed(ssize_t count) {
  if (count > 0) return {static_cast<std::size_t>(count), false};
  const bool later = count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR);
  return {0, !later};
}

}  // namespace

Descriptor::~Descriptor() {
  if (is_open()) ::close(number_);
}

Bell::Bell() : descriptor_(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
  if (!descriptor_.is_open()) throw FileError("network: no event can be made. Close other programs.");
}

void Bell::ring() const {
  const std::uint64_t one = 1;
  // It fails only where it rings already.
  [[maybe_unused]] const ssize_t written = ::write(number(), &one, sizeof one);
}

void Bell::quiet() const {
  std::uint64_t count = 0;
  [[maybe_unused]] const ssize_t taken = ::read(number(), &count, sizeof count);
}

Descriptor listen_at(const Address& address) {
  constexpr int kWaiting = 8;
  const Place place = place_of(address);
  Descriptor listener = new_socket(place);
  set_option(listener.number(), SOL_SOCKET, SO_REUSEADDR, 1);
  if (::bind(listener.number(), place.address(), place.size) != 0 ||
      ::listen(listener.number(), kWaiting) != 0) {
    const bool taken = errno == EADDRINUSE;
    throw InputError(address.text(), "",
                     taken ? std::string("is used by another program")
                           : std::string("cannot be listened at (") + std::strerror(errno) + ")",
                     taken ? "Close that program, or give another port"
                           : "Give an address of this computer, and a port above 1023");
  }
  return listener;
}

int port_of(const Descriptor& listener) {
  sockaddr_storage storage = {};
  socklen_t size = sizeof storage;
  if (::getsockname(listener.number(), reinterpret_cast<sockaddr*>(&storage), &size) != 0) return 0;
  if (storage.ss_family == AF_INET) return ntohs(reinterpret_cast<const sockaddr_in*>(&storage)->sin_port);
  return ntohs(reinterpret_cast<const sockaddr_in6*>(&storage)->sin6_port);
}

Descriptor accept_peer(const Descriptor& listener) {
  Descriptor peer(::accept4(listener.number(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
  if (peer.is_open()) make_prompt(peer);
  return peer;
}

Descriptor begin_to_connect(const Address& address) {
  const Place place = place_of(address);
  Descriptor socket = new_socket(place);
  // What it comes to is told by has_connected().
  [[maybe_unused]] const int begun = ::connect(socket.number(), place.address(), place.size);
  return socket;
}

bool has_connected(const Descriptor& socket) {
  sockaddr_storage peer = {};
  socklen_t size = sizeof peer;
  return ::getpeername(socket.number(), reinterpret_cast<sockaddr*>(&peer), &size) == 0;
}

Passed send_some(const Descriptor& socket, const char* bytes, std::size_t count) {
  return passed(::send(socket.number(), bytes, count, MSG_NOSIGNAL | MSG_DONTWAIT));
}

Passed receive_some(const Descriptor& socket, char* bytes, std::size_t count) {
  return passed(::recv(socket.number(), bytes, count, MSG_DONTWAIT));
}

}  // namespace glisson::openigtlink
