// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/stereo/stereo_panel.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <algorithm>

#include "glisson/engine/commands/load_video_frame.h"
#include "glisson/engine/commands/reconstruct.h"
#include "glisson/engine/commands/set_regions.h"
#include "glisson/engine/obstacle.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/regions.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/engine/parts/video.h"
#include "glisson/stereo/faults.h"
#include "glisson/ui/common/error_texts.h"
#include "glisson/ui/common/texts.h"
#include "glisson/ui/scene/colours.h"
#include "glisson/ui/stereo/cloud_figures.h"
#include "glisson/ui/stereo/looks_row.h"

namespace glisson::ui {
namespace {

constexpr int kMostFrames = 999999;  ///< of a video whose number is not known

QIcon feature_icon(Feature feature) {
  QPixmap pixmap(12, 12);
  pixmap.fill(scene::colour_of(feature));
  return pixmap;
}

QString region_text(const stereo::Region& region) {
  const QString where =
      region.side == stereo::Side::left ? StereoPanel::tr("left") : StereoPanel::tr("right");
  const QString what = region.closed ? feature_name(region.feature)
                                     : StereoPanel::tr("%1, line").arg(feature_name(region.feature));
  const QString text = StereoPanel::tr("%1 (%2), corners: %3").arg(what, where).arg(region.polygon.size());
  return region.closed && stereo::crosses_itself(region) ? StereoPanel::tr("%1, crosses itself").arg(text)
                                                         : text;
}

}  // namespace

StereoPanel::StereoPanel(EngineBridge& engine, QWidget* parent)
    : Panel(engine, tr("Stereo"), tr("What the stereo laparoscope sees of the liver, as points in space."),
            parent) {
  setObjectName(QStringLiteral("stereo_panel"));
  view_ = new StereoView;
  build_input();
  build_regions();
  build_reconstruction();
  connect(view_, &StereoView::regions_edited, this, &StereoPanel::store);
  connect(view_, &StereoView::drawing_changed, this, &StereoPanel::show_drawing);
  connect(&this->engine(), &EngineBridge::case_changed, this, &StereoPanel::show_case);
  connect(&this->engine(), &EngineBridge::finished, this, &StereoPanel::take_outcome);
  watch(part::cloud);
  show_case();
}

StereoPanel::~StereoPanel() {
  if (view_ && view_->parent() == nullptr) delete view_;  // nobody hosted it
}

void StereoPanel::take_outcome(const engine::Outcome& outcome) {
  const bool done = outcome.status == engine::Status::done;
  if (storing_.erase(outcome.id) > 0 && storing_.empty()) {
    // The engine refused the regions: show again those that the case has.
    if (!done) {
      view_->drawing().set_regions({});
      taken_.reset();
      faults_ = error_text(outcome.error);
    }
    show_case();
    if (done) label();
  }
  if (done)
    if (const auto frames = outcome.figures.find("video_frames"); frames != outcome.figures.end())
      frame_->setMaximum(frames->second >= 1.0 ? static_cast<int>(frames->second) - 1 : kMostFrames);
  if (opening_ == outcome.id) {
    opening_.reset();
    if (done) engine().post(engine::LoadVideoFrame{0});
  }
}

void StereoPanel::build_input() {
  QVBoxLayout* box = add_section(tr("Pictures"));
  auto* grid = new QGridLayout;
  grid->setSpacing(5);
  grid->setColumnStretch(1, 1);
  auto* calibration = new QPushButton(tr("Calibration"), this);
  auto* calibrations = new QMenu(calibration);
  calibrations->addAction(tr("Calibration file…"), this, &StereoPanel::open_calibration);
  calibrations->addAction(tr("Folder of text files…"), this, &StereoPanel::open_text_calibration);
  calibrations->addAction(tr("Calibrate from boards…"), this, &StereoPanel::calibrate_from_boards);
  calibrations->addSeparator();
  save_calibration_ = calibrations->addAction(tr("Save as…"), this, &StereoPanel::save_calibration);
  calibration->setMenu(calibrations);
  calibration_ = make_explanation({}, this);
  auto* pictures = new QPushButton(tr("Open"), this);
  auto* sources = new QMenu(pictures);
  fill_source_menu(sources);
  pictures->setMenu(sources);
  pictures->setObjectName(QStringLiteral("open_pictures"));
  QWidget::setTabOrder(pictures, calibration);
  source_ = make_explanation({}, this);
  grid->addWidget(pictures, 0, 0);
  grid->addWidget(source_, 0, 1);
  grid->addWidget(calibration, 1, 0);
  grid->addWidget(calibration_, 1, 1);
  box->addLayout(grid);
  auto* row = new QHBoxLayout;
  frame_ = new QSpinBox(this);
  frame_->setRange(0, kMostFrames);
  frame_->setPrefix(tr("Frame "));
  frame_->setAccessibleName(tr("Frame of the video"));
  load_frame_ = new QPushButton(tr("Take this frame"), this);
  row->addWidget(frame_, 1);
  row->addWidget(load_frame_);
  box->addLayout(row);
  connect(load_frame_, &QPushButton::clicked, this,
          [this] { this->engine().post(engine::LoadVideoFrame{frame_->value()}); });
}

void StereoPanel::build_regions() {
  QVBoxLayout* box = add_section(tr("Regions"), tr("Choose a feature and click around it in either picture. "
                                                   "Esc ends drawing; then corners can be dragged."));
  auto* grid = new QGridLayout;
  grid->setSpacing(4);
  const auto add_tool = [&](const RegionDrawing::Tool& tool, const QString& text, const QString& name) {
    auto* button = new QPushButton(feature_icon(tool.feature), text, this);
    button->setCheckable(true);
    button->setProperty("role", "choice");
    button->setObjectName(name);
    const int place = static_cast<int>(tools_.size());
    grid->addWidget(button, place / 2, place % 2);
    tools_.emplace_back(tool, button);
    connect(button, &QPushButton::clicked, this,
            [this, tool](bool on) { choose(on ? std::optional(tool) : std::nullopt); });
  };
  for (const Feature feature : {Feature::surface, Feature::umbilical_notch, Feature::anterior_margin})
    add_tool({feature, true, 0.0}, feature_name(feature),
             QStringLiteral("region_%1").arg(static_cast<int>(feature)));
  add_tool({Feature::anterior_margin, false, 0.0}, tr("Margin as a line"), QStringLiteral("region_curve"));
  box->addLayout(grid);
  list_ = new QListWidget(this);
  list_->setFixedHeight(84);
  list_->setObjectName(QStringLiteral("region_list"));
  list_->setAccessibleName(tr("Regions"));
  box->addWidget(list_);
  connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
    view_->drawing().select(row < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(row)));
    view_->refresh();
    show_drawing();
  });
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  const auto add_button = [&](const QString& text, const QString& name, const auto& act) {
    auto* button = new QPushButton(text, this);
    button->setObjectName(name);
    row->addWidget(button);
    connect(button, &QPushButton::clicked, this, [this, act] {
      const bool edited = act(view_->drawing());
      view_->refresh();
      show_drawing();
      if (edited) store();
    });
    return button;
  };
  undo_ = add_button(QStringLiteral("↶"), QStringLiteral("undo_region"),
                     [](RegionDrawing& d) { return d.undo(); });
  undo_->setToolTip(tr("Undo (Ctrl+Z)"));
  undo_->setAccessibleName(tr("Undo"));
  redo_ = add_button(QStringLiteral("↷"), QStringLiteral("redo_region"),
                     [](RegionDrawing& d) { return d.redo(); });
  redo_->setToolTip(tr("Redo (Ctrl+Shift+Z)"));
  redo_->setAccessibleName(tr("Redo"));
  remove_ = add_button(tr("Remove"), QStringLiteral("remove_region"),
                       [](RegionDrawing& d) { return d.remove_selected(); });
  clear_ =
      add_button(tr("Clear"), QStringLiteral("clear_regions"), [](RegionDrawing& d) { return d.clear(); });
  box->addLayout(row);
}

void StereoPanel::build_reconstruction() {
  QVBoxLayout* box = add_section(tr("Reconstruct"));
  auto* row = new QHBoxLayout;
  method_ = new QComboBox(this);
  method_->setObjectName(QStringLiteral("method"));
  method_->setAccessibleName(tr("Method"));
  method_->setToolTip(
      tr("Features are the paper's way. Dense covers what lies between them. Automatic becomes dense where "
         "features leave less than %1 points per cm².")
          .arg(stereo::ReconstructOptions{}.least_density_per_cm2));
  method_->addItem(tr("Automatic"), static_cast<int>(stereo::Method::automatic));
  method_->addItem(tr("Features"), static_cast<int>(stereo::Method::sparse));
  method_->addItem(tr("Dense"), static_cast<int>(stereo::Method::dense));
  kind_ = new QComboBox(this);
  kind_->setObjectName(QStringLiteral("features"));
  kind_->setAccessibleName(tr("Kind of features"));
  kind_->setToolTip(tr("Kind of features that are looked for in both pictures"));
  kind_->addItem(QStringLiteral("SURF"), static_cast<int>(stereo::Features::surf));
  kind_->addItem(QStringLiteral("SIFT"), static_cast<int>(stereo::Features::sift));
  kind_->addItem(QStringLiteral("AKAZE"), static_cast<int>(stereo::Features::akaze));
  row->addWidget(method_, 3);
  row->addWidget(kind_, 2);
  box->addLayout(row);
  run_ = new TaskButton(
      engine(), tr("Reconstruct surface"),
      [this] {
        engine::Reconstruct command;
        if (again_)
          command.options = *std::exchange(again_, std::nullopt);
        else {
          command.options.method = static_cast<stereo::Method>(method_->currentData().toInt());
          command.options.kind = static_cast<stereo::Features>(kind_->currentData().toInt());
        }
        return engine::Command(command);
      },
      this);
  run_->setObjectName(QStringLiteral("reconstruct"));
  box->addWidget(run_);
  box->addWidget(new LooksRow(engine(), this));
  connect(run_, &TaskButton::done, this, [this](const engine::Outcome& outcome) {
    faults_ = notes_text(outcome.notes);
    show_figures();
    if (std::exchange(label_again_, false)) label();
  });
  warnings_ = new QLabel(this);
  warnings_->setWordWrap(true);
  warnings_->setObjectName(QStringLiteral("stereo_warnings"));
  set_style_property(warnings_, "role", "muted");
  box->addWidget(warnings_);
  figures_ = new FiguresTable(this);
  figures_->setObjectName(QStringLiteral("cloud_figures"));
  box->addWidget(figures_);
}

void StereoPanel::deactivate() {
  // Whoever looks at another step in the middle of a line comes back to it.
  if (view_->drawing().unfinished() == nullptr) choose(std::nullopt);
}

void StereoPanel::choose(const std::optional<RegionDrawing::Tool>& tool) {
  std::optional<RegionDrawing::Tool> sized = tool;
  // A line reaches as far in a large picture as in a small one.
  if (sized && shown_frame_) sized->half_width_px = std::max(3.0, shown_frame_->frame.left.width / 120.0);
  view_->drawing().set_tool(sized);
  if (tool) view_->editor(stereo::Side::left).setFocus();
  view_->refresh();
  show_drawing();
}

void StereoPanel::store() {
  stereo::Regions regions;
  regions.frame = shown_frame_ ? shown_frame_->frame.index : 0;
  // The identity of the frame that was drawn on: the case may hold another one when the command runs.
  regions.identity = identity_;
  regions.regions = view_->drawing().regions();
  storing_.insert(engine().post(engine::SetRegions{regions}));
  show_drawing();
}

void StereoPanel::label() {
  const engine::CaseState& now = engine().state();
  if (!now[part::points] || now[part::points]->frame != now[part::frame] ||
      now[part::points]->rig != now[part::rig])
    return;
  if (run_->is_running()) {
    label_again_ = true;
    return;
  }
  again_ = now[part::points]->options;
  run_->trigger();
  again_.reset();
}

void StereoPanel::show_case() {
  const engine::CaseState& now = engine().state();
  if (now[part::video] != shown_video_) {
    shown_video_ = now[part::video];
    frame_->setMaximum(kMostFrames);  // how many it has is told when it is opened here
  }
  const bool is_other_frame = now[part::frame] != shown_frame_;
  if (is_other_frame) {
    shown_frame_ = now[part::frame];
    identity_ = now[part::frame]
                    ? stereo::frame_identity(now[part::frame]->frame.left, now[part::frame]->frame.right)
                    : std::string();
    faults_.clear();
    if (now[part::frame]) frame_->setValue(now[part::frame]->frame.index);
  }
  if (now[part::rig] != shown_rig_) faults_.clear();  // they were found with the former one
  shown_rig_ = now[part::rig];
  view_->set_pair(now[part::frame], rig_fits() ? now[part::rig] : nullptr);
  take_regions(is_other_frame);
  calibration_->setText(now[part::rig] ? tr("%1 × %2, baseline %3 mm")
                                             .arg(now[part::rig]->left.width)
                                             .arg(now[part::rig]->left.height)
                                             .arg(1e3 * now[part::rig]->baseline(), 0, 'f', 1)
                                       : tr("none"));
  source_->setText(
      now[part::video]
          ? tr("Video: %1").arg(QString::fromStdString(now[part::video]->left.filename().string()))
      : now[part::frame] ? tr("Stereo pair, %1 × %2")
                               .arg(now[part::frame]->frame.left.width)
                               .arg(now[part::frame]->frame.left.height)
                         : tr("none"));
  save_calibration_->setEnabled(now[part::rig] != nullptr);
  frame_->setEnabled(now[part::video] != nullptr);
  load_frame_->setEnabled(now[part::video] != nullptr);
  run_->set_obstacle(obstacle());
  show_drawing();
  view_->set_cloud(now[part::cloud], engine().snapshot()->stage(part::cloud) == engine::StageState::stale,
                   now[part::points]);
  show_figures();
}

void StereoPanel::take_regions(bool is_other_frame) {
  RegionDrawing& drawing = view_->drawing();
  if (storing_.empty() && engine().state()[part::regions] != taken_) {
    taken_ = engine().state()[part::regions];
    drawing.set_regions(taken_ ? taken_->regions : RegionDrawing::Regions());
    view_->refresh();
  }
  if (!is_other_frame) return;
  of_another_frame_ = taken_ && taken_->identity != identity_ ? taken_->regions : RegionDrawing::Regions();
  drawing.begin_anew(RegionDrawing::Regions(drawing.regions()));  // other steps and lines were the former's
  view_->refresh();
}

void StereoPanel::show_figures() {
  const engine::CaseState& now = engine().state();
  figures_->set_rows(cloud_figures(now));
  QStringList lines{faults_, cloud_warning(now)};
  // Storing them with the others has made them this frame's.
  const int left = count_unchanged(view_->drawing().regions(), of_another_frame_);
  if (left > 0 && engine::stage_state(now, part::regions) != engine::StageState::stale)
    lines << tr("Still as drawn on another frame: %1. Move or clear them.").arg(left);
  lines.removeAll(QString());
  const QString warning = lines.join(QLatin1Char('\n'));
  warnings_->setText(warning);
  warnings_->setVisible(!warning.isEmpty());
}

void StereoPanel::show_drawing() {
  const RegionDrawing& drawing = view_->drawing();
  for (const auto& [tool, button] : tools_) {
    button->setEnabled(shown_frame_ != nullptr);
    button->setChecked(drawing.tool() && drawing.tool()->feature == tool.feature &&
                       drawing.tool()->closed == tool.closed);
  }
  show_region_list();
  undo_->setEnabled(drawing.can_undo());
  redo_->setEnabled(drawing.can_redo());
  remove_->setEnabled(drawing.selected().has_value());
  clear_->setEnabled(!drawing.regions().empty() || drawing.unfinished() != nullptr);
}

/// Leaves the list as it is where nothing has changed: it may be the list that was clicked.
void StereoPanel::show_region_list() {
  const RegionDrawing& drawing = view_->drawing();
  QStringList wanted, shown;
  for (const stereo::Region& region : drawing.regions()) wanted << region_text(region);
  for (int row = 0; row < list_->count(); ++row) shown << list_->item(row)->text();
  const QSignalBlocker quiet(list_);
  if (wanted != shown) {
    list_->clear();
    for (qsizetype i = 0; i < wanted.size(); ++i)
      list_->addItem(new QListWidgetItem(feature_icon(drawing.regions()[static_cast<std::size_t>(i)].feature),
                                         wanted[i]));
  }
  list_->setCurrentRow(drawing.selected() ? static_cast<int>(*drawing.selected()) : -1);
}

QString StereoPanel::obstacle() const {
  const engine::CaseState& now = engine().state();
  if (const auto first = engine::obstacle(now, engine::Reconstruct{})) return obstacle_text(first);
  if (!rig_fits())
    return tr("The calibration is for pictures of %1 × %2, these are %3 × %4: load the one for them.")
        .arg(now[part::rig]->left.width)
        .arg(now[part::rig]->left.height)
        .arg(now[part::frame]->frame.left.width)
        .arg(now[part::frame]->frame.left.height);
  return {};
}

bool StereoPanel::rig_fits() const {
  const engine::CaseState& now = engine().state();
  return now[part::rig] &&
         (!now[part::frame] || stereo::is_rig_of(*now[part::rig], now[part::frame]->frame.left));
}

}  // namespace glisson::ui
