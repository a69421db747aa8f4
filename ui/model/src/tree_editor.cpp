// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/model/tree_editor.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QShortcut>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "glisson/engine/commands/edit_trees.h"
#include "glisson/engine/parts/model.h"
#include "glisson/model/quality.h"
#include "glisson/ui/common/being_made.h"
#include "glisson/ui/common/error_texts.h"
#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/texts.h"
#include "glisson/ui/scene/model_surfaces.h"

namespace glisson::ui {
namespace {

using Kind = model::TreeEdit::Kind;

constexpr double kReachPx = 14.0;  // from the pointer to a centreline's node
constexpr double kSeeThrough = 0.3;
constexpr double kCutWidth = 1.5e-3;  // metres: least radius with which a marked branch is drawn

}  // namespace

TreeEditor::TreeEditor(EngineBridge& engine, LinkedViews& views, QWidget* parent)
    : QWidget(parent), engine_(engine), views_(views), tools_(new QButtonGroup(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(5);
  auto* row = new QHBoxLayout;
  const auto add_tool = [&](Kind kind, const QString& text, const QString& tip, const char* name) {
    auto* button = new QPushButton(text, this);
    button->setObjectName(QString::fromLatin1(name));
    button->setCheckable(true);
    button->setToolTip(tip);
    tools_->addButton(button, static_cast<int>(kind));
    row->addWidget(button);
    connect(button, &QPushButton::clicked, this,
            [this, kind](bool on) { choose(on ? std::optional(kind) : std::nullopt); });
  };
  tools_->setExclusive(false);  // pressed again, a tool is put away
  add_tool(Kind::set_root, tr("Entrance"), tr("Where blood enters or leaves the tree; it is held there."),
           "tree_root");
  add_tool(Kind::prune, tr("Prune"), tr("Cuts off a branch with all that hangs on it."), "tree_prune");
  add_tool(Kind::join, tr("Join"), tr("Hangs one tree on another of its kind."), "tree_join");
  layout->addLayout(row);
  auto* steps = new QHBoxLayout;
  undo_ = new QPushButton(tr("Undo"), this);
  undo_->setObjectName(QStringLiteral("tree_undo"));
  redo_ = new QPushButton(tr("Redo"), this);
  redo_->setObjectName(QStringLiteral("tree_redo"));
  steps->addWidget(undo_);
  steps->addWidget(redo_);
  steps->addStretch(1);
  layout->addLayout(steps);
  message_ = make_explanation({}, this);
  message_->setObjectName(QStringLiteral("tree_message"));
  layout->addWidget(message_);
  escape_ = new QShortcut(Qt::Key_Escape, this);
  escape_->setEnabled(false);
  connect(escape_, &QShortcut::activated, this, &TreeEditor::leave);
  connect(undo_, &QPushButton::clicked, this, [this] {
    if (!shown_ || shown_->tree_edits.empty()) return;
    std::vector<model::TreeEdit> edits = shown_->tree_edits, undone = undone_;
    undone.push_back(edits.back());
    edits.pop_back();
    post(std::move(edits), std::move(undone));
  });
  connect(redo_, &QPushButton::clicked, this, [this] {
    if (!shown_ || undone_.empty()) return;
    std::vector<model::TreeEdit> edits = shown_->tree_edits, undone = undone_;
    edits.push_back(undone.back());
    undone.pop_back();
    post(std::move(edits), std::move(undone));
  });
  connect(&engine_, &EngineBridge::case_changed, this, &TreeEditor::show_case);
  connect(&engine_, &EngineBridge::finished, this, &TreeEditor::take);
  show_case();
}

QAbstractButton* TreeEditor::tool_button(Kind kind) const { return tools_->button(static_cast<int>(kind)); }

void TreeEditor::leave() { choose(std::nullopt); }

void TreeEditor::choose(std::optional<Kind> tool) {
  const bool was_on = is_on();
  tool_ = tool;
  first_.reset();
  for (QAbstractButton* button : tools_->buttons())
    button->setChecked(tool && tools_->id(button) == static_cast<int>(*tool));
  escape_->setEnabled(is_on());
  scene::PatientScene& scene = views_.volume().patient();
  scene.set_pull(std::nullopt);
  if (was_on != is_on()) {
    // The centrelines lie inside the vessels: those are seen through meanwhile.
    scene.set_skeleton_visible(is_on());
    for (const Label vessel : {structure::kPortalVein, structure::kHepaticVeins, structure::kArtery})
      scene.set_opacity(vessel, is_on() ? kSeeThrough : 1.0);
    views_.volume().set_taken(this, is_on());
    is_on() ? views_.volume().installEventFilter(this) : views_.volume().removeEventFilter(this);
    is_on() ? views_.volume().setCursor(Qt::PointingHandCursor) : views_.volume().unsetCursor();
    views_.volume().setMouseTracking(is_on());
  }
  if (was_on || is_on()) scene.set_highlight({});
  views_.volume().update();
  show_message(instruction());
  if (is_on() && !was_on) emit began();
}

QString TreeEditor::instruction() const {
  if (!tool_) return {};
  switch (*tool_) {
    case Kind::set_root:
      return tr(
          "Click the place on a centreline where its tree is to enter. White balls are the entrances "
          "now. Esc ends.");
    case Kind::prune:
      return tr("Point at the branch that is to go: what a click cuts off is marked. Esc ends.");
    case Kind::join:
      break;
  }
  return first_ ? tr("Now click the other tree, where it is to hang on.")
                : tr("Click the tree that stays, then the one that is to hang on it. Esc ends.");
}

void TreeEditor::show_case() {
  const auto now = engine_.state()[part::model];
  if (now != shown_) {
    // What was undone can be redone only on the trees as this editor left them.
    if (!now || !expected_ || now->tree_edits != *expected_) undone_.clear(), undone_before_.clear();
    expected_.reset();
    if (first_) {  // its tree may be gone
      first_.reset();
      views_.volume().patient().set_pull(std::nullopt);
    }
  }
  shown_ = now;
  if (is_on() && (!shown_ || shown_->model.vessels.empty())) leave();
  setEnabled(shown_ && !(shown_->model.vessels.empty() && shown_->tree_edits.empty()));
  for (QAbstractButton* button : tools_->buttons())
    button->setEnabled(shown_ && !shown_->model.vessels.empty());
  undo_->setEnabled(shown_ && !shown_->tree_edits.empty());
  redo_->setEnabled(shown_ && !undone_.empty());
}

void TreeEditor::show_message(const QString& sentence, bool is_problem) {
  message_->setText(sentence);
  message_->setVisible(!sentence.isEmpty());
  set_style_property(message_, "role", is_problem ? QStringLiteral("error") : QStringLiteral("explanation"));
}

void TreeEditor::take(const engine::Outcome& outcome) {
  if (!posted_ || outcome.id != *posted_) return;
  posted_.reset();
  if (outcome.status == engine::Status::done) {
    show_message(instruction());
  } else {
    expected_.reset();
    undone_ = undone_before_;
    show_message(error_text(outcome.error), true);
  }
  show_case();
}

QString TreeEditor::described(const VesselTree& tree) {
  const model::TreeSummary summary = model::tree_summary(tree);
  return tr("%1, %2 mm, tips: %3.")
      .arg(structure_text(summary.structure))
      .arg(1e3 * summary.length, 0, 'f', 0)
      .arg(summary.tips);
}

std::optional<Eigen::Vector3d> TreeEditor::node_at(const QPointF& at) const {
  const RenderView& view = views_.volume();
  std::optional<Eigen::Vector3d> best;
  double least = kReachPx;
  for (const VesselTree& tree : shown_->model.vessels)
    for (Eigen::Index i = 0; i < tree.nodes.rows(); ++i) {
      const Eigen::Vector3d node = tree.nodes.row(i).transpose();
      const auto place = views_.volume().patient().view_point(node, view.aspect());
      if (!place) continue;
      const double far = std::hypot(place->x() * view.width() - at.x(), place->y() * view.height() - at.y());
      if (far >= least) continue;
      least = far;
      best = node;
    }
  return best;
}

std::optional<Eigen::Vector3d> TreeEditor::centreline_at(const QPointF& at) const {
  const RenderView& view = views_.volume();
  const auto on_screen = [&](const Eigen::Vector3d& p) -> std::optional<Eigen::Vector2d> {
    const auto place = views_.volume().patient().view_point(p, view.aspect());
    if (!place) return std::nullopt;
    return Eigen::Vector2d(place->x() * view.width(), place->y() * view.height());
  };
  const Eigen::Vector2d pointer(at.x(), at.y());
  std::optional<Eigen::Vector3d> best;
  double least = kReachPx;
  for (const VesselTree& tree : shown_->model.vessels)
    for (const auto& [from, to] : tree.beams) {
      const Eigen::Vector3d a = tree.nodes.row(from).transpose(), b = tree.nodes.row(to).transpose();
      const auto p = on_screen(a), q = on_screen(b);
      if (!p || !q) continue;
      const Eigen::Vector2d along = *q - *p;
      const double squared = along.squaredNorm();
      const double share = squared > 0.0 ? std::clamp((pointer - *p).dot(along) / squared, 0.0, 1.0) : 0.0;
      const double far = (*p + share * along - pointer).norm();
      if (far >= least) continue;
      least = far;
      best = a + share * (b - a);
    }
  return best;
}

void TreeEditor::mark(VesselTree part) {
  for (double& radius : part.radii) radius = std::max(kCutWidth, radius);
  views_.volume().patient().set_highlight(part.beams.empty() ? TriangleMesh() : scene::tube_mesh(part));
  views_.volume().update();
}

void TreeEditor::hover(const std::optional<Eigen::Vector3d>& place) {
  if (!place) {
    mark({});
    show_message(instruction());
  } else if (*tool_ == Kind::prune) {
    show_cut(*place);
  } else {
    show_join(*place);
  }
}

void TreeEditor::show_cut(const Eigen::Vector3d& place) {
  const model::Pruning cut = model::pruning_at(shown_->model.vessels, place);
  const QString what = described(cut.part);
  show_message(cut.whole_tree ? tr("A click here takes the whole tree: %1").arg(what)
                              : tr("A click here cuts off: %1").arg(what));
  mark(cut.part);
}

void TreeEditor::show_join(const Eigen::Vector3d& place) {
  const std::vector<VesselTree>& trees = shown_->model.vessels;
  const model::Joining join = model::joining_at(trees, first_.value_or(place), place);
  const VesselTree &stays = trees[join.stays], &hangs = trees[join.hangs];
  if (!first_) {
    show_message(tr("A click here lets this tree stay: %1").arg(described(stays)));
    mark(stays);
    return;
  }
  switch (join.obstacle) {
    case model::Joining::Obstacle::none:
      show_message(tr("A click here hangs this on the tree that stays, %1 mm away: %2")
                       .arg(1e3 * join.link, 0, 'f', 0)
                       .arg(described(hangs)));
      break;
    case model::Joining::Obstacle::one_tree:
      show_message(tr("This is the tree that stays. Point at another one."));
      break;
    case model::Joining::Obstacle::two_kinds:
      show_message(tr("Trees of one kind are joined: the one that stays is %1, this is %2.")
                       .arg(structure_text(stays.structure), structure_text(hangs.structure)));
      break;
    case model::Joining::Obstacle::too_far:
      show_message(
          tr("%1 mm from the place that was clicked: too far to join.").arg(1e3 * join.link, 0, 'f', 0));
      break;
  }
  mark(join.part);
}

bool TreeEditor::eventFilter(QObject* watched, QEvent* event) {
  const auto* mouse = dynamic_cast<QMouseEvent*>(event);
  if (watched != &views_.volume() || mouse == nullptr || !tool_ || !shown_)
    return QWidget::eventFilter(watched, event);
  const auto place_at = [&] {
    return *tool_ == Kind::prune ? centreline_at(mouse->position()) : node_at(mouse->position());
  };
  const bool hovers = event->type() == QEvent::MouseMove && mouse->buttons() == Qt::NoButton;
  if (hovers && !posted_ && *tool_ != Kind::set_root) hover(place_at());
  if (event->type() != QEvent::MouseButtonPress || mouse->button() != Qt::LeftButton) return false;
  const auto place = place_at();
  if (!place) return false;  // the camera turns
  if (!posted_) click(*place);
  return true;
}

void TreeEditor::click(const Eigen::Vector3d& place) {
  model::TreeEdit edit{*tool_, place};
  if (*tool_ == Kind::join) {
    if (!first_) {
      first_ = place;
      views_.volume().patient().set_pull(scene::PatientScene::Pull{place, place});
      views_.volume().update();
      show_message(instruction());
      return;
    }
    edit.at = *first_;
    edit.to = place;
    first_.reset();
    views_.volume().patient().set_pull(std::nullopt);
  }
  views_.volume().patient().set_highlight({});
  std::vector<model::TreeEdit> edits = shown_->tree_edits;
  edits.push_back(edit);
  post(std::move(edits), {});
}

void TreeEditor::post(std::vector<model::TreeEdit> edits, std::vector<model::TreeEdit> undone) {
  if (is_being_made(engine_, part::model)) return show_message(model_wait_text());
  expected_ = edits;
  undone_before_ = std::exchange(undone_, std::move(undone));
  posted_ = engine_.post(engine::EditTrees{std::move(edits), shown_});
  undo_->setEnabled(false);
  redo_->setEnabled(false);
}

}  // namespace glisson::ui
