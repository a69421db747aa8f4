// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QElapsedTimer>
#include <QObject>
#include <QProperty>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "glisson/engine/parts/live.h"
#include "glisson/patient/correction.h"
#include "glisson/ui/common/couplings.h"
#include "glisson/ui/common/engine_bridge.h"
#include "glisson/ui/guidance/playback_model.h"
#include "glisson/ui/guidance/review_model.h"

namespace glisson::ui {

/// A hand takes hold of a place of the tracked organ in either picture and drags it to where it is seen.
/// While it drags, pieces of the one gesture go to the engine: the next when the one before is done.
class CorrectionModel : public QObject {
  Q_OBJECT
 public:
  /// All outlive this.
  CorrectionModel(EngineBridge& engine, PlaybackModel& playback, ReviewModel& review,
                  QObject* parent = nullptr);

  /// Takes hold of what lies at a pixel of a picture, in whose pixels it is dragged then. @return false: of
  /// nothing; `said` tells why.
  bool grab(const Eigen::Vector2d& pixel, StereoView view = StereoView::left);
  void drag_to(const Eigen::Vector2d& pixel);
  /// The place is there.
  void let_go(const Eigen::Vector2d& pixel);
  /// Lets go without having said anything.
  void give_up();
  /// What a hand has drawn so far stands: it is a line of record(), whatever becomes of the hand.
  void settle();
  /// Takes the last correction back.
  void undo();
  /// Lines of what was corrected and taken back since tracking began, oldest first (see correction_line).
  const std::vector<std::string>& record() const { return record_; }

  /// Pixels of that picture.
  struct Line {
    Eigen::Vector2d from, to;
    StereoView view = StereoView::left;
    bool operator==(const Line&) const = default;
  };

  // For widgets to read.
  QProperty<bool> is_offered{false};    ///< there is a live organ to be corrected
  QProperty<bool> can_undo{false};      ///< a correction stands
  QProperty<std::optional<Line>> line;  ///< while a hand drags
  QProperty<QString> said, tone;
  // For widgets to set.
  QProperty<bool> is_correcting{false};  ///< drags correct, without a key

 private:
  void read_case();
  void read_live();
  void finish(const engine::Outcome& outcome);
  /// Whether the hand has not moved: what it took hold of may lie beside the pixel.
  bool is_click(const Eigen::Vector2d& pixel) const;
  void send_piece(bool is_last);
  void say(const QString& text, const QString& how = {});
  QString standing() const;
  /// The last correction that stands, for who does the same again.
  void note_last();
  const engine::LiveState* live() const;

  EngineBridge& engine_;
  PlaybackModel& playback_;
  ReviewModel& review_;
  Couplings couplings_;
  std::optional<Correction> held_;                     ///< of the present gesture
  Eigen::Vector2d pressed_ = Eigen::Vector2d::Zero();  ///< pixel at which it began
  QElapsedTimer since_piece_;
  std::optional<engine::CommandId> piece_;    ///< on its way
  std::optional<engine::CommandId> undoing_;  ///< likewise
  bool is_last_ = false;                      ///< the piece on its way ends the gesture
  bool ends_ = false;                         ///< the hand has let go, and the last piece waits for its turn
  bool gives_up_ = false;                     ///< what of the gesture has arrived is to be taken back
  bool has_arrived_ = false;                  ///< a piece of the gesture has
  int gesture_ = 0;
  std::uint64_t said_of_ = 0;  ///< the case's number
  std::vector<std::string> record_;
};

}  // namespace glisson::ui
