// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/openigtlink/receiver.h"

#include <poll.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <deque>
#include <iterator>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "clock.h"
#include "glisson/core/error.h"
#include "glisson/core/statistics.h"
#include "incoming.h"
#include "messages.h"
#include "socket.h"

namespace glisson::openigtlink {
namespace {

/// One view as it came.
struct View {
  Picture picture;
  double seconds = 0.0;
};

/// Those of one side that are in no pair yet; their times ascend. One view may come some frames behind the
/// other.
class Waiting {
 public:
  /// @return false: it is not newer than the last.
  bool add(View view) {
    if (!views_.empty() && view.seconds <= views_.back().seconds) return false;
    if (seen_ && view.seconds > *seen_) steps_.push_back(view.seconds - *seen_);
    if (steps_.size() > kSteps) steps_.erase(steps_.begin());
    seen_ = view.seconds;
    if (views_.size() == kMost) views_.pop_front();
    views_.push_back(std::move(view));
    return true;
  }
  /// The nearest in time, which goes, and with it those before. Empty: none is within `skew` seconds.
  std::optional<View> take(double seconds, double skew) {
    const auto away = [seconds](const View& view) { return std::abs(view.seconds - seconds); };
    const auto nearest = std::min_element(views_.begin(), views_.end(),
                                          [&](const View& a, const View& b) { return away(a) < away(b); });
    if (nearest == views_.end() || away(*nearest) > skew) return {};
    View taken = std::move(*nearest);
    views_.erase(views_.begin(), std::next(nearest));
    return taken;
  }
  void clear() { views_.clear(); }
  /// Seconds from one view to the next, whatever single ones were dropped; empty: not known yet.
  std::optional<double> period() const {
    if (steps_.empty()) return {};
    return at_rank(steps_, (steps_.size() - 1) / 2);
  }

 private:
  static constexpr std::size_t kMost = 4;  ///< a picture may have 100 MB
  static constexpr std::size_t kSteps = 9;
  std::deque<View> views_;
  std::optional<double> seen_;  ///< when the last one was taken
  std::vector<double> steps_;   ///< between the last ones, seconds
};

void require_names(std::string_view text, std::initializer_list<std::string> names, const char* form) {
  for (const std::string& name : names)
    if (name.empty() || name.size() > kLongestName || name.find_first_of(",/") != std::string::npos)
      throw InputError(std::string(text.substr(0, 80)), "name", "is empty or longer than 20 letters", form);
}

}  // namespace

void ReceiverOptions::validate() const {
  const OptionCheck demand("receiver options");
  demand(address.port > 0, "port", address.port, "Give the server's port, as 18944");
  demand(largest_skew > 0.0 && largest_skew <= 1.0, "largest_skew", largest_skew, "Give up to a second");
  demand(patience > 0.0 && patience <= 60.0, "patience", patience, "Give up to 60 seconds");
}

ReceiverOptions parse_pictures(std::string_view text) {
  constexpr const char* kForm = "Give HOST:PORT/LEFT,RIGHT with the names of the two devices";
  const std::size_t slash = text.find('/'), comma = text.find(',', slash == text.npos ? 0 : slash);
  ReceiverOptions options;
  if (slash != text.npos && comma != text.npos) {
    options.left = text.substr(slash + 1, comma - slash - 1);
    options.right = text.substr(comma + 1);
  }
  require_names(text, {options.left, options.right}, kForm);
  if (options.left == options.right)
    throw InputError(std::string(text.substr(0, 80)), "name", "is the same for both views", kForm);
  options.address = parse_address(text.substr(0, slash));
  return options;
}

ReceiverOptions parse_tool(std::string_view text) {
  const std::size_t slash = text.find('/');
  ReceiverOptions options;
  if (slash != text.npos) options.tool = text.substr(slash + 1);
  require_names(text, {options.tool}, "Give HOST:PORT/NAME with the name of the tool's transform");
  options.address = parse_address(text.substr(0, slash));
  return options;
}

struct Receiver::Impl {
  explicit Impl(const ReceiverOptions& given)
      : options(given),
        allowed(given.largest_skew),
        messages([this](const Head& head) { return wants(head); },
                 [this](const Head& head, std::string_view content) { take(head, content); }) {}

  ReceiverOptions options;
  Bell bell;

  mutable std::mutex mutex;  // guards what follows, up to the thread's own
  std::condition_variable changed;
  Connection connection = Connection::waiting;
  std::optional<InputError> problem;
  std::optional<ReceivedPair> pair;  // newest wins
  std::optional<ReceivedTool> tool;
  Clock::time_point tool_came = {}, heard = Clock::now();
  int passed_over = 0, damaged = 0;
  bool has_views = false;  // a picture of either view has come
  double allowed;          // seconds between the views of a pair

  // Of the thread only.
  Messages messages;
  Waiting left, right;
  double last = 0.0;  // seconds of the last pair
  std::jthread thread;

  void serve(const std::stop_token& stop) {
    try {
      const Descriptor socket = connect(stop);
      if (!socket.is_open()) return;
      set(Connection::connected);
      listen(socket, stop);
    } catch (const InputError& failure) {
      fail(failure);
    } catch (const std::exception&) {
      fail(InputError(options.address.text(), "", "cannot be read", "Connect again"));
    }
  }

  void set(Connection to) {
    {
      const std::scoped_lock lock(mutex);
      connection = to;
      heard = Clock::now();
    }
    changed.notify_all();
  }

  void fail(const InputError& why) {
    {
      const std::scoped_lock lock(mutex);
      connection = Connection::failed;
      problem = why;
    }
    changed.notify_all();
  }

  InputError no_answer() const {
    return {options.address.text(), "", "no server of OpenIGTLink answers",
            "Start it, and check its address and port"};
  }

  /// Not open: it is to stop.
  Descriptor connect(const std::stop_token& stop) {
    constexpr int kTick = 100;  // milliseconds
    Descriptor socket = begin_to_connect(options.address);
    for (const Clock::time_point begin = Clock::now(); !stop.stop_requested();) {
      pollfd watched[] = {{bell.number(), POLLIN, 0}, {socket.number(), POLLOUT, 0}};
      ::poll(watched, 2, kTick);
      if (watched[1].revents != 0) {
        if (!has_connected(socket)) throw no_answer();
        return socket;
      }
      if (seconds_since(begin) > options.patience) throw no_answer();
    }
    return {};
  }

  void listen(const Descriptor& socket, const std::stop_token& stop) {
    constexpr int kTick = 100;  // milliseconds
    std::vector<char> buffer(256 * 1024);
    while (!stop.stop_requested()) {
      pollfd watched[] = {{bell.number(), POLLIN, 0}, {socket.number(), POLLIN, 0}};
      ::poll(watched, 2, kTick);
      const Passed passed = receive_some(socket, buffer.data(), buffer.size());
      if (passed.gone) return set(Connection::ended);
      if (passed.bytes > 0 && !messages.feed({buffer.data(), passed.bytes}))
        throw InputError(options.address.text(), "", "sends what is no message of OpenIGTLink",
                         "Check that this is the port of PLUS, or of another server of OpenIGTLink");
      const std::scoped_lock lock(mutex);
      damaged = messages.damaged();
    }
  }

  bool wants(const Head& head) const {
    if (head.type == "IMAGE")
      return !options.left.empty() && (head.device == options.left || head.device == options.right);
    return head.type == "TRANSFORM" && !options.tool.empty() && head.device == options.tool;
  }

  void take(const Head& head, std::string_view content) {
    if (head.type == "TRANSFORM") return take_tool(head, content);
    std::optional<Picture> picture = picture_in(content);
    // Names alone tell the views apart: one device for both would pair with itself.
    const bool is_left = head.device == options.left;
    const double seconds = head.seconds > 0.0 ? head.seconds : now();
    if (!picture || !(is_left ? left : right).add({*picture, seconds})) return pass_over();
    const std::optional<double> skew = skew_now();
    {
      const std::scoped_lock lock(mutex);
      has_views = true;
      allowed = skew.value_or(allowed);
    }
    if (!skew) return;
    const auto other = (is_left ? right : left).take(seconds, *skew);
    if (!other) return;
    (is_left ? left : right).clear();  // it was the newest of its side
    View view{std::move(*picture), seconds};
    is_left ? make_pair(view, *other) : make_pair(*other, view);
  }

  /// A view within half a period of another is of its moment; one farther away may be a neighbour's. Empty:
  /// the period is not known before the second view of a side.
  std::optional<double> skew_now() const {
    std::optional<double> period = left.period();
    if (const auto other = right.period(); other && (!period || *other < *period)) period = other;
    if (!period) return {};
    return std::min(options.largest_skew, 0.5 * *period);
  }

  void take_tool(const Head& head, std::string_view content) {
    const auto pose = pose_in(content);
    if (!pose) return pass_over();
    const std::scoped_lock lock(mutex);
    tool = ReceivedTool{*pose, head.seconds, 0.0};
    tool_came = Clock::now();
  }

  static double now() { return std::chrono::duration<double>(Clock::now().time_since_epoch()).count(); }

  void pass_over() {
    const std::scoped_lock lock(mutex);
    ++passed_over;
  }

  void make_pair(const View& of_left, const View& of_right) {
    const Picture &a = of_left.picture, &b = of_right.picture;
    const bool is_one_size = a.width == b.width && a.height == b.height;
    if (!is_one_size || of_left.seconds <= last) return pass_over();
    last = of_left.seconds;
    {
      const std::scoped_lock lock(mutex);
      passed_over += pair.has_value();
      pair = ReceivedPair{a, b, of_left.seconds};
      heard = Clock::now();
    }
    changed.notify_all();
  }

  /// Why no pair has come for too long.
  InputError silence() const {
    const std::string names = options.left + " and " + options.right;
    if (connection == Connection::waiting) return no_answer();
    if (has_views)
      return {options.address.text(), names,
              "send no pairs within " + std::to_string(std::lround(1e3 * allowed)) + " ms of each other",
              "Record both views at once, from one trigger"};
    return {options.address.text(), names, "send no pictures of 8 bits that can be used",
            "Check the names of the two devices, and that they are on"};
  }
};

Receiver::Receiver(const ReceiverOptions& options) {
  options.validate();
  impl_ = std::make_unique<Impl>(options);
  impl_->thread = std::jthread([impl = impl_.get()](const std::stop_token& stop) { impl->serve(stop); });
}

Receiver::~Receiver() {
  impl_->thread.request_stop();
  impl_->bell.ring();
}

std::optional<ReceivedPair> Receiver::next_pair(const RunContext& context) {
  constexpr auto kLook = std::chrono::milliseconds(50);
  std::unique_lock lock(impl_->mutex);
  const Clock::time_point begin = Clock::now();
  while (!impl_->pair || context.cancelled()) {
    if (context.cancelled() || impl_->connection == Connection::ended) return {};
    if (impl_->problem) throw InputError(*impl_->problem);
    if (seconds_since(std::max(begin, impl_->heard)) > impl_->options.patience) throw impl_->silence();
    impl_->changed.wait_for(lock, kLook);
  }
  return std::exchange(impl_->pair, std::nullopt);
}

std::optional<ReceivedTool> Receiver::tool() const {
  const std::scoped_lock lock(impl_->mutex);
  std::optional<ReceivedTool> found = impl_->tool;
  if (found) found->age = seconds_since(impl_->tool_came);
  return found;
}

Connection Receiver::connection() const {
  const std::scoped_lock lock(impl_->mutex);
  return impl_->connection;
}

std::string Receiver::problem() const {
  const std::scoped_lock lock(impl_->mutex);
  return impl_->problem ? impl_->problem->what() : "";
}

int Receiver::passed_over() const {
  const std::scoped_lock lock(impl_->mutex);
  return impl_->passed_over + impl_->damaged;
}

}  // namespace glisson::openigtlink
