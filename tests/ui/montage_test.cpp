// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/scene/montage.h"

#include <QTest>

#include "glisson/core/error.h"
#include "glisson/ui/scene/headless_gui.h"
#include "glisson/ui/scene/picture_image.h"

using namespace glisson;

namespace {

Picture plain(int width, int height, std::uint8_t blue, std::uint8_t green, std::uint8_t red) {
  auto bytes = std::make_shared<std::vector<std::uint8_t>>();
  for (int i = 0; i < width * height; ++i) bytes->insert(bytes->end(), {blue, green, red});
  return {width, height, 3, bytes};
}

std::array<int, 3> at(const Picture& picture, int u, int v) {
  const auto i = static_cast<std::size_t>(3 * (v * picture.width + u));
  return {(*picture.bytes)[i], (*picture.bytes)[i + 1], (*picture.bytes)[i + 2]};
}

}  // namespace

class MontageTest : public QObject {
  Q_OBJECT
 private slots:
  void EveryPictureStandsInItsPlaceWithItsName();
  void UnlikePicturesAreRefused();
  void TheScreensPictureIsTheSamePicture();
  void NothingIsMadeOfNothing();
};

void MontageTest::EveryPictureStandsInItsPlaceWithItsName() {
  const Picture sheet = scene::montage({{"one", plain(320, 180, 200, 0, 0)},
                                        {"two", plain(320, 180, 0, 200, 0)},
                                        {"three", plain(320, 180, 0, 0, 200)}},
                                       2, 0.5);
  QVERIFY(sheet.width >= 320 && sheet.width < 340 && sheet.height >= 180 && sheet.height < 200);
  QVERIFY((at(sheet, 5, 80) == std::array{200, 0, 0}));
  QVERIFY((at(sheet, sheet.width - 5, 80) == std::array{0, 200, 0}));
  QVERIFY((at(sheet, 5, sheet.height - 5) == std::array{0, 0, 200}));
  QVERIFY((at(sheet, sheet.width - 5, sheet.height - 5) == std::array{0, 0, 0}));
  int written = 0;  // in the first one's upper half
  for (int v = 0; v < 45; ++v)
    for (int u = 0; u < 160; ++u) written += at(sheet, u, v) != std::array{200, 0, 0};
  QVERIFY(written > 50);
}

void MontageTest::UnlikePicturesAreRefused() {
  const Picture one = plain(32, 18, 1, 2, 3), other = plain(32, 20, 1, 2, 3);
  QVERIFY_THROWS_EXCEPTION(PreconditionError, scene::montage({}, 2, 1.0));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, scene::montage({{"a", one}, {"b", other}}, 2, 1.0));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, scene::montage({{"a", one}}, 0, 1.0));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, scene::montage({{"a", one}}, 1, 1.5));
}

void MontageTest::TheScreensPictureIsTheSamePicture() {
  const Picture picture = plain(64, 36, 10, 20, 230);
  for (const QSize size : {QSize(64, 36), QSize(200, 112), QSize(20, 11)}) {
    const QImage image = scene::screen_image(picture, size);
    QVERIFY(image.size() == size && image.format() == QImage::Format_RGB32);
    QVERIFY(image.pixelColor(size.width() / 2, size.height() / 2) == QColor(230, 20, 10));
  }
  Picture grey = picture;
  grey.width *= 3;
  grey.channels = 1;
  QVERIFY(scene::screen_image(grey, {96, 18}).format() == QImage::Format_RGB32);
}

void MontageTest::NothingIsMadeOfNothing() {
  QVERIFY(scene::screen_image({}, {10, 10}).isNull());
  QVERIFY(scene::screen_image(plain(8, 8, 1, 1, 1), {}).isNull());
}

int main(int argc, char** argv) {
  const scene::HeadlessGui gui;
  MontageTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "montage_test.moc"
