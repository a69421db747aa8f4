// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "glisson/engine/commands/import_image.h"
#include "glisson/ui/common/engine_bridge.h"
#include "glisson/ui/common/linked_views.h"
#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/view_state.h"

class QDialog;
class QScrollArea;
class QStackedWidget;

namespace glisson::ui {

class ImageImport;
class PatientIdentity;
class RecentCases;
class RunningWork;
class StepBar;
class TaskStatus;
class WelcomePage;

/// The window: steps on the left, views in the middle, the open step's controls on the right. Hosts panels
/// and knows no algorithm.
class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  enum Step { segmentation = 0, model = 1, atlas = 2, stereo = 3, guidance = 4 };

  explicit MainWindow(engine::Engine::Options options = {}, QWidget* parent = nullptr);
  ~MainWindow() override;

  /// A case, a volume, a DICOM folder, surfaces, a calibration, a video...: whatever is named, as by File >
  /// Open or by dropping it.
  void open(const std::filesystem::path& path);
  void show_step(int step);
  int step() const { return step_; }
  EngineBridge& engine() { return engine_; }
  LinkedViews& views() { return *views_; }
  Panel& panel(int step) { return *panels_[static_cast<std::size_t>(step)]; }
  QString status_text() const;
  const DrawableSource& drawables() const { return drawables_; }

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void build_menu();
  void build_panels();
  void add_panel(Panel* panel, const QString& icon);
  void open_case();
  void import_image(const std::filesystem::path& path);
  /// Asks whose an image is that was read while a case is open.
  void ask_whose(const engine::ImportImage& image);
  /// Asks first when the present one has changes.
  void replace_case(const std::filesystem::path& path);
  /// Asks first where something would be lost. @param losses says it in a sentence each, or empty.
  void post_asking(const engine::Command& command, const std::function<QStringList()>& losses);
  /// The same of anything that a command with these traits will do.
  void ask_first(const engine::CommandTraits& traits, const std::function<QStringList()>& losses,
                 const std::function<void()>& then);
  /// That a new segmentation waits and would be lost; empty: none.
  QString waiting_words() const;
  void open_dicom();
  void open_volume();
  void export_labels();
  void export_surfaces();
  void save();
  void save_as();
  /// None: nothing is saved. Asks first where work is going on.
  void save_into(const std::optional<std::filesystem::path>& place);
  /// Empty path: where the case lies. None: no place was chosen.
  std::optional<std::filesystem::path> place_to_save();
  std::optional<std::filesystem::path> ask_place();
  void show_case();
  void show_outcome(const engine::Outcome& outcome);
  void show_middle();
  QDialog* show_problem(const QString& sentence);
  void close_after(const std::vector<std::string>& notes);
  void leave(QCloseEvent* event);

  EngineBridge engine_;
  ViewState state_;
  DrawableSource drawables_;
  ImageImport* import_ = nullptr;
  RunningWork* running_ = nullptr;
  PatientIdentity* identity_ = nullptr;
  RecentCases* recent_ = nullptr;
  StepBar* steps_ = nullptr;
  QStackedWidget* middle_ = nullptr;
  QStackedWidget* controls_ = nullptr;
  WelcomePage* welcome_ = nullptr;
  LinkedViews* views_ = nullptr;
  TaskStatus* status_ = nullptr;
  QAction* save_ = nullptr;
  QAction* save_as_ = nullptr;
  QAction* export_labels_ = nullptr;
  QAction* export_surfaces_ = nullptr;
  std::vector<Panel*> panels_;
  int step_ = 0;
  engine::Editions saved_{};                       ///< what stands on the disk
  std::optional<engine::CommandId> closing_save_;  ///< after which the window closes
  bool leaves_ = false;                            ///< nothing is asked any more
};

}  // namespace glisson::ui
