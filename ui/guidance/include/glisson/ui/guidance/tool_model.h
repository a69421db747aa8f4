// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QProperty>
#include <QTimer>
#include <memory>
#include <optional>
#include <utility>

#include "glisson/guidance/tool_meter.h"
#include "glisson/openigtlink/receiver.h"
#include "glisson/ui/guidance/live_view_model.h"
#include "glisson/ui/guidance/playback_model.h"
#include "glisson/ui/guidance/review_model.h"

namespace glisson::ui {

/// A tracked tool's tip, as another program tells it: how far it is from the organ and the chosen lesion.
/// While it touches the organ it marks the place there, as a click with the right button does.
class ToolModel : public QObject {
  Q_OBJECT
 public:
  /// All outlive this.
  ToolModel(EngineBridge& engine, DrawableSource& drawables, PlaybackModel& playback, ReviewModel& review,
            LiveViewModel& live, QObject* parent = nullptr);
  ~ToolModel() override;

  /// @param address "HOST:PORT/NAME"; `said` tells what is wrong with it.
  void switch_on(const QString& address);
  void switch_off();

  // For widgets to read.
  QProperty<bool> is_on{false};
  QProperty<QString> said;  ///< empty while it is off
  QProperty<QString> tone;  ///< of what is said, as the style sheet names it: good, warning, error

 private:
  void look();
  void read_live();
  /// Why the organ's place is not that of now; empty: it is.
  QString why_not_now() const;
  static QString not_followed();
  void tell(const openigtlink::ReceivedTool& tool);
  void say(const QString& text, const QString& how);
  /// The meter of the present drawable, at the present place; null: nothing is followed that could be shown.
  /// @pre the place is that of now.
  guidance::ToolMeter* meter();

  EngineBridge& engine_;
  DrawableSource& drawables_;
  PlaybackModel& playback_;
  ReviewModel& review_;
  LiveViewModel& live_;
  std::unique_ptr<openigtlink::Receiver> receiver_;
  std::shared_ptr<const scene::DrawableModel> measured_;  ///< what the meter was made of
  std::unique_ptr<guidance::ToolMeter> meter_;
  std::optional<std::pair<int, double>> frame_;  ///< index and seconds of the last one that was followed
  std::optional<VideoFeed::Clock::time_point> taken_;  ///< when that was; empty: nobody knows
  QTimer looks_;
};

}  // namespace glisson::ui
