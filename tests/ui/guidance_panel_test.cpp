// SPDX-License-Identifier: GPL-3.0-or-later
// What the guidance panel shows and says is of the case that is open, and of now. What it tells while the
// organ is followed is in guidance_live_test.cpp.
#include <vtkActorCollection.h>
#include <vtkRenderer.h>

#include <QComboBox>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>
#include <cmath>

#include "glisson/engine/commands/accept_registration.h"
#include "glisson/engine/commands/build_model.h"
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
#include "glisson/engine/parts/model.h"
#include "glisson/guidance/lesion_judge.h"
#include "guidance_window.h"

namespace glisson {

class GuidancePanelTest : public QObject, protected GuidanceWindow {
  Q_OBJECT
 private slots:
  void init() { open_window(); }
  void cleanup() { close_window(); }
  void NothingOfTheFormerCaseStays();
  void AChosenLesionTellsItsNumbers();
  void TheOtherPlaceIsLookedAtOverThePicture();
  void AHandPlacesTheOrganOverThePicture();
  void AHandLetsGoWithItsCase();
  void TheOrganIsShownInThreeDimensions();
  void BesideThePictureTheOrganGoesWithIt();
  void ThatBothWereShownIsRemembered();
  void WhatIsOutOfDateOrRefusedShowsNoRegions();
  void ErrorGoesWithItsCause();
  void ObstaclesNameTheStepThatHelps();
};

void GuidancePanelTest::NothingOfTheFormerCaseStays() {
  reach_registration(10);
  QVERIFY(!is_blank());
  lesions()->click();  // a picture is on its way when the other case comes
  post(engine::OpenCase{"other.glisson"});
  QVERIFY(window_->engine().state()[part::frame] == nullptr);
  QVERIFY2(is_blank(), qPrintable(said()));
  QVERIFY2(stays_blank(), qPrintable(said()));
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
  QVERIFY2(words_on(*numbers).contains(QStringLiteral("Expected error\n2 mm")),
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

void GuidancePanelTest::AHandLetsGoWithItsCase() {
  operation_->rival_away = 0.02;
  reach_registration(4);
  auto* choice = panel().findChild<QComboBox*>(QStringLiteral("rival"));
  choice->setCurrentIndex(1);
  emit choice->activated(1);
  auto* hold = panel().findChild<QPushButton*>(QStringLiteral("place_by_hand"));
  hold->click();
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("Placed by hand: not registered")), 20000);
  // Of this case there is no model: what was held and what was compared are of the former one.
  post(engine::OpenCase{"other.glisson"});
  QVERIFY(window_->engine().state()[part::model] == nullptr);
  QVERIFY2(is_blank(), qPrintable(said()));
  QVERIFY(!hold->isEnabled());
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

void GuidancePanelTest::BesideThePictureTheOrganGoesWithIt() {
  reach_registration(300);
  panel().view()->findChild<QPushButton*>(QStringLiteral("show_both"))->click();
  auto* organ = panel().view()->findChild<ui::OrganView*>();
  QTRY_VERIFY(organ->width() > 200 && live_view().width() > 200 && organ->height() > 150);
  QVERIFY(organ->isVisible() && live_view().isVisible());
  auto* view = organ->findChild<ui::RenderView*>();
  QVERIFY(organ->width() > 2 * organ->height());
  QTRY_COMPARE(view->height(), organ->height());  // words and colours stand beside it
  const auto actors = [view] { return view->patient().renderer().GetActors()->GetNumberOfItems(); };
  const auto height = [view] {
    double bounds[6];
    view->patient().renderer().ComputeVisiblePropBounds(bounds);
    return 0.5 * (bounds[2] + bounds[3]);
  };
  // What is chosen in the one is chosen in the other.
  const engine::CaseState& now = window_->engine().state();
  const auto lesions =
      guidance::LesionJudge(now[part::model]->model, *now[part::registration]).at_start(Validity::valid);
  const auto place = view->patient().view_point(lesions.front().centre, view->aspect());
  QVERIFY(place);
  const int unchosen = actors();
  QTest::mouseClick(
      view, Qt::LeftButton, Qt::NoModifier,
      {static_cast<int>(place->x() * view->width()), static_cast<int>(place->y() * view->height())});
  QTRY_COMPARE(panel().live().chosen.value(), lesions.front().lesion);
  QCOMPARE(actors(), unchosen + 1);
  QTest::mouseClick(view, Qt::LeftButton, Qt::NoModifier, {2, 2});
  QTRY_COMPARE(panel().live().chosen.value(), Label{0});

  press("start_tracking");
  QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("LIVE")) && actors() < unchosen,
                           20000);  // no points
  const double before = height();
  QTRY_VERIFY_WITH_TIMEOUT(std::abs(height() - before) > 2e-3, 20000);
  operation_->live_validity = Validity::picture_stands;
  QTRY_COMPARE_WITH_TIMEOUT(actors(), 0, 20000);
  QVERIFY(words_on(*organ).contains(QStringLiteral("No overlay: where the organ is")));
  operation_->live_validity = Validity::valid;
  QTRY_VERIFY_WITH_TIMEOUT(actors() > 0, 20000);
}

void GuidancePanelTest::ThatBothWereShownIsRemembered() {
  const auto is_organ_shown = [this] {
    window_->show_step(ui::MainWindow::guidance);
    return panel().view()->findChild<ui::OrganView*>()->isVisible();
  };
  const auto begin_anew = [this](const char* button) {
    panel().view()->findChild<QPushButton*>(QLatin1String(button))->click();
    close_window();
    open_window();
  };
  begin_anew("show_both");
  QVERIFY(is_organ_shown() && live_view().isVisible());
  begin_anew("show_organ");
  QVERIFY(is_organ_shown() && live_view().isVisible());
  begin_anew("show_picture");
  QVERIFY(!is_organ_shown() && live_view().isVisible());
}

void GuidancePanelTest::WhatIsOutOfDateOrRefusedShowsNoRegions() {
  reach_registration(4);
  auto* organ = panel().view()->findChild<ui::OrganView*>();
  panel().view()->findChild<QPushButton*>(QStringLiteral("show_organ"))->click();
  QTRY_VERIFY(organ->isVisible());
  const auto* scale = organ->findChild<QWidget*>(QStringLiteral("error_scale"));
  auto* view = organ->findChild<ui::RenderView*>();
  const auto actors = [view] { return view->patient().renderer().GetActors()->GetNumberOfItems(); };
  const auto tells_errors = [organ] {
    const QString words = words_on(*organ);
    return words.contains(QStringLiteral("7.0 mm")) || words.contains(QStringLiteral("95 of 100"));
  };
  const auto within = [this] {
    return panel().findChild<QTreeWidget*>(QStringLiteral("lesion_table"))->topLevelItem(0)->text(3);
  };
  QVERIFY2(within().contains(QStringLiteral("mm")), qPrintable(within()));
  const int with_region = actors();
  QVERIFY(tells_errors() && scale->isVisible());

  post(engine::SetSeeds{});  // out of date
  QCOMPARE(actors(), with_region - 1);
  QVERIFY2(!tells_errors() && !scale->isVisible(), qPrintable(words_on(*organ)));
  QVERIFY(!words_on(panel()).contains(QStringLiteral("7.0 mm")));
  QVERIFY2(!within().contains(QStringLiteral("mm")), qPrintable(within()));

  operation_->doubts = {"refused", "cloud_noisy 6.3 6"};
  post(engine::Segment{});
  post(engine::BuildModel{});
  post(engine::SetLandmarks{operation_->model.landmarks});
  post(engine::Register{});
  QTRY_VERIFY_WITH_TIMEOUT(window_->drawables().drawable() != nullptr, 20000);
  QTRY_COMPARE(actors(), with_region - 1);
  QVERIFY2(!tells_errors() && !scale->isVisible(), qPrintable(words_on(*organ)));
  QVERIFY(words_on(*organ).contains(QStringLiteral("Refused")));
  // So does the picture, which shows no overlay.
  const auto drawn = [this] { return panel().live().on_screen().made_from; };
  QTRY_VERIFY(drawn() && drawn()->status.refused);
  QVERIFY(drawn()->overlay.level() == Level::withdrawn);

  post(engine::AcceptRegistration{});  // a person has looked at it
  QTRY_COMPARE(actors(), with_region);
  QVERIFY(tells_errors() && scale->isVisible());
  QTRY_VERIFY(!drawn()->status.refused);
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
