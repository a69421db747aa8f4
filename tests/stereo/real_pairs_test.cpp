// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "glisson/core/error.h"
#include "glisson/stereo/calibration_io.h"
#include "glisson/stereo/evaluate.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/stereo/reconstruct_pair.h"
#include "real_data.h"

using namespace glisson;
using namespace glisson::stereo;
namespace fs = std::filesystem;

namespace {

constexpr const char* kAbsent = "the real stereo pairs are not here (see GLISSON_DATA)";

struct Real {
  Picture left, right, mask;
  StereoRig rig;
};

/// Liver tissue with its surface from CT (Maier-Hein et al. 2014).
Real opencas(const fs::path& folder) {
  const auto file = [&](const char* name) {
    return folder / (std::string("Stereo_SD_d_complete_22_") + name);
  };
  Real real;
  real.left = read_picture(file("IMG_left.bmp"));
  real.right = read_picture(file("IMG_right.bmp"));
  real.mask = real_data::inverted(read_picture(file("MASK_eval.png")));
  const auto camera = [&](const std::string& side) {
    return real_data::camera(folder / ("calib." + side + ".intrinsics.txt"),
                             folder / ("calib." + side + ".distortion.txt"), 720, 576);
  };
  real.rig.left = camera("left");
  real.rig.right = camera("right");
  real_data::set_transform(real.rig, folder / "calib.l2r.txt");
  return real;
}

/// A silicone heart (Stoyanov, Hamlyn).
Real heart(const fs::path& folder) {
  Real real;
  real.left = read_picture(folder / "f7_dynamic_deint_L_0100.png");
  real.right = read_picture(folder / "f7_dynamic_deint_R_0100.png");
  real.mask = read_picture(folder / "f7_dynamic_deint_mask_0100.png");
  const auto camera = [&](const std::string& side) {
    return real_data::camera(folder / ("calib." + side + ".intrinsic.txt"),
                             folder / ("calib." + side + ".distortion.txt"), 360, 288);
  };
  real.rig.left = camera("left");
  real.rig.right = camera("right");
  real_data::set_transform(real.rig, folder / "calib.l2r.4x4");
  return real;
}

Reconstructed run(const Real& real, Method method, bool masked = true) {
  ReconstructOptions options;
  options.method = method;
  options.points_per_cm2 = 40.0;
  const PairInput input{{real.left, real.right}, real.rig, masked ? real.mask : Picture{}, {}};
  return *reconstruct_pair(input, options, RunContext())->whole;
}

}  // namespace

class RealPairsTest : public QObject {
  Q_OBJECT

 private slots:
  void LiverTissueLiesOnItsCtSurface_data() {
    QTest::addColumn<bool>("dense");
    QTest::addColumn<double>("median_mm");
    QTest::newRow("sparse") << false << 0.65;
    QTest::newRow("dense") << true << 0.62;
  }
  void LiverTissueLiesOnItsCtSurface() {
    const fs::path folder = glisson::test::data_folder() / "stereo_opencas";
    if (!fs::exists(folder)) QSKIP(kAbsent);
    QFETCH(bool, dense);
    QFETCH(double, median_mm);
    const Reconstructed result = run(opencas(folder), dense ? Method::dense : Method::sparse);
    const TriangleMesh surface = real_data::stl(folder / "Stereo_SD_d_complete_22_CT_cut.stl");
    const CloudErrors errors = cloud_errors(result.cloud, surface);
    qInfo("%d points, median %.3f mm, p95 %.3f mm, max %.3f mm, bias %.3f mm, rows off by %.2f px",
          result.cloud.size(), 1e3 * errors.distance.median, 1e3 * errors.distance.percentile_95,
          1e3 * errors.distance.maximum, 1e3 * errors.bias, result.report.row_offset_px);
    QVERIFY(result.cloud.size() >= 100);
    QVERIFY(1e3 * errors.distance.median <= median_mm);
    QVERIFY(errors.distance.percentile_95 <= 3e-3);
  }

  void CalibrationSurvivesItsFile() {
    const fs::path folder = glisson::test::data_folder() / "stereo_opencas";
    if (!fs::exists(folder)) QSKIP(kAbsent);
    const TemporaryFolder work;
    const StereoRig rig = opencas(folder).rig;
    write_calibration(work.path() / "rig.yml", rig);
    const StereoRig back = read_calibration(work.path() / "rig.yml");
    QVERIFY((back.right_from_left.translation - rig.right_from_left.translation).norm() < 1e-12);
    QVERIFY((back.right_from_left.rotation - rig.right_from_left.rotation).cwiseAbs().maxCoeff() < 1e-5);
  }

  void HeartIsSeenInItsMask() {
    const fs::path folder = glisson::test::data_folder() / "stereo_heart";
    if (!fs::exists(folder)) QSKIP(kAbsent);
    const Real real = heart(folder);
    const Reconstructed masked = run(real, Method::sparse), whole = run(real, Method::sparse, false);
    qInfo("%d points in the mask, %d in all, rows %.2f px", masked.cloud.size(), whole.cloud.size(),
          whole.report.epipolar_rms_px);
    QVERIFY(masked.cloud.size() >= 25);
    QVERIFY(whole.cloud.size() >= 150);
    QVERIFY(whole.report.epipolar_rms_px < 0.8);
    for (int i = 0; i < masked.cloud.size(); ++i) {
      const Eigen::Vector2d pixel = real.rig.left.project(masked.cloud.points.row(i).transpose());
      QVERIFY((pixel - Eigen::Vector2d(199, 204)).norm() < 48.0);  // the mask is that disk, radius 46
      QVERIFY(masked.cloud.points(i, 2) > 0.05 && masked.cloud.points(i, 2) < 0.07);
    }
  }

  void SwappedHeartIsRecognised() {
    const fs::path folder = glisson::test::data_folder() / "stereo_heart";
    if (!fs::exists(folder)) QSKIP(kAbsent);
    Real real = heart(folder);
    std::swap(real.left, real.right);
    QVERIFY_THROWS_EXCEPTION(InputError, run(real, Method::sparse, false));
  }

  void CalibrationOfAnotherScopeIsRefused() {
    const fs::path folder = glisson::test::data_folder();
    if (!fs::exists(folder / "stereo_heart") || !fs::exists(folder / "stereo_opencas")) QSKIP(kAbsent);
    Real real = heart(folder / "stereo_heart");
    real.rig = opencas(folder / "stereo_opencas").rig;
    QVERIFY_THROWS_EXCEPTION(InputError, run(real, Method::sparse, false));
  }
};

QTEST_APPLESS_MAIN(RealPairsTest)
#include "real_pairs_test.moc"
