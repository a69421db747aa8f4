// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/atlas/proposal_review.h"

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
#include "glisson/ui/atlas/move_proposal.h"
#include "glisson/ui/atlas/structure_look.h"
#include "glisson/ui/common/atlas_texts.h"
#include "glisson/ui/common/built_in_atlas.h"
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

}  // namespace

ProposalReview::ProposalReview(EngineBridge& engine, LinkedViews& views, ViewState& state, QWidget* parent)
    : QWidget(parent),
      engine_(engine),
      views_(views),
      state_(state),
      actors_(views.volume().patient().renderer()) {
  setObjectName(QStringLiteral("proposal_review"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  propose_ = new TaskButton(
      engine_, tr("Propose landmarks"),
      []() -> std::optional<engine::Command> { return engine::ProposeLandmarks{built_in_atlas()}; }, this);
  propose_->setObjectName(QStringLiteral("propose_landmarks"));
  layout->addWidget(propose_);
  review_ = new QWidget(this);
  layout->addWidget(review_);
  make_list();
  connect(&engine_, &EngineBridge::case_changed, this, &ProposalReview::show_case);
  connect(&engine_, &EngineBridge::finished, this, [this](const engine::Outcome& outcome) {
    if (posted_.erase(outcome.id) > 0) show_case();
    show_chosen();
  });
  connect(&engine_, &EngineBridge::tasks_changed, this, &ProposalReview::show_chosen);
  connect(&views_.volume(), &RenderView::clicked, this, [this](double x, double y) {
    if (!moving_) return;
    if (const auto p = views_.surface_point(x, y)) move_to(*p);
  });
  connect(&state_, &ViewState::picked, this, [this](const Point<CtFrame>& p) {
    if (moving_) move_to(p.xyz);
  });
  show_list();
  show_case();
}

QPushButton* ProposalReview::add_button(const QString& text, const QString& explanation,
                                        const QKeySequence& key) {
  auto* button = new QPushButton(text, this);
  button->setToolTip(QStringLiteral("%1 (%2)").arg(explanation, key.toString(QKeySequence::NativeText)));
  auto* shortcut = new QShortcut(key, this);
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
  move_ = add_button(tr("Move"), tr("Click where it lies, on the liver in 3D or in a slice"), Qt::Key_M);
  not_visible_ = add_button(tr("Not visible"), tr("The proposal is not used; what the CT itself shows stays"),
                            Qt::Key_N);
  undo_ = add_button(tr("Undo"), tr("Take the last step of the review back"), Qt::Key_U);
  accept_->setObjectName(QStringLiteral("accept_proposal"));
  move_->setObjectName(QStringLiteral("move_proposal"));
  not_visible_->setObjectName(QStringLiteral("not_visible_proposal"));
  undo_->setObjectName(QStringLiteral("undo_review"));
  for (QShortcut* key : keys_) key->setEnabled(false);
  move_->setCheckable(true);
  move_->setProperty("role", "choice");
  auto* row = new QHBoxLayout;
  for (QPushButton* button : {accept_, move_, not_visible_, undo_}) row->addWidget(button);
  layout->addLayout(row);
  layout->addWidget(reason_);  // below: its lines come and go, the buttons stay under the pointer
  connect(list_, &QListWidget::currentRowChanged, this, &ProposalReview::choose);
  connect(accept_, &QPushButton::clicked, this, [this] { decide(Decision::accepted); });
  connect(not_visible_, &QPushButton::clicked, this, [this] { decide(Decision::not_visible); });
  connect(move_, &QPushButton::clicked, this, &ProposalReview::set_moving);
  connect(undo_, &QPushButton::clicked, this, &ProposalReview::undo);
}

void ProposalReview::set_active(bool active) {
  if (active_ && !active) {
    set_moving(false);
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
  propose_->set_obstacle(obstacle_text(engine::obstacle(now, engine::ProposeLandmarks{})));
  if (now[part::proposals] == shown_) return show_chosen();
  const bool is_new = !shown_ || !now[part::proposals] ||
                      shown_->surface.rows() != now[part::proposals]->surface.rows() ||
                      shown_->surface != now[part::proposals]->surface;
  shown_ = now[part::proposals];
  if (is_new) {
    former_.clear();
    set_moving(false);
  }
  show_list();
  if (is_new && shown_) {
    list_->setCurrentRow(0);
    choose(0);
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
  reason_->setText(one == nullptr ? QString() : reason_text(*one));
  for (QPushButton* button : {accept_, move_, not_visible_}) button->setEnabled(one != nullptr && is_open());
  undo_->setEnabled(!former_.empty() && is_open());
  draw();
}

bool ProposalReview::is_open() const {
  return posted_.empty() && !propose_->is_running() &&
         !engine::obstacle(engine_.state(), engine::ReviewProposal{});
}

void ProposalReview::choose(int) {
  const Proposal* one = chosen();
  if (one != nullptr && active_)
    state_.set_crosshair(
        Point<CtFrame>(Eigen::Vector3d(one->points.row(one->points.rows() / 2).transpose())));
  show_chosen();
}

void ProposalReview::draw() {
  std::vector<scene::ProposalMark> marks;
  std::vector<scene::EllipsoidMark> in_slices;
  const Proposal* of_interest = chosen();
  if (active_ && shown_ && !marks_hidden_)
    for (const Proposal& one : shown_->proposals) {
      const bool is_chosen = &one == of_interest;
      marks.push_back({one.points,
                       one.covariances,
                       is_chosen ? one.area : Points(),
                       {},
                       colour_of(one),
                       is_line(one.structure),
                       is_chosen,
                       kEllipsoid95});
      if (is_chosen) in_slices = slice_marks(one);
    }
  actors_.show(marks);
  if (active_) state_.set_ellipsoids(std::move(in_slices));
  views_.volume().update();
}

void ProposalReview::decide(Decision decision, const Points& moved) {
  const Proposal* one = chosen();
  if (one == nullptr) return;
  former_.push_back({*one, engine::placed_points(engine_.state(), one->structure)});
  posted_.insert(engine_.post(engine::ReviewProposal{one->structure, decision, moved}));
  if (decision != Decision::moved) go_on();
  show_chosen();
}

void ProposalReview::go_on() {
  set_moving(false);
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
  posted_.insert(engine_.post(engine::RestoreReview{last.proposal, last.landmark}));
  show_chosen();
}

void ProposalReview::set_moving(bool on) {
  const bool can = on && chosen() != nullptr;
  if (can && !moving_) emit moving_began();
  if (moving_ != can) state_.set_hand(can ? Hand::point : Hand::crosshair);
  moving_ = can;
  move_->setChecked(can);
  views_.volume().setCursor(can ? Qt::CrossCursor : Qt::ArrowCursor);
}

void ProposalReview::move_to(const Eigen::Vector3d& p) {
  const Proposal* one = chosen();
  const auto& built = engine_.state()[part::model];
  if (one == nullptr || !built || !is_open()) return;
  decide(Decision::moved, moved_points(*one, p, built->model.surface.mesh));
}

}  // namespace glisson::ui
