// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/stereo/calibration_results.h"

#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <cmath>
#include <numbers>

#include "glisson/engine/commands/calibrate_rig.h"
#include "glisson/ui/common/panel.h"

namespace glisson::ui {
namespace {

const QColor kProposed(230, 159, 0);  ///< orange, as in the picture, light enough for a dark table
constexpr int kRowsInSight = 9;

QString number(double value, int decimals) {
  return std::isfinite(value) ? QString::number(value, 'f', decimals) : QStringLiteral("–");
}

}  // namespace

CoverageView::CoverageView(QWidget* parent) : PictureView(tr("Covered by boards, left and right"), parent) {
  setToolTip(
      tr("Shaded: where a board lay. What no board has covered is extrapolated. Blue: views used, "
         "orange: proposed for removal or left out. The chosen view is brought out."));
}

void CoverageView::set_sheet(std::shared_ptr<const engine::CalibrationSheet> sheet) {
  sheet_ = std::move(sheet);
  view_ = -1;
  set_picture(sheet_ ? sheet_->coverage : Picture());
}

void CoverageView::bring_out(int view) {
  view_ = view;
  update();
}

void CoverageView::paint_over(QPainter& painter) {
  if (!sheet_ || view_ < 0) return;
  const stereo::BoardView& board = sheet_->views->views()[static_cast<std::size_t>(view_)];
  const double scale = static_cast<double>(stereo::kCoverageWidth) / sheet_->views->width();
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(20, 20, 20));
  for (const bool left : {true, false}) {
    const double shift = left ? 0.0 : stereo::kCoverageWidth + stereo::kCoverageGap;
    for (const Eigen::Vector2d& corner : (left ? board.left : board.right).pixels)
      painter.drawEllipse(widget_point(scale * corner + Eigen::Vector2d(shift, 0.0)), 2.5, 2.5);
  }
}

CalibrationResults::CalibrationResults(QWidget* parent) : QWidget(parent) {
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  coverage_ = new CoverageView(this);
  coverage_->setObjectName(QStringLiteral("calibration_coverage"));
  coverage_->setMinimumWidth(560);
  coverage_->setFixedHeight(216);
  box->addWidget(coverage_);
  views_ = new QTreeWidget(this);
  views_->setObjectName(QStringLiteral("calibration_views"));
  views_->setAccessibleName(tr("Views of the board"));
  views_->setRootIsDecorated(false);
  views_->setUniformRowHeights(true);
  views_->setAllColumnsShowFocus(true);
  views_->setHeaderLabels(
      {tr("View"), tr("Left, px"), tr("Right, px"), tr("Rows off, px"), tr("Distance, mm"), tr("Tilt, °")});
  const QTreeWidgetItem* head = views_->headerItem();
  views_->headerItem()->setToolTip(left, tr("Error of the corners in the left picture, rms"));
  views_->headerItem()->setToolTip(right, tr("Error of the corners in the right picture, rms"));
  views_->headerItem()->setToolTip(
      rows, tr("How far the view's rows disagree by a calibration that has not seen it, rms"));
  views_->header()->setStretchLastSection(false);
  views_->header()->setSectionsClickable(false);
  for (int column = 0; column < head->columnCount(); ++column) {
    views_->header()->setSectionResizeMode(
        column, column == name ? QHeaderView::Stretch : QHeaderView::ResizeToContents);
    if (column != name) views_->headerItem()->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
  }
  views_->setMinimumHeight(views_->header()->sizeHint().height() +
                           kRowsInSight * (views_->fontMetrics().height() + 7));
  box->addWidget(views_, 1);
  box->addWidget(make_explanation(tr("Views that fit far worse than the others come without a tick. Untick "
                                     "what is blurred or was moved."),
                                  this));
  connect(views_, &QTreeWidget::itemChanged, this, &CalibrationResults::ticks_changed);
  connect(views_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
    coverage_->bring_out(item == nullptr ? -1 : views_->indexOfTopLevelItem(item));
  });
}

QTreeWidgetItem* CalibrationResults::make_row(std::size_t view) const {
  const stereo::ViewReport& report = sheet_->calibration.views[view];
  const bool proposed = report.outlier && report.used;
  auto* row = new QTreeWidgetItem({QString::fromStdString(report.name), number(report.left_rms, 2),
                                   number(report.right_rms, 2), number(report.epipolar_left_out, 2),
                                   number(1e3 * report.distance, 0),
                                   number(report.tilt * 180.0 / std::numbers::pi, 0)});
  row->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
  row->setCheckState(name, report.used && !report.outlier ? Qt::Checked : Qt::Unchecked);
  for (int column = left; column <= tilt; ++column)
    row->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
  if (!proposed) return row;
  for (int column = name; column <= tilt; ++column) {
    row->setForeground(column, kProposed);
    row->setToolTip(column, tr("Fits far worse than the others: proposed for removal"));
  }
  return row;
}

void CalibrationResults::set_sheet(std::shared_ptr<const engine::CalibrationSheet> sheet) {
  sheet_ = std::move(sheet);
  coverage_->set_sheet(sheet_);
  {
    const QSignalBlocker quiet(views_);
    views_->clear();
    for (std::size_t i = 0; sheet_ && i < sheet_->calibration.views.size(); ++i)
      views_->addTopLevelItem(make_row(i));
  }
  setVisible(sheet_ != nullptr);
  emit ticks_changed();
}

std::vector<std::string> CalibrationResults::unticked() const {
  std::vector<std::string> names;
  for (int i = 0; i < views_->topLevelItemCount(); ++i)
    if (views_->topLevelItem(i)->checkState(name) != Qt::Checked)
      names.push_back(sheet_->calibration.views[static_cast<std::size_t>(i)].name);
  return names;
}

bool CalibrationResults::differs() const {
  for (int i = 0; i < views_->topLevelItemCount(); ++i)
    if ((views_->topLevelItem(i)->checkState(name) == Qt::Checked) !=
        sheet_->calibration.views[static_cast<std::size_t>(i)].used)
      return true;
  return false;
}

}  // namespace glisson::ui
