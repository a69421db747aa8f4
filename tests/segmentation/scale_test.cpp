// SPDX-License-Identifier: GPL-3.0-or-later
// What the scale of a CT's values makes doubtful is told beside the liver that was found.
#include <QTest>
#include <algorithm>

#include "glisson/segmentation/segment.h"
#include "noisy_ct.h"
#include "points_at.h"

using namespace glisson;
using namespace glisson::segmentation;

namespace {

/// An ellipsoid of 110 HU in fat.
Image phantom() {
  VolumeGrid grid;
  grid.size = {64, 62, 56};
  grid.spacing_mm = {2.0, 2.0, 2.2};
  return test::noisy_ct(grid, 5, 12.0, [](const Eigen::Vector3d& p) {
    return (p - Eigen::Vector3d(62, 62, 60)).cwiseQuotient(Eigen::Vector3d(46, 40, 38)).norm() < 1.0 ? 110.0
                                                                                                     : -100.0;
  });
}

Seeds clicks(const Image& image) {
  Seeds seeds;
  seeds.liver = test::points_at(image, {{62, 75, 75}, {80, 62, 45}});
  return seeds;
}

}  // namespace

class ScaleTest : public QObject {
  Q_OBJECT
 private slots:
  void ALostInterceptIsToldBeforeWhatFollowsFromIt();
};

/// Without its intercept lung looks like liver: what is found there is told to be doubtful, first of all.
void ScaleTest::ALostInterceptIsToldBeforeWhatFollowsFromIt() {
  Image image = phantom();
  auto voxels = *image.voxels;
  const auto corner = voxels.size() / 100;
  std::fill_n(voxels.begin(), corner, std::int16_t{-1000});
  image.voxels = std::make_shared<const std::vector<std::int16_t>>(voxels);
  const auto whole = segment(image, clicks(image), {}, RunContext())->report.notes;
  QVERIFY(std::ranges::none_of(whole, [](const std::string& note) { return note.starts_with("image."); }));
  for (std::int16_t& value : voxels)
    if (value < 0) value = 1074;  // muscle and fat, as they were stored
  image.voxels = std::make_shared<const std::vector<std::int16_t>>(voxels);
  const auto notes = segment(image, clicks(image), {}, RunContext())->report.notes;
  QVERIFY(notes.size() >= 2);
  QCOMPARE(notes[0], std::string("image.no_air 0"));
  QCOMPARE(notes[1], std::string("image.shifted -1024"));
}

QTEST_APPLESS_MAIN(ScaleTest)
#include "scale_test.moc"
