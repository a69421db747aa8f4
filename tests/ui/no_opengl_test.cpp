// SPDX-License-Identifier: GPL-3.0-or-later
// A computer without OpenGL: a view in three dimensions says so, and the window goes on.
#include <QApplication>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>

#include "glisson/ui/common/render_view.h"

namespace glisson {

class NoOpenGlTest : public QObject {
  Q_OBJECT
 private slots:
  void TheViewSaysThatItHasNone();
};

void NoOpenGlTest::TheViewSaysThatItHasNone() {
  ui::RenderView view;
  view.resize(300, 200);
  view.show();
  QSignalSpy drawn(&view, &ui::RenderView::drawn);
  const auto says_so = [&view] {
    const auto labels = view.findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
      return label->isVisible() && label->text().contains(QStringLiteral("OpenGL 3.2"));
    });
  };
  QTRY_VERIFY(says_so());
  // Whoever has nothing to show here takes back a hint of its own, not this one.
  view.set_hint({});
  view.update();
  QTest::qWait(20);
  QVERIFY(says_so());
  QVERIFY(view.picture().isNull());
  QCOMPARE(drawn.size(), 0);
}

}  // namespace glisson

int main(int argc, char** argv) {
  qunsetenv("DISPLAY");
  qunsetenv("WAYLAND_DISPLAY");
  qputenv("QT_QPA_PLATFORM", "offscreen");
  glisson::ui::RenderView::prepare_surface_format();
  QApplication application(argc, argv);
  glisson::NoOpenGlTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "no_opengl_test.moc"
