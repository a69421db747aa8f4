// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/correction_model.h"

#include "glisson/engine/commands/correct_tracking.h"
#include "glisson/engine/commands/undo_correction.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/guidance/place_picker.h"
#include "glisson/ui/common/error_texts.h"

namespace glisson::ui {
namespace {

/// Milliseconds between two pieces of a drag, at least: tracking goes on between them.
constexpr qint64 kPieceEvery = 250;
/// Pixels; a shorter drag is a click.
constexpr double kLeast = 1.0;

}  // namespace

CorrectionModel::CorrectionModel(EngineBridge& engine, PlaybackModel& playback, ReviewModel& review,
                                 QObject* parent)
    : QObject(parent), engine_(engine), playback_(playback), review_(review) {
  connect(&engine_, &EngineBridge::live_changed, this, &CorrectionModel::read_live);
  connect(&engine_, &EngineBridge::finished, this, &CorrectionModel::finish);
  connect(&playback_, &PlaybackModel::case_read, this, &CorrectionModel::read_case);
  connect(&playback_, &PlaybackModel::begun, this, [this] {
    record_.clear();
    say({});
  });
  couplings_.add(review_.is_reviewing, [this](bool) { read_case(); });
  couplings_.add(playback_.is_playing, [this](bool) { read_case(); });
}

const engine::LiveState* CorrectionModel::live() const { return engine_.state()[part::live].get(); }

void CorrectionModel::read_case() {
  if (const std::uint64_t number = engine_.snapshot()->case_number; number != said_of_) {
    said_of_ = number;
    say({});
  }
  is_offered = playback_.is_playing && !review_.is_reviewing;
  if (!is_offered) {
    is_correcting = false;
    settle();
    held_.reset();
    ends_ = gives_up_ = false;
    line = std::optional<Line>();
  }
  read_live();
}

void CorrectionModel::read_live() {
  can_undo = is_offered && live() != nullptr && !live()->corrections.empty();
}

bool CorrectionModel::grab(const Eigen::Vector2d& pixel, StereoView view) {
  const engine::CaseState& now = engine_.state();
  if (!is_offered || live() == nullptr || !now[part::model] || !now[part::rig] || piece_ || held_)
    return false;
  const PatientModel model = engine::effective_model(now);
  const OverlayFrame& overlay = live()->overlay;
  const bool is_proposed =
      is_correcting && overlay.validity == Validity::surface_apart;  // outline and margin
  if (overlay.level() == Level::withdrawn && !is_proposed) {
    say(tr("There is no overlay that could be corrected."), QStringLiteral("warning"));
    return false;
  }
  const Points& nodes = overlay.nodes_in_camera;
  if (nodes.rows() != model.mesh.vertex_count()) return false;
  const auto picked = guidance::pick_place(model, nodes, *now[part::rig], view, pixel);
  if (!picked) {
    say(tr("There is nothing of the drawn organ. Take hold of its margin, its notch, a vessel or its "
           "surface."),
        QStringLiteral("warning"));
    return false;
  }
  Correction correction;
  correction.feature = picked->feature;
  correction.view = view;
  correction.place_in_ct = picked->place_in_ct;
  correction.from = correction.to = picked->pixel;
  correction.sigma_px = picked->sigma_px;
  correction.gesture = ++gesture_;
  held_ = correction;
  pressed_ = pixel;
  has_arrived_ = ends_ = gives_up_ = false;
  line = Line{picked->pixel, pixel, view};
  since_piece_.start();
  const QString what[] = {tr("a place of the surface"), tr("the anterior margin"), tr("the notch"),
                          tr("a vessel")};
  say(tr("In the hand: %1. Drag it to where the picture shows it.")
          .arg(what[static_cast<int>(picked->feature)]));
  return true;
}

void CorrectionModel::drag_to(const Eigen::Vector2d& pixel) {
  if (!held_ || ends_ || gives_up_ || (!has_arrived_ && !piece_ && is_click(pixel))) return;
  held_->to = pixel;
  line = Line{line.value()->from, pixel, held_->view};
  if (!piece_ && since_piece_.elapsed() >= kPieceEvery) send_piece(false);
}

bool CorrectionModel::is_click(const Eigen::Vector2d& pixel) const {
  return (pixel - pressed_).norm() < kLeast;
}

void CorrectionModel::let_go(const Eigen::Vector2d& pixel) {
  if (!held_ || ends_ || gives_up_) return;
  if (!has_arrived_ && !piece_ && is_click(pixel)) return give_up();
  held_->to = pixel;
  ends_ = true;
  if (!piece_) send_piece(true);
}

void CorrectionModel::give_up() {
  if (!held_) return;
  line = std::optional<Line>();
  say(standing());
  if (piece_) {
    gives_up_ = true;  // when it has arrived
    return;
  }
  held_.reset();
  if (has_arrived_) undoing_ = engine_.post(engine::UndoCorrection{});
}

void CorrectionModel::undo() {
  if (can_undo && !held_ && !undoing_) undoing_ = engine_.post(engine::UndoCorrection{});
}

void CorrectionModel::send_piece(bool is_last) {
  const engine::CaseState& now = engine_.state();
  // A frame that could not be followed has no nodes.
  if (live() == nullptr ||
      live()->overlay.nodes_in_camera.rows() != now[part::model]->model.mesh.vertex_count())
    return give_up();
  // From where the place is drawn by all that has arrived.
  const auto drawn = guidance::pixel_of(now[part::model]->model, live()->overlay.nodes_in_camera,
                                        *now[part::rig], held_->view, held_->place_in_ct);
  if (!drawn) return give_up();
  Correction correction = *held_;
  correction.from = *drawn;
  is_last_ = is_last;
  since_piece_.start();
  piece_ = engine_.post(engine::CorrectTracking{correction});
}

void CorrectionModel::finish(const engine::Outcome& outcome) {
  const bool is_done = outcome.status == engine::Status::done;
  if (undoing_ == outcome.id) {
    undoing_.reset();
    read_live();
    if (!is_done) return say(error_text(outcome.error), QStringLiteral("error"));
    const bool was_told = !has_arrived_;
    has_arrived_ = false;
    if (was_told && live() != nullptr)
      record_.push_back(undone_line(live()->overlay.index, live()->overlay.seconds));
    return say(standing());
  }
  if (piece_ != outcome.id) return;
  piece_.reset();
  read_live();
  if (!held_) return;  // what it belonged to has ended
  has_arrived_ = has_arrived_ || is_done;
  if (gives_up_) return give_up();
  if (!is_done) {
    say(error_text(outcome.error), QStringLiteral("error"));
    if (!ends_) return;  // the hand may come back
  }
  if (ends_ && !is_last_) return send_piece(true);
  if (!is_last_) return;
  held_.reset();
  ends_ = false;
  line = std::optional<Line>();
  if (has_arrived_) note_last();
  has_arrived_ = false;
  if (is_done) say(standing());
}

void CorrectionModel::settle() {
  if (!held_ || !has_arrived_) return;
  note_last();
  has_arrived_ = false;
}

void CorrectionModel::note_last() {
  if (live() != nullptr && !live()->corrections.empty())
    record_.push_back(correction_line(live()->corrections.back()));
}

QString CorrectionModel::standing() const {
  const int count = live() == nullptr ? 0 : static_cast<int>(live()->corrections.size());
  if (count == 0) return {};
  return tr("Corrected by hand: %1. The last one moved the organ by %2 mm on average.")
      .arg(count)
      .arg(1e3 * live()->corrections.back().moved, 0, 'f', 1);
}

void CorrectionModel::say(const QString& text, const QString& how) {
  tone = how;
  said = text;
}

}  // namespace glisson::ui
