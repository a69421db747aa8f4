// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

#include "glisson/ui/scene/label_surfaces.h"

namespace glisson::ui {

/// Surfaces of labels for the 3D view, made on a thread of its own: the newest labels win, and after an edit
/// only what changed is made again.
class LabelSurfaceSource : public QObject {
  Q_OBJECT
 public:
  explicit LabelSurfaceSource(QObject* parent = nullptr);
  ~LabelSurfaceSource() override;

  /// From now on those of these labels; null: none. What is shown stays until the new ones are there.
  void set_labels(std::shared_ptr<const LabelVolume> labels);
  /// The newest that were made; never null.
  const std::shared_ptr<const scene::LabelSurfaces>& surfaces() const { return surfaces_; }
  bool is_making() const { return making_; }

 signals:
  void changed();

 private:
  void accept(const std::shared_ptr<const LabelVolume>& of,
              const std::shared_ptr<const scene::LabelSurfaces>& made);
  void run(const std::stop_token& stop);

  std::shared_ptr<const LabelVolume> wanted_;
  std::shared_ptr<const scene::LabelSurfaces> surfaces_;
  bool making_ = false;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::shared_ptr<const LabelVolume> order_;  ///< newest wins
  std::jthread thread_;
};

}  // namespace glisson::ui
