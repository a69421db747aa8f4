// SPDX-License-Identifier: GPL-3.0-or-later
// Networks so small that the label of every voxel is known.
#include "glisson/network/label_network.h"

#include <QTest>
#include <set>

#include "complaint.h"
#include "network_files.h"

using namespace glisson;
using namespace glisson::network;
using test::bright_or_dark;
using test::OnnxNetwork;

namespace {

const char* const kBright = R"({"window_hu": [0, 200], "channels": ["background", "parenchyma"]})";

/// Bright where the remainder says so: detail at every voxel, so that a seam or a shift shows.
int speckle(const Eigen::Vector3i& v) { return (7 * v.x() + 5 * v.y() + 11 * v.z()) % 13 < 6 ? 150 : 40; }

}  // namespace

class LabelNetworkTest : public QObject {
  Q_OBJECT
  TemporaryFolder folder_;
  NetworkLabels labels(const Image& image, const OnnxNetwork& net, const std::string& sheet,
                       const LabelMap* kept = nullptr, const std::vector<Label>& locked = {}) const {
    const auto file = test::write_network(folder_.path(), net, sheet);
    return *label_by_network(image, file, read_label_sheet(file), {locked}, RunContext(), kept);
  }
  std::string refused(const Image& image, const OnnxNetwork& net, const std::string& sheet) const {
    return test::refused_field([&] { (void)labels(image, net, sheet); });
  }

 private slots:
  void SlicesAreLabelledVoxelByVoxelWhateverTheTiles();
  void BlocksAreLabelledVoxelByVoxel();
  void ANetworkThatSeesItsNeighboursLeavesNoSeam();
  void TheWindowClipsAndScales();
  void OtherAxesComeBackToTheirVoxels();
  void OtherSpacingIsInterpolated();
  void OneChannelHasAThreshold();
  void LesionsBecomeLabelsOfTheirOwn();
  void WhatTheNetworkDoesNotKnowStays();
  void LockedLabelsNeitherLoseNorGain();
  void WhatDoesNotFitNamesFileAndField();
  void ProgressRunsAndCancelEnds();
};

void LabelNetworkTest::SlicesAreLabelledVoxelByVoxelWhateverTheTiles() {
  const Image image = test::ct_of({37, 29, 5}, speckle);
  for (const char* tile : {"[16, 16]", "[8, 32]", "[64, 64]", "[1, 1]"}) {
    const std::string sheet =
        std::string(R"({"window_hu": [0, 200], "channels": ["background", "parenchyma"], "tile": )") + tile +
        "}";
    const NetworkLabels made = labels(image, bright_or_dark({1, 1, -1, -1}), sheet);
    for (int k = 0; k < 5; ++k)
      for (int j = 0; j < 29; ++j)
        for (int i = 0; i < 37; ++i)
          QCOMPARE(made.labels.voxels.at({i, j, k}),
                   speckle({i, j, k}) > 100 ? structure::kParenchyma : structure::kBackground);
    QCOMPARE(made.labels.infos.size(), std::size_t{1});
    QCOMPARE(made.labels.infos.front().code, structure::kParenchyma);
  }
}

void LabelNetworkTest::BlocksAreLabelledVoxelByVoxel() {
  const Image image = test::ct_of({21, 18, 11}, speckle);
  const NetworkLabels made = labels(image, bright_or_dark({1, 1, 4, 8, 16}), kBright);
  QVERIFY(made.tiles > 20);
  for (int k = 0; k < 11; ++k)
    for (int j = 0; j < 18; ++j)
      for (int i = 0; i < 21; ++i)
        QCOMPARE(made.labels.voxels.at({i, j, k}) == structure::kParenchyma, speckle({i, j, k}) > 100);
}

void LabelNetworkTest::ANetworkThatSeesItsNeighboursLeavesNoSeam() {
  // The mean of 3 x 3: beyond a tile there are zeros, so that even tissue looks darker at a tile's border
  // (2/3).
  const OnnxNetwork mean =
      OnnxNetwork({1, 1, 16, 16}).conv(1, 1, 3, std::vector<float>(9, 1.0F / 9.0F), {0.0F});
  const Image even = test::ct_of({48, 48, 1}, [](const Eigen::Vector3i&) { return 120; });
  // 120 of 200 is 0.6; at a border 0.4.
  const auto lost = [&](const char* overlap) {
    const std::string sheet =
        std::string(R"({"window_hu": [0, 200], "channels": ["parenchyma"], "threshold": 0.55, "overlap": )") +
        overlap + "}";
    const LabelMap map = labels(even, mean, sheet).labels;
    int count = 0;
    for (int j = 1; j < 47; ++j)
      for (int i = 1; i < 47; ++i) count += map.voxels.at({i, j, 0}) == structure::kBackground;
    return count;
  };
  QVERIFY(lost("0") > 100);  // with tiles side by side they would show
  QCOMPARE(lost("0.5"), 0);
}

void LabelNetworkTest::TheWindowClipsAndScales() {
  // Below the mean by two standard deviations, at the mean, far above the window.
  const Image image = test::ct_of({3, 1, 1}, [](const Eigen::Vector3i& v) {
    return v.x() == 0 ? 10 : v.x() == 1 ? 50 : 900;
  });
  const OnnxNetwork same = OnnxNetwork({1, 1, 1, 3}).conv(1, 1, 1, {1.0F}, {0.0F});
  const auto count = [&](const std::string& threshold) {
    return labels(
               image, same,
               R"({"window_hu": [-100, 100], "mean_hu": 50, "sd_hu": 20, "channels": ["parenchyma"], "threshold": )" +
                   threshold + "}")
        .labels.voxels.histogram();
  };
  QCOMPARE(count("-2.1")[1], 3L);
  QCOMPARE(count("-1.9")[1], 2L);
  QCOMPARE(count("2.4")[1], 1L);  // 100 HU is 2.5
  QVERIFY(count("2.6").size() < 2 || count("2.6")[1] == 0);
}

void LabelNetworkTest::OtherAxesComeBackToTheirVoxels() {
  Image image = test::ct_of({9, 7, 5}, speckle);
  image.grid.direction.col(0) = -Eigen::Vector3d::UnitZ();
  image.grid.direction.col(1) = Eigen::Vector3d::UnitX();
  image.grid.direction.col(2) = -Eigen::Vector3d::UnitY();
  for (const char* axes : {"SPL", "RAI", "PSR"}) {
    const std::string sheet =
        std::string(
            R"({"window_hu": [0, 200], "channels": ["background", "parenchyma"], "tile": [4, 4], "axes": ")") +
        axes + "\"}";
    const LabelMap map = labels(image, bright_or_dark({1, 1, -1, -1}), sheet).labels;
    for (int k = 0; k < 5; ++k)
      for (int j = 0; j < 7; ++j)
        for (int i = 0; i < 9; ++i)
          QCOMPARE(map.voxels.at({i, j, k}) == structure::kParenchyma, speckle({i, j, k}) > 100);
  }
}

void LabelNetworkTest::OtherSpacingIsInterpolated() {
  // A ramp along x crosses the threshold between voxels 19 and 20, whatever the network's voxels are.
  Image image = test::ct_of({40, 12, 6}, [](const Eigen::Vector3i& v) { return 4 * v.x() + 22; });
  image.grid.spacing_mm = {0.8, 0.8, 3.0};
  for (const char* spacing : {"[1.6, 1.6]", "[0.5, 0.5]", "[1.5, 2, 2]", "[5, 0.9, 1.1]"}) {
    const std::string sheet =
        std::string(
            R"({"window_hu": [0, 200], "channels": ["background", "parenchyma"], "tile": [8, 8], "spacing_mm": )") +
        spacing + "}";
    const LabelMap map = labels(image, bright_or_dark({1, 1, -1, -1}), sheet).labels;
    for (int k = 0; k < 6; ++k)
      for (int j = 0; j < 12; ++j)
        for (int i = 0; i < 40; ++i) QCOMPARE(map.voxels.at({i, j, k}) == structure::kParenchyma, i >= 20);
  }
}

void LabelNetworkTest::OneChannelHasAThreshold() {
  const Image image = test::ct_of({20, 20, 2}, speckle);
  const OnnxNetwork net = OnnxNetwork({1, 1, 16, 16}).conv(1, 1, 1, {20.0F}, {-10.0F}).sigmoid();
  const LabelMap map =
      labels(image, net, R"({"window_hu": [0, 200], "channels": ["vena_cava"], "threshold": 0.5})").labels;
  for (int j = 0; j < 20; ++j)
    for (int i = 0; i < 20; ++i)
      QCOMPARE(map.voxels.at({i, j, 1}) == structure::kVenaCava, speckle({i, j, 1}) > 100);
}

void LabelNetworkTest::LesionsBecomeLabelsOfTheirOwn() {
  // A large lesion, a small one, and a speck.
  const Image image = test::ct_of({40, 20, 10}, [](const Eigen::Vector3i& v) {
    const bool large = v.x() < 6 && v.y() < 6 && v.z() < 6,
               small = v.x() >= 30 && v.x() < 34 && v.y() < 4 && v.z() < 4;
    return large || small || v == Eigen::Vector3i(20, 15, 5) ? 150 : 40;
  });
  const char* sheet = R"({"window_hu": [0, 200], "channels": ["parenchyma", "lesions"], "threshold": 0.5})";
  const NetworkLabels made = labels(image, bright_or_dark({1, 1, 16, 16}), sheet);
  QCOMPARE(made.labels.voxels.at({2, 2, 2}), structure::kFirstLesion);
  QCOMPARE(made.labels.voxels.at({31, 2, 2}), static_cast<Label>(structure::kFirstLesion + 1));
  QCOMPARE(made.labels.voxels.at({20, 15, 5}), structure::kParenchyma);
  QVERIFY(!made.notes.empty());
  QCOMPARE(made.notes.back(),
           std::string("network.small_lesions 1"));  // after what the phantom lacks of a CT
  // A number that is locked is another lesion's.
  LabelMap kept;
  kept.voxels = LabelVolume(image.grid);
  kept.voxels.set({39, 19, 9}, structure::kFirstLesion);
  const NetworkLabels beside =
      labels(image, bright_or_dark({1, 1, 16, 16}), sheet, &kept, {structure::kFirstLesion});
  QCOMPARE(beside.labels.voxels.at({39, 19, 9}), structure::kFirstLesion);
  QCOMPARE(beside.labels.voxels.at({2, 2, 2}), static_cast<Label>(structure::kFirstLesion + 1));
  // A speck is no lesion, and no liver where that is locked.
  const NetworkLabels closed =
      labels(image, bright_or_dark({1, 1, 16, 16}), sheet, &kept, {structure::kParenchyma});
  QCOMPARE(closed.labels.voxels.at({20, 15, 5}), structure::kBackground);
  QCOMPARE(closed.labels.voxels.at({2, 2, 2}), structure::kFirstLesion);
}

void LabelNetworkTest::WhatTheNetworkDoesNotKnowStays() {
  const Image image = test::ct_of({20, 20, 4}, speckle);
  LabelMap kept;
  kept.voxels = LabelVolume(image.grid);
  kept.voxels.set({3, 3, 1}, structure::kGallbladder);
  kept.voxels.set({4, 3, 1}, structure::kParenchyma);
  const LabelMap map = labels(image, bright_or_dark({1, 1, 16, 16}), kBright, &kept).labels;
  QCOMPARE(map.voxels.at({3, 3, 1}), structure::kGallbladder);
  QCOMPARE(map.voxels.at({4, 3, 1}) == structure::kParenchyma, speckle({4, 3, 1}) > 100);
}

void LabelNetworkTest::LockedLabelsNeitherLoseNorGain() {
  const Image image = test::ct_of({20, 20, 4}, speckle);
  LabelMap kept;
  kept.voxels = LabelVolume(image.grid);
  for (int i = 0; i < 10; ++i) kept.voxels.set({i, 3, 1}, structure::kParenchyma);
  const LabelMap map =
      labels(image, bright_or_dark({1, 1, 16, 16}), kBright, &kept, {structure::kParenchyma}).labels;
  QVERIFY(map.voxels == kept.voxels);
}

void LabelNetworkTest::WhatDoesNotFitNamesFileAndField() {
  const Image image = test::ct_of({20, 20, 4}, speckle);
  const auto tile = [](const char* size) {
    return std::string(R"({"window_hu": [0, 200], "channels": ["background", "parenchyma"], "tile": )") +
           size + "}";
  };
  QCOMPARE(refused(image, bright_or_dark({1, 1, 16, 16}), tile("[8, 8]")), std::string("tile"));
  QCOMPARE(refused(image, bright_or_dark({1, 1, 16, 16}), tile("[1, 16, 16]")), std::string("tile"));
  QCOMPARE(refused(image, bright_or_dark({1, 1, -1, -1}), kBright), std::string("tile"));
  QCOMPARE(refused(image, bright_or_dark({1, 1, -1, -1, -1}), tile("[4000, 4000, 4000]")),
           std::string("tile"));
  QCOMPARE(
      refused(image, OnnxNetwork({1, 3, 16, 16}).conv(2, 3, 1, std::vector<float>(6, 1.0F), {0.0F, 0.0F}),
              kBright),
      std::string("input"));
  QCOMPARE(refused(image, OnnxNetwork({1, 1, 16}).sigmoid(), kBright), std::string("input"));
  QCOMPARE(refused(image, bright_or_dark({1, 1, 16, 16}),
                   R"({"window_hu": [0, 200], "channels": ["background", "parenchyma", "vena_cava"]})"),
           std::string("output"));
  QCOMPARE(
      refused(
          image, bright_or_dark({1, 1, -1, -1}),
          R"({"window_hu": [0, 200], "channels": ["background", "parenchyma"], "tile": [8, 8], "spacing_mm": [0.05, 0.05]})"),
      std::string("none"));
  Image magnetic = image;
  magnetic.modality = Modality::mr;
  QCOMPARE(refused(magnetic, bright_or_dark({1, 1, 16, 16}), kBright), std::string("modality"));
}

void LabelNetworkTest::ProgressRunsAndCancelEnds() {
  const Image image = test::ct_of({64, 64, 4}, speckle);
  const auto file = test::write_network(folder_.path(), bright_or_dark({1, 1, 16, 16}), kBright);
  const auto flag = std::make_shared<CancelFlag>();
  std::vector<double> told;
  const RunContext context(
      [&](double fraction, std::string_view) {
        told.push_back(fraction);
        if (told.size() == 12) flag->request();
      },
      flag, 1);
  QVERIFY(!label_by_network(image, file, read_label_sheet(file), {}, context));
  QVERIFY(std::is_sorted(told.begin(), told.end()) && told.size() < 16 && told.back() < 0.2);
}

QTEST_GUILESS_MAIN(LabelNetworkTest)
#include "label_network_test.moc"
