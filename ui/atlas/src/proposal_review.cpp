// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/atlas/proposal_review.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPixmap>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "glisson/engine/commands/propose_landmarks.h"
#include "glisson/engine/commands/restore_review.h"
#include "glisson/engine/commands/review_proposal.h"
#include "glisson/engine/obstacle.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/proposals.h"
#include "glisson/geometry/closest_point_tree.h"
#include "glisson/ui/atlas/structure_look.h"
#include "glisson/ui/atlas/surface_drag.h"
#include "glisson/ui/common/atlas_texts.h"
#include "glisson/ui/common/being_made.h"
#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/common/texts.h"

namespace glisson::ui {
namespace {
using atlas::Decision;
using atlas::Proposal;

/// What is said not to be there is grey.
QColor colour_of(const Proposal& proposal) {
  return proposal.decision == Decision::not_visible ? QColor(120, 126, 132)
                                                    : ui::colour_of(proposal.structure);
}

constexpr double kBrushStep = 2e-3;     // metres
constexpr Eigen::Index kLeastArea = 3;  // points of a contact

bool same_points(const Points& a, const Points& b) { return a.rows() == b.rows() && a == b; }

QIcon disc(const QColor& colour) {
  QPixmap picture(12, 12);
  picture.fill(colour);
  return picture;
}

/// Every point, some with their ellipsoids: those of neighbours hide one another.
std::vector<scene::EllipsoidMark> slice_marks(const Proposal& one) {
  constexpr Eigen::Index kBetween = 5;
  std::vector<scene::EllipsoidMark> marks;
  for (Eigen::Index k = 0; k < one.points.rows(); ++k)
    marks.push_back({one.points.row(k).transpose(), one.covariances[static_cast<std::size_t>(k)],
                     k % kBetween == 0 ? kEllipsoid95 : 0.0, colour_of(one)});
  return marks;
}

/// What is painted, as discs.
std::vector<scene::EllipsoidMark> painted_marks(const Points& area, const QColor& colour) {
  std::vector<scene::EllipsoidMark> marks;
  for (Eigen::Index k = 0; k < area.rows(); ++k)
    marks.push_back({area.row(k).transpose(), Eigen::Matrix3d::Identity(), 0.0, colour});
  return marks;
}

Hand hand_of(ProposalReview::Tool tool) {
  if (tool == ProposalReview::Tool::move) return Hand::point;
  return tool == ProposalReview::Tool::paint ? Hand::brush : Hand::crosshair;
}

}  // namespace

ProposalReview::ProposalReview(EngineBridge& engine, LinkedViews& views, ViewState& state,
                               AtlasChoice& choice, QWidget* parent)
    : QWidget(parent),
      engine_(engine),
      views_(views),
      state_(state),
      choice_(choice),
      actors_(views.volume().patient().renderer()),
      ring_(views.volume().patient().renderer()) {
  setObjectName(QStringLiteral("proposal_review"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  propose_ = new TaskButton(
      engine_, tr("Propose landmarks"),
      [this]() -> std::optional<engine::Command> {
        auto atlas = choice_.atlas();
        if (!atlas) return {};
        return engine::ProposeLandmarks{std::move(atlas)};
      },
      this);
  propose_->setObjectName(QStringLiteral("propose_landmarks"));
  layout->addWidget(propose_);
  review_ = new QWidget(this);
  layout->addWidget(review_);
  make_list();
  connect(&engine_, &EngineBridge::case_changed, this, &ProposalReview::show_case);
  connect(&choice_, &AtlasChoice::changed, this, &ProposalReview::show_case);
  connect(&engine_, &EngineBridge::finished, this, [this](const engine::Outcome& outcome) {
    if (posted_.erase(outcome.id) > 0) {
      dragged_.resize(0, 3);
      show_case();
    }
    show_chosen();
  });
  connect(&engine_, &EngineBridge::tasks_changed, this, &ProposalReview::show_chosen);
  drag_ = new SurfaceDrag(views_, this);
  connect(drag_, &SurfaceDrag::began, this, &ProposalReview::begin_drag);
  connect(drag_, &SurfaceDrag::moved, this, &ProposalReview::drag);
  connect(drag_, &SurfaceDrag::ended, this, &ProposalReview::end_drag);
  connect(drag_, &SurfaceDrag::hovered, this, &ProposalReview::show_ring);
  connect(drag_, &SurfaceDrag::left, this, &ProposalReview::hide_ring);
  connect(&state_, &ViewState::gestured, this, &ProposalReview::paint_in_slice);
  connect(&state_, &ViewState::gesture_dropped, this, [this] { dragging_ = false; });
  connect(&state_, &ViewState::brush_turned, this, [this](double notches) {
    if (tool_ == Tool::paint) set_brush(brush_ + kBrushStep * notches);
  });
  connect(&state_, &ViewState::picked, this, [this](const Point<CtFrame>& p) {
    if (tool_ == Tool::move) move_to(p.xyz);
  });
  show_list();
  show_case();
}

QPushButton* ProposalReview::add_button(const QString& text, const QString& explanation,
                                        const QKeySequence& key) {
  auto* button = new QPushButton(text, this);
  button->setToolTip(QStringLiteral("%1 (%2)").arg(explanation, key.toString(QKeySequence::NativeText)));
  auto* shortcut = new QShortcut(key, this);
  shortcut->setAutoRepeat(false);  // a key that is held would accept one after the other, unseen
  connect(shortcut, &QShortcut::activated, button, &QPushButton::click);
  keys_.push_back(shortcut);
  return button;
}

void ProposalReview::make_list() {
  auto* layout = new QVBoxLayout(review_);
  layout->setContentsMargins(0, 0, 0, 0);
  doubts_ = make_warning(review_);
  layout->addWidget(doubts_);
  list_ = new QListWidget(review_);
  list_->setObjectName(QStringLiteral("proposals"));
  list_->setAccessibleName(tr("Proposed landmarks"));
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  layout->addWidget(list_);
  reason_ = make_explanation({}, review_);
  accept_ = add_button(tr("Accept"), tr("It lies there"), Qt::Key_A);
  move_ = add_button(tr("Move"), tr("Drag it over the liver in 3D, or click where it lies in a slice"),
                     Qt::Key_M);
  not_visible_ = add_button(tr("Not visible"), tr("The proposal is not used; what the CT itself shows stays"),
                            Qt::Key_N);
  undo_ = add_button(tr("Undo"), tr("Take the last step of the review back"), Qt::Key_U);
  accept_->setObjectName(QStringLiteral("accept_proposal"));
  move_->setObjectName(QStringLiteral("move_proposal"));
  not_visible_->setObjectName(QStringLiteral("not_visible_proposal"));
  undo_->setObjectName(QStringLiteral("undo_review"));
  paint_ =
      add_button(tr("Paint faces"), tr("Paint where it touches the liver, in 3D or in a slice"), Qt::Key_P);
  thinner_ = add_button(QStringLiteral("\u2212"), tr("A smaller brush"), Qt::Key_Minus);
  thicker_ = add_button(QStringLiteral("+"), tr("A larger brush"), Qt::Key_Plus);
  for (QShortcut* size : {keys_.end()[-2], keys_.back()}) size->setAutoRepeat(true);
  paint_->setObjectName(QStringLiteral("paint_proposal"));
  thinner_->setAccessibleName(tr("A smaller brush"));
  thicker_->setAccessibleName(tr("A larger brush"));
  here_ = new QShortcut(Qt::Key_Return, this);
  here_->setAutoRepeat(false);
  here_->setEnabled(false);
  connect(here_, &QShortcut::activated, this, [this] { move_to(state_.crosshair().xyz); });
  for (QShortcut* key : keys_) key->setEnabled(false);
  for (QPushButton* button : {move_, paint_}) {
    button->setCheckable(true);
    button->setProperty("role", "choice");
  }
  auto* row = new QGridLayout;  // two by two: German words would push a single row out of the panel
  for (int at = 0; QPushButton * button : {accept_, move_, not_visible_, undo_})
    row->addWidget(button, at / 2, at % 2), ++at;
  layout->addLayout(row);
  auto* brush = new QHBoxLayout;
  brush->addWidget(paint_, 1);
  for (QPushButton* button : {thinner_, thicker_}) brush->addWidget(button);
  layout->addLayout(brush);
  layout->addWidget(reason_);  // below: its lines come and go, the buttons stay under the pointer
  connect(list_, &QListWidget::currentRowChanged, this, &ProposalReview::choose);
  connect(accept_, &QPushButton::clicked, this, [this] { decide(Decision::accepted); });
  connect(not_visible_, &QPushButton::clicked, this, [this] { decide(Decision::not_visible); });
  connect(move_, &QPushButton::clicked, this, [this](bool on) { set_tool(on ? Tool::move : Tool::none); });
  connect(paint_, &QPushButton::clicked, this, [this](bool on) { set_tool(on ? Tool::paint : Tool::none); });
  connect(thinner_, &QPushButton::clicked, this, [this] { set_brush(brush_ - kBrushStep); });
  connect(thicker_, &QPushButton::clicked, this, [this] { set_brush(brush_ + kBrushStep); });
  connect(undo_, &QPushButton::clicked, this, &ProposalReview::undo);
}

void ProposalReview::set_active(bool active) {
  if (active_ && !active) {
    set_tool(Tool::none);
    state_.set_ellipsoids({});
  }
  const bool comes = active && !active_;
  active_ = active;
  for (QShortcut* key : keys_) key->setEnabled(active);
  if (active) list_->setFocus();
  if (comes) return choose(list_->currentRow());
  draw();
}

void ProposalReview::set_marks_hidden(bool hidden) {
  marks_hidden_ = hidden;
  if (!hidden && active_) list_->setFocus();  // the arrows choose again
  draw();
}

const Proposal* ProposalReview::chosen() const {
  const int row = list_->currentRow();
  return shown_ && row >= 0 && row < static_cast<int>(shown_->proposals.size())
             ? &shown_->proposals[static_cast<std::size_t>(row)]
             : nullptr;
}

void ProposalReview::show_case() {
  const engine::CaseState& now = engine_.state();
  const QString first = obstacle_text(engine::obstacle(now, engine::ProposeLandmarks{}));
  propose_->set_obstacle(first.isEmpty() && !choice_.problem().isEmpty() ? tr("Choose an atlas first.")
                                                                         : first);
  if (now[part::proposals] == shown_) return show_chosen();
  const bool is_new = !shown_ || !now[part::proposals] ||
                      shown_->surface.rows() != now[part::proposals]->surface.rows() ||
                      shown_->surface != now[part::proposals]->surface;
  shown_ = now[part::proposals];
  if (is_new) {
    former_.clear();
    set_tool(Tool::none);
  }
  if (const Proposal* one = chosen();
      tool_ == Tool::paint && one != nullptr && !same_points(one->area, painter_->area()))
    painter_->begin(one->area);  // a stroke was taken back
  show_list();
  if (is_new && shown_) {
    list_->setCurrentRow(0);
    choose(0);
    if (active_) list_->setFocus();  // the arrows choose at once
  }
  show_chosen();
}

void ProposalReview::show_list() {
  review_->setVisible(shown_ != nullptr);
  if (!shown_) return;
  QStringList doubts;
  for (const std::string& doubt : shown_->doubts) doubts << note_text(doubt);
  show_warning(*doubts_, doubts.join(QLatin1Char('\n')));
  const int row = list_->currentRow();
  const QSignalBlocker quiet(list_);
  list_->clear();
  for (const Proposal& one : shown_->proposals)
    new QListWidgetItem(
        disc(colour_of(one)),
        QStringLiteral("%1: %2").arg(landmark_text(one.structure), decision_text(one.decision)), list_);
  list_->setCurrentRow(std::clamp(row, 0, std::max(0, list_->count() - 1)));
  list_->setFixedHeight(list_->count() * list_->sizeHintForRow(0) + 2 * list_->frameWidth());
}

void ProposalReview::show_chosen() {
  const Proposal* one = chosen();
  QStringList lines;
  if (is_of_former_model()) lines << tr("Of a former model: propose the landmarks again.");
  if (one != nullptr) lines << reasons_text(engine_.state(), *one);
  if (tool_ == Tool::move)
    lines << tr("Drag it over the liver, or click in a slice. Enter: at the crosshair. Esc: done.");
  if (tool_ == Tool::paint)
    lines << tr("Drag over the liver, in 3D or in a slice, to paint, with Ctrl to wipe. Brush %1 mm (+, "
                "\u2212, "
                "Shift + wheel in a slice). Esc: done.")
                 .arg(1e3 * brush_, 0, 'f', 0);
  reason_->setText(lines.join(QLatin1Char('\n')));
  for (QPushButton* button : {accept_, move_, not_visible_}) button->setEnabled(one != nullptr && is_open());
  paint_->setEnabled(one != nullptr && is_open() && atlas::is_area(one->structure));
  for (QPushButton* button : {thinner_, thicker_}) button->setEnabled(tool_ == Tool::paint);
  undo_->setEnabled(!former_.empty() && is_open());
  draw();
}

bool ProposalReview::is_of_former_model() const {
  const engine::CaseState& now = engine_.state();
  const auto& inputs = now.stamp(part::proposals).made_from;
  const auto model = inputs.find(part::model);
  return model != inputs.end() && model->second != now.stamp(part::model).revision;
}

bool ProposalReview::is_open() const {
  return posted_.empty() && !propose_->is_running() && !is_being_made(engine_, part::model) &&
         !engine::obstacle(engine_.state(), engine::ReviewProposal{});
}

void ProposalReview::choose(int) {
  const Proposal* one = chosen();
  dragging_ = false;  // what a hand holds is another one
  if (tool_ == Tool::paint) set_tool(one != nullptr && atlas::is_area(one->structure) ? tool_ : Tool::none);
  if (one != nullptr && active_)
    state_.set_crosshair(
        Point<CtFrame>(Eigen::Vector3d(one->points.row(one->points.rows() / 2).transpose())));
  show_chosen();
}

void ProposalReview::draw() {
  std::vector<scene::ProposalMark> marks;
  std::vector<scene::EllipsoidMark> in_slices;
  const Proposal* of_interest = chosen();
  if (active_ && shown_ && !marks_hidden_ && !is_of_former_model())
    for (const Proposal& case_has : shown_->proposals) {
      const bool is_chosen = &case_has == of_interest;
      const Proposal one = is_chosen ? as_dragged(case_has) : case_has;
      const bool is_painted = is_chosen && tool_ == Tool::paint;
      marks.push_back({one.points, one.covariances, is_chosen && !is_painted ? one.area : Points(),
                       is_painted ? painter_->faces() : TriangleMesh(), colour_of(one),
                       is_line(one.structure), is_chosen && !is_painted, kEllipsoid95});
      if (is_chosen)
        in_slices = is_painted ? painted_marks(painter_->area(), colour_of(one)) : slice_marks(one);
    }
  if (of_interest != nullptr && !dragging_)
    drag_->set_handles(tool_ == Tool::move ? of_interest->points : Points(0, 3));
  actors_.show(marks);
  if (active_) state_.set_ellipsoids(std::move(in_slices));
  views_.volume().update();
}

Proposal ProposalReview::as_dragged(const Proposal& one) const {
  Proposal shown = one;
  if (dragged_.rows() == 0 || one.structure != dragged_of_) return shown;
  if (!atlas::is_area(one.structure)) {
    shown.points = dragged_;
  } else {
    shown.points.rowwise() += dragged_.colwise().mean() - one.area.colwise().mean();
    shown.area = dragged_;
  }
  return shown;
}

void ProposalReview::decide(Decision decision, const Points& moved) {
  const Proposal* one = chosen();
  if (one == nullptr) return;
  former_.push_back({*one, engine::placed_points(engine_.state(), one->structure),
                     engine::placed_deviations(engine_.state(), one->structure)});
  posted_.insert(engine_.post(engine::ReviewProposal{one->structure, decision, moved, shown_}));
  if (decision != Decision::moved) go_on();
  show_chosen();
}

void ProposalReview::go_on() {
  set_tool(Tool::none);
  for (int step = 1; step < list_->count(); ++step) {
    const int row = (list_->currentRow() + step) % list_->count();
    if (shown_->proposals[static_cast<std::size_t>(row)].decision != Decision::proposed) continue;
    list_->setCurrentRow(row);
    return;
  }
}

void ProposalReview::undo() {
  if (former_.empty() || !is_open()) return;
  const Former last = former_.back();
  former_.pop_back();
  for (std::size_t i = 0; i < shown_->proposals.size(); ++i)
    if (shown_->proposals[i].structure == last.proposal.structure) list_->setCurrentRow(static_cast<int>(i));
  posted_.insert(engine_.post(engine::RestoreReview{last.proposal, last.landmark, last.deviations}));
  show_chosen();
}

void ProposalReview::take_model() {
  const auto& built = engine_.state()[part::model];
  if (built == model_) return;
  model_ = built;
  mover_ = nullptr;
  painter_ = nullptr;
}

void ProposalReview::set_tool(Tool wanted) {
  const Proposal* one = chosen();
  take_model();
  const bool can = one != nullptr && model_ && (wanted != Tool::paint || atlas::is_area(one->structure));
  const Tool tool = can ? wanted : Tool::none;
  if (tool != Tool::none && tool_ == Tool::none) emit tool_taken();
  if (tool != tool_) state_.set_hand(hand_of(tool));
  tool_ = tool;
  dragging_ = false;
  if (posted_.empty()) dragged_.resize(0, 3);
  if (tool_ == Tool::move && !mover_) mover_ = std::make_unique<ProposalMover>(model_->model.surface.mesh);
  uncover();
  if (tool_ == Tool::paint) {
    if (const Label body = neighbour_of(one->structure); views_.volume().patient().is_visible(body)) {
      hidden_ = body;
      views_.volume().patient().set_visible(body, false);
    }
    if (!painter_) painter_ = std::make_unique<AreaPainter>(engine::fine_liver(model_->model));
    painter_->begin(one->area);
    set_brush(brush_);
  }
  drag_->set_on(tool_ != Tool::none);
  emit tool_changed();
  move_->setChecked(tool_ == Tool::move);
  paint_->setChecked(tool_ == Tool::paint);
  here_->setEnabled(tool_ == Tool::move);
  show_chosen();
}

void ProposalReview::uncover() {
  if (hidden_) views_.volume().patient().set_visible(*hidden_, true);
  hidden_.reset();
}

void ProposalReview::move_to(const Eigen::Vector3d& p) {
  const Proposal* one = chosen();
  if (one == nullptr || tool_ != Tool::move || !is_open()) return;
  dragged_of_ = one->structure;
  dragged_ = mover_->moved(*one, ProposalMover::taken(*one, p), p);
  decide(Decision::moved, dragged_);
}

void ProposalReview::begin_drag(const Eigen::Vector3d& p, Qt::KeyboardModifiers keys) {
  const Proposal* one = chosen();
  dragging_ = one != nullptr && is_open();
  if (!dragging_) return;
  taken_ = ProposalMover::taken(*one, p);
  dragged_of_ = one->structure;
  drag(p, keys);
}

void ProposalReview::drag(const Eigen::Vector3d& p, Qt::KeyboardModifiers keys) {
  const Proposal* one = chosen();
  if (!dragging_ || one == nullptr || one->structure != dragged_of_) return;
  if (tool_ == Tool::move) dragged_ = mover_->moved(*one, taken_, p);
  if (tool_ == Tool::paint) {
    painter_->dab(p, brush_, !keys.testFlag(Qt::ControlModifier));
    show_ring(p);
  }
  draw();
}

void ProposalReview::end_drag() {
  if (!dragging_) return;
  dragging_ = false;
  if (tool_ == Tool::paint) return end_painting();
  const Proposal* one = chosen();
  if (one == nullptr || dragged_.rows() == 0 || one->structure != dragged_of_) return;
  const Eigen::Index there = atlas::is_area(one->structure) ? dragged_.rows() / 2 : taken_;
  state_.set_crosshair(Point<CtFrame>(Eigen::Vector3d(dragged_.row(there).transpose())));
  decide(Decision::moved, dragged_);
}

void ProposalReview::end_painting() {
  const Proposal* one = chosen();
  const Points area = painter_->area();
  if (one == nullptr) return;
  if (area.rows() >= kLeastArea) return decide(Decision::moved, area);
  painter_->begin(one->area);  // a contact of nothing is not visible, and there is a button for that
  draw();
}

void ProposalReview::paint_in_slice(const SliceGesture& gesture) {
  const Proposal* one = chosen();
  if (tool_ != Tool::paint || one == nullptr) return;
  if (gesture.phase == SliceGesture::Phase::begin) {
    dragging_ = is_open();
    dragged_of_ = one->structure;
  }
  if (!dragging_) return;
  painter_->dab(gesture.p.xyz, brush_, !gesture.keys.testFlag(Qt::ControlModifier));
  if (gesture.phase == SliceGesture::Phase::end) return end_drag();
  draw();
}

void ProposalReview::show_ring(const Eigen::Vector3d& p) {
  if (tool_ != Tool::paint) return;
  scene::ProposalMark ring;
  ring.points = painter_->ring(p, brush_);
  ring.colour = Qt::white;
  ring.is_line = true;
  ring_.show({ring});
  views_.volume().update();
}

void ProposalReview::hide_ring() {
  if (!shows_ring()) return;
  ring_.show({});
  views_.volume().update();
}

void ProposalReview::set_brush(double radius) {
  brush_ = std::clamp(radius, kBrushStep, 10.0 * kBrushStep);
  if (const Proposal* one = chosen(); one != nullptr && tool_ == Tool::paint)
    state_.set_brush({.radius = brush_, .ball = true, .label = neighbour_of(one->structure)});
  hide_ring();  // it is drawn anew where the pointer goes on
  show_chosen();
}

}  // namespace glisson::ui
