// SPDX-License-Identifier: GPL-3.0-or-later
// What the scale of a CT's values hides or makes doubtful is told beside the liver that was found.
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
  void ClippedValuesAreToldToHideMetal();
  void ALostInterceptIsToldBeforeWhatFollowsFromIt();
};

/// A CT whose values end at 1023 HU shows metal as it shows bone.
void ScaleTest::ClippedValuesAreToldToHideMetal() {
  struct Ball {
    std::int16_t hu;
    double radius;
    const char* told;
  };
  // Clipped metal beside the liver; a single voxel; enhanced vessels are no bone.
  for (const Ball& ball : {Ball{1023, 6.0, "image.clipped 1023 "}, Ball{1023, 1.0, ""}, Ball{250, 6.0, ""}}) {
    Image image = phantom();
    auto voxels = *image.voxels;
    for (std::int16_t& value : voxels) value = std::min(value, ball.hu);
    std::size_t at = 0;
    for (int k = 0; k < image.grid.size.z(); ++k)
      for (int j = 0; j < image.grid.size.y(); ++j)
        for (int i = 0; i < image.grid.size.x(); ++i, ++at)
          if ((Eigen::Vector3d(i, j, k).cwiseProduct(image.grid.spacing_mm) - Eigen::Vector3d(8, 8, 60))
                  .norm() < ball.radius)
            voxels[at] = ball.hu;
    image.voxels = std::make_shared<const std::vector<std::int16_t>>(std::move(voxels));
    std::string told;
    const auto notes = segment(image, clicks(image), {}, RunContext())->report.notes;
    for (const std::string& note : notes)
      if (note.starts_with("image.clipped") || note.starts_with("image.metal")) told += note;
    const std::string wanted = ball.told;
    QVERIFY2(wanted.empty() ? told.empty() : told.starts_with(wanted), told.c_str());
  }
}

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
