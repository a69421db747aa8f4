// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/atlas/shape_modes.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QShortcut>
#include <QSignalBlocker>
#include <QSlider>
#include <QTimer>
#include <QVBoxLayout>
#include <cmath>

#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/proposals.h"
#include "glisson/ui/atlas/bent_liver.h"
#include "glisson/ui/atlas/structure_look.h"
#include "glisson/ui/common/panel.h"

namespace glisson::ui {
namespace {

constexpr int kFirstModes = 5;
constexpr int kSteps = 10;           // of the slider to a deviation
constexpr int kFarthest = 3;         // deviations
const QColor kLiver(196, 148, 108);  // no structure has it

QString signed_text(double value) {
  const QString sign = value > 0.0   ? QStringLiteral("+")
                       : value < 0.0 ? QString(QChar(0x2212))  // as wide as the plus
                                     : QString();
  return sign + QString::number(std::abs(value), 'f', 1);
}

}  // namespace

ShapeModes::ShapeModes(EngineBridge& engine, LinkedViews& views, AtlasChoice& choice, QWidget* parent)
    : QWidget(parent),
      engine_(engine),
      views_(views),
      choice_(choice),
      actors_(views.volume().patient().renderer()) {
  setObjectName(QStringLiteral("shape_modes"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  toggle_ = new QPushButton(tr("Show how livers differ"), this);
  toggle_->setObjectName(QStringLiteral("show_modes"));
  toggle_->setCheckable(true);
  toggle_->setProperty("role", "choice");
  toggle_key_ = new QShortcut(Qt::Key_D, this);
  toggle_key_->setAutoRepeat(false);
  toggle_key_->setEnabled(false);
  toggle_->setToolTip(
      QStringLiteral("%1 (%2)").arg(tr("The atlas' mean liver over the patient's, bent by its first modes"),
                                    toggle_key_->key().toString(QKeySequence::NativeText)));
  connect(toggle_key_, &QShortcut::activated, toggle_, &QPushButton::click);
  connect(toggle_, &QPushButton::clicked, this, &ShapeModes::show_modes);
  layout->addWidget(toggle_);
  controls_ = new QWidget(this);
  controls_->hide();
  layout->addWidget(controls_);
  make_controls();
  caption_ = new QLabel(&views_.volume());
  caption_->setObjectName(QStringLiteral("mode_caption"));
  caption_->setProperty("role", "view-hint");
  caption_->setAttribute(Qt::WA_TransparentForMouseEvents);
  caption_->move(8, 28);  // below the view's title
  caption_->hide();
  connect(&engine_, &EngineBridge::case_changed, this, &ShapeModes::show_case);
  connect(&choice_, &AtlasChoice::changed, this, [this] {
    atlas_ = nullptr;
    if (shown_ && choice_.atlas()) take_atlas();
    show_case();
  });
  show_case();
}

void ShapeModes::make_controls() {
  auto* layout = new QVBoxLayout(controls_);
  layout->setContentsMargins(0, 0, 0, 0);
  mode_ = make_narrow_combo(controls_);
  mode_->setObjectName(QStringLiteral("mode"));
  mode_->setAccessibleName(tr("Mode"));
  layout->addWidget(mode_);
  deviations_ = new QSlider(Qt::Horizontal, controls_);
  deviations_->setObjectName(QStringLiteral("deviations"));
  deviations_->setAccessibleName(tr("Standard deviations from the mean liver"));
  deviations_->setRange(-kFarthest * kSteps, kFarthest * kSteps);
  deviations_->setSingleStep(kSteps / 2);
  deviations_->setPageStep(kSteps);
  deviations_->setTickPosition(QSlider::TicksBelow);
  deviations_->setTickInterval(kSteps);
  layout->addWidget(deviations_);
  layout->addWidget(make_explanation(
      tr("Keys: 1 to 5 choose the mode, the arrows bend, 0 is the mean liver, Esc leaves."), controls_));
  connect(mode_, &QComboBox::currentIndexChanged, this, &ShapeModes::draw);
  connect(deviations_, &QSlider::valueChanged, this, &ShapeModes::draw);
  for (int mode = 0; mode < kFirstModes; ++mode)
    add_key(QKeySequence(Qt::Key_1 + mode), [this, mode] {
      if (mode < mode_->count()) mode_->setCurrentIndex(mode);
    });
  add_key(Qt::Key_0, [this] { deviations_->setValue(0); });
}

void ShapeModes::add_key(const QKeySequence& key, const std::function<void()>& act) {
  auto* shortcut = new QShortcut(key, this);
  shortcut->setEnabled(false);
  connect(shortcut, &QShortcut::activated, this, act);
  keys_.push_back(shortcut);
}

void ShapeModes::set_active(bool active) {
  active_ = active;
  if (!active) show_modes(false);
  toggle_key_->setEnabled(active);
}

void ShapeModes::show_case() {
  const bool can = engine_.state()[part::model] != nullptr && choice_.problem().isEmpty();
  toggle_->setEnabled(can);
  if (!can) show_modes(false);
  if (shown_) draw();
}

void ShapeModes::show_modes(bool on) {
  const bool shown = on && active_ && engine_.state()[part::model] && choice_.problem().isEmpty();
  toggle_->setChecked(shown);
  if (shown == shown_) return;
  shown_ = shown;
  if (shown_ && !atlas_) take_atlas();
  for (QShortcut* key : keys_) key->setEnabled(shown_);
  controls_->setVisible(shown_);
  caption_->setVisible(shown_);
  emit shown_changed(shown_);
  draw();
  if (!shown_) return;
  deviations_->setFocus();
  QTimer::singleShot(0, this, [this] {  // once the panel has grown
    for (QWidget* around = parentWidget(); around != nullptr; around = around->parentWidget())
      if (auto* area = qobject_cast<QScrollArea*>(around)) area->ensureWidgetVisible(controls_, 0, 12);
  });
}

void ShapeModes::take_atlas() {
  atlas_ = choice_.atlas();
  const QSignalBlocker quiet(mode_);
  mode_->clear();
  for (int mode = 0; mode < std::min(kFirstModes, atlas_->shape.mode_count()); ++mode)
    mode_->addItem(tr("Mode %1: %2 % of the variance")
                       .arg(mode + 1)
                       .arg(100.0 * share_of_variance(*atlas_, mode), 0, 'f', 0));
}

void ShapeModes::draw() {
  std::vector<scene::ProposalMark> marks;
  const auto& built = engine_.state()[part::model];
  if (shown_ && built && mode_->currentIndex() >= 0) {
    const int mode = mode_->currentIndex();
    const double deviations = static_cast<double>(deviations_->value()) / kSteps;
    const BentLiver bent = bent_liver(
        *atlas_, mode, deviations,
        patient_from_mean(*atlas_, engine_.state()[part::proposals].get(), built->model.surface.mesh));
    scene::ProposalMark liver;
    liver.faces = bent.surface;
    liver.colour = kLiver;
    marks.push_back(std::move(liver));
    for (const auto& [structure, points] : bent.structures) {
      scene::ProposalMark mark;
      mark.points = points;
      mark.colour = colour_of(structure);
      mark.is_line = points.rows() > 1;
      marks.push_back(std::move(mark));
    }
    caption_->setText(tr("Mean liver of %1 (%2 livers)\nMode %3 at %4 deviations\n%5 % of the variance")
                          .arg(QString::fromStdString(atlas_->name))
                          .arg(atlas_->members.size())
                          .arg(mode + 1)
                          .arg(signed_text(deviations))
                          .arg(100.0 * share_of_variance(*atlas_, mode), 0, 'f', 0));
    caption_->adjustSize();
  }
  actors_.show(marks);
  views_.volume().update();
}

}  // namespace glisson::ui
