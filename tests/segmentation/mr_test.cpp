// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <array>
#include <cmath>
#include <map>

#include "glisson/core/error.h"
#include "glisson/insilico/layperson.h"
#include "glisson/insilico/mr_patient.h"
#include "glisson/insilico/operator.h"
#include "glisson/segmentation/grow_around.h"
#include "glisson/volume/morphology.h"
#include "mr_scale.h"
#include "part.h"

using namespace glisson;
using namespace glisson::segmentation;
using insilico::MrOptions;
using insilico::MrPatient;

namespace {

MrPatient small_patient(MrOptions::Sequence sequence) {
  MrOptions options;
  options.sequence = sequence;
  options.spacing_mm = {2.5, 2.5, 3.0};
  return insilico::make_mr_patient(options, RunContext()).value();
}

/// Five random clicks in the liver, five beside it.
Seeds ten_clicks(const MrPatient& patient) {
  return insilico::click_as_layperson(patient.mr, patient.truth, {});
}

/// Why segment() refuses; empty: it does not.
std::string refused(const Image& image, const Seeds& seeds) {
  try {
    on_ct_scale(image, seeds, nullptr, RunContext());
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

/// Mean over the parenchyma of each block of 24 mm or so that holds enough of it.
std::vector<double> block_means(const Image& image, const LabelMap& truth) {
  const VolumeGrid& grid = image.grid;
  std::map<std::array<int, 3>, std::pair<double, double>> sums;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) {
        if (truth.voxels.at({i, j, k}) != structure::kParenchyma) continue;
        auto& [sum, count] = sums[{i / 10, j / 10, k / 8}];
        sum += image.at({i, j, k}), ++count;
      }
  std::vector<double> means;
  for (const auto& [place, block] : sums)
    if (block.second > 200.0) means.push_back(block.first / block.second);
  return means;
}

/// Deviation of the ratio of two lists over its mean: what one has and the other has not.
double unlike(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0, squares = 0.0;
  for (std::size_t n = 0; n < a.size(); ++n) sum += a[n] / b[n], squares += a[n] * a[n] / (b[n] * b[n]);
  const double mean = sum / static_cast<double>(a.size());
  return std::sqrt(squares / static_cast<double>(a.size()) - mean * mean) / mean;
}

}  // namespace

class MrTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void TheLiverIsFoundFromTenRandomClicks();
  void TheCoilsFieldIsTakenOff();
  void TheScannersUnitPlaysNoPart();
  void InvertedContrastIsRefused();
  void BloodThatIsNotEnhancedIsRefused();
  void AClickInFatIsRefused();
  void AKeptLiverIsAnAnchorToo();
  void AroundAClickTheWholePictureIsTheScale();
  void CancelLeavesNothing();

 private:
  MrPatient venous_;
  Seeds clicks_;
  Image mapped_;  ///< the same on a CT's scale
};

void MrTest::initTestCase() {
  venous_ = small_patient(MrOptions::Sequence::t1_venous);
  clicks_ = ten_clicks(venous_);
  const auto voxels = venous_.mr.voxels;
  mapped_ = on_ct_scale(venous_.mr, clicks_, nullptr, RunContext()).value();
  QVERIFY(venous_.mr.voxels == voxels && venous_.mr.modality == Modality::mr);
}

void MrTest::TheLiverIsFoundFromTenRandomClicks() {
  QCOMPARE(clicks_.liver.rows() + clicks_.background.rows(), Eigen::Index(10));
  const Segmented found = segment(venous_.mr, clicks_, {}, RunContext()).value();
  const double overlap = dice(inside_liver(found.labels), inside_liver(venous_.truth));
  qInfo("Dice of the liver %.3f", overlap);
  QVERIFY2(overlap > 0.9, qPrintable(QString::number(overlap)));
}

void MrTest::TheCoilsFieldIsTakenOff() {
  QCOMPARE(mapped_.modality, Modality::ct);
  MrOptions even;
  even.spacing_mm = {2.5, 2.5, 3.0};
  even.coil_variation = 0.0;
  const MrPatient without_coils = insilico::make_mr_patient(even, RunContext()).value();
  const Image same = on_ct_scale(without_coils.mr, clicks_, nullptr, RunContext()).value();
  const LabelMap& truth = venous_.truth;
  const double before = unlike(block_means(venous_.mr, truth), block_means(without_coils.mr, truth)),
               after = unlike(block_means(mapped_, truth), block_means(same, truth));
  qInfo("blocks of the liver differ by %.3f from those without coils, by %.3f after N4", before, after);
  QVERIFY(before > 0.03);
  QVERIFY2(after < 0.7 * before, qPrintable(QString("%1 %2").arg(before).arg(after)));
}

void MrTest::TheScannersUnitPlaysNoPart() {
  Image scaled = venous_.mr;
  auto voxels = *scaled.voxels;
  for (std::int16_t& v : voxels) v = static_cast<std::int16_t>(7 * v);
  scaled.voxels = std::make_shared<const std::vector<std::int16_t>>(std::move(voxels));
  const Image other = on_ct_scale(scaled, clicks_, nullptr, RunContext()).value();
  double difference = 0.0;
  for (std::size_t i = 0; i < mapped_.voxels->size(); ++i)
    difference += std::abs((*mapped_.voxels)[i] - (*other.voxels)[i]);
  difference /= static_cast<double>(mapped_.voxels->size());
  QVERIFY2(difference < 1.0, qPrintable(QString::number(difference)));
}

void MrTest::InvertedContrastIsRefused() {
  const MrPatient t2 = small_patient(MrOptions::Sequence::t2);
  const std::string vessels = refused(t2.mr, insilico::click_seeds(t2.truth, {}));
  QVERIFY2(vessels.find("portal_vein: is not brighter than the liver") != std::string::npos, vessels.c_str());
  std::string without;  // any vessel that was clicked
  try {
    segment(t2.mr, ten_clicks(t2), {}, RunContext());
  } catch (const InputError& error) {
    without = error.what();
  }
  QVERIFY2(without.find("far brighter than the liver") != std::string::npos, without.c_str());
}

void MrTest::BloodThatIsNotEnhancedIsRefused() {
  const MrPatient plain = small_patient(MrOptions::Sequence::t1_unenhanced);
  const std::string why = refused(plain.mr, insilico::click_seeds(plain.truth, {}));
  QVERIFY2(why.find("is not brighter than the liver") != std::string::npos, why.c_str());
  QCOMPARE(refused(venous_.mr, insilico::click_seeds(venous_.truth, {})), std::string());
}

void MrTest::AClickInFatIsRefused() {
  Seeds seeds;
  seeds.liver.resize(1, 3);
  seeds.liver.row(0) = venous_.mr.grid.p_in_ct({3.0, 3.0, 40.0}).xyz.transpose();
  const std::string why = refused(venous_.mr, seeds);
  QVERIFY2(why.find("hardly stands out") != std::string::npos, why.c_str());
}

void MrTest::AKeptLiverIsAnAnchorToo() {
  const Image kept = on_ct_scale(venous_.mr, {}, &venous_.truth, RunContext()).value();
  const auto& grid = venous_.mr.grid;
  const Eigen::Vector3i inside =
      grid.index_of(Point<CtFrame>(Eigen::Vector3d(clicks_.liver.row(0).transpose())))
          .array()
          .round()
          .cast<int>();
  QVERIFY(std::abs(mapped_.at(inside) - kept.at(inside)) < 15);
}

/// Of the voxels of a label the one that lies deepest in the liver.
Eigen::Vector3i deepest_of(const LabelMap& labels, Label label) {
  const VolumeGrid& grid = labels.voxels.grid();
  Mask liver(grid.size, grid.spacing_mm);
  liver.voxels = inside_liver(labels);
  const std::vector<float> depth2 = squared_depth_mm2(liver);
  Eigen::Vector3i deepest(0, 0, 0);
  float most = -1.0F;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i)
        if (const float here = depth2[liver.offset(i, j, k)];
            labels.voxels.at({i, j, k}) == label && here > most)
          most = here, deepest = {i, j, k};
  return deepest;
}

void MrTest::AroundAClickTheWholePictureIsTheScale() {
  const Eigen::Vector3i at = deepest_of(venous_.truth, structure::kParenchyma);
  constexpr std::size_t kNumber = 20;  // of a lesion that the labels do not have
  const StructureClick click{static_cast<Label>(structure::kFirstLesion + kNumber),
                             venous_.mr.grid.p_in_ct(at.cast<double>())};
  Seeds seeds;
  seeds.lesions.assign(kNumber + 1, PointsIn<CtFrame>(0, 3));
  seeds.lesions[kNumber] = click.p_in_ct.xyz.transpose();
  seeds.lesion_diameters_mm.assign(kNumber + 1, 0.0);
  seeds.lesion_diameters_mm[kNumber] = 8.0;
  // What is read around it holds liver alone, which tells no scale.
  const VoxelBox box = box_around(venous_.mr.grid, seeds.lesions[kNumber], 25.0);
  const LabelMap around = part_of(venous_.truth, box);
  QVERIFY_THROWS_EXCEPTION(InputError, on_ct_scale(part_of(venous_.mr, box), {}, &around, RunContext()));
  const CorrectedAround made = grow_around(venous_.mr, venous_.truth, seeds, click, {}, RunContext()).value();
  QCOMPARE(made.labels.voxels.at(at), click.structure);
  QVERIFY2(made.voxels_changed > 5 && made.reach_mm < 8.0, qPrintable(QString::number(made.reach_mm)));
}

void MrTest::CancelLeavesNothing() {
  const auto flag = std::make_shared<CancelFlag>();
  const RunContext context(
      [&](double, std::string_view stage) {
        if (stage == "segmentation.bias") flag->request();
      },
      flag, 1);
  QVERIFY(!segment(venous_.mr, clicks_, {}, context).has_value());
  QVERIFY(flag->requested());
}

QTEST_APPLESS_MAIN(MrTest)
#include "mr_test.moc"
