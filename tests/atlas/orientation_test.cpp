// SPDX-License-Identifier: GPL-3.0-or-later
// A liver that is mirrored or upside down is told by its shape alone, whichever axes are turned round; one
// that lies as livers lie is not, and what nothing can be said of neither.
#include "glisson/atlas/orientation.h"

#include <QTest>
#include <algorithm>

#include "glisson/core/error.h"
#include "known_livers.h"

using namespace glisson;
using namespace glisson::atlas;

namespace {

using Doubts = std::vector<std::string>;

/// Livers of the population that the atlas has not.
constexpr std::array<std::uint64_t, 3> kSeeds = {4711, 911, 31337};

const Atlas& known() {
  static const Atlas kAtlas = test::built_in();
  return kAtlas;
}

Doubts doubts_of(const TriangleMesh& liver) { return *orientation_doubts(known(), liver, RunContext()); }

/// @param axes that are turned round: of x, y and z the bits 1, 2 and 4.
TriangleMesh image_of(TriangleMesh liver, unsigned axes) {
  for (int axis = 0; axis < 3; ++axis) {
    if ((axes >> axis & 1U) == 0) continue;
    liver.vertices.col(axis) *= -1.0;
    liver.triangles.col(1).swap(liver.triangles.col(2));
  }
  return liver;
}

}  // namespace

class OrientationTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    for (const std::uint64_t seed : kSeeds) livers_.push_back(test::synthetic_liver(seed, 4.0).surface);
  }
  void whatLiesRightIsNotDoubted() {
    for (const TriangleMesh& liver : livers_) QCOMPARE(doubts_of(liver), Doubts());
  }
  void whatIsExchangedIsTold_data() {
    QTest::addColumn<unsigned>("axes");
    QTest::addColumn<QString>("told");
    QTest::newRow("left and right") << 1U << "left_right";
    QTest::newRow("front and back") << 2U << "front_back";
    QTest::newRow("RAS for LPS") << 3U << "left_right+front_back";
    QTest::newRow("head and feet") << 4U << "head_feet";
    QTest::newRow("on the other side, upside down") << 5U << "left_right+head_feet";
    QTest::newRow("on the belly, upside down") << 6U << "front_back+head_feet";
    QTest::newRow("all") << 7U << "left_right+front_back+head_feet";
  }
  void whatIsExchangedIsTold() {
    QFETCH(const unsigned, axes);
    QFETCH(const QString, told);
    const TriangleMesh& liver = livers_[axes % livers_.size()];
    QCOMPARE(doubts_of(image_of(liver, axes)), Doubts{"liver.axes_exchanged " + told.toStdString()});
  }
  /// The images of an image are the images of the liver in another order.
  void imagesOfImagesAreTheSame() {
    const ImageMisfits own = *image_misfits(known(), livers_[0], RunContext());
    const ImageMisfits of_image = *image_misfits(known(), image_of(livers_[0], 5), RunContext());
    for (unsigned axes = 0; axes < 8; ++axes) QVERIFY(std::abs(of_image[axes ^ 5U] / own[axes] - 1.0) < 0.02);
  }
  /// Inner surfaces, specks and normals that point inwards do not matter.
  void normalsAndSpecksDoNotMatter() {
    TriangleMesh turned = livers_[0];
    turned.triangles.col(1).swap(turned.triangles.col(2));
    QCOMPARE(doubts_of(turned), Doubts());
    QCOMPARE(doubts_of(image_of(turned, 1)), Doubts{"liver.axes_exchanged left_right"});
  }
  void nothingIsSaidOfWhatIsNoWholeLiver() {
    QCOMPARE(doubts_of({}), Doubts());
    TriangleMesh open = image_of(livers_[0], 1);
    open.triangles.conservativeResize(open.triangle_count() - 1, 3);
    QCOMPARE(doubts_of(open), Doubts());
    TriangleMesh in_other_units = image_of(livers_[0], 1);
    in_other_units.vertices *= 1e3;
    QCOMPARE(doubts_of(in_other_units), Doubts());
    QVERIFY_THROWS_EXCEPTION(PreconditionError, image_misfits(known(), {}, RunContext()));
  }
  void cancelEndsIt() {
    auto flag = std::make_shared<CancelFlag>();
    flag->request();
    QVERIFY(!orientation_doubts(known(), livers_[0], RunContext({}, flag, 1)));
  }

 private:
  std::vector<TriangleMesh> livers_;
};

QTEST_APPLESS_MAIN(OrientationTest)
#include "orientation_test.moc"
