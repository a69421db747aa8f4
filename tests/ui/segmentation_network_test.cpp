// SPDX-License-Identifier: GPL-3.0-or-later
// A person's own network in the window: chosen, run, and refused by a sentence.
#include <QLabel>
#include <QPushButton>

#include "glisson/engine/parts/offer.h"
#include "glisson/ui/segmentation/network_box.h"
#include "network_files.h"
#include "segmentation_window.h"

namespace glisson {

class SegmentationNetworkTest : public QObject, private SegmentationWindow {
  Q_OBJECT
 private slots:
  void initTestCase() { make_ct(); }
  void init() { show_window(); }
  void cleanup() { window_.reset(); }
  void TheChosenNetworkLabelsTheCt();
  void CorrectionsByHandWaitForADecision();
  void ABadNetworkIsToldAndChangesNothing();

 private:
  /// Liver, portal vein: all that is bright.
  void choose_network(const std::string& channels = R"(["background", "parenchyma"])") {
    const auto file =
        test::write_network(folder_->path(), test::bright_or_dark({1, 1, -1, -1}),
                            R"({"window_hu": [0, 100], "tile": [32, 32], "channels": )" + channels + "}");
    panel().findChild<ui::NetworkBox*>()->set_network(file);
  }
  ui::TaskButton* task() { return find<ui::TaskButton>("segment_by_network"); }
  void label() {
    QVERIFY(task()->button()->isEnabled());
    QTest::mouseClick(task()->button(), Qt::LeftButton);
    QVERIFY(settle());
  }
};

void SegmentationNetworkTest::TheChosenNetworkLabelsTheCt() {
  open_ct();
  QVERIFY(!task()->isVisibleTo(&panel()));  // nothing is chosen
  choose_network();
  QVERIFY(task()->isVisibleTo(&panel()));
  QVERIFY(find<QPushButton>("choose_network")->text().contains("net.onnx"));
  label();
  QVERIFY(window_->engine().state()[part::labels] != nullptr);
  QCOMPARE(at({0.0, 0.0, 0.02}), structure::kParenchyma);
  QCOMPARE(at({0.0, 0.06, 0.0}), structure::kBackground);
  QVERIFY(!window_->engine().state()[part::offer]);
  const QString pictures = qEnvironmentVariable("GLISSON_PICTURES");
  if (!pictures.isEmpty()) QVERIFY(window_->grab().save(pictures + QStringLiteral("/network.png")));
}

void SegmentationNetworkTest::CorrectionsByHandWaitForADecision() {
  correct_by_hand();
  choose_network();
  label();
  QVERIFY(window_->engine().state()[part::offer] != nullptr);
  QCOMPARE(at({0.0, -0.050, 0.0}), structure::kParenchyma);
  press("offer_take");
  QVERIFY(settle());
  QCOMPARE(at({0.0, -0.052, 0.0}), structure::kBackground);
}

void SegmentationNetworkTest::ABadNetworkIsToldAndChangesNothing() {
  open_ct();
  choose_network(R"(["background", "liver"])");
  label();
  QVERIFY(!window_->engine().state()[part::labels]);
  QString told;
  for (const QLabel* text : task()->findChildren<QLabel*>()) told += text->text();
  QVERIFY2(told.contains("net.json") && told.contains("channels"), qPrintable(told));
}

}  // namespace glisson

int main(int argc, char** argv) {
  return glisson::run_in_window<glisson::SegmentationNetworkTest>(argc, argv);
}
#include "segmentation_network_test.moc"
