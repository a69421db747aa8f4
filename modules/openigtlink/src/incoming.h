// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "glisson/geometry/rigid.h"
#include "glisson/openigtlink/receiver.h"
#include "glisson/patient/picture.h"

/// @file
/// What a stranger has sent. The library's own unpacking trusts the sizes that messages say of themselves;
/// here nothing is stored or read that its bytes do not hold.

namespace glisson::openigtlink {

/// A message's header.
struct Head {
  int version = 0;
  std::string type, device;
  double seconds = 0.0;    ///< since 1970; 0: not said
  std::uint64_t size = 0;  ///< of the body, bytes
  std::uint64_t crc = 0;
};
inline constexpr std::size_t kHeadSize = 58;
/// @param bytes kHeadSize of them. Empty: no header, or of a body larger than any that is sent.
std::optional<Head> read_head(std::string_view bytes);

/// Of a body that fits its check sum, the content: in later versions of the protocol other things stand
/// before and behind it. Empty: damaged.
std::optional<std::string_view> content_of(const Head& head, std::string_view body);

/// The picture of an IMAGE: whole, one slice, bytes, one or three components. Empty: none such.
std::optional<Picture> picture_in(std::string_view content);
/// The motion of a TRANSFORM, metres. Empty: not finite, no rotation, or farther away than 10 m.
std::optional<Rigid<CameraFrame, ToolFrame>> pose_in(std::string_view content);

/// Takes a stream apart, in pieces of any size.
class Messages {
 public:
  /// @param wants whether a message's body is kept; others are passed over unread.
  /// @param take gets each that was wanted, and its content.
  Messages(std::function<bool(const Head&)> wants, std::function<void(const Head&, std::string_view)> take)
      : wants_(std::move(wants)), take_(std::move(take)) {}

  /// @return false: what comes is no message; nothing more can be understood.
  bool feed(std::string_view bytes);
  int damaged() const { return damaged_; }

 private:
  void end_message();

  std::function<bool(const Head&)> wants_;
  std::function<void(const Head&, std::string_view)> take_;
  std::string head_bytes_, body_;
  std::optional<Head> head_;
  bool is_wanted_ = false;
  std::uint64_t left_ = 0;  ///< of the body
  int damaged_ = 0;
};

}  // namespace glisson::openigtlink
