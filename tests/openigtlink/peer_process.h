// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QProcess>
#include <QRegularExpression>
#include <functional>

/// @file
/// A peer in a process of its own (peer.cpp), and what it says.

namespace glisson {

/// The words of a line that a peer printed.
using Words = QStringList;

class PeerProcess {
 public:
  explicit PeerProcess(const QStringList& arguments) {
    process_.start(QStringLiteral(GLISSON_PEER), arguments);
    process_.waitForStarted();
  }
  ~PeerProcess() {
    process_.kill();  // a server may live longer
    process_.waitForFinished();
  }

  /// The first line, of those that nobody has waited past, for which this holds; empty: none came in time.
  Words wait_for(const std::function<bool(const Words&)>& holds) {
    QElapsedTimer timer;
    for (timer.start(); timer.elapsed() < kLongest;) {
      while (next_ < lines_.size()) {
        const Words words = lines_[next_++];
        if (holds(words)) return words;
      }
      if (!read()) return {};
    }
    return {};
  }
  /// Of a type and a device.
  Words wait_for(const QString& type, const QString& name) {
    return wait_for([&](const Words& words) { return words.value(0) == type && words.value(1) == name; });
  }
  /// The same without waiting, for tests whose own events must go on.
  Words look_for(const std::function<bool(const Words&)>& holds) {
    process_.waitForReadyRead(1);
    take_lines();
    while (next_ < lines_.size()) {
      const Words words = lines_[next_++];
      if (holds(words)) return words;
    }
    return {};
  }
  /// Every line until it ends.
  QList<Words> all() {
    while (read()) {
    }
    return lines_;
  }
  QProcess& process() { return process_; }

 private:
  static constexpr int kLongest = 20000;  ///< milliseconds; only a test that fails waits so long

  bool read() {
    if (!process_.canReadLine() && !process_.waitForReadyRead(kLongest) && !process_.canReadLine())
      return false;
    take_lines();
    return true;
  }
  void take_lines() {
    while (process_.canReadLine())
      lines_ << QString::fromUtf8(process_.readLine()).split(QRegularExpression("\\s+"), Qt::SkipEmptyParts);
  }

  QProcess process_;
  QList<Words> lines_;
  qsizetype next_ = 0;
};

}  // namespace glisson
