// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QTest>
#include <cmath>

#include "data_folder.h"
#include "glisson/core/error.h"
#include "glisson/geometry/mesh_io.h"
#include "phantom.h"
#include "pulled_proof.h"
#include "pulled_trials.h"

using namespace glisson;
using namespace glisson::experiments;

namespace {

const PulledKind& kind(const std::string& code) {
  return *std::find_if(std::begin(kPulledKinds), std::end(kPulledKinds),
                       [&](const PulledKind& one) { return code == one.code; });
}

}  // namespace

class PulledTest : public QObject {
  Q_OBJECT
 private slots:
  void APhantomIsFoundAndFollowed_data() {
    QTest::addColumn<QString>("code");
    for (const PulledKind& one : kPulledKinds)
      if (one.held_radius_mm < 50.0)  // more than half of so small an organ
        QTest::newRow(one.code) << QString(one.code);
  }
  void APhantomIsFoundAndFollowed() {
    QFETCH(QString, code);
    const BareOrgan organ{"phantom", phantom::model(10, 8, 6).mesh};
    const auto trial = try_pulled(organ, kind(code.toStdString()), 3, 0.0, 2, RunContext());
    QVERIFY(trial && trial->moved > 1e-3 && trial->frames == 1);
    const auto shown = [&](double error) {
      return QString("%1 of %2 mm").arg(1e3 * error).arg(1e3 * trial->moved);
    };
    QVERIFY2(trial->error < 0.35 * trial->moved, qPrintable(shown(trial->error)));
    QVERIFY2(trial->followed < 0.35 * trial->moved, qPrintable(shown(trial->followed)));
    QVERIFY(trial->worst > trial->error && trial->followed_worst >= trial->followed);
  }

  /// From rest the neo-Hookean law, which is the true one, was still moving where it fits badly: the linear
  /// one was chosen, 1 mm off on average.
  void ALawThatWasStillMovingBeginsAgainWhereTheBestHasEnded() {
    const std::filesystem::path folder = test::data_folder() / "elastic_sequence";
    if (!std::filesystem::exists(folder)) QSKIP("elastic_sequence is not here (set GLISSON_DATA)");
    const BareOrgan organ{"elastic_sequence", read_tet_mesh(folder / "rest.vtk", LengthUnit::millimetre)};
    const auto trial = try_pulled(organ, kind("local"), 103, 0.0, 1, RunContext());
    QVERIFY2(trial->error < 0.2e-3, qPrintable(QString::number(1e3 * trial->error)));
    QVERIFY(trial->doubts.empty());
  }

  void CancelGivesNothing() {
    const auto flag = std::make_shared<CancelFlag>();
    flag->request();
    const RunContext context({}, flag, 1);
    const BareOrgan organ{"phantom", phantom::model(10, 8, 6).mesh};
    QVERIFY(!try_pulled(organ, kPulledKinds[0], 1, 0.0, 2, context));
    QTemporaryDir folder;
    QVERIFY(!prove_pulled({}, folder.path().toStdString(), context));
    QVERIFY(QDir(folder.path()).isEmpty());
  }

  void RefusesUnusableOptions() {
    PulledProofOptions options;
    options.organs = 0;
    QVERIFY_THROWS_EXCEPTION(InputError, options.validate());
    options = {};
    options.frames = 1;
    QVERIFY_THROWS_EXCEPTION(InputError, options.validate());
    options = {};
    options.threads = 3;
    QVERIFY_THROWS_EXCEPTION(InputError, options.validate());
  }
};

QTEST_APPLESS_MAIN(PulledTest)
#include "pulled_test.moc"
