// SPDX-License-Identifier: GPL-3.0-or-later
// No control is a dummy: whatever can be pressed in the window and its dialogs is heard by something.
#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include "fake_operation.h"
#include "glisson/core/files.h"
#include "glisson/ui/shell/main_window.h"
#include "glisson/ui/stereo/calibration_dialog.h"
#include "glisson/ui/stereo/source_dialog.h"
#include "run_in_window.h"

namespace glisson {

namespace {

/// How many hear a signal of any object: Qt tells an object of its own kind only.
class Listeners : public QObject {
 public:
  static int count(const QObject& object, const char* signal) {
    return (object.*(&Listeners::receivers))(signal);
  }
};

template <class Control>
bool is_heard(const Control& control, std::initializer_list<const char*> signals_of_it) {
  return std::any_of(signals_of_it.begin(), signals_of_it.end(),
                     [&](const char* signal) { return Listeners::count(control, signal) > 0; });
}

/// Buttons that Qt made as parts of its own widgets it hears itself.
bool is_inside_another_control(const QWidget& button) {
  for (const QWidget* above = button.parentWidget(); above != nullptr; above = above->parentWidget())
    if (qobject_cast<const QAbstractSpinBox*>(above) || qobject_cast<const QLineEdit*>(above) ||
        qobject_cast<const QDialogButtonBox*>(above) || qobject_cast<const QMenuBar*>(above))
      return true;
  return false;
}

/// Names of what is pressed in vain.
QStringList dead_controls(const QWidget& window, int& looked_at) {
  QStringList dead;
  for (const QAbstractButton* button : window.findChildren<QAbstractButton*>()) {
    const auto* tool = qobject_cast<const QToolButton*>(button);
    const auto* push = qobject_cast<const QPushButton*>(button);
    if ((tool == nullptr && push == nullptr) || is_inside_another_control(*button)) continue;
    ++looked_at;
    const bool opens_menu = tool ? tool->menu() != nullptr || tool->defaultAction() : push->menu() != nullptr;
    if (!opens_menu && button->group() == nullptr &&
        !is_heard(*button, {SIGNAL(clicked(bool)), SIGNAL(toggled(bool)), SIGNAL(pressed())}))
      dead << button->objectName() + QLatin1Char(' ') + button->text();
  }
  for (const QAction* action : window.findChildren<QAction*>()) {
    if (action->isSeparator() || action->menu() != nullptr || action->text().isEmpty()) continue;
    if (const auto* edit = qobject_cast<const QLineEdit*>(action->parent()); edit != nullptr) continue;
    ++looked_at;
    if (!is_heard(*action, {SIGNAL(triggered(bool)), SIGNAL(toggled(bool))})) dead << action->text();
  }
  return dead;
}

}  // namespace

class ControlsTest : public QObject {
  Q_OBJECT
 private slots:
  void ADummyIsFound();
  void NothingInTheWindowIsADummy();
  void NothingInTheDialogsIsADummy();
  void ACommaIsADecimalPoint();
  void TheFolderOfBoardsIsChosenByAButton();
};

void ControlsTest::ADummyIsFound() {
  QWidget window;
  auto* live = new QPushButton(QStringLiteral("Live"), &window);
  connect(live, &QPushButton::clicked, &window, &QWidget::hide);
  new QPushButton(QStringLiteral("Dummy"), &window);
  int looked_at = 0;
  QCOMPARE(dead_controls(window, looked_at), QStringList{QStringLiteral(" Dummy")});
  QCOMPARE(looked_at, 2);
}

void ControlsTest::NothingInTheWindowIsADummy() {
  FakeOperation operation;
  make_box_operation(operation);
  ui::MainWindow window(operation.options());
  int looked_at = 0;
  const QStringList dead = dead_controls(window, looked_at);
  QVERIFY2(dead.isEmpty(), qPrintable(dead.join(QStringLiteral(", "))));
  QVERIFY(looked_at > 60);
}

void ControlsTest::NothingInTheDialogsIsADummy() {
  ui::EngineBridge engine;
  const ui::CalibrationDialog calibration(engine);
  const ui::SourceDialog source;
  for (const QWidget* dialog : std::initializer_list<const QWidget*>{&calibration, &source}) {
    int looked_at = 0;
    const QStringList dead = dead_controls(*dialog, looked_at);
    QVERIFY2(dead.isEmpty(), qPrintable(dead.join(QStringLiteral(", "))));
    QVERIFY(looked_at > 1);
  }
}

/// As hands write it in German and French: 2,5 was 25.
void ControlsTest::ACommaIsADecimalPoint() {
  FakeOperation operation;
  make_box_operation(operation);
  ui::MainWindow window(operation.options());
  ui::CalibrationDialog calibration(window.engine());
  const auto typed = [](QDoubleSpinBox& number, const QString& text) {
    auto* line = number.findChild<QLineEdit*>();
    line->selectAll();
    QTest::keyClicks(line, text);
    const double told = number.valueFromText(line->text());  // before its panel makes something of it
    number.interpretText();
    return told;
  };
  int looked_at = 0;
  for (const QWidget* place : std::initializer_list<const QWidget*>{&window, &calibration})
    for (QDoubleSpinBox* number : place->findChildren<QDoubleSpinBox*>()) {
      if (!number->isEnabled() || number->isHidden() || number->decimals() == 0) continue;
      const int whole = static_cast<int>(number->minimum()) + 1;
      const double wanted = whole + 0.5;
      if (wanted > number->maximum()) continue;
      ++looked_at;
      const double told = typed(*number, QStringLiteral("%1,5").arg(whole));
      QVERIFY2(told == wanted, qPrintable(QStringLiteral("%1: %2").arg(number->objectName()).arg(told)));
    }
  QVERIFY(looked_at > 5);
  auto* square = calibration.findChild<QDoubleSpinBox*>(QStringLiteral("board_square"));
  QCOMPARE(typed(*square, QStringLiteral("2,5")), 2.5);
  QCOMPARE(calibration.command().search.board.square, 2.5e-3);
  QCOMPARE(square->text(), QStringLiteral("2.500 mm"));
}

void ControlsTest::TheFolderOfBoardsIsChosenByAButton() {
  const TemporaryFolder folder;
  ui::EngineBridge engine;
  ui::CalibrationDialog dialog(engine);
  dialog.open();
  QTimer answer;
  bool asked = false;
  connect(&answer, &QTimer::timeout, this, [&] {
    auto* files = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    if (files == nullptr) return;
    asked = true;
    answer.stop();
    files->findChild<QLineEdit*>()->setText(QString::fromStdString(folder.path().string()));
    files->findChild<QDialogButtonBox*>()->buttons().constFirst()->click();
  });
  answer.start(20);
  QTest::mouseClick(dialog.findChild<QPushButton*>(QStringLiteral("choose_boards")), Qt::LeftButton);
  QVERIFY(asked);
  QCOMPARE(dialog.findChild<QLineEdit*>(QStringLiteral("board_folder"))->text(),
           QString::fromStdString(folder.path().string()));
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::ControlsTest>(argc, argv); }
#include "controls_test.moc"
