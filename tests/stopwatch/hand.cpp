// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QTest>
#include <QTreeWidget>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "glisson/engine/parts/image.h"
#include "glisson/volume/axes.h"
#include "human_times.h"

namespace glisson::stopwatch {
namespace {

constexpr int kBeat = 10, kPoll = 5, kQuiet = 60;  ///< ms
constexpr double kLongest = 1800.0;                ///< s

std::string name_of(const QWidget& widget) {
  const auto* button = qobject_cast<const QAbstractButton*>(&widget);
  const QString text = button != nullptr ? button->text().remove(QLatin1Char('&')) : QString();
  return (text.isEmpty() ? widget.objectName() : text).toStdString();
}

bool is_in_sight(const QWidget& control) {
  return control.isVisible() && control.visibleRegion().contains(control.rect().center());
}

QStringList words_of(const QString& text) {
  static const QRegularExpression kMarks(QStringLiteral("<[^>]*>"));
  return QString(text).remove(kMarks).split(QRegularExpression(QStringLiteral("\\s+")), Qt::SkipEmptyParts);
}

}  // namespace

Hand::Hand(ui::MainWindow& window, Ledger& ledger) : window_(window), ledger_(ledger) {
  connect(&beat_, &QTimer::timeout, this, &Hand::note_deafness);
  connect(&files_, &QTimer::timeout, this, &Hand::answer_file_dialog);
  beat_.start(kBeat);
}

void Hand::note_deafness() {
  const double seconds = 1e-3 * static_cast<double>(since_beat_.restart());
  if (is_watched_) ledger_.now().longest_deaf = std::max(ledger_.now().longest_deaf, seconds);
}

void Hand::act(double human, const std::function<void()>& what) {
  think(human);
  QElapsedTimer timer;
  timer.start();
  since_beat_.restart();
  is_watched_ = true;
  what();
  QCoreApplication::processEvents();
  note_deafness();
  is_watched_ = false;
  ledger_.now().program += 1e-3 * static_cast<double>(timer.elapsed());
}

void Hand::press(const char* name) {
  auto* control = window_.findChild<QWidget*>(QLatin1String(name));
  if (control == nullptr) throw std::runtime_error(std::string("there is no ") + name);
  press(*control);
}

void Hand::press(QWidget& control) {
  if (!control.isEnabled()) throw std::runtime_error(name_of(control) + " is switched off");
  bring_into_sight(control);
  click(control, control.rect().center());
}

void Hand::bring_into_sight(QWidget& control) {
  if (is_in_sight(control)) return;
  if (!control.isVisible()) throw std::runtime_error(name_of(control) + " is not there");
  ledger_.finding(name_of(control) + " is out of sight and is scrolled to");
  for (QWidget* above = control.parentWidget(); above != nullptr; above = above->parentWidget()) {
    auto* area = qobject_cast<QScrollArea*>(above);
    if (area == nullptr) continue;
    const auto off = [&] {  // pixels below what the area shows; negative: above
      const int at = control.mapTo(area->viewport(), control.rect().center()).y();
      return at < 0 ? at : std::max(0, at - area->viewport()->height() + 1);
    };
    if (off() == 0) continue;
    act(HumanTimes::kScrollControls, [&] {
      for (int n = 0; n < 100 && off() != 0; ++n) turn(*area->verticalScrollBar(), off() < 0 ? 1 : -1);
    });
  }
  if (!is_in_sight(control)) throw std::runtime_error(name_of(control) + " cannot be scrolled to");
}

void Hand::click(QWidget& widget, const QPoint& place) {
  QWidget* top = widget.window();
  if (!widget.visibleRegion().contains(place))
    throw std::runtime_error(name_of(widget) + ": the place is out of sight");
  const QWidget* modal = QApplication::activeModalWidget();
  if (modal != nullptr && modal != top) throw std::runtime_error(name_of(widget) + " lies behind a question");
  ++ledger_.now().clicks;
  act(HumanTimes::kDecide + HumanTimes::kPoint + HumanTimes::kClick,
      [&] { QTest::mouseClick(top->windowHandle(), Qt::LeftButton, {}, widget.mapTo(top, place)); });
}

void Hand::click(ui::SliceView& view, const Point<CtFrame>& p) {
  find_slice(view, p);
  click(static_cast<QWidget&>(view), view.widget_point(p).toPoint());
}

int Hand::notches_to(const ui::SliceView& view, double height) const {
  const VolumeGrid& grid = window_.engine().state()[part::image]->grid;
  const int normal = scene::normal_axis(view.plane());
  const double step = 1e-3 * grid.spacing_mm[axis_along(grid, normal)];
  return static_cast<int>(std::lround((height - window_.views().state().crosshair().xyz[normal]) / step));
}

void Hand::find_slice(ui::SliceView& view, const Point<CtFrame>& p) {
  const int notches = notches_to(view, p.xyz[scene::normal_axis(view.plane())]);
  if (notches != 0) act(HumanTimes::kFindSlice, [&] { turn(view, notches); });
}

void Hand::look_through(ui::SliceView& view, double from, double to) {
  act(HumanTimes::kFindSlice, [&] { turn(view, notches_to(view, from)); });
  const int notches = notches_to(view, to);
  act(HumanTimes::kSlice * std::abs(notches), [&] { turn(view, notches); });
}

void Hand::turn(QWidget& widget, int notches) {
  if (QApplication::activeModalWidget() != nullptr)
    throw std::runtime_error("the wheel turns behind a question");
  const QPointF middle = widget.rect().center();
  for (int n = 0; n < std::abs(notches); ++n) {
    QWheelEvent event(middle, widget.mapToGlobal(middle), {}, {0, notches > 0 ? 120 : -120}, Qt::NoButton, {},
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&widget, &event);
    QCoreApplication::processEvents();  // each slice is drawn
    ++ledger_.now().notches;
  }
}

void Hand::shortcut(Qt::Key key, Qt::KeyboardModifiers modifiers) {
  const int keys = 1 + (modifiers == Qt::NoModifier ? 0 : 1);
  ledger_.now().keys += keys;
  act(HumanTimes::kDecide + HumanTimes::kHome + keys * HumanTimes::kKey, [&] {
    QApplication::setActiveWindow(&window_);  // no window manager gives it back after a dialogue
    QTest::keyClick(window_.windowHandle(), key, modifiers);
  });
}

void Hand::will_answer_with(const std::filesystem::path& path, double seconds) {
  path_ = QString::fromStdString(path.string());
  path_seconds_ = seconds;
  files_.start(kPoll);
}

void Hand::answer_file_dialog() {
  auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
  if (dialog == nullptr || !dialog->isVisible()) return;
  files_.stop();
  think(path_seconds_);
  dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(path_);
  ++ledger_.now().clicks;
  dialog->findChild<QDialogButtonBox*>()->buttons().constFirst()->click();
}

void Hand::read(const QString& text) {
  if (read_.contains(text)) return;
  read_.insert(text);
  think(HumanTimes::kWord * static_cast<double>(words_of(text).size()));
}

void Hand::read_what_is_new() {
  for (const QLabel* label : window_.findChildren<QLabel*>())
    if (is_in_sight(*label)) read(label->text());
  for (const QAbstractButton* button : window_.findChildren<QAbstractButton*>())
    if (is_in_sight(*button)) read(button->text());
}

bool Hand::answer_question() {
  QWidget* asks = QApplication::activeModalWidget();
  if (asks == nullptr || qobject_cast<QFileDialog*>(asks) != nullptr) return false;
  if (!album.empty()) photograph(album / ("question_" + std::to_string(ledger_.now().clicks) + ".png"));
  QAbstractButton* answer = nullptr;
  if (auto* series = asks->findChild<QTreeWidget*>(QStringLiteral("series"))) {
    think(HumanTimes::kLookAtSeries * series->topLevelItemCount());
  } else if (auto* box = qobject_cast<QMessageBox*>(asks)) {
    ledger_.finding("a question or a note stands in the way: " +
                    (box->text() + QLatin1Char(' ') + box->informativeText()).simplified().toStdString());
    answer = box->defaultButton() != nullptr ? box->defaultButton() : box->buttons().constFirst();
  }
  for (const QLabel* label : asks->findChildren<QLabel*>()) read(label->text());
  for (QPushButton* button : asks->findChildren<QPushButton*>())
    if (answer == nullptr && button->isDefault()) answer = button;
  if (answer == nullptr) throw std::runtime_error("a question has no answer that is proposed");
  press(*answer);
  return true;
}

bool Hand::is_at_work() const {
  const auto& tasks = window_.engine().tasks();
  return std::any_of(tasks.begin(), tasks.end(), [](const ui::Task& task) {
    return task.traits.notice != engine::Notice::unasked;  // nobody waits for what nobody has asked for
  });
}

QString Hand::signs_of_work() const {
  QString signs = window_.status_text();
  for (const QProgressBar* bar : window_.findChildren<QProgressBar*>())
    if (is_in_sight(*bar) && bar->maximum() > 0)  // as far as a pixel shows it
      signs += QString::number(bar->value() * bar->width() / bar->maximum()) + QLatin1Char('/');
  for (const QLabel* label : window_.findChildren<QLabel*>())
    if (is_in_sight(*label)) signs += label->text();
  return signs + QString::number(reinterpret_cast<quintptr>(window_.views().state().evolving().get()));
}

void Hand::settle(const std::function<void()>& look) {
  QElapsedTimer all, still, quiet;
  all.start();
  still.start();
  since_beat_.restart();
  double worked = 0.0;  // s, until nothing was at work any more
  QString signs = signs_of_work();
  for (bool idle = false; !idle || quiet.elapsed() < kQuiet;) {
    is_watched_ = true;
    QTest::qWait(kPoll);
    is_watched_ = false;
    const bool busy = is_at_work();
    if (busy) {
      worked = 1e-3 * static_cast<double>(all.elapsed());
      if (const QString now = signs_of_work(); now != signs) {
        signs = now;
        still.restart();
      }
      Step& step = ledger_.now();
      if (const double seconds = 1e-3 * static_cast<double>(still.elapsed()); seconds > step.longest_still) {
        step.longest_still = seconds;
        step.still_at = window_.status_text().toStdString();
      }
    } else {
      still.restart();
    }
    if (look) look();
    const bool asked = !busy && answer_question();
    if (busy || asked || !idle) quiet.start();
    idle = !busy && !asked;
    since_beat_.restart();
    if (1e-3 * static_cast<double>(all.elapsed()) > kLongest)
      throw std::runtime_error("the work does not end");
  }
  ledger_.now().program += worked;
}

void Hand::photograph(const std::filesystem::path& file) {
  QPixmap picture = window_.grab();
  if (QWidget* over = QApplication::activeModalWidget()) {
    QPainter painter(&picture);
    painter.drawPixmap(over->mapToGlobal(QPoint()) - window_.mapToGlobal(QPoint()), over->grab());
  }
  picture.save(QString::fromStdString(file.string()));
  since_beat_.restart();
}

}  // namespace glisson::stopwatch
