// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "glisson/core/run_context.h"
#include "glisson/geometry/rigid.h"
#include "glisson/openigtlink/address.h"
#include "glisson/patient/picture.h"

namespace glisson::openigtlink {

/// A tool as its tracker has it: the tip is its origin, metres.
struct ToolFrame {
  static constexpr const char* kName = "tool";
};

/// A server, and what of it is taken. A name that is empty is not taken.
struct ReceiverOptions {
  Address address;
  std::string left, right;     ///< devices whose IMAGE messages are the two views
  std::string tool;            ///< device whose TRANSFORM is the tool in the left camera's frame
  double largest_skew = 0.02;  ///< seconds between the views of a pair; half their period where that is less
  double patience = 5.0;       ///< seconds for the server to answer, and from one pair to the next
  /// @throws InputError naming the field.
  void validate() const;
};

/// "HOST:PORT/LEFT,RIGHT" and "HOST:PORT/TOOL". The host is as in parse_address().
/// @throws InputError no slash, a name that is empty or longer than 20 letters.
ReceiverOptions parse_pictures(std::string_view text);
ReceiverOptions parse_tool(std::string_view text);

/// Both views of a moment.
struct ReceivedPair {
  Picture left, right;   ///< grey or blue, green, red; rows from the top
  double seconds = 0.0;  ///< by the server's clock; ascends
};
/// A tool's pose as the server sent it last.
struct ReceivedTool {
  Rigid<CameraFrame, ToolFrame> camera_from_tool;  ///< left camera's frame, metres
  double seconds = 0.0;                            ///< by the server's clock
  double age = 0.0;                                ///< seconds since it came
};

/// How a client stands with its server.
enum class Connection {
  waiting,    ///< the server has not answered yet
  connected,  ///< it has
  ended,      ///< it has closed
  failed      ///< see problem()
};

/// A client of OpenIGTLink: takes pictures and a tool's pose from PLUS or another server, on a thread of its
/// own, the newest always. Whatever comes is held against its own sizes before it is stored, and against its
/// check sum; what does not hold is passed over, and what is no message ends the connection. Any thread.
class Receiver {
 public:
  /// Connects; returns at once. @throws InputError options.
  explicit Receiver(const ReceiverOptions& options);
  /// Closes at once.
  ~Receiver();
  Receiver(const Receiver&) = delete;
  Receiver& operator=(const Receiver&) = delete;

  /// A pair that is newer than the last; waits for it. Empty: cancelled (within 50 ms), or the server has
  /// closed. @throws InputError the server does not answer, sends no such pictures in time, or no messages.
  std::optional<ReceivedPair> next_pair(const RunContext& context);
  /// The last pose; empty: none has come.
  std::optional<ReceivedTool> tool() const;

  /// Now; `ended` and `failed` are for good.
  Connection connection() const;
  /// A sentence with its remedy; empty: none.
  std::string problem() const;
  /// Messages that did not hold, so far, and pairs that a newer one has replaced.
  int passed_over() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson::openigtlink
