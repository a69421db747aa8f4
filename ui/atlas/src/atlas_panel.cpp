// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/atlas/atlas_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QVBoxLayout>

#include "glisson/engine/commands/set_landmarks.h"
#include "glisson/engine/obstacle.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/proposals.h"
#include "glisson/ui/atlas/atlas_box.h"
#include "glisson/ui/atlas/atlas_choice.h"
#include "glisson/ui/atlas/proposal_review.h"
#include "glisson/ui/atlas/shape_modes.h"
#include "glisson/ui/common/being_made.h"
#include "glisson/ui/common/texts.h"

namespace glisson::ui {
namespace {

double length_mm(const Points& line) {
  double length = 0.0;
  for (Eigen::Index i = 0; i + 1 < line.rows(); ++i) length += (line.row(i + 1) - line.row(i)).norm();
  return 1e3 * length;
}

}  // namespace

AtlasPanel::AtlasPanel(EngineBridge& engine, LinkedViews& views, ViewState& state, QWidget* parent)
    : Panel(engine, tr("Landmarks"),
            tr("Features that are found again in the laparoscope's pictures. Check them on the 3D surface "
               "and place "
               "what is missing."),
            parent),
      views_(views) {
  setObjectName(QStringLiteral("atlas_panel"));
  obstacle_ = make_explanation({}, this);
  content()->addWidget(obstacle_);
  QVBoxLayout* proposals = add_section(
      tr("Proposals"),
      tr("Where they should lie: from the CT where it shows them, else from other livers. Nothing "
         "is used before you accept it."));
  choice_ = new AtlasChoice(this);
  proposals->addWidget(new AtlasBox(engine, *choice_, this));
  review_ = new ProposalReview(engine, views, state, *choice_, this);
  proposals->addWidget(review_);
  connect(review_, &ProposalReview::tool_taken, this, [this] {
    choose(Tool::none);
    modes_->leave();
  });
  connect(review_, &ProposalReview::tool_changed, this, &AtlasPanel::show_landmarks);
  QVBoxLayout* margin =
      add_section(tr("Anterior margin"), tr("The sharp lower edge, found on the model (white line)."));
  margin_ = new QLabel(this);
  margin->addWidget(margin_);
  place_notch_ = add_tool(tr("Umbilical notch"), tr("Where the round ligament enters (magenta)."), notch_,
                          &Landmarks::umbilical_notch, Tool::notch);
  place_notch_->setObjectName(QStringLiteral("place_notch"));
  place_cava_ = add_tool(tr("Vena cava"), tr("Where the liver is attached to it, seen from behind (green)."),
                         cava_, &Landmarks::vena_cava, Tool::vena_cava);
  place_cava_->setObjectName(QStringLiteral("place_vena_cava"));
  QVBoxLayout* end = add_section(tr("Acceptance"));
  end->addWidget(
      make_explanation(tr("What you see in the 3D view is what the registration will use."), this));
  accept_ = new QPushButton(tr("Accept landmarks"), this);
  accept_->setObjectName(QStringLiteral("accept_landmarks"));
  accept_->setProperty("role", "run");
  end->addWidget(accept_);
  modes_ = new ShapeModes(engine, views, *choice_, this);
  add_section(tr("Shapes of livers"),
              tr("What the atlas knows of how livers differ. Nothing of the case changes."))
      ->addWidget(modes_);
  connect(modes_, &ShapeModes::shown_changed, this, [this](bool shown) {
    if (shown) {
      choose(Tool::none);
      review_->put_tool_away();
    }
    review_->set_marks_hidden(shown);
    show_landmarks();
  });
  connect(accept_, &QPushButton::clicked, this, &AtlasPanel::accept_all);
  connect(&views_.volume(), &RenderView::clicked, this, &AtlasPanel::place);
  connect(&this->engine(), &EngineBridge::case_changed, this, &AtlasPanel::show_case);
  connect(&this->engine(), &EngineBridge::finished, this, [this](const engine::Outcome& outcome) {
    if (storing_.erase(outcome.id) == 0 || !storing_.empty()) return;
    model_.reset();  // what is shown is what the case has now, even where nothing has changed there
    show_case();
  });
  connect(&this->engine(), &EngineBridge::tasks_changed, this, [this] {
    if (waits_ == is_being_made(this->engine(), part::model)) return;
    waits_ = !waits_;
    show_landmarks();
  });
  auto* escape = new QShortcut(Qt::Key_Escape, this);
  connect(escape, &QShortcut::activated, this, [this] {
    choose(Tool::none);
    review_->put_tool_away();
    modes_->leave();
  });
  watch(part::landmarks,
        [](const engine::CaseState& state) { return engine::landmark_review(state).is_open; });
  show_case();
}

QPushButton* AtlasPanel::add_tool(const QString& heading, const QString& explanation, QLabel*& state,
                                  Points Landmarks::*points, Tool tool) {
  QVBoxLayout* box = add_section(heading, explanation);
  state = new QLabel(this);
  state->setWordWrap(true);
  box->addWidget(state);
  auto* row = new QHBoxLayout;
  auto* place = new QPushButton(tr("Place by clicking"), this);
  place->setCheckable(true);
  place->setProperty("role", "choice");
  auto* undo = new QPushButton(tr("Undo last"), this);
  undo->setObjectName(QStringLiteral("undo_landmark"));
  auto* clear = new QPushButton(tr("Clear"), this);
  clear->setObjectName(QStringLiteral("clear_landmarks"));
  row->addWidget(place, 1);
  row->addWidget(undo);
  row->addWidget(clear);
  box->addLayout(row);
  const auto has_points = [this, points] { return (landmarks_.*points).rows() > 0; };
  connect(this, &AtlasPanel::landmarks_shown, this, [this, undo, clear, has_points] {
    for (QPushButton* button : {undo, clear}) button->setEnabled(has_points() && !waits_);
  });
  connect(place, &QPushButton::clicked, this, [this, tool](bool on) { choose(on ? tool : Tool::none); });
  connect(undo, &QPushButton::clicked, this, [this, points, tool] {
    Points& list = landmarks_.*points;
    if (list.rows() == 0) return;
    list.conservativeResize(list.rows() - 1, 3);
    if (tool == Tool::notch && list.rows() == 0) landmarks_.notch_deviation = 0.0;
    store(points);
  });
  connect(clear, &QPushButton::clicked, this, [this, points, tool] {
    (landmarks_.*points).resize(0, 3);
    if (tool == Tool::notch) landmarks_.notch_deviation = 0.0;
    // Those that the model brought come back where nobody has placed any: the next click takes their place.
    const auto model = engine().state()[part::model];
    if (model && (model->model.landmarks.*points).rows() > 0) begin_anew_.insert(tool);
    store(points);
  });
  return place;
}

void AtlasPanel::activate() {
  active_ = true;
  review_->set_active(true);
  modes_->set_active(true);
}

void AtlasPanel::deactivate() {
  active_ = false;
  choose(Tool::none);
  modes_->set_active(false);
  review_->set_active(false);
}

void AtlasPanel::choose(Tool tool) {
  tool_ = tool;
  if (tool != Tool::none) {
    review_->put_tool_away();
    modes_->leave();
  }
  place_notch_->setChecked(tool == Tool::notch);
  place_cava_->setChecked(tool == Tool::vena_cava);
  views_.volume().set_taken(this, tool != Tool::none);
  views_.volume().setCursor(tool == Tool::none ? Qt::ArrowCursor : Qt::CrossCursor);
}

void AtlasPanel::place(double x, double y) {
  if (!active_ || tool_ == Tool::none || waits_) return;
  const auto p = views_.surface_point(x, y);
  if (!p) return;
  const auto points = tool_ == Tool::notch ? &Landmarks::umbilical_notch : &Landmarks::vena_cava;
  Points& list = landmarks_.*points;
  // A guess of the atlas beside a person's point would be taken for as exact as that.
  const bool is_guess = tool_ == Tool::notch && landmarks_.notch_deviation > 0.0;
  if (begin_anew_.erase(tool_) > 0 || is_guess) list.resize(0, 3);
  if (tool_ == Tool::notch) landmarks_.notch_deviation = 0.0;  // from now on it is the person's
  list.conservativeResize(list.rows() + 1, 3);
  list.row(list.rows() - 1) = p->transpose();
  store(points);
}

void AtlasPanel::store(Points Landmarks::*points) {
  placed_.*points = landmarks_.*points;
  placed_.notch_deviation = placed_.umbilical_notch.rows() > 0 ? landmarks_.notch_deviation : 0.0;
  storing_.insert(engine().post(engine::SetLandmarks{placed_, model_}));
  show_landmarks();
}

void AtlasPanel::accept_all() {
  placed_ = landmarks_;
  storing_.insert(engine().post(engine::SetLandmarks{placed_, model_}));
  show_landmarks();
}

void AtlasPanel::show_case() {
  const engine::CaseState& now = engine().state();
  const bool changed = now[part::landmarks] != taken_ || now[part::model] != model_;
  if (model_ && now[part::model] != model_) begin_anew_.clear();
  if (storing_.empty() && changed) {
    taken_ = now[part::landmarks];
    model_ = now[part::model];
    landmarks_ = now[part::model] ? engine::effective_landmarks(now) : Landmarks{};
    const bool is_of_model = engine::stage_state(now, part::landmarks) == engine::StageState::current;
    placed_ = taken_ && is_of_model ? *taken_ : Landmarks{};
  }
  show_landmarks();
}

void AtlasPanel::show_landmarks() {
  const auto first = engine::obstacle(engine().state(), engine::SetLandmarks{});
  const bool ready = !first && !waits_;
  obstacle_->setText(first ? obstacle_text(first) : waits_ ? model_wait_text() : QString());
  obstacle_->setVisible(!ready);
  for (QPushButton* button : {place_notch_, place_cava_, accept_}) button->setEnabled(ready);
  margin_->setText(landmarks_.anterior_margin.rows() > 1
                       ? tr("%1 mm long").arg(length_mm(landmarks_.anterior_margin), 0, 'f', 0)
                       : tr("not found"));
  const auto placed = [this](const Points& points, Tool tool) {
    if (points.rows() == 0) return tr("not placed");
    return begin_anew_.contains(tool)
               ? tr("points of the model: %1, the next click replaces them").arg(points.rows())
               : tr("points: %1").arg(points.rows());
  };
  notch_->setText(placed(landmarks_.umbilical_notch, Tool::notch));
  cava_->setText(placed(landmarks_.vena_cava, Tool::vena_cava));
  emit landmarks_shown();
  if (!ready) return;
  Landmarks shown = modes_->is_shown() ? Landmarks{} : landmarks_;
  if (review_->tool() == ProposalReview::Tool::paint) shown.vena_cava.resize(0, 3);  // its faces are shown
  views_.set_landmarks(shown);
}

}  // namespace glisson::ui
