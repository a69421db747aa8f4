// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <exception>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "glisson/patient/picture.h"

namespace glisson::network {

/// A mask network beside a live loop, on a thread of its own: the newest picture wins, and nobody waits. What
/// goes wrong is told, and no masks come any more. For one thread that offers.
class LiveMask {
 public:
  /// Begins to open the network. @param threads of the processor; 0: a quarter of them.
  explicit LiveMask(std::filesystem::path network, int threads = 0);
  /// Ends within a moment, whatever the network does.
  ~LiveMask();

  /// A left picture, to be masked when the network has time; takes the place of one that still waits.
  void offer(const StereoFrame& frame);
  /// Waits until all that was offered has been masked, or something went wrong: for films, whose masks are
  /// the same on any machine then.
  void wait() const;

  /// The newest mask. Null: there is none, or it is older than the sheet allows.
  /// @param now seconds of the source.
  std::shared_ptr<const PictureMask> usable(double now) const;
  /// Seconds of the source since the picture of the newest mask; empty: there is none.
  std::optional<double> age(double now) const;
  /// Why no masks come any more; empty: nothing went wrong.
  std::string problem() const;
  /// @throws what went wrong, if anything did.
  void require_well() const;
  const std::filesystem::path& network() const { return network_; }

 private:
  void run(const std::stop_token& stop, int threads);

  std::filesystem::path network_;
  mutable std::mutex mutex_;
  mutable std::condition_variable_any changed_;
  std::optional<StereoFrame> waiting_;
  bool is_busy_ = false;
  std::shared_ptr<const PictureMask> latest_;
  std::exception_ptr failure_;
  double oldest_seconds_ = 0.0;
  std::jthread thread_;
};

}  // namespace glisson::network
