// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QSet>
#include <QString>
#include <QTimer>
#include <filesystem>
#include <functional>

#include "glisson/ui/common/slice_view.h"
#include "glisson/ui/shell/main_window.h"
#include "ledger.h"

namespace glisson::stopwatch {

/// A person's hand and eye at the window. Clicks go to the window as the system sends them, so that only what
/// is in sight and not behind a question can be hit. Each act adds a person's time to the ledger, and the
/// program's time until the window has taken it. All throw std::runtime_error where a person could not go on.
class Hand : public QObject {
 public:
  Hand(ui::MainWindow& window, Ledger& ledger);

  /// A click in the middle of a control. One that is out of sight is scrolled to first, which is a finding.
  void press(QWidget& control);
  /// The same of the control of this object name.
  void press(const char* name);
  void click(QWidget& widget, const QPoint& place);
  void click(ui::SliceView& view, const Point<CtFrame>& p);
  /// Turns the wheel over a view until it shows the slice that is closest to this place.
  void find_slice(ui::SliceView& view, const Point<CtFrame>& p);
  /// Looks for faults in each slice from this height to that one (CT frame, metres, along the view's normal).
  void look_through(ui::SliceView& view, double from, double to);
  void shortcut(Qt::Key key, Qt::KeyboardModifiers modifiers);
  /// Answers the file dialogue that the next act opens.
  /// @param seconds that a person needs for it.
  void will_answer_with(const std::filesystem::path& path, double seconds);
  /// Reads the texts of the window that were not read yet.
  void read_what_is_new();
  void think(double seconds) { ledger_.now().human += seconds; }
  /// Until the work has ended; questions on the way are read and answered. Half an hour at most.
  /// @param look is called from time to time meanwhile.
  void settle(const std::function<void()>& look = {});
  /// The window and what lies over it as they stand, into a file. Takes nobody's time.
  void photograph(const std::filesystem::path& file);
  /// Photographs of questions are put here; empty: nowhere.
  std::filesystem::path album;

 private:
  void act(double human, const std::function<void()>& what);
  void bring_into_sight(QWidget& control);
  int notches_to(const ui::SliceView& view, double height) const;
  void turn(QWidget& widget, int notches);
  void read(const QString& text);
  bool answer_question();
  void answer_file_dialog();
  bool is_at_work() const;
  /// All that tells that work goes on.
  QString signs_of_work() const;
  void note_deafness();

  ui::MainWindow& window_;
  Ledger& ledger_;
  QTimer beat_, files_;
  QElapsedTimer since_beat_;
  QString path_;
  double path_seconds_ = 0.0;
  bool is_watched_ = false;
  QSet<QString> read_;
};

}  // namespace glisson::stopwatch
