// SPDX-License-Identifier: GPL-3.0-or-later
// What the guidance panel shows and says is of the case that is open, and of now.
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QToolButton>
#include <QTreeWidget>
#include <QtTest>
#include <algorithm>
#include <atomic>
#include <utility>

#include "fake_operation.h"
#include "glisson/core/files.h"
#include "glisson/engine/commands/build_model.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/load_video_frame.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/reconstruct.h"
#include "glisson/engine/commands/register.h"
#include "glisson/engine/commands/segment.h"
#include "glisson/engine/commands/set_calibration.h"
#include "glisson/engine/commands/set_landmarks.h"
#include "glisson/engine/commands/set_regions.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/commands/set_video.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/video.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/guidance/guidance_panel.h"
#include "glisson/ui/guidance/video_feed.h"
#include "glisson/ui/shell/main_window.h"
#include "run_in_window.h"

namespace glisson {

using engine::Part;
using engine::StageState;
using ui::MainWindow;

class GuidancePanelTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void cleanup();
  void EveryPlayingKnowsWhenItsFramesWereSent();
  void NothingOfTheFormerCaseStays();
  void NothingOfTheFormerLiveViewStays();
  void TheLiveLineTellsTheLevelAndWhy();
  void TimesFromTheCameraToTheScreenAreTold();
  void TheRawPictureStandsBesideTheOverlay();
  void TheTableTellsOfEachLesion();
  void AChosenLesionTellsItsNumbers();
  void LastPictureStaysUntilAnotherCaseWhateverItsStyle();
  void OverTheLastPictureKeysTakeNoRegistrationBack();
  void TheOtherPlaceIsLookedAtOverThePicture();
  void AHandPlacesTheOrganOverThePicture();
  void TheOrganIsShownInThreeDimensions();
  void ErrorGoesWithItsCause();
  void ObstaclesNameTheStepThatHelps();

 private:
  /// FakeOperation opens no cases: here every one holds a CT and nothing else.
  engine::Engine::Options with_other_case() const {
    engine::Engine::Options options = operation_->options();
    options.apply = [apply = options.apply, ct = std::make_shared<const Image>(operation_->ct)](
                        const engine::CaseState& state, const engine::Command& command,
                        const RunContext& context,
                        const engine::Services& services) -> Cancellable<engine::Applied> {
      if (command.as<engine::OpenCase>() == nullptr) return apply(state, command, context, services);
      engine::Applied applied;
      applied.state[part::image] = ct;
      applied.state.stamp(part::image).revision = 1;
      applied.keeps_stamps = true;
      return applied;
    };
    return options;
  }
  void post(engine::Command command) {
    window_->engine().post(std::move(command));
    QVERIFY(QTest::qWaitFor([this] { return window_->engine().tasks().empty(); }, 20000));
  }
  void reach_registration(int frames) {
    operation_->film(folder_->path() / "scope.mkv", frames);
    post(engine::ImportImage{"ct.nii"});
    post(engine::SetSeeds{});
    post(engine::Segment{});
    post(engine::BuildModel{});
    post(engine::SetLandmarks{operation_->model.landmarks});
    post(engine::SetCalibration{"scope.yml"});
    post(engine::SetVideo{operation_->video, {}});
    post(engine::LoadVideoFrame{2});
    post(engine::SetRegions{});
    post(engine::Reconstruct{});
    post(engine::Register{});
    QCOMPARE(window_->engine().snapshot()->stage(part::registration), StageState::current);
    window_->show_step(MainWindow::guidance);
    QTRY_VERIFY_WITH_TIMEOUT(window_->drawables().drawable() != nullptr, 20000);
    QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("Registered frame 2, not live")), 20000);
  }

  ui::GuidancePanel& panel() const { return *window_->findChild<ui::GuidancePanel*>(); }
  const Picture& picture() const { return panel().picture().picture(); }
  bool is_tracking() const { return window_->engine().snapshot()->tracking; }
  ui::TaskButton* task(const char* name) const {
    return window_->findChild<ui::TaskButton*>(QString::fromLatin1(name));
  }
  void press(const char* name) const { QTest::mouseClick(task(name)->button(), Qt::LeftButton); }
  QCheckBox* lesions() const {
    const QList<QCheckBox*> boxes = panel().findChildren<QCheckBox*>();
    const auto box = std::find_if(boxes.begin(), boxes.end(), [](const QCheckBox* one) {
      return one->text() == QStringLiteral("Lesions");
    });
    return box == boxes.end() ? nullptr : *box;
  }

  static QString words_on(const QWidget& widget) {
    QStringList words;
    for (const QLabel* label : widget.findChildren<QLabel*>())
      if (!label->isHidden() && !label->text().isEmpty()) words << label->text();
    return words.join(QLatin1Char('\n'));
  }
  /// Above and below the picture.
  QString said() const { return words_on(live_view()); }
  ui::LiveView& live_view() const { return *panel().view()->findChild<ui::LiveView*>(); }
  /// Under the button; empty: it can be pressed.
  QString obstacle(const char* name) const {
    const QString words = words_on(*task(name));
    return task(name)->button()->isEnabled() ? QString() : words;
  }
  bool is_blank() const {
    for (const QLabel* label : live_view().findChildren<QLabel*>())
      if (label->property("fresh").isValid()) return false;
    const bool has_live_figures = words_on(panel()).contains(QStringLiteral("Drawing"));
    return picture().empty() && said().isEmpty() && !has_live_figures;
  }
  /// Also of what was on its way nothing comes.
  bool stays_blank() const {
    return !QTest::qWaitFor([this] { return !is_blank(); }, 500);
  }
  /// No picture is on its way any more.
  bool rests() const {
    int shown = -1;
    QElapsedTimer since;
    return QTest::qWaitFor(
        [&] {
          if (std::exchange(shown, panel().pictures_shown()) != panel().pictures_shown()) since.start();
          return since.elapsed() > 500;
        },
        20000);
  }
  /// Of both, the panel's and the picture's.
  bool do_keys_undo() const {
    const QList<QShortcut*> keys =
        panel().findChildren<QShortcut*>() + panel().view()->findChildren<QShortcut*>();
    return std::any_of(keys.begin(), keys.end(), [](const QShortcut* one) {
      return one->key() == QKeySequence(QKeySequence::Undo) && one->isEnabled();
    });
  }
  /// The next one, after the lesions were switched on or off. Empty: none came.
  Picture picture_with_other_style() const {
    const int before = panel().pictures_shown();
    lesions()->click();
    const bool came = QTest::qWaitFor([&] { return panel().pictures_shown() > before; }, 20000);
    return came ? picture() : Picture{};
  }

  std::unique_ptr<TemporaryFolder> folder_;
  std::unique_ptr<FakeOperation> operation_;
  std::unique_ptr<MainWindow> window_;
};

void GuidancePanelTest::init() {
  folder_ = std::make_unique<TemporaryFolder>();
  operation_ = std::make_unique<FakeOperation>();
  make_box_operation(*operation_);
  window_ = std::make_unique<MainWindow>(with_other_case());
  window_->resize(1280, 800);
  window_->show();
  QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
}

void GuidancePanelTest::cleanup() {
  window_.reset();
  operation_.reset();
  folder_.reset();
}

void GuidancePanelTest::EveryPlayingKnowsWhenItsFramesWereSent() {
  using Clock = ui::VideoFeed::Clock;
  constexpr int kFrames = 130;  // more than a feed remembers
  const std::filesystem::path file = folder_->path() / "fast.mkv";
  stereo::VideoWriter writer(file, 64, 32, 250.0);
  for (int i = 0; i < kFrames; ++i) writer.write(FakeOperation::picture(64, 32, i));
  writer.close();

  std::atomic<Clock::rep> begun{0};
  std::atomic<int> sent{0}, unknown{0};
  int ended = 0;
  QObject listener;
  std::unique_ptr<ui::VideoFeed> feed;
  feed = std::make_unique<ui::VideoFeed>([&](const StereoFrame& frame) {
    const auto at = feed->sent_at(frame.index);
    if (!at || at->time_since_epoch().count() < begun.load()) ++unknown;
    ++sent;
  });
  connect(feed.get(), &ui::VideoFeed::ended, &listener, [&ended] { ++ended; });
  for (int playing = 1; playing <= 2; ++playing) {
    begun = Clock::now().time_since_epoch().count();
    feed->start(engine::VideoSource{file, {}}, 0);
    QTRY_COMPARE_WITH_TIMEOUT(ended, playing, 20000);
    QCOMPARE(sent.load(), playing * kFrames);
    QCOMPARE(unknown.load(), 0);
  }
}

void GuidancePanelTest::NothingOfTheFormerCaseStays() {
  reach_registration(10);
  QVERIFY(!is_blank());
  lesions()->click();  // a picture is on its way when the other case comes
  post(engine::OpenCase{"other.glisson"});
  QVERIFY(window_->engine().state()[part::frame] == nullptr);
  QVERIFY2(is_blank(), qPrintable(said()));
  QVERIFY2(stays_blank(), qPrintable(said()));
}

void GuidancePanelTest::NothingOfTheFormerLiveViewStays() {
  reach_registration(120);
  press("start_tracking");
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("LIVE")), 20000);
  post(engine::OpenCase{"other.glisson"});
  QVERIFY(!is_tracking());
  QVERIFY2(is_blank(), qPrintable(said()));
  QVERIFY2(stays_blank(), qPrintable(said()));
}

void GuidancePanelTest::TheLiveLineTellsTheLevelAndWhy() {
  reach_registration(300);
  press("start_tracking");
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("LIVE")), 20000);
  QVERIFY2(!said().contains(QStringLiteral("ONLY")) && !said().contains(QStringLiteral("NO OVERLAY")),
           qPrintable(said()));
  operation_->live_validity = Validity::partly_covered;
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("OUTLINE ONLY: part of the organ is covered")),
                           20000);
  operation_->live_validity = Validity::picture_stands;
  QTRY_VERIFY_WITH_TIMEOUT(
      said().contains(QStringLiteral("NO OVERLAY: the picture stands still. Check the camera")), 20000);
}

void GuidancePanelTest::TimesFromTheCameraToTheScreenAreTold() {
  reach_registration(60);
  QVERIFY(rests());
  QCOMPARE(panel().live().screen_times().count(), 0);  // the registered frame is not live
  QStringList told;
  connect(&panel().live(), &ui::LiveViewModel::times_told, window_.get(),
          [&told](const ui::ScreenTimes& times) { told << QString::fromStdString(line_of(times)); });
  press("start_tracking");
  QTRY_VERIFY_WITH_TIMEOUT(words_on(panel()).contains(QStringLiteral("Camera to screen, median / 99 %")),
                           20000);
  QTRY_VERIFY_WITH_TIMEOUT(panel().live().screen_times().count() >= 3, 20000);
  QVERIFY(*panel().live().screen_times().percentile(0.5) > 0.0);
  // What is on the screen was made for it beside the window's thread.
  QTRY_VERIFY_WITH_TIMEOUT(!panel().live().on_screen().screen.isNull(), 20000);
  const ui::LivePicture& view = live_view().picture();
  QCOMPARE(panel().live().on_screen().screen.size(), view.screen_size({picture().width, picture().height}));
  QTRY_COMPARE_WITH_TIMEOUT(told.size(), qsizetype{1}, 20000);
  QVERIFY2(told.front().startsWith(QStringLiteral("camera to screen ")), qPrintable(told.front()));
}

void GuidancePanelTest::TheRawPictureStandsBesideTheOverlay() {
  reach_registration(60);
  QVERIFY(rests());
  auto* raw = live_view().findChild<ui::PictureView*>(QStringLiteral("raw_picture"));
  QVERIFY(!raw->isVisible());
  QTest::keyClick(const_cast<ui::LivePicture*>(&live_view().picture()), Qt::Key_B);
  QVERIFY(raw->isVisible());
  const auto& frame = window_->engine().state()[part::frame]->frame;
  QTRY_VERIFY_WITH_TIMEOUT(!raw->picture().empty() && *raw->picture().bytes == *frame.left.bytes, 20000);
  QVERIFY(*raw->picture().bytes != *picture().bytes);
  QVERIFY(raw->width() > 200 && std::abs(raw->width() - live_view().picture().width()) < 4);
  press("start_tracking");
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("LIVE")), 20000);
  // Both are of one moment.
  QTRY_VERIFY_WITH_TIMEOUT(
      panel().live().on_screen().raw_screen.size() == panel().live().on_screen().screen.size() &&
          raw->picture().bytes == panel().live().on_screen().raw.bytes,
      20000);
  // Also of what came while another page was shown.
  window_->show_step(MainWindow::model);
  QVERIFY(!raw->isVisible());
  QTRY_VERIFY_WITH_TIMEOUT(!is_tracking(), 20000);
  QVERIFY(rests());
  window_->show_step(MainWindow::guidance);
  QVERIFY(raw->isVisible() && raw->picture().bytes == panel().live().on_screen().raw.bytes);
  live_view().findChild<QToolButton*>(QStringLiteral("show_raw"))->click();
  QVERIFY(!raw->isVisible());
}

void GuidancePanelTest::TheTableTellsOfEachLesion() {
  reach_registration(300);
  auto* table = panel().findChild<QTreeWidget*>(QStringLiteral("lesion_table"));
  auto* reasons = panel().findChild<QLabel*>(QStringLiteral("lesion_reasons"));
  const auto row = [table] {
    const QTreeWidgetItem* item = table->topLevelItem(0);
    return item == nullptr ? QString()
                           : item->text(0) + "|" + item->text(1) + "|" + item->text(2) + "|" + item->text(3);
  };
  QTRY_COMPARE_WITH_TIMEOUT(row(), QStringLiteral("Lesion 1|shown|3.2 mm|±5.6 mm"), 20000);
  QCOMPARE(table->topLevelItemCount(), 2);
  const QTreeWidgetItem* fork = table->topLevelItem(1);  // as the registration expects, without a verdict
  QCOMPARE(fork->text(0), QStringLiteral("Portal vein"));
  QCOMPARE(fork->text(1), QStringLiteral("fork 1"));
  QCOMPARE(fork->text(3), QStringLiteral("±8.4 mm"));
  QVERIFY(reasons->isHidden());
  press("start_tracking");
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("LIVE")), 20000);
  operation_->live_validity = Validity::partly_covered;
  QTRY_COMPARE_WITH_TIMEOUT(row(), QStringLiteral("Lesion 1|region only|3.2 mm|±5.6 mm"), 20000);
  QVERIFY(reasons->text().contains(QStringLiteral("Lesion 1: as the whole overlay")));
  operation_->live_validity = Validity::picture_stands;
  QTRY_COMPARE_WITH_TIMEOUT(row(), QStringLiteral("Lesion 1|not shown|3.2 mm|±5.6 mm"), 20000);
}

void GuidancePanelTest::AChosenLesionTellsItsNumbers() {
  reach_registration(300);
  QVERIFY(rests());
  auto* table = panel().findChild<QTreeWidget*>(QStringLiteral("lesion_table"));
  auto* numbers = panel().findChild<QWidget*>(QStringLiteral("lesion_numbers"));
  auto* view = panel().view()->findChild<ui::LivePicture*>();
  const auto at = [&](const Eigen::Vector3d& p_in_ct) {
    const Eigen::Vector3d p =
        operation_->camera_from_ct.rotation * p_in_ct + operation_->camera_from_ct.translation;
    return view->widget_point(operation_->rig.left.project(p)).toPoint();
  };
  const Picture plain = picture();
  QVERIFY(words_on(*numbers).isEmpty());
  QTest::mouseClick(view, Qt::LeftButton, {}, at({0.03, 0.0, 0.0}));
  QTRY_VERIFY_WITH_TIMEOUT(words_on(*numbers).contains(QStringLiteral("Depth, shortest way\n19 mm")), 20000);
  QVERIFY2(words_on(*numbers).contains(QStringLiteral("Expected error\n3 mm")),
           qPrintable(words_on(*numbers)));
  QVERIFY(!words_on(*numbers).contains(QStringLiteral("From the mark")));
  QVERIFY(table->topLevelItem(0)->isSelected());
  QVERIFY(*picture().bytes != *plain.bytes);

  // On the near side of the block: 30 mm beside the lesion and 40 mm before it.
  QTest::mouseClick(view, Qt::RightButton, {}, at({0.0, -0.04, 0.0}));
  QTRY_VERIFY_WITH_TIMEOUT(words_on(*numbers).contains(QStringLiteral("From the mark")), 20000);
  QVERIFY2(words_on(*numbers).contains(QStringLiteral("From the mark\n44 mm")),
           qPrintable(words_on(*numbers)));

  QTest::keyClick(view, Qt::Key_Escape);
  QTRY_VERIFY_WITH_TIMEOUT(words_on(*numbers).isEmpty(), 20000);
  QVERIFY(!table->topLevelItem(0)->isSelected());
  QTRY_VERIFY_WITH_TIMEOUT(*picture().bytes == *plain.bytes, 20000);

  const QRect row = table->visualItemRect(table->topLevelItem(0));
  QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, row.center());
  QTRY_VERIFY_WITH_TIMEOUT(words_on(*numbers).contains(QStringLiteral("19 mm")), 20000);
  press("start_tracking");
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("LIVE")), 20000);
  QTRY_VERIFY_WITH_TIMEOUT(words_on(*numbers).contains(QStringLiteral("Nearest tracked points\n24 mm")),
                           20000);
  // Of a lesion that is not shown nothing is told.
  operation_->live_validity = Validity::picture_stands;
  QTRY_VERIFY_WITH_TIMEOUT(words_on(*numbers).isEmpty(), 20000);
}

void GuidancePanelTest::LastPictureStaysUntilAnotherCaseWhateverItsStyle() {
  reach_registration(12);
  QVERIFY(rests());
  const Picture registered = picture();
  press("start_tracking");
  const auto is_marked = [this] { return said().contains(QStringLiteral("Last picture, not live")); };
  QTRY_VERIFY_WITH_TIMEOUT(is_marked() && !is_tracking(), 20000);
  QVERIFY(rests());
  const Picture without = picture_with_other_style();
  QVERIFY(!without.empty());
  QVERIFY(is_marked());
  const Picture with = picture_with_other_style();
  QVERIFY(!with.empty());
  QVERIFY(is_marked());
  QVERIFY(*with.bytes != *without.bytes);
  QVERIFY2(*with.bytes != *registered.bytes, "it is still the last one, not the registered frame");
  post(engine::OpenCase{"other.glisson"});
  QVERIFY2(is_blank(), qPrintable(said()));
}

void GuidancePanelTest::OverTheLastPictureKeysTakeNoRegistrationBack() {
  reach_registration(12);
  QVERIFY(!do_keys_undo());
  post(engine::Register{});
  QVERIFY(do_keys_undo());
  press("start_tracking");
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("Last picture, not live")) && !is_tracking(),
                           20000);
  QVERIFY(!do_keys_undo());
  auto* undo = panel().findChild<QPushButton*>(QStringLiteral("undo_registration"));
  QVERIFY(undo->isVisible() && undo->isEnabled());
  const auto before = window_->engine().state()[part::registration];
  undo->click();
  QTRY_VERIFY(window_->engine().state()[part::registration] != before);
  QTRY_VERIFY(do_keys_undo());  // the last picture has gone with its registration
}

void GuidancePanelTest::TheOtherPlaceIsLookedAtOverThePicture() {
  operation_->rival_away = 0.02;
  reach_registration(4);
  const Picture registered = picture();
  auto* choice = panel().findChild<QComboBox*>(QStringLiteral("rival"));
  choice->setCurrentIndex(1);
  emit choice->activated(1);
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("Other place 1, to be compared")), 20000);
  QVERIFY(*picture().bytes != *registered.bytes);
  choice->setCurrentIndex(0);
  emit choice->activated(0);
  QTRY_VERIFY_WITH_TIMEOUT(*picture().bytes == *registered.bytes, 20000);
}

void GuidancePanelTest::AHandPlacesTheOrganOverThePicture() {
  reach_registration(4);
  const Picture registered = picture();
  auto* hold = panel().findChild<QPushButton*>(QStringLiteral("place_by_hand"));
  hold->click();
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("Placed by hand: not registered")), 20000);
  const Picture held = picture();
  auto* view = panel().view()->findChild<ui::LivePicture*>();
  const QPoint middle = view->rect().center();
  QTest::mousePress(view, Qt::LeftButton, Qt::NoModifier, middle);
  QTest::mouseMove(view, middle + QPoint(60, 20));
  QTest::mouseRelease(view, Qt::LeftButton, Qt::NoModifier, middle + QPoint(60, 20));
  QTRY_VERIFY_WITH_TIMEOUT(*picture().bytes != *held.bytes, 20000);
  QVERIFY(said().contains(QStringLiteral("Placed by hand: not registered")));
  hold->click();
  QTRY_VERIFY_WITH_TIMEOUT(*picture().bytes == *registered.bytes, 20000);
}

void GuidancePanelTest::TheOrganIsShownInThreeDimensions() {
  reach_registration(4);
  auto* organ = panel().view()->findChild<ui::OrganView*>();
  QVERIFY(!organ->isVisible());
  panel().view()->findChild<QPushButton*>(QStringLiteral("show_organ"))->click();
  QTRY_VERIFY(organ->isVisible());
  QVERIFY2(words_on(*organ).contains(QStringLiteral("mean 7.0 mm, at most 13.0 mm")),
           qPrintable(words_on(*organ)));
  // Where one more look helps, of the lesion that is chosen.
  QVERIFY2(words_on(*organ).contains(QStringLiteral("Lesion 1: one more look helps most at the ")) &&
               words_on(*organ).contains(QStringLiteral("Expected error then 3 mm instead of 6 mm")),
           qPrintable(words_on(*organ)));
  auto* colours = organ->findChild<QComboBox*>(QStringLiteral("organ_colours"));
  QCOMPARE(colours->count(), 2);
  QTest::keyClick(colours, Qt::Key_Down);
  QCOMPARE(colours->currentText(), QStringLiteral("Lesion 1 after a look here"));
  // Whoever places by hand needs the picture.
  panel().findChild<QPushButton*>(QStringLiteral("place_by_hand"))->click();
  QTRY_VERIFY(!organ->isVisible() && live_view().isVisible());
}

void GuidancePanelTest::ErrorGoesWithItsCause() {
  reach_registration(10);
  const int width = operation_->rig.left.width;
  operation_->rig.left.width = 2 * width;
  post(engine::SetCalibration{"of_another_scope.yml"});
  const auto is_refused = [this] { return said().contains(QStringLiteral("Use the calibration")); };
  QTRY_VERIFY_WITH_TIMEOUT(is_refused(), 20000);
  QVERIFY(picture().empty());  // nor does the picture that was drawn with the former one stay
  operation_->rig.left.width = width;
  post(engine::SetCalibration{"scope.yml"});
  QTRY_VERIFY_WITH_TIMEOUT(!picture().empty(), 20000);
  QVERIFY2(!is_refused(), qPrintable(said()));
}

void GuidancePanelTest::ObstaclesNameTheStepThatHelps() {
  reach_registration(10);
  // The same for registering and for tracking.
  const auto refusal = [this] {
    const QString first = obstacle("register"), second = obstacle("start_tracking");
    return first == second ? first : first + QStringLiteral(" / ") + second;
  };
  const auto only_registering_is_left = [this] {
    return task("register")->button()->isEnabled() &&
           obstacle("start_tracking") == QStringLiteral("The registration is out of date: register again.");
  };
  const auto can_track = [this] { return task("start_tracking")->button()->isEnabled(); };
  QVERIFY(can_track());

  post(engine::SetSeeds{});
  QCOMPARE(refusal(),
           QStringLiteral("The labels are out of date: segment or import them again (Segmentation)."));
  post(engine::Segment{});
  QCOMPARE(refusal(), QStringLiteral("The model is out of date: build it again (Model)."));
  post(engine::BuildModel{});
  QCOMPARE(
      refusal(),
      QStringLiteral("The landmarks are those of another model: look at them and accept them (Landmarks)."));
  post(engine::SetLandmarks{operation_->model.landmarks});
  QVERIFY(only_registering_is_left());
  post(engine::Register{});
  QVERIFY(can_track());

  post(engine::SetVideo{operation_->video, {}});
  QCOMPARE(refusal(),
           QStringLiteral("The frame is of a former video: take one of the present video (Stereo)."));
  post(engine::LoadVideoFrame{3});
  QCOMPARE(refusal(),
           QStringLiteral("The regions are those of another frame: draw them again or clear them (Stereo)."));
  post(engine::SetRegions{});
  QCOMPARE(refusal(), QStringLiteral("The points are out of date: reconstruct the surface again (Stereo)."));
  post(engine::Reconstruct{});
  QVERIFY(only_registering_is_left());
  post(engine::Register{});
  QVERIFY(can_track());
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::GuidancePanelTest>(argc, argv); }
#include "guidance_panel_test.moc"
