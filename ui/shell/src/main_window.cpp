// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/shell/main_window.h"

#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QScreen>
#include <QStackedWidget>
#include <QStatusBar>
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "glisson/engine/commands/export_labels.h"
#include "glisson/engine/commands/export_surfaces.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/commands/set_video.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/keeping.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/offer.h"
#include "glisson/engine/patient_held.h"
#include "glisson/engine/surface_export.h"
#include "glisson/ui/atlas/atlas_panel.h"
#include "glisson/ui/common/being_made.h"
#include "glisson/ui/common/error_texts.h"
#include "glisson/ui/common/named_video_question.h"
#include "glisson/ui/common/save_name.h"
#include "glisson/ui/common/texts.h"
#include "glisson/ui/common/unit_question.h"
#include "glisson/ui/guidance/guidance_panel.h"
#include "glisson/ui/model/model_panel.h"
#include "glisson/ui/segmentation/segmentation_panel.h"
#include "glisson/ui/shell/case_opening.h"
#include "glisson/ui/shell/image_import.h"
#include "glisson/ui/stereo/stereo_panel.h"
#include "patient_identity.h"
#include "recent_cases.h"
#include "running_work.h"
#include "steady_scroll.h"
#include "step_bar.h"
#include "task_status.h"
#include "welcome_page.h"
#include "wheel_guard.h"
#include "winding_up.h"

namespace glisson::ui {
namespace {

constexpr int kControlsWidth = 360;
constexpr QSize kLargestAtStart(1600, 1000);  ///< smaller screens are filled

/// Whether there is anything that a case would keep: labels or regions alone are a person's work, too.
bool holds_anything(const engine::CaseState& state) {
  const auto& parts = engine::all_parts();
  return std::any_of(parts.begin(), parts.end(),
                     [&](const engine::Part part) { return part.type().is_saved() && state.has(part); });
}

engine::SaveCase save_to(const std::filesystem::path& place) {
  return {place, !place.empty()};  // a place that was chosen was asked about
}

}  // namespace

MainWindow::MainWindow(engine::Engine::Options options, QWidget* parent)
    : QMainWindow(parent), engine_(std::move(options)), drawables_(engine_) {
  setAcceptDrops(true);
  setMinimumSize(1180, 720);
  resize(screen()->availableSize().boundedTo(kLargestAtStart));
  auto* body = new QWidget(this);
  auto* row = new QHBoxLayout(body);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(2);
  steps_ = new StepBar(body);
  middle_ = new QStackedWidget(body);
  controls_ = new QStackedWidget(body);
  controls_->setFixedWidth(kControlsWidth);
  row->addWidget(steps_);
  row->addWidget(middle_, 1);
  row->addWidget(controls_);
  setCentralWidget(body);
  welcome_ = new WelcomePage(middle_);
  middle_->addWidget(welcome_);
  views_ = new LinkedViews(engine_, state_, drawables_, middle_);
  middle_->addWidget(views_);
  new WheelGuard(this);
  build_panels();
  status_ = new TaskStatus(engine_, this);
  statusBar()->addWidget(status_, 1);
  statusBar()->setSizeGripEnabled(false);
  import_ = new ImageImport(engine_, this);
  running_ = new RunningWork(engine_, this);
  build_menu();
  identity_ = new PatientIdentity(this);
  menuBar()->setCornerWidget(identity_);
  connect(import_, &ImageImport::found, this, &MainWindow::ask_whose);
  connect(running_, &RunningWork::waits, status_, &TaskStatus::set_afterwards);
  connect(welcome_, &WelcomePage::open_case, this, &MainWindow::open_case);
  connect(welcome_, &WelcomePage::open_dicom, this, &MainWindow::open_dicom);
  connect(welcome_, &WelcomePage::open_volume, this, &MainWindow::open_volume);
  connect(steps_, &StepBar::chosen, this, &MainWindow::show_step);
  connect(&engine_, &EngineBridge::case_changed, this, &MainWindow::show_case);
  connect(&engine_, &EngineBridge::finished, this, &MainWindow::show_outcome);
  saved_ = engine::editions(engine_.state());
  show_step(segmentation);
  show_case();
}

MainWindow::~MainWindow() {
  // Panels use the engine and the views until they are gone: children go before members.
  delete takeCentralWidget();
}

void MainWindow::build_panels() {
  add_panel(new SegmentationPanel(engine_, state_), QStringLiteral(":/glisson/icons/segmentation.svg"));
  add_panel(new ModelPanel(engine_, *views_), QStringLiteral(":/glisson/icons/model.svg"));
  add_panel(new AtlasPanel(engine_, *views_, state_), QStringLiteral(":/glisson/icons/atlas.svg"));
  add_panel(new StereoPanel(engine_), QStringLiteral(":/glisson/icons/stereo.svg"));
  add_panel(new GuidancePanel(engine_, drawables_), QStringLiteral(":/glisson/icons/guidance.svg"));
}

void MainWindow::add_panel(Panel* panel, const QString& icon) {
  const int step = static_cast<int>(panels_.size());
  panels_.push_back(panel);
  steps_->add_step(panel->title(), icon);
  auto* scroll = new SteadyScroll(controls_);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(panel);
  controls_->addWidget(scroll);
  if (panel->view() != nullptr) middle_->addWidget(panel->view());
  const auto show_state = [this, step, panel] { steps_->set_state(step, panel->step_state()); };
  connect(panel, &Panel::step_state_changed, this, show_state);
  show_state();
}

void MainWindow::build_menu() {
  QMenu* file = menuBar()->addMenu(tr("&File"));
  QMenu* open = file->addMenu(tr("&Open"));
  open->addAction(tr("&DICOM folder…"), this, &MainWindow::open_dicom);
  open->addAction(tr("&Volume…"), this, &MainWindow::open_volume);
  open->addAction(tr("&Case…"), QKeySequence::Open, this, &MainWindow::open_case);
  recent_ = new RecentCases(file);
  file->addMenu(recent_);
  connect(recent_, &RecentCases::chosen, this,
          [this](const QString& path) { replace_case(path.toStdString()); });
  connect(recent_, &RecentCases::missing, this, [this](const QString& path) {
    show_problem(tr("%1 is not there any more. It was taken from the list.").arg(path));
  });
  file->addSeparator();
  save_ = file->addAction(tr("&Save"), QKeySequence::Save, this, &MainWindow::save);
  save_as_ = file->addAction(tr("Save &as…"), QKeySequence::SaveAs, this, &MainWindow::save_as);
  export_labels_ = file->addAction(tr("Export &labels…"), this, &MainWindow::export_labels);
  export_surfaces_ = file->addAction(tr("Export s&urfaces…"), this, &MainWindow::export_surfaces);
  file->addSeparator();
  file->addAction(tr("&Quit"), QKeySequence::Quit, this, &QWidget::close);
  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  edit->addActions(qobject_cast<SegmentationPanel*>(panels_[segmentation])->history_actions());
  menuBar()->addMenu(tr("&View"))->addActions(views_->bar().all_actions());
  QMenu* go = menuBar()->addMenu(tr("&Step"));
  for (int step = 0; step < static_cast<int>(panels_.size()); ++step)
    go->addAction(panels_[static_cast<std::size_t>(step)]->title(), this, [this, step] { show_step(step); });
  QMenu* help = menuBar()->addMenu(tr("&Help"));
  help->addAction(tr("&About Glisson"), this, [this] {
    QMessageBox::about(
        this, tr("About Glisson"),
        tr("<b>Glisson</b><br>Planning and guidance of minimally invasive liver surgery, after "
           "Plantefève, Peterlik, Haouchine and Cotin (2015).<br><br>Research software: not for "
           "clinical use.<br>Licence: GPL-3.0-or-later."));
  });
}

void MainWindow::open(const std::filesystem::path& path) {
  if (const auto opening = opening_of(path)) {
    const auto losses = [this, loses = opening->command.traits().writes.has(part::offer)] {
      return QStringList{loses ? waiting_words() : QString()};
    };
    switch (opening->way) {
      case Opening::Way::replace_case:
        return replace_case(opening->path);
      case Opening::Way::import_image:
        return import_image(opening->path);
      case Opening::Way::open_video:
        return qobject_cast<StereoPanel*>(panels_[stereo])->open_source({opening->path, {}});
      case Opening::Way::import_labels:
        return ask_first(opening->command.traits(), losses, [this, path = opening->path] {
          qobject_cast<SegmentationPanel*>(panels_[segmentation])->import_labels(path);
        });
      case Opening::Way::in_a_unit:
        return ask_unit(this, opening->path,
                        [this, losses, in = opening->in](LengthUnit unit) { post_asking(in(unit), losses); });
      case Opening::Way::plain:
        return post_asking(opening->command, losses);
    }
  }
  show_problem(tr("%1 is nothing that Glisson opens. Give a folder of DICOM slices, a volume (NIfTI, NRRD, "
                  "MetaImage) or a case (NAME.glisson).")
                   .arg(QString::fromStdString(path.string())));
}

QString MainWindow::waiting_words() const {
  return engine_.state()[part::offer]
             ? tr("A new segmentation waits for your decision (Segmentation). Opening this lets it go.")
             : QString();
}

void MainWindow::replace_case(const std::filesystem::path& path) {
  post_asking(engine::OpenCase{path}, [this] {
    const QString unsaved = tr("The case has changes that are not saved. Opening another loses them.");
    return QStringList{isWindowModified() ? unsaved : QString(), waiting_words()};
  });
}

void MainWindow::post_asking(const engine::Command& command, const std::function<QStringList()>& losses) {
  ask_first(command.traits(), losses, [this, command] { engine_.post(command); });
}

void MainWindow::ask_first(const engine::CommandTraits& traits, const std::function<QStringList()>& losses,
                           const std::function<void()>& then) {
  // What is lost is known when the work has ended.
  running_->before(RunningWork::opening(traits, [this, losses, then] {
    QStringList told = losses();
    told.removeAll(QString());
    if (told.isEmpty()) return then();
    auto* box = new QMessageBox(QMessageBox::Question, tr("Open"), told.join(QLatin1Char(' ')),
                                QMessageBox::Discard | QMessageBox::Cancel, this);
    box->setDefaultButton(QMessageBox::Cancel);
    box->setAttribute(Qt::WA_DeleteOnClose);
    connect(box, &QMessageBox::finished, this, [then](int answer) {
      if (answer == QMessageBox::Discard) then();
    });
    box->open();  // does not stop the window
  }));
}

void MainWindow::import_image(const std::filesystem::path& path) {
  // It may become a new case, of which this one has no part.
  running_->before(RunningWork::opening(engine::ImportImage{path, {}, true}.traits(),
                                        [this, path] { import_->start(path); }));
}

void MainWindow::ask_whose(const engine::ImportImage& image) {
  // "The patient who is open" is the one who is when it is answered: of one who is on the way it is asked
  // then.
  if (is_case_to_come(engine_)) {
    connect(
        &engine_, &EngineBridge::finished, this, [this, image] { ask_whose(image); },
        static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection));
    return;
  }
  if (!engine::holds_patient(engine_.state())) return import_->finish(image);  // none came
  auto* box = new QMessageBox(QMessageBox::Question, tr("Open a CT"),
                              tr("Is this CT of another patient, or another one of the patient who is open?"),
                              QMessageBox::Cancel, this);
  box->setObjectName(QStringLiteral("whose_image"));
  QStringList told{isWindowModified()
                       ? tr("A new case loses the changes of this one, which are not saved. The same "
                            "patient's case keeps everything, marked out of date.")
                       : tr("The same patient's case keeps everything, marked out of date."),
                   waiting_words()};
  told.removeAll(QString());
  box->setInformativeText(told.join(QLatin1Char(' ')));
  box->setDefaultButton(QMessageBox::Cancel);
  box->setAttribute(Qt::WA_DeleteOnClose);
  const auto add = [&](const QString& text, const char* name, QMessageBox::ButtonRole role, bool new_case) {
    auto* button = box->addButton(text, role);
    button->setObjectName(QLatin1String(name));
    connect(button, &QPushButton::clicked, this, [this, box, image, new_case] {
      engine_.disconnect(box);  // it is answered
      if (is_case_to_come(engine_)) return ask_whose(image);
      engine::ImportImage answered = image;
      answered.new_case = new_case;
      running_->before(
          RunningWork::opening(answered.traits(), [this, answered] { import_->finish(answered); }));
    });
  };
  add(tr("New case"), "new_case", QMessageBox::AcceptRole, true);
  add(tr("Same patient"), "same_patient", QMessageBox::ActionRole, false);
  connect(&engine_, &EngineBridge::case_changed, box,
          [this, box, image, asked_of = engine_.snapshot()->case_number] {
            if (engine_.snapshot()->case_number == asked_of) return;
            engine_.disconnect(box);
            box->reject();
            ask_whose(image);
          });
  box->open();  // does not stop the window
}

QDialog* MainWindow::show_problem(const QString& sentence) {
  auto* box = new QMessageBox(QMessageBox::Warning, tr("Glisson"), sentence, QMessageBox::Ok, this);
  box->setObjectName(QStringLiteral("problem"));
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();  // does not stop the window
  return box;
}

void MainWindow::open_case() {
  const QString path = QFileDialog::getExistingDirectory(this, tr("Open a case (a folder NAME.glisson)"));
  if (!path.isEmpty()) replace_case(path.toStdString());
}

void MainWindow::open_dicom() {
  const QString path = QFileDialog::getExistingDirectory(this, tr("Open a folder of DICOM slices"));
  if (!path.isEmpty()) import_image(path.toStdString());
}

void MainWindow::open_volume() {
  const QString path =
      QFileDialog::getOpenFileName(this, tr("Open a volume"), {},
                                   tr("Volumes (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.vti *.zip "
                                      "*.tar.gz *.tgz *.tar DICOMDIR dicomdir)"));
  if (!path.isEmpty()) import_image(path.toStdString());
}

std::optional<std::filesystem::path> MainWindow::place_to_save() {
  return engine_.state().path.empty() ? ask_place() : std::filesystem::path();
}

std::optional<std::filesystem::path> MainWindow::ask_place() {
  const QString path = ask_where_to_save(
      this, tr("Save the case as a folder"), QStringLiteral("patient.glisson"), tr("Cases (*.glisson)"),
      {QStringLiteral(".glisson")}, QString::fromStdString(engine_.state().path.string()));
  if (path.isEmpty()) return {};
  return path.toStdString();
}

void MainWindow::save_into(const std::optional<std::filesystem::path>& place) {
  if (place) running_->before(RunningWork::saving([this, place] { engine_.post(save_to(*place)); }));
}

void MainWindow::save() { save_into(place_to_save()); }

void MainWindow::save_as() { save_into(ask_place()); }

void MainWindow::export_labels() {
  const QString path =
      QFileDialog::getSaveFileName(this, tr("Export labels"), QStringLiteral("labels.seg.nrrd"),
                                   tr("Labels (*.seg.nrrd *.dcm *.nii.gz *.nrrd *.mha)"));
  if (!path.isEmpty()) engine_.post(engine::ExportLabels{path.toStdString()});
}

void MainWindow::export_surfaces() {
  QString chosen;
  const QString path = QFileDialog::getSaveFileName(
      this, tr("Export surfaces into a folder"), QStringLiteral("surfaces"),
      QStringLiteral("STL (*.stl);;PLY (*.ply);;OBJ (*.obj);;VTP (*.vtp)"), &chosen);
  if (path.isEmpty()) return;
  engine::ExportSurfaces command{path.toStdString()};
  for (const std::string& ending : engine::surface_endings()) {
    const QString text = QString::fromStdString(ending);
    if (chosen.contains(text)) command.ending = ending;
    // A file's ending that somebody has typed names the format, not the folder.
    if (path.endsWith(text)) command = {path.chopped(text.size()).toStdString(), ending};
    if (path.endsWith(text)) break;
  }
  QStringList there;
  for (const auto& file : engine::surfaces_in(command.folder, command.ending))
    there << QString::fromStdString(file.string());
  if (may_be_replaced(this, there)) engine_.post(command);
}

void MainWindow::show_step(int step) {
  panels_[static_cast<std::size_t>(step_)]->deactivate();
  step_ = step;
  steps_->set_current(step);
  controls_->setCurrentIndex(step);
  panels_[static_cast<std::size_t>(step)]->activate();
  show_middle();
}

void MainWindow::show_middle() {
  QWidget* own = panels_[static_cast<std::size_t>(step_)]->view();
  const engine::CaseState& now = engine_.state();
  if (own != nullptr)
    middle_->setCurrentWidget(own);
  else if (now[part::image] || now[part::labels] || now[part::model])
    middle_->setCurrentWidget(views_);
  else
    middle_->setCurrentWidget(welcome_);
}

void MainWindow::show_case() {
  const engine::CaseState& now = engine_.state();
  const QString name = now.path.empty() ? (holds_anything(now) ? tr("unsaved case") : QString())
                                        : QString::fromStdString(now.path.filename().string());
  const auto& keeping = now[part::keeping];
  const bool for_reading = keeping && keeping->writer;
  setWindowTitle(name.isEmpty() ? tr("Glisson")
                 : for_reading  ? tr("%1 (for reading)[*] – Glisson").arg(name)
                                : tr("%1[*] – Glisson").arg(name));
  identity_->show_case(now);
  menuBar()->setCornerWidget(identity_);  // laid out anew: its width changes
  save_->setEnabled(!name.isEmpty());
  save_as_->setEnabled(!name.isEmpty());
  export_labels_->setEnabled(!engine::obstacle(now, engine::ExportLabels{}));
  export_surfaces_->setEnabled(!engine::obstacle(now, engine::ExportSurfaces{}));
  setWindowModified(!name.isEmpty() && engine::editions(now) != saved_);
  show_middle();
}

void MainWindow::show_outcome(const engine::Outcome& outcome) {
  const bool closes = outcome.id == closing_save_;
  if (closes) closing_save_.reset();
  if (const auto on_disk = outcome.result.as<engine::CaseOnDisk>()) {
    // The case may have gone on while it was being saved.
    saved_ = on_disk->editions;
    recent_->add(engine_.state().path);
    show_case();
    if (closes) return close_after(outcome.notes);
  }
  // A panel's own button shows its own error and notes; what came from the menu or a drop has no other place.
  if (outcome.traits.notice != engine::Notice::files) return;
  if (outcome.status == engine::Status::failed) show_problem(error_text(outcome.error));
  // What is odd about a file is told before work on it begins; of a save or an export, what became otherwise.
  // A model has a sheet of its own for it.
  const bool has_sheet = outcome.traits.writes.has(part::model) && !outcome.traits.replaces_case();
  const std::vector<std::string> notes = ask_named_video(this, engine_, outcome);
  if (outcome.status == engine::Status::done && !notes.empty() && !has_sheet) show_problem(notes_text(notes));
}

/// What became otherwise of the save that closes the window is read before it does, which asks again where it
/// has.
void MainWindow::close_after(const std::vector<std::string>& notes) {
  if (notes.empty())
    close();
  else
    connect(show_problem(notes_text(notes)), &QDialog::finished, this, [this] { close(); });
}

QString MainWindow::status_text() const { return status_->text(); }

void MainWindow::closeEvent(QCloseEvent* event) {
  const RunningWork::Wish closing = RunningWork::closing([this] { close(); });
  if (running_->concerns(closing)) {
    event->ignore();
    return running_->before(closing);
  }
  QStringList losses;
  if (isWindowModified()) losses << tr("The case has changes that are not saved.");
  if (engine_.state()[part::offer])
    losses << tr(
        "A new segmentation waits for your decision (Segmentation). Closing lets it go; your labels "
        "are kept as they are.");
  if (leaves_ || losses.isEmpty()) return leave(event);
  const QString told = losses.join(QLatin1Char(' '));
  if (!isWindowModified()) {
    const auto answer =
        QMessageBox::question(this, tr("Close"), told, QMessageBox::Close | QMessageBox::Cancel);
    return answer == QMessageBox::Close ? leave(event) : event->ignore();
  }
  const auto answer = QMessageBox::question(this, tr("Close"), told,
                                            QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  if (answer == QMessageBox::Discard) return leave(event);
  event->ignore();
  if (answer != QMessageBox::Save) return;
  if (const auto path = place_to_save())
    closing_save_ = engine_.post(save_to(*path));  // closes when the outcome comes
}

/// What must not be cut short is brought to its end first, and what went wrong is told.
void MainWindow::leave(QCloseEvent* event) {
  const auto go = [this] {
    leaves_ = true;
    close();
  };
  const bool waits = wind_up(panels_, this, go, [this](const QString& problem) { show_problem(problem); });
  event->setAccepted(!waits);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile() && opening_of(url.toLocalFile().toStdString()))
      return event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile()) open(url.toLocalFile().toStdString());
  event->acceptProposedAction();
}

}  // namespace glisson::ui
