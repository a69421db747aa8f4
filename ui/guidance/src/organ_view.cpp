// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/organ_view.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>

#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/guidance/lesion_judge.h"
#include "glisson/ui/common/panel.h"

namespace glisson::ui {
namespace {

/// What the colours stand for.
class ErrorScale : public QWidget {
 public:
  explicit ErrorScale(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("error_scale"));
    setFixedSize(290, 40);
  }
  void set_range(const scene::ErrorRange& range) {
    range_ = range;
    update();
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    constexpr int kLeft = 14, kTop = 4, kHeight = 12, kSteps = 3;
    const int wide = width() - 3 * kLeft - 26;  // the last number hangs over
    for (int x = 0; x < wide; ++x)
      painter.fillRect(kLeft + x, kTop, 1, kHeight,
                       scene::error_colour(scene::kMostErrorShown * x / (wide - 1)));
    painter.setPen(palette().color(QPalette::WindowText));
    const bool usual = range_ == scene::ErrorRange();
    for (int k = 0; k <= kSteps; ++k) {
      const double mm = 1e3 * (range_.low + (range_.high - range_.low) * k / kSteps);
      const QString number = QString::number(mm, 'f', usual ? 0 : 1);
      const QString text = k < kSteps ? number
                           : usual    ? OrganView::tr("%1+ mm").arg(number)
                                      : OrganView::tr("%1 mm").arg(number);
      const int x = kLeft + wide * k / kSteps;
      painter.drawText(QRect(x - 40, kTop + kHeight + 2, 80, 20), Qt::AlignHCenter | Qt::AlignTop, text);
    }
  }

 private:
  scene::ErrorRange range_;
};

}  // namespace

OrganView::OrganView(EngineBridge& engine, DrawableSource& drawables, RegistrationModel& model,
                     QWidget* parent)
    : QWidget(parent),
      engine_(engine),
      drawables_(drawables),
      model_(model),
      view_(new RenderView(this)),
      scale_(new QWidget(this)),
      actors_(std::make_unique<scene::RegistrationActors>(view_->patient().renderer())) {
  setObjectName(QStringLiteral("organ_view"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  view_->set_hint(tr("Register the model: the organ appears here, as it was found."));
  layout->addWidget(view_, 1);
  scale_->setProperty("role", "probe");
  auto* row = new QHBoxLayout(scale_);
  row->setContentsMargins(10, 4, 10, 4);
  auto* words = new QLabel(scale_);
  words->setObjectName(QStringLiteral("organ_words"));
  words->setWordWrap(true);
  row->addWidget(words, 1);
  auto* colours = new QComboBox(scale_);
  colours->setObjectName(QStringLiteral("organ_colours"));
  colours->setToolTip(
      tr("Expected error of each place; or of a lesion, once the surface around a place has been "
         "seen as well. The ball marks the best place."));
  auto* legend = new QWidget(scale_);
  auto* column = new QVBoxLayout(legend);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(colours);
  auto* scale = new ErrorScale(legend);
  column->addWidget(scale);
  QSizePolicy kept = legend->sizePolicy();
  kept.setRetainSizeWhenHidden(true);  // the organ keeps its place
  legend->setSizePolicy(kept);
  row->addWidget(legend);
  layout->addWidget(scale_);
  connect(&engine_, &EngineBridge::case_changed, this, &OrganView::refresh);
  connect(&drawables_, &DrawableSource::changed, this, &OrganView::refresh);
  couplings_.add(model_.shown_rival, [this](int) { refresh(); });
  connect(colours, &QComboBox::activated, this, [this](int index) { model_.shown_look = index - 1; });
  couplings_.add(model_.looked_for, [colours](const QStringList& lesions) {
    colours->clear();
    colours->addItem(tr("Error here"));
    for (const QString& lesion : lesions) colours->addItem(tr("%1 after a look here").arg(lesion));
    colours->setVisible(!lesions.isEmpty());
  });
  couplings_.add(model_.shown_look, [this, colours, scale](int which) {
    colours->setCurrentIndex(which + 1);
    const auto& now = engine_.state()[part::registration];
    const auto look = static_cast<std::size_t>(which);
    scale->set_range(which >= 0 && now && look < now->looks.size() ? scene::look_range(now->looks[look])
                                                                   : scene::ErrorRange());
    refresh();
  });
  couplings_.add(model_.holds, [this, legend, words](bool holds) {
    legend->setVisible(holds);  // nothing has these colours then
    set_style_property(words, "role", holds ? QVariant() : QVariant(QStringLiteral("warning")));
    refresh();
  });
  couplings_.add(model_.error_words, [words](const QString& text) { words->setText(text); });
}

OrganView::~OrganView() = default;

void OrganView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  refresh();
}

void OrganView::refresh() {
  if (!isVisible()) return;
  const engine::CaseState& now = engine_.state();
  const auto& registration = now[part::registration];
  const auto& drawable = drawables_.drawable();
  const bool is_there = registration && drawable && now[part::model] &&
                        registration->nodes_in_camera.rows() == drawable->model->mesh.vertex_count();
  scale_->setVisible(is_there);
  view_->set_hint(is_there ? QString() : tr("Register the model: the organ appears here, as it was found."));
  scene::PatientScene& patient = view_->patient();
  if (!is_there) {
    actors_->clear();
    patient.set_model(nullptr);
    patient.set_cloud({});
    drawn_ = nullptr;
    view_->update();
    return;
  }
  if (drawn_ != drawable) {
    patient.set_model(drawable);
    patient.set_visible(structure::kParenchyma, false);  // drawn by the actors, in the error's colours
    drawn_ = drawable;
  }
  patient.set_nodes(registration->nodes_in_camera);
  patient.set_cloud(now[part::cloud] ? *now[part::cloud] : LabelledCloud());
  const guidance::LesionJudge judge(*drawable->model, *registration);
  actors_->show(*drawable, *registration, judge.at_start(Validity::valid),
                {model_.shown_rival, model_.shown_look, model_.holds});
  if (looked_at_ != registration) patient.look_from(scene::ViewFrom::camera);
  looked_at_ = registration;
  view_->update();
}

}  // namespace glisson::ui
