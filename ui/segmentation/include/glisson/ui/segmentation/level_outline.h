// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "glisson/editing/level_tracing.h"
#include "glisson/ui/common/preview_service.h"
#include "glisson/ui/common/view_state.h"

namespace glisson::ui {

/// Draws at the pointer what level tracing would take there. Traced beside the window's thread: the line
/// never falls behind the hand.
class LevelOutline : public QObject {
  Q_OBJECT
 public:
  explicit LevelOutline(ViewState& views, QObject* parent = nullptr);

  /// For which label, which gives the colour; none: nothing is drawn.
  void set_label(const std::optional<Label>& label);

 private:
  struct Order {
    std::shared_ptr<const Image> image;
    PointerPlace place;
    Label label = 0;
  };
  void follow();
  /// On the thread.
  SliceLine trace(const Order& order);
  void accept(const std::shared_ptr<const SliceLine>& line);

  ViewState& views_;
  std::optional<Label> label_;
  bool draws_ = false;                        ///< the line in the views is its own
  editing::LevelTracer tracer_;               ///< the thread's
  PreviewService<Order, SliceLine> tracing_;  ///< last: its thread uses the tracer
};

}  // namespace glisson::ui
