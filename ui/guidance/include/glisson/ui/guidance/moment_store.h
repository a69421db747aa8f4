// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "glisson/patient/picture.h"
#include "glisson/patient/registration.h"

namespace glisson::ui {

/// One frame as it was followed.
struct Moment {
  Picture left;
  OverlayFrame overlay;
};

/// Keeps what was followed, to be looked at again: pictures as JPEG of high quality, made on a thread of its
/// own. The oldest go when there is no more room. Any thread may ask; add() and clear() are for one thread.
class MomentStore : public QObject {
  Q_OBJECT
 public:
  /// @param bytes kept at the most.
  explicit MomentStore(std::size_t bytes = std::size_t{512} << 20U, QObject* parent = nullptr);
  ~MomentStore() override;

  /// Where the thread cannot keep up, a moment is left out.
  void add(Moment moment);
  void clear();

  struct Entry {
    int index = 0;
    double seconds = 0.0;
    Level level = Level::withdrawn;
  };
  /// What is kept, in the order of the frames.
  std::vector<Entry> entries() const;
  /// Empty: it is not kept.
  std::optional<Moment> at(int index) const;

 signals:
  /// There are others now. Comes from the store's thread.
  void changed();

 private:
  struct Kept {
    QByteArray picture;
    OverlayFrame overlay;
    std::size_t bytes() const;
  };
  void run(const std::stop_token& stop);
  void keep(const Moment& moment, int generation);

  std::size_t most_;
  mutable std::mutex mutex_;
  std::condition_variable_any wanted_;
  std::deque<Moment> waiting_;
  std::map<int, Kept> kept_;
  std::size_t bytes_ = 0;
  int generation_ = 0;  ///< what waited when all was cleared is not kept
  std::jthread thread_;
};

}  // namespace glisson::ui
