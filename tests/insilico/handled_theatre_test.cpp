// SPDX-License-Identifier: GPL-3.0-or-later
// What hands do in the theatre: a fast scope, and a tool that takes the organ along.
#include <Eigen/Geometry>
#include <QTest>
#include <algorithm>
#include <numbers>

#include "glisson/core/error.h"
#include "glisson/insilico/theatre.h"
#include "theatre_patient.h"

using namespace glisson;
using namespace glisson::insilico;

namespace {

TheatreOptions small_options() {
  TheatreOptions options;
  options.width = 320;
  options.height = 180;
  options.frames = 151;
  options.truth_vertices = 1000;
  return options;
}

/// It enters after a third of a second, touches after two, has gone its way after one and two thirds, and is
/// gone after four.
ToolUse use(double way_mm) {
  ToolUse use;
  use.way_mm = way_mm;
  use.begins_s = 1.0 / 3.0;
  use.moves_s = 1.0;
  use.holds_s = 1.0;
  use.tip_mm = 10.0;
  return use;
}
constexpr int kBefore = 9, kTouches = 20, kThere = 60, kGone = 121;

}  // namespace

class HandledTheatreTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void AFastHandTurnsAndSlidesAsFastAsIsSaid();
  void TheOrganGoesWithTheTip_data();
  void TheOrganGoesWithTheTip();
  void ThePictureShowsToolAndOrgan();
  void TheSameSeedIsTheSameUse();
  void AFirmerPullTakesMoreForce();
  void WrongOptionsAreRefusedAndCancelChangesNothing();

 private:
  Points nodes(int frame) const { return theatre_->truth(frame).nodes_in_camera; }
  std::unique_ptr<Theatre> theatre_;
};

void HandledTheatreTest::initTestCase() {
  theatre_ = std::move(Theatre::build(test::small_patient(), small_options(), RunContext()).value());
}

/// By where the patient goes before the camera, of which breath's own part is known from a scope that stands.
void HandledTheatreTest::AFastHandTurnsAndSlidesAsFastAsIsSaid() {
  std::vector<Points> still;
  for (int k = 0; k < theatre_->frame_count(); ++k) still.push_back(nodes(k));
  theatre_->move_scope(ScopePath::in_a_fast_hand());
  double turn = 0.0, speed = 0.0, nearest = 1.0, farthest = 0.0, first_turn = 1.0;
  Rigid<CameraFrame, CameraFrame> before;
  for (int k = 0; k < theatre_->frame_count(); ++k) {
    // Where the scope is, in its frame of the beginning.
    const auto scope =
        fit_rigid<CameraFrame, CameraFrame>(still[static_cast<std::size_t>(k)], nodes(k)).inverse();
    const double degrees =
        Eigen::AngleAxisd(before.rotation.transpose() * scope.rotation).angle() * 180.0 / std::numbers::pi;
    if (k == 1) first_turn = 30.0 * degrees;
    turn = std::max(turn, 30.0 * degrees);
    speed = std::max(speed, 30.0 * (scope.translation - before.translation).norm());
    const double depth = (scope.inverse() * Point<CameraFrame>(Eigen::Vector3d(0.0, 0.0, 0.12))).xyz.z();
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
    before = scope;
  }
  theatre_->move_scope({});
  QVERIFY2(turn > 27.0 && turn < 33.0, qPrintable(QString::number(turn)));
  QVERIFY2(speed > 0.09 && speed < 0.11, qPrintable(QString::number(speed)));
  QVERIFY2(std::abs(nearest - 0.06) < 2e-3 && std::abs(farthest - 0.18) < 2e-3,
           qPrintable(QString("%1 %2").arg(nearest).arg(farthest)));
  QVERIFY(first_turn < 0.3 * turn);  // it begins standing
}

void HandledTheatreTest::TheOrganGoesWithTheTip_data() {
  QTest::addColumn<double>("way");
  QTest::newRow("lifted") << 12.0;
  QTest::newRow("pressed") << -8.0;
}

void HandledTheatreTest::TheOrganGoesWithTheTip() {
  QFETCH(double, way);
  std::vector<Points> still;
  for (const int k : {kBefore, kTouches, kThere, kGone}) still.push_back(nodes(k));
  QVERIFY(!theatre_->tool_touches(0));
  QVERIFY(theatre_->use_tool(use(way), RunContext()));
  for (const auto& [k, i] : {std::pair{kBefore, 0}, {kTouches, 1}, {kGone, 3}})
    QVERIFY((nodes(k) - still[static_cast<std::size_t>(i)]).rowwise().norm().maxCoeff() < 1e-9);
  const Eigen::Vector3d first = *theatre_->tool_touches(kTouches), there = *theatre_->tool_touches(kThere);
  const Points pulled = nodes(kThere) - still[2];
  const Eigen::VectorXd moved = pulled.rowwise().norm();
  // Most of the tip's way, towards the lens when lifted; far away less: this organ is small and held loosely.
  const Eigen::VectorXd from_tip = (still[2].rowwise() - first.transpose()).rowwise().norm();
  double near = 0.0, far = 0.0;
  for (Eigen::Index i = 0; i < moved.size(); ++i) {
    if (from_tip[i] < 0.008) near = std::max(near, moved[i]);
    if (from_tip[i] > 0.08) far = std::max(far, moved[i]);
  }
  QVERIFY2(near > 0.6e-3 * std::abs(way) && near < 1.1e-3 * std::abs(way),
           qPrintable(QString::number(1e3 * near)));
  QVERIFY2(far < 0.6 * near, qPrintable(QString("%1 of %2").arg(1e3 * far).arg(1e3 * near)));
  Eigen::Index most = 0;
  moved.maxCoeff(&most);
  QVERIFY(way * pulled(most, 2) < 0.0);
  TetMesh mesh = theatre_->mesh();
  mesh.vertices = nodes(kThere);
  QVERIFY(tetrahedron_volumes(mesh).minCoeff() > 0.0);
  // What is touched lies on the organ's surface as it is then.
  const TriangleMesh surface = theatre_->surface(kThere);
  QVERIFY((surface.vertices.rowwise() - there.transpose()).rowwise().norm().minCoeff() < 4e-3);
  QVERIFY(theatre_->use_tool({}, RunContext()));
  QVERIFY((nodes(kThere) - still[2]).rowwise().norm().maxCoeff() < 1e-9);
}

void HandledTheatreTest::ThePictureShowsToolAndOrgan() {
  std::vector<Picture> without;
  for (const int k : {kBefore, kThere, kGone}) without.push_back(theatre_->render(k).left);
  const std::vector<float> depth_without = theatre_->depth(kThere);
  QVERIFY(theatre_->use_tool(use(12.0), RunContext()));
  const auto same = [&](int k, std::size_t i) {
    return *theatre_->render(k).left.bytes == *without[i].bytes;
  };
  QVERIFY(same(kBefore, 0) && !same(kThere, 1) && same(kGone, 2));
  const Picture with = theatre_->render(kThere).left;
  const std::vector<float> depth = theatre_->depth(kThere);
  // Somewhere the tool hides the organ, grey where tissue is red; beside it the organ itself has come nearer.
  int hidden = 0, grey = 0, nearer = 0;
  for (std::size_t i = 0; i < depth.size(); ++i) {
    if (depth_without[i] == 0.0F) continue;
    nearer += depth[i] > 0.0F && depth[i] < depth_without[i] - 3e-3F;
    if (depth[i] > 0.0F) continue;
    ++hidden;
    const std::uint8_t* bgr = with.bytes->data() + 3 * i;
    grey += bgr[2] < 1.25 * bgr[0] + 12.0;
  }
  QVERIFY2(hidden > 100 && grey > 0.8 * hidden, qPrintable(QString("%1 %2").arg(hidden).arg(grey)));
  QVERIFY2(nearer > 200, qPrintable(QString::number(nearer)));
  QVERIFY(theatre_->use_tool({}, RunContext()));
  QVERIFY(same(kThere, 1));
}

void HandledTheatreTest::TheSameSeedIsTheSameUse() {
  const auto shown = [&](std::uint64_t seed) {
    ToolUse seeded = use(6.0);
    seeded.seed = seed;
    QVERIFY(theatre_->use_tool(seeded, RunContext()));
  };
  shown(3);
  const Points three = nodes(kThere);
  shown(4);
  const Points four = nodes(kThere);
  // Where the scope stands does not change where the tool goes.
  theatre_->move_scope(ScopePath::in_a_hand());
  shown(3);
  theatre_->move_scope({});
  QVERIFY(nodes(kThere) == three && nodes(kThere) != four);
  QVERIFY(theatre_->use_tool({}, RunContext()));
}

void HandledTheatreTest::AFirmerPullTakesMoreForce() {
  QCOMPARE(theatre_->tool_force_n(), 0.0);
  QVERIFY(theatre_->use_tool(use(4.0), RunContext()));
  const double weak = theatre_->tool_force_n();
  QVERIFY(theatre_->use_tool(use(12.0), RunContext()));
  const double strong = theatre_->tool_force_n();
  QVERIFY2(weak > 0.05 && strong > 2.0 * weak && strong < 20.0,
           qPrintable(QString("%1 N, %2 N").arg(weak).arg(strong)));
  QVERIFY(theatre_->use_tool({}, RunContext()));
}

void HandledTheatreTest::WrongOptionsAreRefusedAndCancelChangesNothing() {
  QVERIFY_THROWS_EXCEPTION(InputError, theatre_->use_tool(use(99.0), RunContext()));
  QVERIFY_THROWS_EXCEPTION(InputError, theatre_->move_scope({.zoom_mm = 99.0}));
  const Points still = nodes(kThere);
  const auto flag = std::make_shared<CancelFlag>();
  flag->request();
  QVERIFY(!theatre_->use_tool(use(5.0), RunContext({}, flag, 1)));
  QVERIFY(nodes(kThere) == still && !theatre_->tool_touches(0));
}

QTEST_GUILESS_MAIN(HandledTheatreTest)
#include "handled_theatre_test.moc"
