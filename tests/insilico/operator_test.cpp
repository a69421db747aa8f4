// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/insilico/operator.h"

#include <QTest>
#include <cmath>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/stereo/regions.h"
#include "theatre_patient.h"

using namespace glisson;
using namespace glisson::insilico;

namespace {

/// A box of liver with a thick and a thin vessel piece, a cava outside and one lesion; 2 mm voxels.
LabelMap box_of_labels() {
  VolumeGrid grid;
  grid.size = {70, 60, 50};
  grid.spacing_mm = {2.0, 2.0, 2.5};
  grid.origin_mm = {-70.0, -60.0, 30.0};
  LabelMap map;
  map.voxels = LabelVolume(grid);
  for (int k = 0; k < 50; ++k)
    for (int j = 0; j < 60; ++j)
      for (int i = 0; i < 70; ++i) {
        Label label = 0;
        if (i >= 15 && i < 55 && j >= 12 && j < 48 && k >= 8 && k < 42) label = structure::kParenchyma;
        const double portal = std::hypot(2.0 * (j - 30), 2.5 * (k - 25));
        if (label != 0 && i < 40 && portal < (i < 25 ? 7.0 : 3.5)) label = structure::kPortalVein;
        if (label != 0 && std::hypot(2.0 * (i - 45), 2.0 * (j - 20), 2.5 * (k - 30)) < 8.0) label = 16;
        if (std::hypot(2.0 * (i - 35), 2.0 * (j - 54)) < 9.0) label = structure::kVenaCava;
        map.voxels.set({i, j, k}, label);
      }
  return map;
}

Label label_at(const LabelMap& map, const Eigen::Vector3d& p) {
  const Eigen::Vector3i v = map.voxels.grid().index_of(Point<CtFrame>(p)).array().round().cast<int>();
  return map.voxels.grid().contains(v) ? map.voxels.at(v) : structure::kBackground;
}

bool inside(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& p) {
  bool in = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++)
    if ((polygon[i].y() > p.y()) != (polygon[j].y() > p.y()) &&
        p.x() <
            (polygon[j].x() - polygon[i].x()) * (p.y() - polygon[i].y()) / (polygon[j].y() - polygon[i].y()) +
                polygon[i].x())
      in = !in;
  return in;
}

}  // namespace

class OperatorTest : public QObject {
  Q_OBJECT
 private slots:
  void SeedsLieInTheirStructures() {
    const LabelMap map = box_of_labels();
    const segmentation::Seeds seeds = click_seeds(map, {});
    const auto all_in = [&](const Points& points, Label label) {
      for (Eigen::Index i = 0; i < points.rows(); ++i)
        if (label_at(map, points.row(i).transpose()) != label) return false;
      return points.rows() > 0;
    };
    QVERIFY(seeds.liver.rows() >= 3);
    QVERIFY(all_in(seeds.liver, structure::kParenchyma));
    QVERIFY(all_in(seeds.portal_vein, structure::kPortalVein));
    QVERIFY(all_in(seeds.vena_cava, structure::kVenaCava));
    QVERIFY(all_in(seeds.background, structure::kBackground));
    QCOMPARE(seeds.lesions.size(), std::size_t{1});
    QVERIFY(all_in(seeds.lesions[0], 16));
    QCOMPARE(seeds.hepatic_veins.rows(), Eigen::Index{0});
    // the thick end of the portal vein is where its tree comes in
    QVERIFY(seeds.portal_vein(0, 0) < map.voxels.grid().p_in_ct({26, 0, 0}).xyz.x());
  }

  void ClicksAreNotTheTruthAndRepeatBySeed() {
    Landmarks truth;
    truth.umbilical_notch = Points::Random(1, 3) * 0.1;
    truth.vena_cava = Points::Random(400, 3) * 0.1;
    truth.anterior_margin = Points::Random(40, 3) * 0.1;
    OperatorOptions options;
    const Landmarks a = click_landmarks(truth, options), b = click_landmarks(truth, options);
    QVERIFY(a.umbilical_notch == b.umbilical_notch && a.vena_cava == b.vena_cava);
    QCOMPARE(a.anterior_margin.rows(), Eigen::Index{0});
    options.seed = 2;
    QVERIFY(a.umbilical_notch != click_landmarks(truth, options).umbilical_notch);
    QVERIFY(a.umbilical_notch != truth.umbilical_notch);
    QVERIFY((a.umbilical_notch - truth.umbilical_notch).norm() < 10e-3);
    options.click_margin = true;
    QCOMPARE(click_landmarks(truth, options).anterior_margin.rows(), Eigen::Index{15});
  }

  void ClickNoiseHasItsStandardDeviation() {
    Landmarks truth;
    truth.umbilical_notch = Points::Zero(3000, 3);
    OperatorOptions options;
    options.click_noise_mm = 2.0;
    const Points noise = 1e3 * click_landmarks(truth, options).umbilical_notch;
    QVERIFY(std::abs(std::sqrt(noise.array().square().mean()) - 2.0) < 0.1);
    QVERIFY(noise.colwise().mean().norm() < 0.15);
  }

  void RegionsLieOnTheLiverAndNameItsFeatures() {
    TheatreOptions small;
    small.width = 480;
    small.height = 270;
    small.frames = 2;
    small.truth_vertices = 400;
    const auto theatre = Theatre::build(test::small_patient(), small, RunContext()).value();
    OperatorOptions options;
    options.click_noise_px = 0.0;
    const stereo::Regions regions = click_regions(*theatre, 0, options);
    const std::vector<float> depth = theatre->depth(0);
    bool surface = false, margin = false, notch = false;
    for (const stereo::Region& region : regions.regions) {
      QVERIFY(region.polygon.size() >= 20 && region.polygon.size() <= 40);
      int in = 0, on_liver = 0;
      for (int y = 0; y < 270; y += 2)
        for (int x = 0; x < 480; x += 2)
          if (inside(region.polygon, {x, y})) {
            ++in;
            on_liver += depth[static_cast<std::size_t>(y * 480 + x)] > 0.0F ? 1 : 0;
          }
      QVERIFY(in > 10);
      QVERIFY2(on_liver > 0.97 * in, qPrintable(QString("%1 of %2").arg(on_liver).arg(in)));
      surface |= region.feature == Feature::surface;
      margin |= region.feature == Feature::anterior_margin;
      notch |= region.feature == Feature::umbilical_notch;
    }
    QVERIFY(surface && margin && notch);
    // The truth's notch lies in the clicked notch, and the files hold it all.
    const Points p = theatre->carry(theatre->landmarks().umbilical_notch, 0);
    const TemporaryFolder folder;
    stereo::write_regions(folder.path() / "regions.json", regions);
    const stereo::Regions read = stereo::read_regions(folder.path() / "regions.json");
    const auto found = stereo::feature_at(read, theatre->rig().left.project(p.row(0).transpose()));
    QVERIFY(!found ||
            *found == Feature::umbilical_notch);  // nothing: the very edge, which a person leaves out
    options.click_noise_px = 3.0;
    QVERIFY(click_regions(*theatre, 0, options).regions[0].polygon[0] != regions.regions[0].polygon[0]);
  }

  void NoLiverIsRefused() {
    LabelMap empty;
    VolumeGrid grid;
    grid.size = {4, 4, 4};
    empty.voxels = LabelVolume(grid);
    QVERIFY_THROWS_EXCEPTION(InputError, static_cast<void>(click_seeds(empty, {})));
  }
  void UnusableNoiseIsRefused() {
    OperatorOptions options;
    options.click_noise_mm = -1.0;
    QVERIFY_THROWS_EXCEPTION(InputError, static_cast<void>(click_landmarks({}, options)));
    options = {};
    options.click_noise_px = std::nan("");
    QVERIFY_THROWS_EXCEPTION(InputError, static_cast<void>(click_landmarks({}, options)));
  }
};

QTEST_APPLESS_MAIN(OperatorTest)
#include "operator_test.moc"
