// SPDX-License-Identifier: GPL-3.0-or-later
// Each box of the guidance panel alone: its widgets say what its model's properties say.
#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QLabel>
#include <QLayout>
#include <QProperty>
#include <QPushButton>
#include <QScopeGuard>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <vector>

#include "glisson/engine/commands/build_model.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/load_video_frame.h"
#include "glisson/engine/commands/reconstruct.h"
#include "glisson/engine/commands/register.h"
#include "glisson/engine/commands/segment.h"
#include "glisson/engine/commands/set_calibration.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/commands/set_video.h"
#include "glisson/engine/commands/start_tracking.h"
#include "glisson/engine/commands/stop_tracking.h"
#include "glisson/engine/obstacle.h"
#include "glisson/ui/common/texts.h"
#include "glisson/ui/guidance/playback_box.h"
#include "glisson/ui/guidance/registration_box.h"
#include "guidance_bench.h"
#include "run_in_window.h"

namespace glisson {

using engine::Part;
using ui::EngineBridge;

class GuidanceBoxesTest : public QObject, GuidanceBench {
  Q_OBJECT
 private slots:
  void init() { set_up(); }
  void cleanup() { take_down(); }
  void CouplingShowsNowAndAtEveryChange();
  void RegistrationSaysWhatItNeeds();
  void RegistrationShowsItsFiguresAndDoubts();
  void WhatRegisteringNotesIsShown();
  void RefusedRegistrationIsUsedOnlyWhenSomebodySaysSo();
  void NothingIsDecidedAboutARegistrationThatIsBeingMade();
  void OtherPlacesAreOfferedAndTaken();
  void OtherPlacesAreSeenSideBySideAndTakenByAClick();
  void ADoubleClickTakesOnePlaceOnly();
  void NoPlaceIsTakenWhileTheOrganIsFollowed();
  void TheFormerRegistrationIsOneClickAway();
  void TheMethodIsChosenInTheBox();
  void PlacedByHandTheModelIsRefinedFromThere();
  void PlacingEndsWithWhatItBelongsTo();
  void PlaybackSaysWhatItNeeds();
  void StopStaysWhereItIsWhenTrackingBegins();
  void PlaybackFreezesWhenItIsStopped();
  void FrozenPictureGoesWithItsRegistration();
  void PlaybackRepeatsOnlyWhenItShould_data();
  void PlaybackRepeatsOnlyWhenItShould();
};

void GuidanceBoxesTest::CouplingShowsNowAndAtEveryChange() {
  QProperty<int> first{1};
  QProperty<int> twice;
  twice.setBinding([&first] { return 2 * first; });
  std::vector<int> shown;
  {
    ui::Couplings couplings;
    couplings.add(twice, [&shown](int value) { shown.push_back(value); });
    first = 2;
    first = 2;
    first = 3;
  }
  first = 4;
  QCOMPARE(shown, (std::vector<int>{2, 4, 6}));
}

void GuidanceBoxesTest::RegistrationSaysWhatItNeeds() {
  ui::RegistrationModel model(*engine_);
  ui::PlacingModel placing(*engine_);
  const ui::RegistrationBox box(*engine_, model, placing);
  QVERIFY(words_on(box).contains(QStringLiteral("Build a model first.")));
  QVERIFY(!task(box, "register")->button()->isEnabled());
  post(engine::ImportImage{"ct.nii"});
  post(engine::SetSeeds{});
  post(engine::Segment{});
  post(engine::BuildModel{});
  QVERIFY(words_on(box).contains(QStringLiteral("Reconstruct the surface first (Stereo).")));
  reach_cloud(4);
  QVERIFY(task(box, "register")->button()->isEnabled());
  post(engine::SetSeeds{});
  QVERIFY(words_on(box).contains(QStringLiteral("The labels are out of date")));
  QVERIFY(!task(box, "register")->button()->isEnabled());
}

void GuidanceBoxesTest::RegistrationShowsItsFiguresAndDoubts() {
  ui::RegistrationModel model(*engine_);
  ui::PlacingModel placing(*engine_);
  const ui::RegistrationBox box(*engine_, model, placing);
  const auto* doubts = box.findChild<QLabel*>(QStringLiteral("registration_doubts"));
  QVERIFY(doubts->isHidden());
  reach_registration(4);
  QVERIFY(words_on(box).contains(QStringLiteral("1.10 mm")));
  QVERIFY(words_on(box).contains(QStringLiteral("came to rest")));
  QVERIFY(!doubts->isHidden() && !doubts->text().isEmpty());
  QVERIFY(!box.findChild<QLabel*>(QStringLiteral("model_unchecked"))->isHidden());
}

void GuidanceBoxesTest::WhatRegisteringNotesIsShown() {
  ui::RegistrationModel model(*engine_);
  ui::PlacingModel placing(*engine_);
  const ui::RegistrationBox box(*engine_, model, placing);
  const auto* notes = box.findChild<QLabel*>(QStringLiteral("registration_notes"));
  operation_->doubts = {"refused", "cloud_noisy 6.3 6"};
  operation_->more_notes = {"landmarks.no_vena_cava", "landmarks.not_reviewed"};
  reach_registration(4);
  QVERIFY(!notes->isHidden());
  // What is told as a doubt is not told twice.
  QCOMPARE(notes->text(), ui::notes_text(operation_->more_notes));
  task(box, "accept_registration")->trigger();
  QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty(); }, 20000));
  QVERIFY(!model.is_refused);
  QCOMPARE(notes->text(), ui::notes_text(operation_->more_notes));  // they hold still
  const ui::RegistrationModel later(*engine_);  // has not seen it made, as where the case is opened again
  QCOMPARE(later.notes.value(), ui::notes_text(operation_->more_notes));
  operation_->more_notes.clear();
  post(engine::Register{});
  QVERIFY(notes->isHidden());
}

void GuidanceBoxesTest::RefusedRegistrationIsUsedOnlyWhenSomebodySaysSo() {
  ui::RegistrationModel model(*engine_);
  ui::PlacingModel placing(*engine_);
  const ui::RegistrationBox box(*engine_, model, placing);
  ui::TaskButton* accept = task(box, "accept_registration");
  QVERIFY(accept->isHidden());
  operation_->doubts = {"refused", "cloud_noisy 6.3 6"};
  reach_registration(4);
  QVERIFY(!accept->isHidden());
  QVERIFY(words_on(box).contains(QStringLiteral("refused")));
  QVERIFY(!words_on(box).contains(QStringLiteral("came to rest")));  // nothing that sounds like success
  QVERIFY(model.error_words.value().startsWith(QStringLiteral("Refused")));
  QVERIFY(model.spots.value().empty());
  const auto first = engine::obstacle(*engine_->snapshot(), engine::StartTracking{});
  QVERIFY(first && first->kind == engine::Obstacle::Kind::refused);
  ui::PlaybackModel playback(*engine_);
  QVERIFY(playback.obstacle.value().contains(QStringLiteral("refused")));
  QVERIFY_THROWS_EXCEPTION(
      InputError, engine::apply(engine_->state(), engine::StartTracking{}, RunContext(), engine::Services{}));
  accept->trigger();
  QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty(); }, 20000));
  QVERIFY(accept->isHidden());
  QVERIFY2(words_on(box).contains(QStringLiteral("scatter by 6.30 mm")),
           qPrintable(words_on(box)));  // it stays
  QVERIFY(model.error_words.value().startsWith(QStringLiteral("Expected error")));
  QCOMPARE(model.spots.value().size(), std::size_t{2});
  post(engine::SetSeeds{});
  QVERIFY(model.error_words.value().startsWith(QStringLiteral("Out of date")));
  QVERIFY(model.spots.value().empty());
}

void GuidanceBoxesTest::NothingIsDecidedAboutARegistrationThatIsBeingMade() {
  ui::RegistrationModel model(*engine_);
  ui::PlacingModel placing(*engine_);
  const ui::RegistrationBox box(*engine_, model, placing);
  operation_->doubts = {"refused", "cloud_noisy 6.3 6"};
  operation_->rival_away = 0.014;
  reach_registration(4);
  auto* choice = box.findChild<QComboBox*>(QStringLiteral("rival"));
  choice->setCurrentIndex(1);
  emit choice->activated(1);
  auto* place = box.findChild<QToolButton*>(QStringLiteral("take_rival_1"));
  const std::vector<QAbstractButton*> decisions = {task(box, "accept_registration")->button(),
                                                   task(box, "choose_rival")->button(), place};
  const auto is_open = [](const QAbstractButton* one) { return one->isEnabled(); };
  QVERIFY(std::ranges::all_of(decisions, is_open));
  // What is said of the one that is shown would be said of one that nobody has seen.
  operation_->doubts = {"refused", "cloud_noisy 9.1 6"};
  operation_->hold = true;
  task(box, "register")->trigger();
  QVERIFY(std::ranges::none_of(decisions, is_open));
  QVERIFY(words_on(box).contains(QStringLiteral("look at it first")));
  for (QAbstractButton* one : decisions) one->click();
  operation_->hold = false;
  QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty(); }, 20000));
  QVERIFY(model.is_refused);
  QVERIFY2(words_on(box).contains(QStringLiteral("scatter by 9.10 mm")), qPrintable(words_on(box)));
  QVERIFY(task(box, "accept_registration")->button()->isEnabled() && place->isEnabled());
  task(box, "accept_registration")->trigger();
  QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty(); }, 20000));
  QVERIFY(!model.is_refused);
}

void GuidanceBoxesTest::OtherPlacesAreOfferedAndTaken() {
  ui::RegistrationModel model(*engine_);
  ui::PlacingModel placing(*engine_);
  const ui::RegistrationBox box(*engine_, model, placing);
  reach_registration(4);
  const auto* rows = box.findChild<QWidget*>(QStringLiteral("rivals"));
  QVERIFY(rows->isHidden());
  QVERIFY(words_on(box).contains(QStringLiteral("7.0 mm")));  // the expected error's mean
  operation_->rival_away = 0.014;
  post(engine::Register{});
  QVERIFY(!rows->isHidden());
  auto* choice = box.findChild<QComboBox*>(QStringLiteral("rival"));
  QCOMPARE(choice->count(), 2);
  QCOMPARE(choice->itemText(1), QStringLiteral("Other place 1: 12 %, 14 mm away"));
  QVERIFY(!task(box, "choose_rival")->button()->isEnabled());
  QVERIFY(model.rival_nodes() == nullptr);
  choice->setCurrentIndex(1);
  emit choice->activated(1);
  const Points there = *model.rival_nodes();
  task(box, "choose_rival")->trigger();
  QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty(); }, 20000));
  QVERIFY(engine_->state()[part::registration]->nodes_in_camera == there);
  QCOMPARE(choice->itemText(1), QStringLiteral("Other place 1: 88 %, 14 mm away"));
  QVERIFY(model.rival_nodes() == nullptr);  // nothing is compared until somebody chooses
  QVERIFY(words_on(box).contains(QStringLiteral("gave it 12 %")));
}

void GuidanceBoxesTest::OtherPlacesAreSeenSideBySideAndTakenByAClick() {
  ui::RegistrationModel model(*engine_);
  ui::PlacingModel placing(*engine_);
  const ui::RegistrationBox box(*engine_, model, placing);
  operation_->rival_away = 0.014;
  reach_registration(4);
  auto* first = box.findChild<QToolButton*>(QStringLiteral("take_rival_1"));
  QVERIFY(!first->isHidden());
  QVERIFY(box.findChild<QToolButton*>(QStringLiteral("take_rival_2"))->isHidden());
  QCOMPARE(first->text(), QStringLiteral("1: 12 %, 14 mm"));
  // The organ lies over the picture where that place puts it.
  const Registration& registration = *engine_->state()[part::registration];
  const QImage drawn = first->icon().pixmap(first->iconSize()).toImage();
  const Eigen::Vector2d at = operation_->rig.left.project(
      Eigen::Vector3d(registration.rivals[0].nodes_in_camera.colwise().mean().transpose()));
  const double scale = std::max(drawn.width() / static_cast<double>(operation_->rig.left.width),
                                drawn.height() / static_cast<double>(operation_->rig.left.height));
  const QPoint pixel(
      static_cast<int>(scale * at.x() - 0.5 * (scale * operation_->rig.left.width - drawn.width())),
      static_cast<int>(scale * at.y() - 0.5 * (scale * operation_->rig.left.height - drawn.height())));
  QVERIFY(drawn.rect().contains(pixel));
  const QColor organ = drawn.pixelColor(pixel), corner = drawn.pixelColor(1, 1);
  QVERIFY2(organ.blue() > organ.red() && corner.blue() <= corner.red(),
           qPrintable(organ.name() + corner.name()));
  const Points there = registration.rivals[0].nodes_in_camera;
  first->click();
  QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty(); }, 20000));
  QVERIFY(engine_->state()[part::registration]->nodes_in_camera == there);
  QCOMPARE(first->text(), QStringLiteral("1: 88 %, 14 mm"));
}

void GuidanceBoxesTest::ADoubleClickTakesOnePlaceOnly() {
  ui::RegistrationModel model(*engine_);
  ui::PlacingModel placing(*engine_);
  const ui::RegistrationBox box(*engine_, model, placing);
  const auto usual = qScopeGuard(
      [interval = QApplication::doubleClickInterval()] { QApplication::setDoubleClickInterval(interval); });
  QApplication::setDoubleClickInterval(2000);  // however slow the machine is
  operation_->rival_away = 0.014;
  reach_registration(4);
  auto* first = box.findChild<QToolButton*>(QStringLiteral("take_rival_1"));
  const Points there = engine_->state()[part::registration]->rivals[0].nodes_in_camera;
  for (int click = 0; click < 2; ++click) {  // by the second the picture shows the place that was left
    first->click();
    QVERIFY(!first->isEnabled());
    QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty(); }, 20000));
  }
  QVERIFY(engine_->state()[part::registration]->nodes_in_camera == there);
  QTRY_VERIFY(first->isEnabled());
  first->click();
  QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty(); }, 20000));
  QVERIFY(engine_->state()[part::registration]->nodes_in_camera != there);
  QTRY_VERIFY(first->isEnabled());
  post(engine::StartTracking{});
  QVERIFY(!first->isEnabled() && first->toolTip().contains(QStringLiteral("stop tracking first")));
}

void GuidanceBoxesTest::NoPlaceIsTakenWhileTheOrganIsFollowed() {
  ui::RegistrationModel model(*engine_);
  ui::PlacingModel placing(*engine_);
  const ui::RegistrationBox box(*engine_, model, placing);
  operation_->rival_away = 0.014;
  reach_registration(4);
  auto* choice = box.findChild<QComboBox*>(QStringLiteral("rival"));
  choice->setCurrentIndex(1);
  emit choice->activated(1);
  for (const char* name : {"choose_rival", "register"}) {
    const auto* use = task(box, name)->button();
    QVERIFY(use->isEnabled());
    post(engine::StartTracking{});
    QVERIFY2(!use->isEnabled(), name);
    QVERIFY(words_on(*task(box, name)).contains(QStringLiteral("stop tracking first")));
    post(engine::StopTracking{});
    QVERIFY(use->isEnabled());
  }
}

void GuidanceBoxesTest::TheFormerRegistrationIsOneClickAway() {
  ui::RegistrationModel model(*engine_);
  ui::PlacingModel placing(*engine_);
  const ui::RegistrationBox box(*engine_, model, placing);
  reach_registration(4);
  QPushButton* undo = button(box, "undo_registration");
  QVERIFY(undo->isHidden());
  const auto first = engine_->state()[part::registration];
  operation_->rival_away = 0.014;
  post(engine::Register{});
  const auto second = engine_->state()[part::registration];
  QVERIFY(!undo->isHidden() && second != first);
  const auto press = [&] {
    undo->click();
    QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty(); }, 20000));
  };
  press();
  QVERIFY(engine_->state()[part::registration] == first);
  QCOMPARE(engine_->snapshot()->stage(part::registration), engine::StageState::current);
  press();
  QVERIFY(engine_->state()[part::registration] == second);
  // While the organ is followed it keeps its room, so that no button below it moves.
  post(engine::StartTracking{});
  QVERIFY(!undo->isHidden() && !undo->isEnabled());
}

void GuidanceBoxesTest::TheMethodIsChosenInTheBox() {
  ui::RegistrationModel model(*engine_);
  ui::PlacingModel placing(*engine_);
  const ui::RegistrationBox box(*engine_, model, placing);
  reach_cloud(4);
  task(box, "register")->trigger();
  QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty(); }, 20000));
  QVERIFY(operation_->method == registration::Method::automatic);
  auto* choice = box.findChild<QComboBox*>(QStringLiteral("registration_method"));
  QCOMPARE(choice->count(), 4);
  choice->setCurrentIndex(3);
  emit choice->activated(3);
  task(box, "register")->trigger();
  QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty(); }, 20000));
  QVERIFY(operation_->method == registration::Method::paper);
  button(box, "place_by_hand")->click();
  task(box, "refine")->trigger();
  QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty(); }, 20000));
  QVERIFY(operation_->method == registration::Method::paper && operation_->start);
}

void GuidanceBoxesTest::PlacedByHandTheModelIsRefinedFromThere() {
  ui::RegistrationModel model(*engine_);
  ui::PlacingModel placing(*engine_);
  const ui::RegistrationBox box(*engine_, model, placing);
  QVERIFY(!button(box, "place_by_hand")->isEnabled());
  reach_cloud(4);
  button(box, "place_by_hand")->click();
  QVERIFY(placing.is_placing);
  const auto where = [&] { return Eigen::Vector3d(placing.nodes().colwise().mean().transpose()); };
  const Eigen::Vector2d at = operation_->rig.left.project(where()), to = at + Eigen::Vector2d(40.0, -25.0);
  placing.drag(at, to, ui::PlacingModel::Move::along);
  QVERIFY((operation_->rig.left.project(where()) - to).norm() < 1e-3);
  placing.drag({100, 90}, {180, 90}, ui::PlacingModel::Move::turn);
  // 80 of 320 pixels: a quarter of half a circle, about the vertical.
  const Eigen::AngleAxisd turn(placing.pose().rotation * operation_->camera_from_ct.rotation.transpose());
  QVERIFY(std::abs(turn.angle() - M_PI / 4.0) < 1e-9 && turn.axis().y() > 0.999);
  const double before = where().norm();
  placing.bring_nearer(1.0);
  QVERIFY(std::abs(where().norm() / before - 0.97) < 1e-9);
  const CameraFromCt held = placing.pose();
  task(box, "refine")->trigger();
  QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty(); }, 20000));
  QVERIFY(operation_->start && operation_->start->rotation == held.rotation &&
          operation_->start->translation == held.translation);
  QTRY_VERIFY(!placing.is_placing);
}

void GuidanceBoxesTest::PlacingEndsWithWhatItBelongsTo() {
  ui::PlacingModel placing(*engine_);
  reach_registration(4);
  placing.start();
  QVERIFY(placing.is_placing);
  QVERIFY(placing.pose().translation == operation_->camera_from_ct.translation);
  post(engine::LoadVideoFrame{1});
  QVERIFY(!placing.is_placing);
}

void GuidanceBoxesTest::PlaybackSaysWhatItNeeds() {
  ui::PlaybackModel model(*engine_);
  const ui::PlaybackBox box(*engine_, model);
  QVERIFY(words_on(box).contains(QStringLiteral("Register first.")));
  reach_registration(200);
  QVERIFY(task(box, "start_tracking")->button()->isEnabled());
  QVERIFY(!button(box, "stop_tracking")->isEnabled());
  task(box, "start_tracking")->trigger();
  QTRY_VERIFY(model.is_tracking);
  QVERIFY(words_on(box).contains(QStringLiteral("Tracking is running.")));
  QVERIFY(button(box, "stop_tracking")->isEnabled());
}

void GuidanceBoxesTest::StopStaysWhereItIsWhenTrackingBegins() {
  ui::PlaybackModel model(*engine_);
  ui::PlaybackBox box(*engine_, model);
  reach_registration(200);
  box.show();
  const auto stop_at = [&] {
    QCoreApplication::processEvents();
    box.resize(320, box.sizeHint().height());
    box.layout()->activate();
    return button(box, "stop_tracking")->mapTo(&box, QPoint(0, 0)).y();
  };
  const int before = stop_at();
  task(box, "start_tracking")->trigger();
  QTRY_VERIFY(model.is_tracking && !task(box, "start_tracking")->is_running());
  QVERIFY(words_on(box).contains(QStringLiteral("Tracking is running.")));
  QTRY_COMPARE(stop_at(), before);
}

void GuidanceBoxesTest::PlaybackFreezesWhenItIsStopped() {
  ui::PlaybackModel model(*engine_);
  const ui::PlaybackBox box(*engine_, model);
  reach_registration(200);
  task(box, "start_tracking")->trigger();
  QTRY_VERIFY(model.is_playing);
  button(box, "stop_tracking")->click();
  QVERIFY(model.is_frozen && !model.is_playing);
  QVERIFY(model.frozen_why.value().contains(QStringLiteral("Last picture, not live")));
  QTRY_VERIFY(!model.is_tracking);
  QVERIFY(model.is_frozen);
  QVERIFY(task(box, "start_tracking")->button()->isEnabled());
}

void GuidanceBoxesTest::FrozenPictureGoesWithItsRegistration() {
  ui::PlaybackModel model(*engine_);
  const ui::PlaybackBox box(*engine_, model);
  reach_registration(200);
  task(box, "start_tracking")->trigger();
  QTRY_VERIFY(model.is_playing);
  model.stop();
  QTRY_VERIFY(!model.is_tracking);
  post(engine::Register{});
  QVERIFY(!model.is_frozen);
}

void GuidanceBoxesTest::PlaybackRepeatsOnlyWhenItShould_data() {
  QTest::addColumn<bool>("repeats");
  QTest::newRow("once") << false;
  QTest::newRow("again") << true;
}

void GuidanceBoxesTest::PlaybackRepeatsOnlyWhenItShould() {
  QFETCH(bool, repeats);
  ui::PlaybackModel model(*engine_);
  const ui::PlaybackBox box(*engine_, model);
  reach_registration(8);
  box.findChild<QCheckBox*>()->setChecked(repeats);
  QCOMPARE(model.repeats.value(), repeats);
  QSignalSpy begun(&model, &ui::PlaybackModel::begun);
  task(box, "start_tracking")->trigger();
  QTRY_VERIFY_WITH_TIMEOUT(begun.count() >= (repeats ? 3 : 1), 20000);
  if (repeats) return;
  QTRY_VERIFY(model.is_frozen && !model.is_tracking);
  QVERIFY(model.frozen_why.value().contains(QStringLiteral("The video has ended")));
  QVERIFY(!QTest::qWaitFor([&] { return begun.count() > 1; }, 300));
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::GuidanceBoxesTest>(argc, argv); }
#include "guidance_boxes_test.moc"
