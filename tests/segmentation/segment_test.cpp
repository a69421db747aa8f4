// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/segmentation/segment.h"

#include <QTest>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "noisy_ct.h"
#include "points_at.h"

using namespace glisson;
using namespace glisson::segmentation;
namespace fs = std::filesystem;

namespace {

struct Phantom {
  Image image;
  std::vector<std::uint8_t> liver, lesion;
};

/// An ellipsoid of 110 HU in fat, a ball of 118 HU that touches it through a bridge, a vessel of 160 HU and a
/// dark lesion in it; noise of 12 HU.
Phantom phantom() {
  Phantom result;
  VolumeGrid grid;
  grid.size = {80, 64, 56};
  grid.spacing_mm = {2.0, 2.0, 2.2};
  grid.origin_mm = {-90, -60, 20};
  result.image = test::noisy_ct(grid, 5, 12.0, [&](const Eigen::Vector3d& p) {
    const bool liver =
        (p - Eigen::Vector3d(62, 62, 60)).cwiseQuotient(Eigen::Vector3d(46, 40, 38)).norm() < 1.0;
    const bool neighbour = (p - Eigen::Vector3d(134, 62, 60)).norm() < 26.0;
    const bool bridge = p.x() > 100 && p.x() < 120 && std::hypot(p.y() - 62, p.z() - 60) < 6.0;
    const bool vessel = liver && std::hypot(p.y() - 50, p.z() - 60) < 4.0;
    const bool lesion = (p - Eigen::Vector3d(50, 75, 60)).norm() < 9.0;
    double hu = -100.0;
    if (neighbour || bridge) hu = 118.0;
    if (liver) hu = vessel ? 160.0 : lesion ? 60.0 : 110.0;
    result.liver.push_back(liver ? 1 : 0);
    result.lesion.push_back(lesion ? 1 : 0);
    return hu;
  });
  return result;
}

Seeds clicks_in(const Image& image) {
  Seeds seeds;
  seeds.liver = test::points_at(image, {{62, 75, 75}, {80, 62, 45}});
  seeds.portal_vein = test::points_at(image, {{62, 50, 60}});
  seeds.lesions = {test::points_at(image, {{50, 75, 60}})};
  return seeds;
}

std::vector<std::uint8_t> mask_of(const Segmented& result, Label label) {
  return result.labels.voxels.mask([=](Label l) { return l == label; });
}

}  // namespace

class SegmentTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void LiverLesionAndVesselAreFound();
  void ABridgeToANeighbourIsNotCrossed();
  void ResultDoesNotDependOnTheStorageOrder();
  void TheSameInputGivesTheSameLabels();
  void AGallbladderThatRunsOnIsTold();
  void MetalInTheLiversSlicesIsTold();
  void CancelledWorkGivesNothing();
  void ProgressRunsFromStartToEnd();
  void TheContourIsShownWhileItMoves();
  void WhatIsKeptStaysVoxelByVoxel();
  void ALesionWithoutSeedsStays();
  void ARegionLeavesTheRestAlone();
  void ARegionOfATiltedVolumeLeavesTheRestAlone();
  void FinerVoxelsDoNotLoseTheBoundary();
  void SeedsComeBackFromTheirFile();
  void BadSeedFilesAreRefused_data();
  void BadSeedFilesAreRefused();
  void BadInputIsRefused();
  void DiceOfKnownMasks();

 private:
  /// The phantom, found from its clicks: what most tests look at.
  Phantom phantom_;
  Segmented found_;
};

void SegmentTest::initTestCase() {
  phantom_ = phantom();
  found_ = segment(phantom_.image, clicks_in(phantom_.image), {}, RunContext()).value();
}

void SegmentTest::LiverLesionAndVesselAreFound() {
  const Phantom& p = phantom_;
  const Segmented& result = found_;
  const double liver = dice(inside_liver(result.labels), p.liver);
  QVERIFY2(liver > 0.95, qPrintable(QString::number(liver)));
  const double lesion = dice(mask_of(result, structure::kFirstLesion), p.lesion);
  QVERIFY2(lesion > 0.75, qPrintable(QString::number(lesion)));
  QVERIFY(result.report.portal_ml > 1.0 && result.report.portal_ml < 8.0);
  QCOMPARE(result.report.hepatic_ml, 0.0);
  QCOMPARE(result.report.lesion_ml.size(), std::size_t(1));
}

void SegmentTest::ABridgeToANeighbourIsNotCrossed() {
  const Segmented& result = found_;
  const Eigen::Vector3i in_neighbour(67, 31, 27);
  QCOMPARE(result.labels.voxels.at(in_neighbour), structure::kBackground);
}

void SegmentTest::ResultDoesNotDependOnTheStorageOrder() {
  const Phantom& p = phantom_;
  const Segmented& straight = found_;
  // The same patient, stored with i and j exchanged and k running backwards.
  Image turned = p.image;
  const VolumeGrid& g = p.image.grid;
  turned.grid.size = {g.size.y(), g.size.x(), g.size.z()};
  turned.grid.spacing_mm = {g.spacing_mm.y(), g.spacing_mm.x(), g.spacing_mm.z()};
  turned.grid.direction.setZero();
  turned.grid.direction(1, 0) = turned.grid.direction(0, 1) = 1.0;
  turned.grid.direction(2, 2) = -1.0;
  turned.grid.origin_mm.z() += g.spacing_mm.z() * (g.size.z() - 1);
  std::vector<std::int16_t> voxels;
  for (int k = 0; k < g.size.z(); ++k)
    for (int i = 0; i < g.size.x(); ++i)
      for (int j = 0; j < g.size.y(); ++j) voxels.push_back(p.image.at({i, j, g.size.z() - 1 - k}));
  turned.voxels = std::make_shared<const std::vector<std::int16_t>>(std::move(voxels));
  const Segmented other = segment(turned, clicks_in(p.image), {}, RunContext()).value();
  std::vector<std::uint8_t> back;
  for (int k = 0; k < g.size.z(); ++k)
    for (int j = 0; j < g.size.y(); ++j)
      for (int i = 0; i < g.size.x(); ++i)
        back.push_back(other.labels.voxels.at({j, i, g.size.z() - 1 - k}) != 0 ? 1 : 0);
  const double same = dice(back, straight.labels.voxels.mask([](Label l) { return l != 0; }));
  QVERIFY2(same > 0.995, qPrintable(QString::number(same)));
}

void SegmentTest::TheSameInputGivesTheSameLabels() {
  const Phantom& p = phantom_;
  const Segmented again = segment(p.image, clicks_in(p.image), {}, RunContext()).value();
  QVERIFY(again.labels.voxels == found_.labels.voxels);
}

/// A liver that lies in fluid, and one with a cyst of 92 ml that touches the gallbladder: nothing tells bile
/// from either.
void SegmentTest::AGallbladderThatRunsOnIsTold() {
  const auto told = [](const Segmented& result) {
    return std::ranges::any_of(
        result.report.notes, [](const std::string& note) { return note.starts_with("gallbladder.large "); });
  };
  enum class Beside { fat, cyst, ascites };
  for (const Beside beside : {Beside::fat, Beside::cyst, Beside::ascites}) {
    const Image image = test::noisy_ct(phantom_.image.grid, 5, 12.0, [&](const Eigen::Vector3d& p) {
      const bool liver =
          (p - Eigen::Vector3d(62, 62, 60)).cwiseQuotient(Eigen::Vector3d(46, 40, 38)).norm() < 1.0;
      const bool gallbladder = (p - Eigen::Vector3d(124, 62, 60)).norm() < 15.0;
      const bool cyst = beside == Beside::cyst && (p - Eigen::Vector3d(124, 95, 60)).norm() < 28.0;
      return liver ? 110.0 : gallbladder || cyst || beside == Beside::ascites ? 10.0 : -100.0;
    });
    Seeds seeds;
    seeds.liver = test::points_at(image, {{62, 75, 75}, {80, 62, 45}});
    seeds.gallbladder = test::points_at(image, {{124, 62, 60}});
    QCOMPARE(told(segment(image, seeds, {}, RunContext()).value()), beside != Beside::fat);
  }
}

void SegmentTest::MetalInTheLiversSlicesIsTold() {
  // A ball of 6 mm beside the liver, a clip of one voxel in it, and nothing.
  struct Metal {
    Eigen::Vector3d at;
    double radius;
    bool told;
  };
  for (const Metal& metal : {Metal{{8, 8, 60}, 6.0, true}, Metal{{62, 62, 61.6}, 1.0, false}}) {
    Image image = phantom_.image;
    auto voxels = *image.voxels;
    std::size_t at = 0;
    for (int k = 0; k < image.grid.size.z(); ++k)
      for (int j = 0; j < image.grid.size.y(); ++j)
        for (int i = 0; i < image.grid.size.x(); ++i, ++at)
          if ((Eigen::Vector3d(i, j, k).cwiseProduct(image.grid.spacing_mm) - metal.at).norm() < metal.radius)
            voxels[at] = 3000;
    QVERIFY(voxels != *image.voxels);
    image.voxels = std::make_shared<const std::vector<std::int16_t>>(std::move(voxels));
    const auto notes = segment(image, clicks_in(image), {}, RunContext())->report.notes;
    QCOMPARE(
        std::ranges::any_of(notes, [](const std::string& note) { return note.starts_with("image.metal "); }),
        metal.told);
  }
}

void SegmentTest::CancelledWorkGivesNothing() {
  const Phantom& p = phantom_;
  const auto flag = std::make_shared<CancelFlag>();
  // Cancelled from within, in the middle of the contour.
  const RunContext context(
      [&](double, std::string_view stage) {
        if (stage == "segmentation.contour") flag->request();
      },
      flag, 1);
  QVERIFY(!segment(p.image, clicks_in(p.image), {}, context).has_value());
  const auto late = std::make_shared<CancelFlag>();
  const RunContext in_vessels(
      [&](double, std::string_view stage) {
        if (stage == "segmentation.vesselness") late->request();
      },
      late, 1);
  QVERIFY(!segment(p.image, clicks_in(p.image), {}, in_vessels).has_value());
}

void SegmentTest::ProgressRunsFromStartToEnd() {
  const Phantom& p = phantom_;
  double last = 0.0;
  bool rising = true;
  const RunContext context(
      [&](double fraction, std::string_view) {
        rising = rising && fraction >= last - 1e-9;
        last = fraction;
      },
      nullptr, 1);
  QVERIFY(segment(p.image, clicks_in(p.image), {}, context).has_value());
  QVERIFY(rising);
  QCOMPARE(last, 1.0);
}

void SegmentTest::TheContourIsShownWhileItMoves() {
  const Phantom& p = phantom_;
  std::vector<LabelVolume> seen;
  const Segmented result =
      segment(p.image, clicks_in(p.image), {}, RunContext(), nullptr, [&](const LabelVolume& liver) {
        seen.push_back(liver);
      }).value();
  QVERIFY(seen.size() >= 2);
  QVERIFY(seen.back().grid().same_as(p.image.grid));
  const auto is_set = [](Label label) { return label == 1; };
  for (const LabelVolume& liver : seen)
    QCOMPARE(liver.histogram().size() <= 2 || liver.histogram()[1] > 0, true);
  const double last = dice(seen.back().mask(is_set), inside_liver(result.labels));
  QVERIFY2(last > 0.99, qPrintable(QString::number(last)));
  // It moved, and what did not move is shared.
  const int moved = seen.back().bricks_differing_from(seen.front());
  QVERIFY(moved > 0);
  QVERIFY(seen.front().mask(is_set) != seen.back().mask(is_set));
}

void SegmentTest::WhatIsKeptStaysVoxelByVoxel() {
  const Phantom& p = phantom_;
  Seeds seeds = clicks_in(p.image);
  LabelMap edited = found_.labels;
  // A person's edits: an artery across the vessel, and a corner of the liver taken away.
  for (int i = 20; i < 40; ++i) edited.voxels.set({i, 25, 27}, structure::kArtery);
  for (int k = 0; k < 20; ++k)
    for (int j = 0; j < 64; ++j)
      for (int i = 0; i < 20; ++i) edited.voxels.set({i, j, k}, structure::kBackground);
  edited.infos.front().terminology = "kept";
  SegmentationOptions options;
  options.structures = {false, true, false, false, false, false};
  seeds.liver.resize(0, 3);  // not needed: the liver is kept
  const Segmented again = segment(p.image, seeds, options, RunContext(), &edited).value();
  const std::vector<Label> before = edited.voxels.dense(), after = again.labels.voxels.dense();
  const auto may_change = [](Label l) { return l == structure::kParenchyma || l == structure::kPortalVein; };
  long vessel = 0;
  for (std::size_t n = 0; n < before.size(); ++n) {
    if (before[n] != after[n]) QVERIFY(may_change(before[n]) && may_change(after[n]));
    vessel += after[n] == structure::kPortalVein;
  }
  QVERIFY(vessel > 100);
  QCOMPARE(again.labels.infos.front().terminology, std::string("kept"));
  // Without seeds nothing is found anew, and nothing is lost.
  seeds.portal_vein.resize(0, 3);
  QVERIFY(segment(p.image, seeds, options, RunContext(), &edited).value().labels.voxels == edited.voxels);
}

void SegmentTest::ALesionWithoutSeedsStays() {
  const Phantom& p = phantom_;
  constexpr Label first = structure::kFirstLesion, second = structure::kFirstLesion + 1;
  // A hand painted the first lesion; the second is clicked.
  LabelMap edited = found_.labels;
  for (int k = 0; k < p.image.grid.size.z(); ++k)
    for (int j = 0; j < p.image.grid.size.y(); ++j)
      for (int i = 0; i < p.image.grid.size.x(); ++i)
        if (edited.voxels.at({i, j, k}) == first) edited.voxels.set({i, j, k}, structure::kParenchyma);
  for (int k = 32; k < 37; ++k)
    for (int j = 29; j < 34; ++j)
      for (int i = 38; i < 43; ++i) edited.voxels.set({i, j, k}, first);
  const std::vector<std::uint8_t> painted = edited.voxels.mask([](Label label) { return label == first; });
  Seeds seeds;
  seeds.lesions = {Points(0, 3), test::points_at(p.image, {{50, 75, 60}})};
  SegmentationOptions options;
  options.structures = {false, false, false, false, false, true};
  const auto lesions_are_right = [&](const Segmented& result) {
    return mask_of(result, first) == painted && dice(mask_of(result, second), p.lesion) > 0.6;
  };
  const Segmented anew = segment(p.image, seeds, options, RunContext(), &edited).value();
  QVERIFY(lesions_are_right(anew));
  for (const std::string& note : anew.report.notes)
    QVERIFY2(note.find("lesion") == std::string::npos, note.c_str());
  // In a region only seeds that lie in it count.
  seeds.lesions[0] = test::points_at(p.image, {{100, 62, 60}});
  const VolumeGrid& grid = p.image.grid;
  options.region =
      Eigen::AlignedBox3d(grid.p_in_ct({2.0, 4.0, 3.0}).xyz, grid.p_in_ct({45.0, 60.0, 52.0}).xyz);
  QVERIFY(lesions_are_right(segment(p.image, seeds, options, RunContext(), &edited).value()));
  // With a seed of its own it is found anew, where one is: not among plain liver.
  seeds.lesions[0] = test::points_at(p.image, {{80, 62, 75}});
  QVERIFY(mask_of(segment(p.image, seeds, options, RunContext(), &edited).value(), first) == painted);
  seeds.lesions = {test::points_at(p.image, {{50, 75, 60}})};
  QVERIFY(dice(mask_of(segment(p.image, seeds, options, RunContext(), &edited).value(), first), p.lesion) >
          0.6);
}

void SegmentTest::ARegionLeavesTheRestAlone() {
  const Phantom& p = phantom_;
  const VolumeGrid& grid = p.image.grid;
  LabelMap kept{LabelVolume(grid), {}};
  for (int k = 0; k < grid.size.z(); ++k) kept.voxels.set({70, 60, k}, structure::kArtery);
  SegmentationOptions options;
  // The left half of the ellipsoid, not cut along a brick.
  options.region =
      Eigen::AlignedBox3d(grid.p_in_ct({2.0, 4.0, 3.0}).xyz, grid.p_in_ct({37.0, 60.0, 52.0}).xyz);
  const Segmented half = segment(p.image, clicks_in(p.image), options, RunContext(), &kept).value();
  std::vector<std::uint8_t> truth, found;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) {
        const Label label = half.labels.voxels.at({i, j, k});
        if (i < 2 || i > 37 || j < 4 || j > 60 || k < 3 || k > 52) {
          QCOMPARE(label, kept.voxels.at({i, j, k}));
          continue;
        }
        truth.push_back(p.liver[static_cast<std::size_t>(grid.offset({i, j, k}))]);
        found.push_back(label != 0 ? 1 : 0);
      }
  const double overlap = dice(truth, found);
  QVERIFY2(overlap > 0.95, qPrintable(QString::number(overlap)));
  // It ends on the region's border, with a flat face.
  double cut = 0.0;  // mm^2
  for (int k = 3; k <= 52; ++k)
    for (int j = 4; j <= 60; ++j)
      if (p.liver[static_cast<std::size_t>(grid.offset({37, j, k}))] != 0)
        cut += grid.spacing_mm.y() * grid.spacing_mm.z();
  double told_mm2 = 0.0;
  for (const std::string& note : half.report.notes)
    if (note.starts_with("liver.cut_by_region ")) told_mm2 = 1e2 * std::stod(note.substr(20));
  QVERIFY2(std::abs(told_mm2 / cut - 1.0) < 0.1, qPrintable(QString("%1 of %2").arg(told_mm2).arg(cut)));
  // The other half of the image was not written: its bricks are the kept ones.
  for (const LabelChange& change : half.labels.voxels.changes_since(kept.voxels))
    QVERIFY(kept.voxels.brick_place(change.number).x() < 2);
}

void SegmentTest::ARegionOfATiltedVolumeLeavesTheRestAlone() {
  Phantom p = phantom_;
  VolumeGrid& grid = p.image.grid;
  grid.direction = Eigen::AngleAxisd(0.35, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const auto place = [&](const Eigen::Vector3d& mm) {
    return Eigen::Vector3d(grid.p_in_ct(mm.cwiseQuotient(grid.spacing_mm)).xyz);
  };
  Seeds seeds;
  seeds.liver.resize(2, 3);
  seeds.liver.row(0) = place({62, 75, 75}).transpose();
  seeds.liver.row(1) = place({80, 62, 45}).transpose();
  // Around the liver, along the patient's axes; its box of voxels is larger.
  const Eigen::Vector3d middle = place({62, 62, 60}), half(0.052, 0.046, 0.044);
  SegmentationOptions options;
  options.region = Eigen::AlignedBox3d(middle - half, middle + half);
  const std::vector<Label> everywhere(static_cast<std::size_t>(grid.voxel_count()), structure::kParenchyma);
  const LabelMap kept{LabelVolume(grid, everywhere), {}};
  const Segmented result = segment(p.image, seeds, options, RunContext(), &kept).value();
  std::vector<std::uint8_t> truth, found;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) {
        const Label label = result.labels.voxels.at({i, j, k});
        const Eigen::Vector3i voxel(i, j, k);
        if (options.region->exteriorDistance(grid.p_in_ct(voxel.cast<double>()).xyz) > 1e-6) {
          QCOMPARE(label, structure::kParenchyma);
          continue;
        }
        truth.push_back(p.liver[static_cast<std::size_t>(grid.offset(voxel))]);
        found.push_back(label != 0 ? 1 : 0);
      }
  const double overlap = dice(truth, found);
  QVERIFY2(overlap > 0.9, qPrintable(QString::number(overlap)));
}

void SegmentTest::FinerVoxelsDoNotLoseTheBoundary() {
  const Phantom& p = phantom_;
  SegmentationOptions options;
  options.working_spacing_mm = 1.2;
  const Segmented& coarse = found_;
  const Segmented fine = segment(p.image, clicks_in(p.image), options, RunContext()).value();
  const double at_2 = dice(inside_liver(coarse.labels), p.liver),
               at_1 = dice(inside_liver(fine.labels), p.liver);
  QVERIFY2(at_1 > at_2 - 0.002, qPrintable(QString("%1 %2").arg(at_1).arg(at_2)));
  QVERIFY(!(fine.labels.voxels == coarse.labels.voxels));
}

void SegmentTest::SeedsComeBackFromTheirFile() {
  const TemporaryFolder folder;
  const Phantom& p = phantom_;
  Seeds seeds = clicks_in(p.image);
  seeds.background = test::points_at(p.image, {{134, 62, 60}});
  seeds.lesions.emplace_back();  // a lesion of this number was painted, not clicked
  seeds.lesions.push_back(test::points_at(p.image, {{1, 2, 3}, {4, 5, 6}}));
  seeds.lesion_diameters_mm = {0.0, 0.0, 24.5};
  write_seeds(folder.path() / "seeds.json", seeds);
  const Seeds back = read_seeds(folder.path() / "seeds.json");
  QVERIFY((back.liver - seeds.liver).cwiseAbs().maxCoeff() < 1e-12);
  QVERIFY((back.background - seeds.background).cwiseAbs().maxCoeff() < 1e-12);
  QCOMPARE(back.lesions.size(), std::size_t(3));
  QCOMPARE(back.lesions[1].rows(), Eigen::Index(0));
  QVERIFY((back.lesions[2] - seeds.lesions[2]).cwiseAbs().maxCoeff() < 1e-12);
  QCOMPARE(back.lesion_diameters_mm, seeds.lesion_diameters_mm);
  QCOMPARE(back.vena_cava.rows(), Eigen::Index(0));
  QVERIFY(read_file(folder.path() / "seeds.json").find("-28") !=
          std::string::npos);  // millimetres, not metres
}

void SegmentTest::BadSeedFilesAreRefused_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::newRow("not JSON") << QByteArray("{");
  QTest::newRow("diameters are no list") << QByteArray(R"({"lesion_diameters_mm": 12})");
  QTest::newRow("diameter in words") << QByteArray(
      R"({"lesions": [[[1, 2, 3]]], "lesion_diameters_mm": ["12"]})");
  QTest::newRow("diameter of no lesion")
      << QByteArray(R"({"lesions": [[[1, 2, 3]]], "lesion_diameters_mm": [0, 12]})");
  QTest::newRow("diameter of a house")
      << QByteArray(R"({"lesions": [[[1, 2, 3]]], "lesion_diameters_mm": [9000]})");
  QTest::newRow("a list") << QByteArray("[]");
  QTest::newRow("no list") << QByteArray(R"({"liver": 3})");
  QTest::newRow("two numbers") << QByteArray(R"({"liver": [[1, 2]]})");
  QTest::newRow("text") << QByteArray(R"({"liver": [["a", 2, 3]]})");
  QTest::newRow("far away") << QByteArray(R"({"liver": [[1e9, 2, 3]]})");
  QTest::newRow("unknown") << QByteArray(R"({"spleen": [[1, 2, 3]]})");
  QTest::newRow("lesions flat") << QByteArray(R"({"lesions": [[1, 2, 3]]})");
}

void SegmentTest::BadSeedFilesAreRefused() {
  QFETCH(QByteArray, text);
  const TemporaryFolder folder;
  write_file_atomically(folder.path() / "seeds.json", text.toStdString());
  QVERIFY_THROWS_EXCEPTION(InputError, read_seeds(folder.path() / "seeds.json"));
}

void SegmentTest::BadInputIsRefused() {
  const Phantom& p = phantom_;
  const Seeds good = clicks_in(p.image);
  Seeds none = good;
  none.liver.resize(0, 3);
  QVERIFY_THROWS_EXCEPTION(InputError, segment(p.image, none, {}, RunContext()));
  Seeds outside = good;
  outside.lesions.push_back(test::points_at(p.image, {{-50, 0, 0}}));
  try {
    segment(p.image, outside, {}, RunContext());
    QFAIL("accepted");
  } catch (const InputError& error) {  // as the file with the seeds has it: which lesion's which point
    QCOMPARE(error.field(), "lesions " + std::to_string(outside.lesions.size()) + " 1");
  }
  Seeds in_air = good;
  in_air.liver = test::points_at(p.image, {{1, 1, 1}});
  Image air = p.image;
  air.voxels = std::make_shared<const std::vector<std::int16_t>>(p.image.voxels->size(), std::int16_t{-1000});
  QVERIFY_THROWS_EXCEPTION(InputError, segment(air, in_air, {}, RunContext()));
  Image unknown = p.image;
  unknown.modality = Modality::other;
  QVERIFY_THROWS_EXCEPTION(InputError, segment(unknown, good, {}, RunContext()));
  QVERIFY_THROWS_EXCEPTION(InputError, segment(Image(), good, {}, RunContext()));
  SegmentationOptions options;
  options.working_spacing_mm = 0.0;
  QVERIFY_THROWS_EXCEPTION(InputError, segment(p.image, good, options, RunContext()));
  options = {};
  options.region = Eigen::AlignedBox3d(Eigen::Vector3d(5, 5, 5), Eigen::Vector3d(6, 6, 6));
  QVERIFY_THROWS_EXCEPTION(InputError, segment(p.image, good, options, RunContext()));  // beside the image
  const auto corner = [&](double n) { return p.image.grid.p_in_ct({n, n, n}).xyz; };
  options.region = Eigen::AlignedBox3d(corner(0.0), corner(12.0));
  QVERIFY_THROWS_EXCEPTION(InputError, segment(p.image, good, options, RunContext()));  // no seed in it
  options = {};
  options.structures.liver = false;
  QVERIFY_THROWS_EXCEPTION(InputError, segment(p.image, good, options, RunContext()));  // nothing kept
  const LabelMap empty{LabelVolume(p.image.grid), {}};
  QVERIFY_THROWS_EXCEPTION(InputError, segment(p.image, good, options, RunContext(), &empty));
  VolumeGrid shifted = p.image.grid;
  shifted.origin_mm.x() += 10.0;
  const LabelMap elsewhere{LabelVolume(shifted), {}};
  QVERIFY_THROWS_EXCEPTION(InputError, segment(p.image, good, {}, RunContext(), &elsewhere));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, dice({1, 0}, {1}));
}

void SegmentTest::DiceOfKnownMasks() {
  QCOMPARE(dice({1, 1, 0, 0}, {1, 0, 1, 0}), 0.5);
  QCOMPARE(dice({1, 1}, {1, 1}), 1.0);
  QCOMPARE(dice({1, 0}, {0, 1}), 0.0);
  QCOMPARE(dice({0, 0}, {0, 0}), 1.0);
}

QTEST_APPLESS_MAIN(SegmentTest)
#include "segment_test.moc"
