// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>

#include "glisson/ui/common/preview_service.h"
#include "glisson/ui/scene/label_surfaces.h"

namespace glisson::ui {

/// Surfaces of labels for the 3D view, made on a thread of its own: the newest labels win, and after an edit
/// only what changed is made again.
class LabelSurfaceSource : public QObject {
  Q_OBJECT
 public:
  explicit LabelSurfaceSource(QObject* parent = nullptr);

  /// From now on those of these labels; null: none. What is shown stays until the new ones are there.
  void set_labels(std::shared_ptr<const LabelVolume> labels);
  /// Labels of another patient come: what is shown goes at once, and what is being made never comes.
  void forget();
  /// The newest that were made; never null.
  const std::shared_ptr<const scene::LabelSurfaces>& surfaces() const { return surfaces_; }
  bool is_making() const { return making_; }

 signals:
  void changed();

 private:
  void accept(const std::shared_ptr<const LabelVolume>& of,
              const std::shared_ptr<const scene::LabelSurfaces>& made);
  /// On the thread. Empty: cancelled.
  Cancellable<scene::LabelSurfaces> make(const std::shared_ptr<const LabelVolume>& order,
                                         const RunContext& context);

  std::shared_ptr<const LabelVolume> wanted_;
  std::shared_ptr<const scene::LabelSurfaces> surfaces_;
  bool making_ = false;
  scene::LabelSurfaces former_;  ///< the thread's; even of other labels: it compares bricks
  PreviewService<std::shared_ptr<const LabelVolume>, scene::LabelSurfaces> maker_;
};

}  // namespace glisson::ui
