// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/guidance_panel.h"

#include <QCheckBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QVBoxLayout>

#include "glisson/ui/common/texts.h"

namespace glisson::ui {
namespace {

constexpr double kFreshSeconds = 0.5;  ///< a live picture that is older is marked
constexpr qint64 kRateWindow = 2000;   ///< milliseconds over which the frame rate is counted

}  // namespace

GuidancePanel::GuidancePanel(EngineBridge& engine, DrawableSource& drawables, QWidget* parent)
    : Panel(engine, tr("Guidance"), tr("The model brought to what the laparoscope sees, and kept there."),
            parent),
      drawables_(drawables),
      feed_([&engine](StereoFrame frame) { engine.submit_frame(std::move(frame)); }) {
  setObjectName(QStringLiteral("guidance_panel"));
  clock_.start();
  build_view();
  build_registration();
  build_tracking();
  build_look();
  connect(&worker_, &OverlayWorker::painted, this, &GuidancePanel::show_painted);
  connect(&worker_, &OverlayWorker::failed, this, &GuidancePanel::show_failed);
  connect(
      &worker_, &OverlayWorker::recording_ended, this,
      [this](const QString& path, int frames, const QString& error) {
        is_recording_ = false;
        recording_->setText(error.isEmpty() ? tr("Frames recorded: %1, in %2").arg(frames).arg(path) : error);
        set_style_property(recording_, "role", error.isEmpty() ? "good" : "error");
        show_buttons();
      });
  connect(&feed_, &VideoFeed::ended, this, [this] {
    if (!is_playing()) return;
    repeat_now_ = repeat_->isChecked();
    stop_tracking(tr("The video has ended. Last picture, not live."));
  });
  connect(&feed_, &VideoFeed::failed, this, [this](const QString& message) {
    if (is_playing()) stop_tracking(message);
  });
  connect(&this->engine(), &EngineBridge::case_changed, this, &GuidancePanel::show_case);
  connect(&this->engine(), &EngineBridge::live_changed, this, &GuidancePanel::show_live);
  connect(&drawables_, &DrawableSource::changed, this, &GuidancePanel::redraw);
  connect(&freshness_, &QTimer::timeout, this, &GuidancePanel::show_freshness);
  freshness_.start(100);
  watch(engine::Part::registration, {"register", "import_registration"});
  show_case();
}

GuidancePanel::~GuidancePanel() {
  feed_.stop();
  if (view_ && view_->parent() == nullptr) delete view_;  // nobody hosted it
}

void GuidancePanel::build_view() {
  view_ = new QWidget;
  view_->setObjectName(QStringLiteral("guidance_view"));
  auto* layout = new QVBoxLayout(view_);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  banner_ = new QLabel(view_);
  banner_->setProperty("role", "banner");
  banner_->setWordWrap(true);
  banner_->hide();
  layout->addWidget(banner_);
  picture_ = new PictureView({}, view_);
  picture_->set_hint(
      tr("Register the model to a frame of the laparoscope; the augmented picture appears here."));
  layout->addWidget(picture_, 1);
  live_line_ = new QLabel(view_);
  live_line_->setProperty("role", "probe");
  live_line_->setContentsMargins(10, 4, 10, 4);
  layout->addWidget(live_line_);
}

void GuidancePanel::build_registration() {
  QVBoxLayout* box =
      add_section(tr("1. Initial registration"),
                  tr("Rigid start from the labelled features; then the shape that simulated operations on "
                     "this liver make most probable, drawn to the points."));
  unchecked_ = make_warning(this);
  unchecked_->setText(tr("Nobody has checked this model (Model, Quality). The picture says so."));
  unchecked_->setObjectName(QStringLiteral("model_unchecked"));
  box->addWidget(unchecked_);
  register_ = new TaskButton(
      engine(), tr("Register"), [] { return engine::Command(engine::Register{}); }, this);
  register_->setObjectName(QStringLiteral("register"));
  box->addWidget(register_);
  registration_figures_ = new FiguresTable(this);
  box->addWidget(registration_figures_);
  doubts_ = make_warning(this);
  box->addWidget(doubts_);
}

void GuidancePanel::build_tracking() {
  QVBoxLayout* box =
      add_section(tr("2. Live tracking"), tr("Plays the case's stereo video as a live laparoscope."));
  track_ = new TaskButton(
      engine(), tr("Start tracking"), [] { return engine::Command(engine::StartTracking{}); }, this);
  track_->setObjectName(QStringLiteral("start_tracking"));
  box->addWidget(track_);
  auto* row = new QHBoxLayout;
  stop_ = new QPushButton(tr("Stop"), this);
  stop_->setObjectName(QStringLiteral("stop_tracking"));
  record_ = new QPushButton(tr("Record…"), this);
  record_->setObjectName(QStringLiteral("record"));
  row->addWidget(stop_);
  row->addWidget(record_);
  box->addLayout(row);
  repeat_ = new QCheckBox(tr("Repeat the video"), this);
  repeat_->setToolTip(tr("At its end, track again from the registered frame."));
  box->addWidget(repeat_);
  recording_ = new QLabel(this);
  recording_->setWordWrap(true);
  box->addWidget(recording_);
  live_figures_ = new FiguresTable(this);
  box->addWidget(live_figures_);
  connect(track_, &TaskButton::done, this, [this](const engine::Outcome& outcome) {
    const engine::CaseState& now = engine().state();
    if (outcome.status != engine::Status::done || !now.video || !now.frame) return;
    if (!engine().snapshot()->tracking) return;  // ended already, as by another case
    unfreeze();
    painted_at_.clear();
    since_painted_.invalidate();
    feed_.start(*now.video, now.frame->frame.index + 1);
    show_buttons();
  });
  connect(stop_, &QPushButton::clicked, this, [this] {
    repeat_now_ = false;
    stop_tracking(tr("Tracking was stopped. Last picture, not live."));
  });
  connect(record_, &QPushButton::clicked, this, &GuidancePanel::toggle_recording);
}

void GuidancePanel::build_look() {
  QVBoxLayout* box = add_section(tr("Overlay"));
  const std::array<std::pair<QString, bool scene::OverlayStyle::*>, 5> parts = {
      {{tr("Portal vein"), &scene::OverlayStyle::portal_vein},
       {tr("Hepatic veins"), &scene::OverlayStyle::hepatic_veins},
       {tr("Lesions"), &scene::OverlayStyle::lesions},
       {tr("Liver outline"), &scene::OverlayStyle::outline},
       {tr("Anterior margin"), &scene::OverlayStyle::anterior_margin}}};
  auto* grid = new QGridLayout;
  int cell = 0;
  for (const auto& [name, member] : parts) {
    auto* check = new QCheckBox(name, this);
    check->setChecked(style_.*member);
    grid->addWidget(check, cell / 2, cell % 2);
    ++cell;
    connect(check, &QCheckBox::toggled, this, [this, shown = member](bool on) {
      style_.*shown = on;
      redraw();
    });
  }
  box->addLayout(grid);
  auto* opacity = new QSlider(Qt::Horizontal, this);
  opacity->setRange(10, 100);
  opacity->setValue(static_cast<int>(100 * style_.opacity));
  auto* form = new QFormLayout;
  form->addRow(tr("Vessel opacity"), opacity);
  box->addLayout(form);
  connect(opacity, &QSlider::valueChanged, this, [this](int value) {
    style_.opacity = value / 100.0;
    redraw();
  });
}

OverlayJob GuidancePanel::make_job() {
  const engine::CaseState& now = engine().state();
  // One object as long as nothing changes: the painter binds the margin once for it.
  if (now.model != model_source_ || now.landmarks != landmarks_source_) {
    model_source_ = now.model;
    landmarks_source_ = now.landmarks;
    margin_ = now.model ? std::make_shared<const Points>(engine::effective_landmarks(now).anterior_margin)
                        : nullptr;
  }
  OverlayJob job;
  job.model = drawables_.drawable();
  job.margin = margin_;
  job.rig = now.rig;
  job.style = style_;
  job.model_unchecked = now.model && !engine::is_model_checked(now);
  return job;
}

void GuidancePanel::show_case() {
  const engine::CaseState& now = engine().state();
  const bool tracking = engine().snapshot()->tracking;
  register_->set_obstacle(registration_obstacle());
  unchecked_->setVisible(now.model && !engine::is_model_checked(now));
  if (now.registration) {
    const Registration& r = *now.registration;
    registration_figures_->set_rows(
        {{tr("Residual (not an accuracy)"), tr("%1 mm").arg(1e3 * r.residual, 0, 'f', 2)},
         {tr("Converged"), r.termination == Termination::converged ? tr("yes, %1 plateaus").arg(r.plateaus)
                                                                   : tr("no, %1 steps").arg(r.steps)}});
    show_warning(*doubts_, notes_text(r.doubts));
  } else {
    registration_figures_->clear();
    doubts_->hide();
  }
  if (was_tracking_ && !tracking) {
    feed_.stop();
    if (is_recording_) worker_.stop_recording();
  }
  if (tracking && !was_tracking_) ++generation_;  // what is still being painted is not live
  was_tracking_ = tracking;
  const bool outdated = !now.frame || now.registration != frozen_registration_ ||
                        engine().snapshot()->stage(engine::Part::registration) != engine::StageState::current;
  if (is_frozen_ && outdated) unfreeze();
  if (!tracking && !is_frozen_) {
    ++generation_;  // what is still being painted is of the case as it was, or of another one
    show_registered();
  }
  show_buttons();
  if (!tracking && repeat_now_) {
    repeat_now_ = false;
    track_->trigger();
  }
}

void GuidancePanel::unfreeze() {
  is_frozen_ = false;
  repeat_now_ = false;
  frozen_why_.clear();
  frozen_registration_.reset();
}

void GuidancePanel::put_away() {
  job_.reset();
  picture_->set_picture({});
  live_line_->clear();
  set_style_property(live_line_, "fresh", {});
  live_figures_->clear();
  banner_->hide();
}

void GuidancePanel::submit(OverlayJob job) {
  job.generation = generation_;
  job_ = job;
  worker_.submit(std::move(job));
}

void GuidancePanel::redraw() {
  if (!is_frozen_) {
    if (!engine().snapshot()->tracking) show_registered();
    return;
  }
  if (!job_) return;
  OverlayJob job = *job_;
  job.style = style_;
  if (drawables_.drawable()) job.model = drawables_.drawable();
  job.taken.reset();  // it is not live any more
  job.frames_per_second = 0.0;
  submit(std::move(job));
}

void GuidancePanel::show_registered() {
  const engine::CaseState& now = engine().state();
  if (!now.frame) return put_away();
  OverlayJob job = make_job();
  job.frame = now.frame->frame.left;
  job.overlay.index = now.frame->frame.index;
  if (now.registration) {
    const bool current =
        engine().snapshot()->stage(engine::Part::registration) == engine::StageState::current;
    job.overlay.validity = current ? Validity::valid : Validity::stale;
    job.overlay.nodes_in_camera = now.registration->nodes_in_camera;
    job.overlay.residual = now.registration->residual;
    job.overlay.doubtful = !now.registration->doubts.empty();
  }
  submit(std::move(job));
}

void GuidancePanel::show_live() {
  const engine::CaseState& now = engine().state();
  if (!now.live || now.live->frame.left.empty() || !engine().snapshot()->tracking) return;
  OverlayJob job = make_job();
  job.frame = now.live->frame.left;
  job.overlay = now.live->overlay;
  if (engine().snapshot()->stage(engine::Part::live) == engine::StageState::stale)
    job.overlay.validity = Validity::stale;
  job.taken = feed_.sent_at(now.live->frame.index);
  job.source_rate = feed_.frames_per_second();
  if (painted_at_.size() > 1)
    job.frames_per_second =
        1e3 * static_cast<double>(painted_at_.size() - 1) /
        static_cast<double>(std::max<qint64>(1, painted_at_.back() - painted_at_.front()));
  submit(std::move(job));
}

void GuidancePanel::show_painted(const Picture& picture, const OverlayFrame& overlay, double age, double draw,
                                 int generation) {
  if (generation != generation_) return;
  picture_->set_picture(picture);
  ++pictures_shown_;
  last_age_ = age;
  shown_index_ = overlay.index;
  since_painted_.start();
  shown_validity_ = overlay.validity;
  if (is_frozen_) {  // the last live pictures may still come in
    banner_->setText(frozen_why_);
    return;
  }
  const engine::Snapshot& now = *engine().snapshot();
  if (!now.tracking || !now.state.live) return show_still(overlay);
  show_live_figures(overlay, draw);
  show_freshness();
}

void GuidancePanel::show_failed(const QString& message, int generation) {
  if (generation != generation_) return;
  // What is on the screen is of the case as it was, unless it says that it is a former picture.
  if (!is_frozen_ && !engine().snapshot()->tracking) put_away();
  banner_->setText(is_frozen_ ? frozen_why_ + QLatin1Char('\n') + message : message);
  banner_->show();
}

void GuidancePanel::show_still(const OverlayFrame& overlay) {
  const bool valid = overlay.validity == Validity::valid;
  live_line_->setText(valid ? tr("Registered frame %1, not live").arg(overlay.index)
                            : tr("Frame %1, not live").arg(overlay.index));
  set_style_property(live_line_, "fresh", valid);
  live_figures_->clear();
  banner_->hide();
}

void GuidancePanel::show_live_figures(const OverlayFrame& overlay, double draw) {
  const engine::LiveState& live = *engine().state().live;
  painted_at_.push_back(clock_.elapsed());
  while (painted_at_.back() - painted_at_.front() > kRateWindow) painted_at_.pop_front();
  const auto ms = [](double value) { return tr("%1 ms").arg(value, 0, 'f', 0); };
  live_figures_->set_rows(
      {{tr("Tracked points, left / right"),
        tr("%1 / %2").arg(overlay.tracked_left).arg(overlay.tracked_right)},
       {tr("Pairs"), QString::number(overlay.pairs)},
       {tr("Residual (not an accuracy)"), tr("%1 mm").arg(1e3 * overlay.residual, 0, 'f', 2)},
       {tr("Tracking and mechanics"), ms(overlay.milliseconds)},
       {tr("Drawing"), ms(1e3 * draw)},
       {tr("Frames late / dropped"), tr("%1 / %2").arg(live.frames_late).arg(live.frames_dropped)}});
}

void GuidancePanel::show_freshness() {
  if (is_frozen_ || !engine().snapshot()->tracking || !engine().state().live || !since_painted_.isValid())
    return;
  const double age = last_age_ + since_painted_.elapsed() / 1e3;
  const double span =
      painted_at_.size() > 1 ? static_cast<double>(painted_at_.back() - painted_at_.front()) : 0.0;
  const double rate = span > 0.0 ? 1e3 * static_cast<double>(painted_at_.size() - 1) / span : 0.0;
  QString line = tr("LIVE   frame %1   age %2 ms   %3 frames/s")
                     .arg(shown_index_)
                     .arg(1e3 * age, 0, 'f', 0)
                     .arg(rate, 0, 'f', 1);
  const bool valid = shown_validity_ == Validity::valid;
  if (!valid)
    line += tr("   NO OVERLAY: %1").arg(QString::fromStdString(scene::validity_text(shown_validity_)));
  live_line_->setText(line);
  set_style_property(live_line_, "fresh", valid && age < kFreshSeconds && !drawables_.is_preparing());
  const bool old = age > kFreshSeconds;
  const bool preparing = drawables_.is_preparing();
  if (old)
    banner_->setText(
        tr("The picture is %1 s old: the overlay does not show where things are now.").arg(age, 0, 'f', 1));
  if (!old && preparing) banner_->setText(tr("The overlay is being prepared: the picture shows none yet."));
  banner_->setVisible(old || preparing);
}

void GuidancePanel::show_buttons() {
  const bool tracking = engine().snapshot()->tracking;
  track_->set_obstacle(tracking ? tr("Tracking is running.") : tracking_obstacle());
  stop_->setEnabled(tracking);
  record_->setEnabled(tracking || is_recording_);
  record_->setText(is_recording_ ? tr("Stop recording") : tr("Record…"));
  set_style_property(record_, "role", is_recording_ ? "recording" : "");
}

bool GuidancePanel::is_playing() const { return engine().snapshot()->tracking && !is_frozen_; }

void GuidancePanel::stop_tracking(const QString& why) {
  feed_.stop();
  if (is_recording_) worker_.stop_recording();
  if (engine().snapshot()->tracking) engine().post(engine::StopTracking{});
  is_frozen_ = true;
  frozen_why_ = why;
  frozen_registration_ = engine().state().registration;
  banner_->setText(why);
  banner_->show();
  live_line_->setText(tr("Not live"));
  set_style_property(live_line_, "fresh", false);
}

void GuidancePanel::toggle_recording() {
  if (is_recording_) return record_to({});
  const QString path = QFileDialog::getSaveFileName(this, tr("Record the live view"),
                                                    QStringLiteral("overlay.mkv"), tr("Video (*.mkv)"));
  if (!path.isEmpty()) record_to(path);
}

void GuidancePanel::record_to(const QString& path) {
  if (path.isEmpty()) {
    worker_.stop_recording();
    return;
  }
  worker_.start_recording(path.toStdString());
  is_recording_ = true;
  recording_->setText(tr("Recording to %1").arg(path));
  set_style_property(recording_, "role", "warning");
  show_buttons();
}

QString GuidancePanel::outdated_input() const {
  using engine::Part;
  const engine::Snapshot& now = *engine().snapshot();
  const auto stale = [&](Part part) { return now.stage(part) == engine::StageState::stale; };
  // Made again of such an input, the part would be out of date as before.
  const auto stale_input = [&](Part part, Part input) {
    return stale(input) && now.state.stamp(part).made_from.contains(input);
  };
  if (stale_input(Part::model, Part::labels))
    return tr("The labels are out of date: segment or import them again (Segmentation).");
  if (stale(Part::model)) return tr("The model is out of date: build it again (Model).");
  if (stale(Part::landmarks))
    return tr("The landmarks are those of another model: look at them and accept them (Landmarks).");
  if (!stale(Part::cloud)) return {};
  if (stale_input(Part::cloud, Part::frame))
    return tr("The frame is of a former video: take one of the present video (Stereo).");
  if (stale_input(Part::cloud, Part::regions))
    return tr("The regions are those of another frame: draw them again or clear them (Stereo).");
  return tr("The points are out of date: reconstruct the surface again (Stereo).");
}

QString GuidancePanel::registration_obstacle() const {
  const engine::CaseState& now = engine().state();
  if (!now.model) return tr("Build a model first.");
  if (!now.cloud) return tr("Reconstruct the surface first (Stereo).");
  return outdated_input();
}

QString GuidancePanel::tracking_obstacle() const {
  const engine::CaseState& now = engine().state();
  if (!now.registration) return tr("Register first.");
  if (engine().snapshot()->stage(engine::Part::registration) == engine::StageState::stale) {
    const QString first = registration_obstacle();
    return first.isEmpty() ? tr("The registration is out of date: register again.") : first;
  }
  if (!now.video) return tr("The case has no stereo video (Stereo, Video…).");
  if (!now.frame || !now.rig) return tr("The registered frame or the calibration is missing.");
  return {};
}

}  // namespace glisson::ui
