// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/volume/plausibility.h"

#include <QTest>

#include "data_folder.h"
#include "glisson/core/error.h"
#include "glisson/volume/io.h"

using namespace glisson;

namespace {

/// A body of 60 HU in air, with noise that repeats in no slice: 20 x 20 x 20 voxels of 15 mm.
Image body() {
  Image image;
  image.grid.size = {20, 20, 20};
  image.grid.spacing_mm = {15, 15, 15};
  std::vector<std::int16_t> values;
  for (int n = 0; n < 8000; ++n) {
    const int x = n % 20 - 10, y = n / 20 % 20 - 10;
    values.push_back(static_cast<std::int16_t>((x * x + y * y < 80 ? 60 : -1000) + n * 7919 % 23));
  }
  image.voxels = std::make_shared<const std::vector<std::int16_t>>(values);
  return image;
}

template <class Change>
Image changed(Change change) {
  Image image = body();
  std::vector<std::int16_t> values = *image.voxels;
  change(image, values);
  image.voxels = std::make_shared<const std::vector<std::int16_t>>(std::move(values));
  return image;
}

using Values = std::vector<std::int16_t>;
using Doubts = std::vector<std::string>;

}  // namespace

class PlausibilityTest : public QObject {
  Q_OBJECT
 private slots:
  void ABodyInAirIsNotDoubted() { QCOMPARE(image_doubts(body()), Doubts()); }
  void SizesThatAreNoAbdomensAreTold();
  void SlicesThatWereLostAreTold();
  void NumbersThatAreNoHounsfieldUnitsAreTold();
  void ALostInterceptIsToldWithWhatSpeaksForIt();
  void ACroppedCtIsToldNoShift();
  void RealScansAreNotDoubted();
};

void PlausibilityTest::SizesThatAreNoAbdomensAreTold() {
  const auto sized = [](double mm) {
    return image_doubts(changed([&](Image& image, Values&) { image.grid.spacing_mm.setConstant(mm); }));
  };
  QCOMPARE(sized(1.0), Doubts{"image.small 20"});
  QCOMPARE(sized(75.0), Doubts{"image.large 1.5e+03"});
}

void PlausibilityTest::SlicesThatWereLostAreTold() {
  const Image empty = changed([](Image&, Values& v) { std::fill(v.begin() + 400, v.begin() + 1200, -1024); });
  QCOMPARE(image_doubts(empty), Doubts{"image.constant_slices 2 20"});
  const Image twice = changed([](Image&, Values& v) { std::copy_n(v.begin(), 400, v.begin() + 400); });
  QCOMPARE(image_doubts(twice), Doubts{"image.repeated_slices 1 20"});
}

void PlausibilityTest::NumbersThatAreNoHounsfieldUnitsAreTold() {
  const Image scaled = changed([](Image&, Values& v) {
    for (std::int16_t& value : v) value = static_cast<std::int16_t>(8 * value);
  });
  QCOMPARE(image_doubts(scaled), (Doubts{"image.no_tissue 0", "image.no_air 0"}));
  // A file that ended early and was filled up.
  const Image half = changed([](Image&, Values& v) {
    for (std::size_t n = 0; n < v.size(); n += 2) v[n] = 0;
  });
  QCOMPARE(image_doubts(half), Doubts{"image.zeros 50"});
  // Elsewhere zeros are the background, and no number has a meaning of its own.
  Image other = half;
  other.modality = Modality::mr;
  QCOMPARE(image_doubts(other), Doubts());
  QVERIFY_THROWS_EXCEPTION(PreconditionError, image_doubts(Image()));
}

void PlausibilityTest::ALostInterceptIsToldWithWhatSpeaksForIt() {
  const auto moved_by = [](int hu) {
    return changed([hu](Image&, Values& v) {
      for (std::int16_t& value : v) value = static_cast<std::int16_t>(value + hu);
      // What lies outside of the scanner's view is no air, whatever number stands for it.
      for (std::size_t n = 0; n < v.size(); n += 97) v[n] = -3024;
    });
  };
  QCOMPARE(scale_doubts(moved_by(0)), Doubts());
  for (const int lost : {1024, 1000})
    QCOMPARE(scale_doubts(moved_by(lost)), (Doubts{"image.no_air 0", "image.shifted -1024"}));
  QCOMPARE(scale_doubts(moved_by(-1024)), (Doubts{"image.no_tissue 0", "image.shifted 1024"}));
  QCOMPARE(image_doubts(moved_by(1024)), scale_doubts(moved_by(1024)));
  Image mr = moved_by(1024);
  mr.modality = Modality::mr;
  QCOMPARE(scale_doubts(mr), Doubts());
}

void PlausibilityTest::ACroppedCtIsToldNoShift() {
  // Liver, fat and bone, without a voxel of air.
  const Image cropped = changed([](Image&, Values& v) {
    for (std::size_t n = 0; n < v.size(); ++n)
      if (v[n] < -300) v[n] = static_cast<std::int16_t>(n % 11 == 0 ? 1200 : n % 3 == 0 ? -100 : 110);
  });
  QCOMPARE(scale_doubts(cropped), Doubts{"image.no_air 0"});
}

void PlausibilityTest::RealScansAreNotDoubted() {
  const auto folder = test::data_folder();
  const auto archive = folder / "ct_ircad1/PATIENT_DICOM.tar.gz";
  if (folder.empty() || !std::filesystem::exists(archive))
    QSKIP("no real CT (see tests/support/data_folder.h)");
  QCOMPARE(image_doubts(read_image(archive, RunContext()).value()), Doubts());
}

QTEST_APPLESS_MAIN(PlausibilityTest)
#include "plausibility_test.moc"
