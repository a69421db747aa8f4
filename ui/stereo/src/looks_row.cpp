// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/stereo/looks_row.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "glisson/engine/commands/forget_looks.h"
#include "glisson/engine/commands/keep_look.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/earlier_looks.h"
#include "glisson/ui/common/panel.h"

namespace glisson::ui {

LooksRow::LooksRow(EngineBridge& engine, QWidget* parent) : QWidget(parent), engine_(engine) {
  setObjectName(QStringLiteral("looks_row"));
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  keep_ = new QPushButton(tr("Keep this look"), this);
  keep_->setObjectName(QStringLiteral("keep_look"));
  keep_->setToolTip(
      tr("Keeps these points. Then move the laparoscope, not the organ, and reconstruct again: registration "
         "joins all looks and finds out itself where each was seen from."));
  forget_ = new QPushButton(tr("Forget looks"), this);
  forget_->setObjectName(QStringLiteral("forget_looks"));
  forget_->setToolTip(tr("The organ has moved since: registration goes by the present points alone"));
  row->addWidget(keep_);
  row->addWidget(forget_);
  box->addLayout(row);
  said_ = new QLabel(this);
  said_->setObjectName(QStringLiteral("looks_said"));
  said_->setWordWrap(true);
  set_style_property(said_, "role", "muted");
  said_->setAlignment(Qt::AlignTop);
  said_->setMinimumHeight(2 * said_->fontMetrics().lineSpacing());  // what stands below keeps its place
  box->addWidget(said_);
  connect(keep_, &QPushButton::clicked, this, [this] {
    engine::KeepLook keep;
    keep.seen = engine_.state()[part::cloud];
    engine_.post(keep);
  });
  connect(forget_, &QPushButton::clicked, this, [this] { engine_.post(engine::ForgetLooks{}); });
  connect(&engine_, &EngineBridge::case_changed, this, &LooksRow::show_case);
  show_case();
}

void LooksRow::show_case() {
  const engine::CaseState& now = engine_.state();
  const std::size_t kept = now[part::earlier_looks] ? now[part::earlier_looks]->clouds.size() : 0;
  const std::size_t joined = engine::looks_to_join(now).size();
  // What is kept already would be joined with itself.
  keep_->setEnabled(now[part::cloud] && joined == kept && kept < engine::kMostLooks);
  forget_->setEnabled(kept > 0);
  said_->setText(kept == 0        ? tr("No earlier look is kept.")
                 : joined == kept ? tr("Earlier looks that registration joins: %1").arg(joined)
                                  : tr("Kept. Now look from elsewhere and reconstruct again."));
}

}  // namespace glisson::ui
