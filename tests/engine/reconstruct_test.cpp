// SPDX-License-Identifier: GPL-3.0-or-later
// Which points a stereo pair has, and when they change.
#include <QTest>

#include "glisson/core/files.h"
#include "glisson/engine/commands/load_stereo_pair.h"
#include "glisson/engine/commands/reconstruct.h"
#include "glisson/engine/commands/set_calibration.h"
#include "glisson/engine/commands/set_regions.h"
#include "glisson/engine/engine.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/stereo/calibration_io.h"
#include "glisson/stereo/labelling.h"
#include "glisson/stereo/picture_io.h"
#include "rendered_pair.h"

using namespace glisson;
using namespace glisson::engine;

class ReconstructTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void APairBecomesDenseOnceItsRegionsAreThinAndStaysSo();
  void TheNextPairIsJudgedAnew();
  void WhoChoosesSparseGetsSparse();
  void ANewPairIsLookedAtFirst();

 private:
  static stereo::Regions square(double x, double y) {
    stereo::Regions regions;
    regions.regions = {{Feature::surface, {{x, y}, {x + kSide, y}, {x + kSide, y + kSide}, {x, y + kSide}}}};
    return regions;
  }
  std::unique_ptr<Engine> engine() const {
    Engine::Options options;
    options.runner = Runner::inline_;
    auto made = std::make_unique<Engine>(options);
    after(*made, SetCalibration{folder_.path() / "scope.yaml"});
    after(*made, pair());
    return made;
  }
  Command pair() const {
    return LoadStereoPair{folder_.path() / "left.png", folder_.path() / "right.png", {}};
  }
  /// What the engine holds after this command, which must succeed.
  static CaseState after(Engine& engine, const Command& command) {
    const Outcome outcome = engine.wait(engine.post(command));
    if (outcome.status != Status::done) throw std::runtime_error(outcome.error);
    return engine.snapshot()->state;
  }
  static CaseState labelled(Engine& engine, const stereo::Regions& regions, const Reconstruct& command) {
    after(engine, SetRegions{regions});
    return after(engine, command);
  }
  static bool dense(const CaseState& state) {
    return state[part::points]->whole->report.method == stereo::Method::dense;
  }

  static constexpr double kSide = 80.0;
  TemporaryFolder folder_;
  Reconstruct automatic_;
  stereo::Regions thin_, thick_;  ///< with fewer and with more of the sparse points than are wanted
  double thin_density_ = HUGE_VAL;
};

void ReconstructTest::initTestCase() {
  const rendered::Pair pair = rendered::pair(
      rendered::plane(Eigen::Vector3d(0, 0, 0.09), Eigen::Vector3d(0.1, 0.2, -1.0).normalized()));
  stereo::write_picture(folder_.path() / "left.png", pair.left);
  stereo::write_picture(folder_.path() / "right.png", pair.right);
  stereo::write_calibration(folder_.path() / "scope.yaml", pair.rig);
  automatic_.options.features = 250;
  automatic_.options.method = stereo::Method::sparse;
  const CaseState state = after(*engine(), automatic_);
  double thick = 0.0;
  for (double y = 100.0; y < 300.0; y += 40.0)
    for (double x = 150.0; x < 450.0; x += 40.0) {
      const double density =
          stereo::label(state[part::points]->whole->cloud, *state[part::rig], {}, square(x, y))
              .density_per_cm2;
      if (density < thin_density_ && density > 0.0) thin_density_ = density, thin_ = square(x, y);
      if (density > thick) thick = density, thick_ = square(x, y);
    }
  const double whole = state[part::points]->whole->report.density_per_cm2;
  QVERIFY2(thin_density_ < 0.8 * whole && whole <= thick,
           qPrintable(QString("%1 %2 %3").arg(thin_density_).arg(whole).arg(thick)));
  automatic_.options.method = stereo::Method::automatic;
  automatic_.options.least_density_per_cm2 = 0.5 * (thin_density_ + whole);
}

void ReconstructTest::APairBecomesDenseOnceItsRegionsAreThinAndStaysSo() {
  const auto scope = engine();
  const CaseState before = labelled(*scope, thick_, automatic_);
  QVERIFY(!dense(before));
  const CaseState switched = labelled(*scope, thin_, automatic_);
  QVERIFY(dense(switched));
  QVERIFY(switched[part::points]->density_per_cm2 > 2.0 * thin_density_);
  // To and fro between the two: the points are not exchanged again, nor made again.
  for (const stereo::Regions& regions : {thick_, thin_, thick_}) {
    const CaseState now = labelled(*scope, regions, automatic_);
    QVERIFY(now[part::points]->whole == switched[part::points]->whole);
  }
}

void ReconstructTest::TheNextPairIsJudgedAnew() {
  const auto scope = engine();
  QVERIFY(dense(labelled(*scope, thin_, automatic_)));
  after(*scope, pair());
  QVERIFY(!dense(labelled(*scope, thick_, automatic_)));
}

void ReconstructTest::WhoChoosesSparseGetsSparse() {
  const auto scope = engine();
  Reconstruct sparse = automatic_;
  sparse.options.method = stereo::Method::sparse;
  const CaseState state = labelled(*scope, thin_, sparse);
  QVERIFY(!dense(state));
  QCOMPARE(state[part::points]->density_per_cm2, thin_density_);
}

void ReconstructTest::ANewPairIsLookedAtFirst() {
  const auto scope = engine();
  Reconstruct command = automatic_;
  command.options.method = stereo::Method::sparse;
  const Outcome looked = scope->wait(scope->post(command));
  QVERIFY(looked.figures.at("pair_matches") >= 20.0);
  QVERIFY(looked.figures.at("pair_rows_px") < 2.0);
  // Its points are known now.
  QVERIFY(!scope->wait(scope->post(command)).figures.contains("pair_matches"));
  after(*scope, LoadStereoPair{folder_.path() / "right.png", folder_.path() / "left.png", {}});
  const Outcome refused = scope->wait(scope->post(command));
  QCOMPARE(refused.status, Status::failed);
  QVERIFY2(refused.error.find("swapped") != std::string::npos, refused.error.c_str());
}

QTEST_APPLESS_MAIN(ReconstructTest)
#include "reconstruct_test.moc"
