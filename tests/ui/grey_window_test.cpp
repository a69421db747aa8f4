// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "glisson/core/error.h"
#include "glisson/ui/common/grey_window.h"
#include "glisson/ui/common/view_state.h"

namespace glisson {

using ui::WindowPreset;

namespace {

/// Greys 0 to 999, ten voxels of each, and one hot pixel.
std::shared_ptr<Image> ramp(Modality modality) {
  auto image = std::make_shared<Image>();
  image->grid.size = {100, 100, 1};
  image->modality = modality;
  auto voxels = std::make_shared<std::vector<std::int16_t>>();
  for (int n = 0; n < 10000; ++n) voxels->push_back(static_cast<std::int16_t>(n / 10));
  voxels->back() = 32767;
  image->voxels = voxels;
  return image;
}

}  // namespace

class GreyWindowTest : public QObject {
  Q_OBJECT
 private slots:
  void WholeRangeLeavesOutAHotPixel();
  void WholeRangeOfOneGreyIsAWindow();
  void WholeRangeOfNothingIsRefused();
  void OwnAndWholeAreNotOfHounsfieldUnits();
  void ThePortalVeinDiffersFromTheLiverInTheWindowsOfBoth();
  void AnMriOpensWithItsWholeRange();
  void HounsfieldWindowsDoNotApplyToAnMri();
  void AnMrisOwnWindowIsNotTheCts();
};

void GreyWindowTest::WholeRangeLeavesOutAHotPixel() {
  const ui::GreyWindow range = ui::whole_range(*ramp(Modality::mr));
  QCOMPARE(range.level, 499.5);
  QVERIFY(range.width > 990.0 && range.width < 1000.0);
}

void GreyWindowTest::WholeRangeOfOneGreyIsAWindow() {
  Image image = *ramp(Modality::ct);
  image.voxels = std::make_shared<std::vector<std::int16_t>>(10000, std::int16_t{-7});
  QCOMPARE(ui::whole_range(image), (ui::GreyWindow{-7.0, 1.0}));
}

void GreyWindowTest::WholeRangeOfNothingIsRefused() {
  QVERIFY_THROWS_EXCEPTION(PreconditionError, ui::whole_range(Image()));
}

void GreyWindowTest::OwnAndWholeAreNotOfHounsfieldUnits() {
  for (const WindowPreset preset : ui::kWindowPresets) {
    if (ui::is_hounsfield(preset))
      QVERIFY(ui::hounsfield_window(preset).width > 0.0);
    else
      QVERIFY_THROWS_EXCEPTION(PreconditionError, ui::hounsfield_window(preset));
  }
}

void GreyWindowTest::ThePortalVeinDiffersFromTheLiverInTheWindowsOfBoth() {
  const auto grey = [](const ui::GreyWindow& window, double hu) {
    return std::clamp((hu - window.level) / window.width + 0.5, 0.0, 1.0);
  };
  const ui::GreyWindow plain = ui::hounsfield_window(WindowPreset::abdomen);
  for (const WindowPreset preset : {WindowPreset::liver, WindowPreset::vessels}) {
    const ui::GreyWindow window = ui::hounsfield_window(preset);
    QVERIFY(grey(window, 170.0) - grey(window, 110.0) > grey(plain, 170.0) - grey(plain, 110.0));
    QVERIFY(grey(window, 110.0) > 0.2 && grey(window, 170.0) < 0.95);  // neither is lost in white or black
  }
}

void GreyWindowTest::AnMriOpensWithItsWholeRange() {
  ui::ViewState state;
  state.set_volume(ramp(Modality::mr), nullptr);
  QCOMPARE(state.preset(), WindowPreset::whole);
  QCOMPARE(state.style().level, 499.5);
  state.set_volume(ramp(Modality::ct), nullptr);
  QCOMPARE(state.preset(), WindowPreset::abdomen);
  QCOMPARE(state.style().level, 80.0);
}

void GreyWindowTest::HounsfieldWindowsDoNotApplyToAnMri() {
  ui::ViewState state;
  state.set_volume(ramp(Modality::other), nullptr);
  const double before = state.style().width;
  state.set_preset(WindowPreset::lung);
  QCOMPARE(state.style().width, before);
  QCOMPARE(state.preset(), WindowPreset::whole);
  QVERIFY(!state.applies(WindowPreset::liver) && state.applies(WindowPreset::whole));
}

void GreyWindowTest::AnMrisOwnWindowIsNotTheCts() {
  ui::ViewState state;
  state.set_volume(ramp(Modality::ct), nullptr);
  state.set_window(40.0, 90.0);
  QCOMPARE(state.preset(), WindowPreset::own);
  state.set_volume(ramp(Modality::mr), nullptr);
  state.set_window(700.0, 300.0);
  state.set_preset(WindowPreset::whole);
  state.set_preset(WindowPreset::own);
  QCOMPARE(state.style().level, 700.0);
  QCOMPARE(state.own_window(), (ui::GreyWindow{40.0, 90.0}));  // what is kept for the next CT
  state.set_volume(ramp(Modality::ct), nullptr);
  state.set_preset(WindowPreset::own);
  QCOMPARE(state.style().level, 40.0);
}

}  // namespace glisson

QTEST_APPLESS_MAIN(glisson::GreyWindowTest)
#include "grey_window_test.moc"
