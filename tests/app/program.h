// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDirIterator>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTest>

#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <functional>
#include <memory>

#include "glisson/core/files.h"
#include "glisson/geometry/camera.h"
#include "glisson/geometry/mesh.h"
#include "glisson/geometry/topology.h"

/// The program itself is run, in a folder of its own.
namespace glisson::test {

struct Ran {
  int code = -1;
  QString out, error;
};

/// A flattened ball of tetrahedra, half axes 0.10 x 0.07 x 0.04 m: a cube's grid, each cell cut into six,
/// mapped.
inline TetMesh ball(int cells = 6) {
  const int n = cells + 1;
  TetMesh mesh;
  mesh.vertices.resize(n * n * n, 3);
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const Eigen::Vector3d cube = 2.0 * Eigen::Vector3d(i, j, k) / cells - Eigen::Vector3d::Ones();
        const double largest = cube.cwiseAbs().maxCoeff();
        const Eigen::Vector3d p = largest > 0.0 ? (cube * largest / cube.norm()).eval() : cube;
        mesh.vertices.row(i + n * (j + n * k)) =
            p.cwiseProduct(Eigen::Vector3d(0.10, 0.07, 0.04)).transpose();
      }
  static constexpr int kPaths[6][3] = {{1, 2, 4}, {1, 4, 2}, {2, 1, 4}, {2, 4, 1}, {4, 1, 2}, {4, 2, 1}};
  std::vector<Eigen::RowVector4i> cells_cut;
  const auto node = [&](int i, int j, int k, int corner) {
    return (i + (corner & 1)) + n * ((j + ((corner >> 1) & 1)) + n * (k + ((corner >> 2) & 1)));
  };
  for (int k = 0; k < cells; ++k)
    for (int j = 0; j < cells; ++j)
      for (int i = 0; i < cells; ++i)
        for (const auto& path : kPaths)
          cells_cut.emplace_back(node(i, j, k, 0), node(i, j, k, path[0]), node(i, j, k, path[0] | path[1]),
                                 node(i, j, k, 7));
  mesh.tetrahedra.resize(static_cast<Eigen::Index>(cells_cut.size()), 4);
  for (std::size_t t = 0; t < cells_cut.size(); ++t)
    mesh.tetrahedra.row(static_cast<Eigen::Index>(t)) = cells_cut[t];
  orient_tetrahedra(mesh);
  return mesh;
}

/// A bend that no rigid motion undoes, some millimetres at the ends.
inline Points bent(const Points& p, double amount) {
  Points q = p;
  for (Eigen::Index i = 0; i < p.rows(); ++i) q(i, 2) += amount * (p(i, 0) * p(i, 0) / 0.01 - 0.3);
  return q;
}

inline StereoRig rig() {
  StereoRig made;
  made.left.width = made.right.width = 320;
  made.left.height = made.right.height = 240;
  made.left.matrix << 300, 0, 160, 0, 300, 120, 0, 0, 1;
  made.right.matrix = made.left.matrix;
  made.right_from_left.translation = {-0.005, 0.0, 0.0};
  return made;
}

inline void write_text(const std::filesystem::path& path, const std::string& text) {
  write_file_atomically(path, text);
}

class Program {
 protected:
  void make_folder() {
    folder_ = std::make_unique<TemporaryFolder>();
    state_ = std::make_unique<TemporaryFolder>();
  }
  void remove_folder() {
    folder_.reset();
    state_.reset();
  }
  /// Where the program keeps its log and its crash reports: not where it works.
  std::filesystem::path state() const { return state_->path() / "glisson"; }

  std::filesystem::path at(const char* name) const { return folder_->path() / name; }
  QString text_of(const char* name) const { return QString::fromStdString(at(name).string()); }
  /// @param locale of the system; its files are in the folder "locales" where they have been made.
  Ran run(const QStringList& arguments, const QString& locale = QStringLiteral("C.UTF-8")) const {
    return end_of(*start(arguments, locale));
  }
  /// The person presses Ctrl-C as soon as the program listens.
  Ran interrupted(const QStringList& arguments) const {
    const auto process = start(arguments, QStringLiteral("C.UTF-8"));
    if (!process->waitForStarted()) return {};
    while (process->state() == QProcess::Running && !catches_interrupts(process->processId()))
      process->waitForFinished(1);
    if (process->processId() > 0) ::kill(static_cast<pid_t>(process->processId()), SIGINT);
    return end_of(*process);
  }
  /// As a terminal does it: the program and all that it has started get the signal, as soon as a helper of
  /// it runs.
  Ran interrupted_as_a_group(const QStringList& arguments, int signal) const {
    const auto process = prepared(arguments, QStringLiteral("C.UTF-8"));
    process->setChildProcessModifier([] { ::setpgid(0, 0); });
    process->start();
    if (!process->waitForStarted()) return {};
    while (process->state() == QProcess::Running && !has_helper(process->processId()))
      process->waitForFinished(1);
    if (process->processId() > 0) ::kill(-static_cast<pid_t>(process->processId()), signal);
    return end_of(*process);
  }
  /// The person presses Ctrl-C when something has happened.
  Ran interrupted_when(const QStringList& arguments, const std::function<bool()>& happened,
                       int signal = SIGINT) const {
    const auto process = start(arguments, QStringLiteral("C.UTF-8"));
    if (!process->waitForStarted()) return {};
    while (process->state() == QProcess::Running && !happened()) process->waitForFinished(1);
    if (process->processId() > 0) ::kill(static_cast<pid_t>(process->processId()), signal);
    return end_of(*process);
  }
  QJsonObject figures(const char* name) const {
    return QJsonDocument::fromJson(QByteArray::fromStdString(read_file(at(name)))).object();
  }
  /// How many files there are, to show that a failure left nothing behind.
  int files() const {
    int count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::recursive_directory_iterator(folder_->path()))
      ++count;
    return count;
  }
  void refused(const QStringList& arguments, const QString& mentions, int code = 1) const {
    const int before = files();
    const Ran ran = run(arguments);
    QVERIFY2(ran.code == code, qPrintable(QString::number(ran.code) + ran.error + ran.out));
    QVERIFY2(ran.error.contains(mentions, Qt::CaseInsensitive), qPrintable(ran.error));
    QVERIFY2(ran.error.trimmed().count('\n') == 0, qPrintable(ran.error));
    QCOMPARE(files(), before);
  }

  /// In the folder, without a display.
  std::unique_ptr<QProcess> prepared(const QStringList& arguments, const QString& locale) const {
    auto process = std::make_unique<QProcess>();
    process->setWorkingDirectory(QString::fromStdString(folder_->path().string()));
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove("DISPLAY");
    environment.remove("WAYLAND_DISPLAY");
    // As in a container or a cron job: what Qt then says must not reach the person.
    environment.remove("XDG_RUNTIME_DIR");
    environment.remove("LANGUAGE");
    environment.insert("LC_ALL", locale);
    environment.insert("XDG_STATE_HOME", QString::fromStdString(state_->path().string()));
    if (std::filesystem::exists(at("locales"))) environment.insert("LOCPATH", text_of("locales"));
    process->setProcessEnvironment(environment);
    process->setProgram(GLISSON_EXECUTABLE);
    process->setArguments(arguments);
    return process;
  }

  std::unique_ptr<QProcess> start(const QStringList& arguments, const QString& locale) const {
    auto process = prepared(arguments, locale);
    process->start();
    return process;
  }

  static Ran end_of(QProcess& process) {
    if (process.state() != QProcess::NotRunning && !process.waitForFinished(-1)) return {};
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -2,
            QString::fromUtf8(process.readAllStandardOutput()),
            QString::fromUtf8(process.readAllStandardError())};
  }

 private:
  /// Whether one of its threads has started another program.
  static bool has_helper(qint64 process) {
    const auto program_of = [](const QString& number) {
      std::error_code failure;
      return std::filesystem::read_symlink(QStringLiteral("/proc/%1/exe").arg(number).toStdString(), failure);
    };
    const auto own = program_of(QString::number(process));
    QDirIterator threads(QStringLiteral("/proc/%1/task").arg(process), QDir::Dirs | QDir::NoDotAndDotDot);
    while (threads.hasNext()) {
      QFile children(threads.next() + QStringLiteral("/children"));
      if (!children.open(QIODevice::ReadOnly)) continue;
      for (const QByteArray& child : children.readAll().split(' '))
        if (const auto program = program_of(QString::fromLatin1(child.trimmed()));
            !program.empty() && program != own)
          return true;
    }
    return false;
  }
  /// Linux tells for each process which signals it has a handler for.
  static bool catches_interrupts(qint64 process) {
    QFile status(QStringLiteral("/proc/%1/status").arg(process));
    if (!status.open(QIODevice::ReadOnly)) return false;
    for (const QByteArray& line : status.readAll().split('\n'))
      if (line.startsWith("SigCgt:"))
        return ((line.mid(7).trimmed().toULongLong(nullptr, 16) >> (SIGINT - 1)) & 1U) != 0;
    return false;
  }

  std::unique_ptr<TemporaryFolder> folder_, state_;
};

}  // namespace glisson::test
