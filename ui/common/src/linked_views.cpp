// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/linked_views.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QTimer>
#include <QToolButton>
#include <algorithm>
#include <tuple>

#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/texts.h"
#include "glisson/ui/scene/seen_point.h"

namespace glisson::ui {
namespace {

constexpr int kLate = 150;  ///< milliseconds
constexpr std::array<scene::Plane, 3> kPlanes = {scene::Plane::axial, scene::Plane::coronal,
                                                 scene::Plane::sagittal};

/// Whether the case's labels are not those that are shown, edited: the CT is another one, or their grid is.
bool are_of_another_volume(const engine::CaseState& now, const ViewState& shown) {
  const auto &labels = now[part::labels], &former = shown.labels();
  if (labels == former) return false;
  if (now[part::image] != shown.image()) return true;
  return labels && former && !labels->voxels.grid().same_as(former->voxels.grid());
}

/// A strip below a view, and the row of what it holds.
std::pair<QWidget*, QHBoxLayout*> make_strip(const char* role, const QMargins& margins, int spacing,
                                             QWidget* parent) {
  auto* strip = new QWidget(parent);
  strip->setProperty("role", role);
  auto* row = new QHBoxLayout(strip);
  row->setContentsMargins(margins);
  row->setSpacing(spacing);
  return {strip, row};
}

}  // namespace

LinkedViews::LinkedViews(EngineBridge& engine, ViewState& state, DrawableSource& drawables, QWidget* parent)
    : QWidget(parent), engine_(engine), state_(state), drawables_(drawables) {
  for (const scene::Plane plane : kPlanes) {
    auto* view = new SliceView(state, plane, this);
    slices_[static_cast<std::size_t>(plane)] = view;
    connect(view, &SliceView::hovered, this, &LinkedViews::probe);
    connect(view, &SliceView::left_view, this, [this] { probe(state_.crosshair()); });
    connect(view, &SliceView::slice_changed, this, [this, plane] { show_slice(plane); });
  }
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  bar_ = new ViewBar(state_, this);
  layout->addWidget(bar_, 0, 0, 1, 2);
  layout->addWidget(slices_[0], 1, 0);
  layout->addWidget(make_volume_pane(), 1, 1);
  layout->addWidget(slices_[1], 2, 0);
  layout->addWidget(slices_[2], 2, 1);
  for (int k = 0; k < 2; ++k) {
    layout->setRowStretch(1 + k, 1);
    layout->setColumnStretch(k, 1);
  }
  const auto [line, row] = make_strip("probe", {10, 4, 10, 4}, 24, this);
  position_ = new QLabel(line);
  value_ = new QLabel(line);
  label_ = new QLabel(line);
  position_->setMinimumWidth(240);
  value_->setMinimumWidth(90);
  row->addWidget(position_);
  row->addWidget(value_);
  row->addWidget(label_, 1);
  layout->addWidget(line, 3, 0, 1, 2);

  connect_bar();
  connect_labels();
  connect(&engine_, &EngineBridge::case_changed, this, &LinkedViews::show_case);
  connect(&drawables_, &DrawableSource::changed, this, &LinkedViews::show_model);
  connect(&state_, &ViewState::markers_changed, this, &LinkedViews::show_markers);
  connect(&state_, &ViewState::crosshair_changed, this, [this] { probe(state_.crosshair()); });
  connect(&state_, &ViewState::volume_changed, this, [this] { probe(state_.crosshair()); });
  connect(&state_, &ViewState::labels_changed, this, [this] { probe(probed_); });
  show_case();
}

LinkedViews::~LinkedViews() = default;

void LinkedViews::showEvent(QShowEvent* event) {
  bar_->set_live(true);
  QWidget::showEvent(event);
}

void LinkedViews::hideEvent(QHideEvent* event) {
  bar_->set_live(false);
  QWidget::hideEvent(event);
}

void LinkedViews::connect_bar() {
  addActions(bar_->all_actions());  // keys reach them from here, too
  connect(bar_->whole_action(), &QAction::triggered, this, [this] {
    for (SliceView* view : slices_) view->show_whole();
  });
  connect(bar_->alone_action(), &QAction::triggered, this,
          [this](bool on) { show_alone(on ? pointed_ : nullptr); });
  for (SliceView* view : slices_) {
    connect(view, &SliceView::double_clicked, this, [this, view] { show_alone(alone_ ? nullptr : view); });
    connect(view, &SliceView::menu_wanted, this, [this](const QPoint& place) {
      auto* menu = new QMenu(this);
      menu->setAttribute(Qt::WA_DeleteOnClose);
      menu->addActions(bar_->all_actions());
      menu->popup(place);
    });
  }
  connect(volume_, &RenderView::double_clicked, this, [this] { show_alone(alone_ ? nullptr : volume_); });
  connect(volume_, &RenderView::clicked, this, [this](double x, double y) {
    if (volume_->is_taken()) return;
    if (const auto p = seen_point(x, y)) state_.set_crosshair(Point<CtFrame>(*p));
  });
  pointed_ = slices_[0];
  QCoreApplication::instance()->installEventFilter(this);
}

void LinkedViews::show_alone(QWidget* view) {
  alone_ = view;
  auto* grid = static_cast<QGridLayout*>(layout());
  std::array<int, 2> rows{}, columns{};
  for (const auto& [pane, row, column] : std::array<std::tuple<QWidget*, int, int>, 4>{
           {{slices_[0], 0, 0}, {volume_pane_, 0, 1}, {slices_[1], 1, 0}, {slices_[2], 1, 1}}}) {
    const bool shown = view == nullptr || pane == (view == volume_ ? volume_pane_ : view);
    pane->setVisible(shown);
    if (shown) rows[static_cast<std::size_t>(row)] = columns[static_cast<std::size_t>(column)] = 1;
  }
  for (int k = 0; k < 2; ++k) {
    grid->setRowStretch(1 + k, rows[static_cast<std::size_t>(k)]);
    grid->setColumnStretch(k, columns[static_cast<std::size_t>(k)]);
  }
  bar_->alone_action()->setChecked(view != nullptr);
}

void LinkedViews::leave() {
  MeasureBook& measures = state_.measures();
  if (measures.is_drawing())
    measures.drop();
  else if (state_.is_measuring())
    measures.set_tool(MeasureTool::none);
  else
    show_alone(nullptr);
}

bool LinkedViews::takes_escape() const {
  if (!isVisible()) return false;
  if (state_.is_measuring()) return true;
  // A panel's tool lies above the views: it is put away first.
  return alone_ != nullptr && state_.hand() == Hand::crosshair && !volume_->is_taken();
}

bool LinkedViews::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::Enter:
    case QEvent::MouseMove:
    case QEvent::MouseButtonPress:
      if (watched == volume_ || std::find(slices_.begin(), slices_.end(), watched) != slices_.end())
        pointed_ = static_cast<QWidget*>(watched);
      return false;
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress: {
      const auto* key = static_cast<QKeyEvent*>(event);
      const auto* widget = qobject_cast<QWidget*>(watched);
      if (key->key() != Qt::Key_Escape || widget == nullptr || widget->window() != window() ||
          !takes_escape())
        return false;
      if (event->type() == QEvent::KeyPress) leave();
      event->accept();  // the key comes here and is no panel's
      return true;
    }
    default:
      return false;
  }
}

void LinkedViews::connect_labels() {
  late_ = new QTimer(this);
  late_->setSingleShot(true);
  late_->setInterval(kLate);
  connect(late_, &QTimer::timeout, this, [this] {
    for (const scene::Plane plane : kPlanes) show_slice(plane);
    show_labels();
  });
  label_surfaces_ = new LabelSurfaceSource(this);
  label_actors_ = std::make_unique<scene::LabelActors>(volume_->patient().renderer());
  connect(label_surfaces_, &LabelSurfaceSource::changed, this, &LinkedViews::show_label_surfaces);
  for (const auto signal :
       {&ViewState::volume_changed, &ViewState::overlays_changed, &ViewState::shows_labels_changed})
    connect(&state_, signal, this, &LinkedViews::show_labels);
  connect(&state_, &ViewState::labels_changed, this, [this] {
    // Each change restarts the delay: the 3D view is not drawn while a stroke goes on.
    if (label_actors_->actor_count() > 0)
      late_->start();
    else
      show_labels();
  });
  connect(&engine_, &EngineBridge::evolving_changed, this,
          [this] { state_.set_evolving(engine_.snapshot()->evolving); });
  connect(&state_, &ViewState::style_changed, this, [this] {
    label_actors_->set_hidden(state_.style().hidden);
    volume_->update();
  });
  connect(&state_, &ViewState::hand_changed, this,
          [this] { volume_->set_lasso(state_.hand() == Hand::lasso); });
  connect(&state_, &ViewState::gesture_dropped, volume_, &RenderView::drop_lasso);
  connect(volume_, &RenderView::lassoed, this, &LinkedViews::lasso);
}

std::shared_ptr<const LabelVolume> LinkedViews::labels_in_3d() const {
  if (!state_.shows_labels() && engine_.state()[part::model]) return nullptr;
  if (state_.evolving()) return state_.evolving();
  if (!state_.labels()) return nullptr;
  return {state_.labels(), &state_.labels()->voxels};
}

void LinkedViews::show_labels() {
  label_surfaces_->set_labels(labels_in_3d());
  show_model();
}

void LinkedViews::show_label_surfaces() {
  const bool first = label_actors_->actor_count() == 0;
  label_actors_->show(*label_surfaces_->surfaces());
  if (first && label_actors_->actor_count() > 0) {
    slices_toggle_->setChecked(false);
    volume_->patient().look_from(scene::ViewFrom::anterior);
  }
  volume_->update();
  show_model();
}

void LinkedViews::lasso(const QPolygonF& outline, Qt::KeyboardModifiers keys) {
  VolumeLasso lasso;
  lasso.view_from_ct = volume_->view_from_scene();
  lasso.keys = keys;
  lasso.outline.resize(outline.size(), 2);
  for (qsizetype i = 0; i < outline.size(); ++i) lasso.outline.row(i) << outline[i].x(), outline[i].y();
  state_.lasso_volume(lasso);
}

QWidget* LinkedViews::make_volume_pane() {
  auto* pane = volume_pane_ = new QWidget(this);
  auto* layout = new QVBoxLayout(pane);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  volume_ = new RenderView(pane);
  volume_->set_title(tr("3D"));
  volume_->show_orientation();
  layout->addWidget(volume_, 1);
  const auto [bar, row] = make_strip("viewbar", {6, 2, 6, 2}, 4, pane);
  const std::array<std::tuple<QString, QString, scene::ViewFrom>, 6> sides = {
      {{tr("A"), tr("Look from the front (anterior)"), scene::ViewFrom::anterior},
       {tr("P"), tr("Look from behind (posterior)"), scene::ViewFrom::posterior},
       {tr("R"), tr("Look from the patient's right"), scene::ViewFrom::right},
       {tr("L"), tr("Look from the patient's left"), scene::ViewFrom::left},
       {tr("S"), tr("Look from above (superior)"), scene::ViewFrom::superior},
       {tr("I"), tr("Look from below (inferior)"), scene::ViewFrom::inferior}}};
  auto* caption = make_explanation(tr("Look from"), bar);
  caption->setWordWrap(false);
  row->addWidget(caption);
  for (const auto& [name, explanation, from] : sides) {
    auto* button = new QToolButton(bar);
    button->setText(name);
    button->setToolTip(explanation);
    button->setAccessibleName(explanation);
    row->addWidget(button);
    connect(button, &QToolButton::clicked, this, [this, side = from] {
      volume_->patient().look_from(side);
      volume_->update();
    });
  }
  row->addStretch(1);
  slices_toggle_ = new QToolButton(bar);
  slices_toggle_->setText(tr("Slices"));
  slices_toggle_->setCheckable(true);
  slices_toggle_->setChecked(true);
  slices_toggle_->setToolTip(tr("Show the three slices in the 3D view"));
  row->addWidget(slices_toggle_);
  connect(slices_toggle_, &QToolButton::toggled, this, [this](bool on) {
    volume_->patient().set_slices_visible(on);
    for (const scene::Plane plane : kPlanes) show_slice(plane);
    volume_->update();
  });
  layout->addWidget(bar);
  return pane;
}

void LinkedViews::show_case() {
  const engine::CaseState& now = engine_.state();
  // Of another case: its former surfaces would stand beside this one's slices until the new ones are made.
  if (are_of_another_volume(now, state_)) label_surfaces_->forget();
  state_.set_volume(now[part::image], now[part::labels]);
  if (now[part::landmarks] != taken_landmarks_ || now[part::model] != taken_model_) {
    const bool was_without_model = !taken_model_;
    taken_landmarks_ = now[part::landmarks];
    taken_model_ = now[part::model];
    if (was_without_model != !now[part::model]) label_surfaces_->set_labels(labels_in_3d());
    set_landmarks(now[part::model] ? engine::effective_landmarks(now) : Landmarks{});
  }
  const bool was_empty = scene_is_empty_;
  scene_is_empty_ = !now[part::model] && !now[part::image];
  if (was_empty != scene_is_empty_) {
    if (was_empty) volume_->patient().look_from(scene::ViewFrom::anterior);
    volume_->update();
  }
  show_model();  // which draws only what is new: this is called for every stretch of a stroke
}

void LinkedViews::set_landmarks(const Landmarks& landmarks) {
  landmarks_ = landmarks;
  if (shown_model_) volume_->patient().set_landmarks(landmarks_);
  volume_->update();
}

void LinkedViews::show_model() {
  const bool labels_instead = labels_in_3d() != nullptr;
  const auto wanted = labels_instead ? nullptr : drawables_.drawable();
  if (wanted != shown_model_) {
    shown_model_ = wanted;
    scene::PatientScene& patient = volume_->patient();
    patient.set_model(shown_model_);
    if (shown_model_) patient.set_landmarks(landmarks_);
    if (shown_model_ && shown_model_ != faced_model_) {
      faced_model_ = shown_model_;
      slices_toggle_->setChecked(false);  // the liver would hide in them
      patient.look_from(scene::ViewFrom::anterior);
    }
    volume_->update();
  }
  const bool making_labels =
      labels_instead && label_surfaces_->is_making() && label_actors_->actor_count() == 0;
  volume_->set_hint(scene_is_empty_                                ? tr("No volume")
                    : making_labels                                ? tr("Preparing the surfaces…")
                    : !labels_instead && drawables_.is_preparing() ? tr("Preparing the model for drawing…")
                                                                   : QString());
}

void LinkedViews::show_slice(scene::Plane plane) {
  const SliceView& view = slice(plane);
  // All are brought up to date when they are shown; one that there is no more goes at once.
  if (!slices_toggle_->isChecked() && !view.slice().empty()) return;
  volume_->patient().set_slice(view.geometry_in_ct(), view.slice());
  volume_->update();
}

void LinkedViews::show_markers() {
  volume_->patient().set_markers(state_.markers());
  volume_->update();
}

void LinkedViews::probe(const Point<CtFrame>& p) {
  probed_ = p;
  if (!state_.image()) {
    for (QLabel* part : {position_, value_, label_}) part->clear();
    return;
  }
  const LabelVolume* labels = state_.labels() ? &state_.labels()->voxels : nullptr;
  const scene::Probe found = scene::probe(*state_.image(), labels, p);
  QStringList coordinates;
  for (int axis = 0; axis < 3; ++axis)
    coordinates << QString::fromStdString(scene::anatomical_coordinate(axis, p.xyz[axis]));
  position_->setText(tr("%1 mm").arg(coordinates.join(QStringLiteral("   "))));
  const QString value = QString::number(qRound(found.value));
  value_->setText(!found.inside                              ? tr("outside")
                  : state_.image()->modality == Modality::ct ? tr("%1 HU").arg(value)
                                                             : value);
  label_->setText(found.label == structure::kBackground ? QString() : structure_text(found.label));
}

QString LinkedViews::probe_line() const {
  return QStringLiteral("%1   %2   %3").arg(position_->text(), value_->text(), label_->text()).trimmed();
}

std::optional<Eigen::Vector3d> LinkedViews::seen_point(double x, double y) const {
  std::vector<vtkActor*> actors = volume_->patient().surface_actors();
  const std::vector<vtkActor*> labels = label_actors_->actors();
  actors.insert(actors.end(), labels.begin(), labels.end());
  return scene::seen_point(volume_->patient().renderer(), actors, x, y, volume_->aspect());
}

std::optional<Eigen::Vector3d> LinkedViews::surface_point(double x, double y) const {
  return volume_->patient().surface_point(x, y, volume_->aspect());
}

}  // namespace glisson::ui
