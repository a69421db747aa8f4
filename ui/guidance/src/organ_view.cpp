// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/organ_view.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>

#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/guidance/lesion_judge.h"
#include "glisson/ui/common/panel.h"

namespace glisson::ui {
namespace {

constexpr int kPace = 300;  ///< milliseconds: how old the organ is at the most, beside a live picture

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
                     LiveViewModel& live, QWidget* parent)
    : QWidget(parent),
      engine_(engine),
      drawables_(drawables),
      model_(model),
      live_(live),
      view_(new RenderView(this)),
      scale_(new QWidget(this)),
      legend_(new QWidget(scale_)),
      actors_(std::make_unique<scene::RegistrationActors>(view_->patient().renderer())) {
  setObjectName(QStringLiteral("organ_view"));
  around_ = new QVBoxLayout(this);
  around_->setContentsMargins(0, 0, 0, 0);
  around_->setSpacing(0);
  view_->set_hint(nothing_words());
  around_->addWidget(view_, 1);
  scale_->setProperty("role", "probe");
  words_and_legend_ = new QHBoxLayout(scale_);
  words_and_legend_->setContentsMargins(10, 4, 10, 4);
  auto* words = new QLabel(scale_);
  words->setObjectName(QStringLiteral("organ_words"));
  words->setWordWrap(true);
  words_and_legend_->addWidget(words, 1);
  QSizePolicy kept = legend_->sizePolicy();
  kept.setRetainSizeWhenHidden(true);  // the organ keeps its place
  legend_->setSizePolicy(kept);
  words_and_legend_->addWidget(legend_);
  around_->addWidget(scale_);
  connect(&engine_, &EngineBridge::case_changed, this, &OrganView::refresh);
  connect(&drawables_, &DrawableSource::changed, this, &OrganView::refresh);
  pace_.setSingleShot(true);
  pace_.setInterval(kPace);
  connect(&pace_, &QTimer::timeout, this, &OrganView::refresh);
  connect(&live_, &LiveViewModel::picture_changed, this, [this] {
    if (isVisible() && !pace_.isActive()) pace_.start();
  });
  connect(view_, &RenderView::clicked, this, &OrganView::choose_at);
  couplings_.add(live_.chosen, [this](Label) { refresh(); });
  join_model(*words);
}

void OrganView::join_model(QLabel& words) {
  auto* colours = new QComboBox(scale_);
  colours->setObjectName(QStringLiteral("organ_colours"));
  colours->setToolTip(
      tr("Expected error of each place; or of a lesion, once the surface around a place has been "
         "seen as well. The ball marks the best place."));
  auto* column = new QVBoxLayout(legend_);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(colours);
  auto* scale = new ErrorScale(legend_);
  column->addWidget(scale);
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
  couplings_.add(model_.holds, [this, told = &words](bool holds) {
    legend_->setVisible(holds);  // nothing has these colours then
    set_style_property(told, "role", holds ? QVariant() : QVariant(QStringLiteral("warning")));
    refresh();
  });
  couplings_.add(model_.error_words, [told = &words](const QString& text) { told->setText(text); });
}

OrganView::~OrganView() = default;

QString OrganView::nothing_words() {
  return tr("Register the model: the organ appears here, as it was found.");
}

void OrganView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  refresh();
}

void OrganView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  // Below the picture there is little height: words and colours beside the organ leave it all of that.
  const bool is_flat = width() > 2 * height();
  around_->setDirection(is_flat ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  words_and_legend_->setDirection(is_flat ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
  scale_->setMaximumWidth(is_flat ? legend_->sizeHint().width() + 20 : QWIDGETSIZE_MAX);
}

void OrganView::put_away(const QString& hint) {
  view_->set_hint(hint);
  legend_->setVisible(false);
  actors_->clear();
  lesions_.clear();
  scene::PatientScene& patient = view_->patient();
  patient.set_highlight({});
  patient.set_model(nullptr);
  patient.set_cloud({});
  drawn_ = nullptr;
  view_->update();
}

void OrganView::refresh() {
  if (!isVisible()) return;
  const engine::CaseState& now = engine_.state();
  const auto& registration = now[part::registration];
  const auto& drawable = drawables_.drawable();
  const bool is_there = registration && drawable && now[part::model] &&
                        registration->nodes_in_camera.rows() == drawable->model->mesh.vertex_count();
  scale_->setVisible(is_there);
  if (!is_there) return put_away(nothing_words());
  const OverlayFrame* followed = live_.followed();
  if (followed && followed->level() == Level::withdrawn)
    return put_away(tr("No overlay: where the organ is in this picture is not known."));
  if (followed && followed->nodes_in_camera.rows() != drawable->model->mesh.vertex_count())
    followed = nullptr;
  view_->set_hint(QString());
  if (drawn_ != drawable) {
    view_->patient().set_model(drawable);
    view_->patient().set_visible(structure::kParenchyma,
                                 false);  // drawn by the actors, in the error's colours
    drawn_ = drawable;
  }
  draw(followed);
  if (looked_at_ != registration) view_->patient().look_from(scene::ViewFrom::camera, scene::InView::liver);
  looked_at_ = registration;
  view_->update();
}

void OrganView::draw(const OverlayFrame* followed) {
  const engine::CaseState& now = engine_.state();
  scene::PatientScene& patient = view_->patient();
  Registration shown = *now[part::registration];
  const bool holds = model_.holds && (!followed || followed->level() == Level::valid);
  if (followed) shown.nodes_in_camera = followed->nodes_in_camera;
  patient.set_nodes(shown.nodes_in_camera);
  // Points and the place that is compared are of the moment of the registration.
  patient.set_cloud(now[part::cloud] && !followed ? *now[part::cloud] : LabelledCloud());
  lesions_ =
      followed ? followed->lesions : guidance::LesionJudge(*drawn_->model, shown).at_start(Validity::valid);
  for (const LesionVerdict& lesion : lesions_)
    patient.set_visible(lesion.lesion, !followed || lesion.level == Level::valid);
  std::erase_if(lesions_,
                [&](const LesionVerdict& one) { return followed && one.level == Level::withdrawn; });
  actors_->show(*drawn_, shown, lesions_, {followed ? -1 : model_.shown_rival, model_.shown_look, holds});
  legend_->setVisible(holds);
  const auto chosen =
      std::ranges::find(drawn_->surfaces, live_.chosen.value(), &scene::DrawableSurface::structure);
  const bool is_drawn = live_.chosen != 0 && chosen != drawn_->surfaces.end() &&
                        patient.is_visible(live_.chosen) && chosen->binding.weights.rows() > 0;
  patient.set_highlight(is_drawn
                            ? TriangleMesh{chosen->binding.apply(drawn_->model->mesh, shown.nodes_in_camera),
                                           chosen->mesh.triangles}
                            : TriangleMesh());
}

void OrganView::choose_at(double x, double y) {
  constexpr double kBeside = 4e-3;  // metres: small lesions are hit, too
  Label chosen = 0;
  double nearest = kBeside;
  for (const LesionVerdict& lesion : lesions_) {
    const Eigen::Vector3d p = view_->patient().point_beside(lesion.centre, x, y, view_->aspect());
    const double beside = (p - lesion.centre).norm() - lesion.radius;
    if (beside < nearest) nearest = beside, chosen = lesion.lesion;
  }
  live_.choose(chosen);
}

}  // namespace glisson::ui
