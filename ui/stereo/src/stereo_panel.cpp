// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/stereo/stereo_panel.h"

#include <QFileDialog>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSpinBox>
#include <QSplitter>
#include <map>

namespace glisson::ui {
namespace {

QString feature_name(Feature feature) {
  switch (feature) {
    case Feature::surface:
      return StereoPanel::tr("Surface");
    case Feature::anterior_margin:
      return StereoPanel::tr("Anterior margin");
    case Feature::umbilical_notch:
      return StereoPanel::tr("Umbilical notch");
  }
  return {};
}

/// What is known of a cloud, wherever it came from.
std::vector<std::pair<QString, QString>> rows_of(const LabelledCloud* cloud) {
  if (cloud == nullptr) return {};
  std::map<Feature, int> counts;
  for (int i = 0; i < cloud->size(); ++i) ++counts[cloud->feature(i)];
  std::vector<std::pair<QString, QString>> rows = {
      {StereoPanel::tr("Points"), QString::number(cloud->size())}};
  for (const Feature feature : {Feature::surface, Feature::anterior_margin, Feature::umbilical_notch})
    rows.emplace_back(feature_name(feature), QString::number(counts[feature]));
  if (cloud->size() == 0) return rows;
  const auto z = cloud->points.col(2);
  rows.emplace_back(
      StereoPanel::tr("Distance from the camera"),
      StereoPanel::tr("%1 to %2 mm").arg(1e3 * z.minCoeff(), 0, 'f', 0).arg(1e3 * z.maxCoeff(), 0, 'f', 0));
  return rows;
}

QString pictures_filter() { return StereoPanel::tr("Pictures (*.png *.jpg *.jpeg *.bmp)"); }

}  // namespace

StereoPanel::StereoPanel(EngineBridge& engine, QWidget* parent)
    : Panel(engine, tr("Stereo"), tr("What the stereo laparoscope sees of the liver, as points in space."),
            parent) {
  setObjectName(QStringLiteral("stereo_panel"));
  build_view();
  build_input();
  build_regions();
  QVBoxLayout* build = add_section(tr("Reconstruct"));
  run_ = new TaskButton(
      engine, tr("Reconstruct surface"),
      [this] {
        choose(std::nullopt);
        return engine::Command(engine::Reconstruct{});
      },
      this);
  run_->setObjectName(QStringLiteral("reconstruct"));
  build->addWidget(run_);
  figures_ = new FiguresTable(this);
  build->addWidget(figures_);
  connect(&this->engine(), &EngineBridge::case_changed, this, &StereoPanel::show_case);
  connect(&this->engine(), &EngineBridge::finished, this, [this](const engine::Outcome& outcome) {
    if (storing_.erase(outcome.id) > 0 && storing_.empty()) show_case();
    if (outcome.command == "set_video" && outcome.status == engine::Status::done)
      if (const auto frames = outcome.figures.find("video_frames"); frames != outcome.figures.end())
        frame_->setMaximum(std::max(0, static_cast<int>(frames->second) - 1));
  });
  watch(engine::Part::cloud, {"reconstruct", "import_cloud"});
  show_case();
}

StereoPanel::~StereoPanel() {
  if (view_ && view_->parent() == nullptr) delete view_;  // nobody hosted it
}

void StereoPanel::build_view() {
  auto* rows = new QSplitter(Qt::Vertical);
  view_ = rows;
  rows->setObjectName(QStringLiteral("stereo_view"));
  rows->setChildrenCollapsible(false);
  editor_ = new RegionEditor(rows);
  rows->addWidget(editor_);
  auto* lower = new QSplitter(Qt::Horizontal, rows);
  lower->setChildrenCollapsible(false);
  right_ = new PictureView(tr("Right"), lower);
  cloud_ = new RenderView(lower);
  cloud_->set_title(tr("Reconstructed points"));
  cloud_->set_hint(tr("No points yet"));
  lower->addWidget(right_);
  lower->addWidget(cloud_);
  rows->addWidget(lower);
  rows->setStretchFactor(0, 3);
  rows->setStretchFactor(1, 2);
  connect(editor_, &RegionEditor::regions_edited, this, &StereoPanel::store);
  connect(editor_, &RegionEditor::drawing_ended, this, [this] { choose(std::nullopt); });
}

void StereoPanel::build_input() {
  QVBoxLayout* box = add_section(tr("Pictures"));
  auto* grid = new QGridLayout;
  grid->setSpacing(5);
  grid->setColumnStretch(1, 1);
  auto* calibration = new QPushButton(tr("Calibration…"), this);
  calibration_ = make_explanation({}, this);
  auto* pair = new QPushButton(tr("Stereo pair…"), this);
  auto* video = new QPushButton(tr("Video…"), this);
  source_ = make_explanation({}, this);
  grid->addWidget(calibration, 0, 0);
  grid->addWidget(calibration_, 0, 1);
  grid->addWidget(pair, 1, 0);
  grid->addWidget(source_, 1, 1, 2, 1);
  grid->addWidget(video, 2, 0);
  box->addLayout(grid);
  auto* row = new QHBoxLayout;
  frame_ = new QSpinBox(this);
  frame_->setRange(0, 999999);
  frame_->setPrefix(tr("Frame "));
  load_frame_ = new QPushButton(tr("Take this frame"), this);
  row->addWidget(frame_, 1);
  row->addWidget(load_frame_);
  box->addLayout(row);
  connect(calibration, &QPushButton::clicked, this, &StereoPanel::open_calibration);
  connect(pair, &QPushButton::clicked, this, &StereoPanel::open_pair);
  connect(video, &QPushButton::clicked, this, &StereoPanel::open_video);
  connect(load_frame_, &QPushButton::clicked, this,
          [this] { engine().post(engine::LoadVideoFrame{frame_->value()}); });
}

void StereoPanel::build_regions() {
  QVBoxLayout* box =
      add_section(tr("Regions"), tr("Choose a feature and click around it in the left picture; Enter, or a "
                                    "click on the first corner, closes. Backspace takes a corner back, Esc "
                                    "ends. Then corners can be dragged; right click removes a region."));
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  for (const Feature feature : {Feature::surface, Feature::anterior_margin, Feature::umbilical_notch}) {
    auto* button = new QPushButton(feature_name(feature), this);
    button->setCheckable(true);
    button->setProperty("role", "choice");
    button->setObjectName(QStringLiteral("region_%1").arg(static_cast<int>(feature)));
    row->addWidget(button);
    features_[feature] = button;
    connect(button, &QPushButton::clicked, this,
            [this, feature](bool on) { choose(on ? std::optional(feature) : std::nullopt); });
  }
  box->addLayout(row);
  list_ = new QListWidget(this);
  list_->setFixedHeight(72);
  list_->setObjectName(QStringLiteral("region_list"));
  box->addWidget(list_);
  clear_ = new QPushButton(tr("Clear regions"), this);
  box->addWidget(clear_);
  connect(clear_, &QPushButton::clicked, this, [this] {
    editor_->set_regions({});
    store();
  });
}

void StereoPanel::open_calibration() {
  const QString path =
      QFileDialog::getOpenFileName(this, tr("Calibration"), {}, tr("OpenCV YAML (*.yml *.yaml)"));
  if (!path.isEmpty()) engine().post(engine::SetCalibration{path.toStdString()});
}

void StereoPanel::open_pair() {
  const QString left = QFileDialog::getOpenFileName(this, tr("Left picture"), {}, pictures_filter());
  if (left.isEmpty()) return;
  const QString right =
      QFileDialog::getOpenFileName(this, tr("Right picture"), QFileInfo(left).path(), pictures_filter());
  if (!right.isEmpty()) engine().post(engine::LoadStereoPair{left.toStdString(), right.toStdString(), {}});
}

void StereoPanel::open_video() {
  const QString path = QFileDialog::getOpenFileName(this, tr("Stereo video, both views side by side"), {},
                                                    tr("Videos (*.mkv *.mp4 *.avi *.mov)"));
  if (path.isEmpty()) return;
  engine().post(engine::SetVideo{path.toStdString(), {}});
  engine().post(engine::LoadVideoFrame{0});
}

void StereoPanel::deactivate() { choose(std::nullopt); }

void StereoPanel::choose(std::optional<Feature> feature) {
  for (const auto& [one, button] : features_) button->setChecked(feature == one);
  editor_->set_feature(feature);
}

void StereoPanel::store() {
  stereo::Regions regions;
  regions.frame = shown_frame_ ? shown_frame_->frame.index : 0;
  regions.regions = editor_->regions();
  storing_.insert(engine().post(engine::SetRegions{regions}));
  show_region_list();
}

void StereoPanel::show_case() {
  const engine::CaseState& now = engine().state();
  if (now.frame != shown_frame_) {
    shown_frame_ = now.frame;
    editor_->set_picture(now.frame ? now.frame->frame.left : Picture());
    right_->set_picture(now.frame ? now.frame->frame.right : Picture());
    if (now.frame) frame_->setValue(now.frame->frame.index);
  }
  if (storing_.empty() && now.regions != taken_) {
    taken_ = now.regions;
    editor_->set_regions(taken_ ? taken_->regions : std::vector<stereo::Region>());
  }
  calibration_->setText(now.rig ? tr("%1 × %2, baseline %3 mm")
                                      .arg(now.rig->left.width)
                                      .arg(now.rig->left.height)
                                      .arg(1e3 * now.rig->baseline(), 0, 'f', 1)
                                : tr("none"));
  source_->setText(
      now.video ? tr("Video: %1").arg(QString::fromStdString(now.video->left.filename().string()))
      : now.frame
          ? tr("Stereo pair, %1 × %2").arg(now.frame->frame.left.width).arg(now.frame->frame.left.height)
          : tr("none"));
  frame_->setEnabled(now.video != nullptr);
  load_frame_->setEnabled(now.video != nullptr);
  for (const auto& [feature, button] : features_) button->setEnabled(now.frame != nullptr);
  run_->set_obstacle(obstacle());
  show_region_list();
  show_cloud();
}

void StereoPanel::show_cloud() {
  const engine::CaseState& now = engine().state();
  if (now.cloud == shown_cloud_) return;
  shown_cloud_ = now.cloud;
  figures_->set_rows(rows_of(now.cloud.get()));
  cloud_->set_hint(now.cloud ? QString() : tr("No points yet"));
  cloud_->patient().set_cloud(now.cloud ? *now.cloud : LabelledCloud());
  if (now.cloud) cloud_->patient().look_from(scene::ViewFrom::camera);
  cloud_->update();
  std::vector<Eigen::Vector2d> dots;
  std::vector<Feature> features;
  if (now.cloud && now.rig)
    for (int i = 0; i < now.cloud->size(); ++i) {
      const Eigen::Vector3d p = now.cloud->points.row(i).transpose();
      if (p.z() <= 0.0) continue;
      const Eigen::Vector2d pixel = now.rig->left.project(p);
      if (!now.rig->left.sees(pixel)) continue;
      dots.push_back(pixel);
      features.push_back(now.cloud->feature(i));
    }
  editor_->set_dots(std::move(dots), std::move(features));
}

void StereoPanel::show_region_list() {
  list_->clear();
  for (const stereo::Region& region : editor_->regions())
    list_->addItem(tr("%1, corners: %2").arg(feature_name(region.feature)).arg(region.polygon.size()));
  clear_->setEnabled(!editor_->regions().empty());
}

QString StereoPanel::obstacle() const {
  const engine::CaseState& now = engine().state();
  if (!now.rig) return tr("Load the laparoscope's calibration first.");
  if (!now.frame) return tr("Load a stereo pair or a video frame first.");
  return {};
}

}  // namespace glisson::ui
