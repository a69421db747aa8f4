// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/segmentation/bridge_list.h"

#include <QLabel>
#include <QListWidget>
#include <QVBoxLayout>

#include "glisson/engine/parts/labels.h"
#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/texts.h"

namespace glisson::ui {
namespace {

/// On the thread.
Cancellable<BridgeList::Found> look(const std::shared_ptr<const LabelMap>& labels,
                                    const RunContext& context) {
  BridgeList::Found found{editing::find_bridges(*labels), {}};
  if (context.cancelled()) return std::nullopt;
  found.joints = editing::find_joined(*labels);
  return found;
}

}  // namespace

BridgeList::BridgeList(EditSession& session, EngineBridge& engine, ViewState& views, QWidget* parent)
    : QWidget(parent),
      engine_(engine),
      views_(views),
      looking_(this, look, [this](const auto& of, const auto& found) { accept(of, *found); }) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(5);
  state_ = make_explanation({}, this);
  column->addWidget(state_);
  list_ = new QListWidget(this);
  list_->setObjectName(QStringLiteral("bridges"));
  list_->setFixedHeight(96);
  column->addWidget(list_);
  const auto go = [this](int row) {
    if (row >= 0 && row < static_cast<int>(places_.size()))
      views_.set_crosshair(places_[static_cast<std::size_t>(row)]);
  };
  connect(list_, &QListWidget::currentRowChanged, this, go);
  connect(list_, &QListWidget::itemClicked, this, [this, go] { go(list_->currentRow()); });
  connect(&engine_, &EngineBridge::case_changed, this, &BridgeList::order);
  connect(&session, &EditSession::tool_changed, this, [this, &session] {
    const EditTool tool = session.tool();
    setVisible(tool != nullptr && tool->at_pointer == WindowTool::AtPointer::branch);
  });
  hide();
}

void BridgeList::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  order();
}

void BridgeList::order() {
  const auto& labels = engine_.state()[part::labels];
  if (!isVisible() || labels == wanted_) return;
  wanted_ = labels;
  list_->clear();  // places of the former labels, or of another patient's
  places_.clear();
  state_->setText(labels ? tr("Looking for places where the trees touch…") : QString());
  if (labels)
    looking_.give_instead(labels);
  else
    looking_.cancel();
}

void BridgeList::accept(const std::shared_ptr<const LabelMap>& of, const Found& found) {
  if (of != wanted_) return;  // newer labels are being looked at
  for (const editing::Bridge& bridge : found.bridges) {
    list_->addItem(tr("The trees touch: %1 mm²").arg(bridge.contact_mm2, 0, 'f', 0));
    places_.push_back(bridge.p_in_ct);
  }
  for (const editing::Joint& joint : found.joints) {
    list_->addItem(new QListWidgetItem(structure_icon(joint.tree), tr("A neck of %1 mm², %2 ml beyond it")
                                                                       .arg(joint.neck_mm2, 0, 'f', 0)
                                                                       .arg(joint.beyond_ml, 0, 'f', 1)));
    places_.push_back(joint.p_in_ct);
  }
  state_->setText(places_.empty()
                      ? tr("The trees touch nowhere, and no part hangs by a neck.")
                      : tr("Suspicious places. Click one to go there; cut where the branch is wrong."));
}

}  // namespace glisson::ui
