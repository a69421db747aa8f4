// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces that are made beside the window: of this patient's labels and of nobody else's.
#include "glisson/ui/common/label_surface_source.h"

#include <QSignalSpy>
#include <QTest>

#include "glisson/patient/label_map.h"

namespace glisson {

class LabelSurfaceSourceTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void TheNewestLabelsAreShown();
  void WhatIsForgottenGoesAtOnceAndDoesNotComeBack();
  void NoLabelsHaveNoSurfaces();

 private:
  /// A block of one label.
  static std::shared_ptr<const LabelVolume> block_of(Label label) {
    VolumeGrid grid;
    grid.size = {40, 40, 40};
    auto labels = std::make_shared<LabelVolume>(grid);
    for (int k = 10; k < 30; ++k)
      for (int j = 10; j < 30; ++j)
        for (int i = 10; i < 30; ++i) labels->set({i, j, k}, label);
    return labels;
  }
  bool shows(Label label) const {
    const auto& blocks = source_->surfaces()->blocks();
    return std::any_of(blocks.begin(), blocks.end(),
                       [&](const auto& entry) { return entry.first.first == label; });
  }
  std::unique_ptr<ui::LabelSurfaceSource> source_;
};

void LabelSurfaceSourceTest::init() { source_ = std::make_unique<ui::LabelSurfaceSource>(); }

void LabelSurfaceSourceTest::TheNewestLabelsAreShown() {
  source_->set_labels(block_of(structure::kParenchyma));
  QVERIFY(source_->is_making());
  QTRY_VERIFY(!source_->is_making() && shows(structure::kParenchyma));
  source_->set_labels(block_of(structure::kPortalVein));
  QVERIFY(shows(structure::kParenchyma));  // until the new ones are there
  QTRY_VERIFY(!source_->is_making() && shows(structure::kPortalVein));
  QVERIFY(!shows(structure::kParenchyma));
}

void LabelSurfaceSourceTest::WhatIsForgottenGoesAtOnceAndDoesNotComeBack() {
  source_->set_labels(block_of(structure::kPortalVein));
  QTRY_VERIFY(shows(structure::kPortalVein));
  bool came_back = false;
  connect(source_.get(), &ui::LabelSurfaceSource::changed, this,
          [&] { came_back = came_back || shows(structure::kPortalVein) || shows(structure::kHepaticVeins); });
  source_->set_labels(block_of(structure::kHepaticVeins));  // still made when it is forgotten
  source_->forget();
  QVERIFY(source_->surfaces()->blocks().empty() && !source_->is_making());
  source_->set_labels(block_of(structure::kParenchyma));
  QTRY_VERIFY(!source_->is_making() && shows(structure::kParenchyma));
  QVERIFY(!came_back);
}

void LabelSurfaceSourceTest::NoLabelsHaveNoSurfaces() {
  const auto labels = block_of(structure::kPortalVein);
  source_->set_labels(labels);
  source_->set_labels(nullptr);
  QVERIFY(source_->surfaces()->blocks().empty() && !source_->is_making());
  QSignalSpy changed(source_.get(), &ui::LabelSurfaceSource::changed);
  QTest::qWait(50);
  QCOMPARE(changed.count(), 0);
  source_->set_labels(labels);
  QTRY_VERIFY(!source_->is_making() && shows(structure::kPortalVein));
}

}  // namespace glisson

QTEST_GUILESS_MAIN(glisson::LabelSurfaceSourceTest)
#include "label_surface_source_test.moc"
