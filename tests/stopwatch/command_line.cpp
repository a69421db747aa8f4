// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <stdexcept>

#include "glisson/core/files.h"
#include "glisson/core/stopwatch.h"
#include "glisson/volume/io.h"

namespace glisson::stopwatch {
namespace {

namespace fs = std::filesystem;

void run(const fs::path& folder, const QStringList& arguments) {
  QProcess process;
  process.setWorkingDirectory(QString::fromStdString(folder.string()));
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.remove(QStringLiteral("DISPLAY"));
  process.setProcessEnvironment(environment);
  process.start(QStringLiteral(GLISSON_EXECUTABLE), arguments);
  if (!process.waitForFinished(-1) || process.exitStatus() != QProcess::NormalExit || process.exitCode() != 0)
    throw std::runtime_error("glisson " + arguments.join(QLatin1Char(' ')).toStdString() + ": " +
                             process.readAllStandardError().toStdString());
}

/// The series that the window offers first; empty: there is only one.
QString first_series(const fs::path& ct, const fs::path& folder) {
  run(folder, {"import", QString::fromStdString(ct.string()), "--list", "--json", "series.json"});
  const QJsonObject told =
      QJsonDocument::fromJson(QByteArray::fromStdString(read_file(folder / "series.json"))).object();
  return told.value(QLatin1String("series")).toInt() > 1
             ? told.value(QLatin1String("series_01_uid")).toString()
             : QString();
}

long apart(const LabelVolume& one, const LabelVolume& two) {
  require_same_grid(one.grid(), two.grid(), "labels of the command line, and the window's");
  const std::vector<Label> a = one.dense(), b = two.dense();
  long count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i] ? 1 : 0;
  return count;
}

}  // namespace

Comparison do_the_same(const fs::path& ct, const Sitting& sitting, const fs::path& folder) {
  Comparison comparison;
  comparison.saved_apart =
      apart(read_labels(sitting.saved / "labels.seg.nrrd").voxels, sitting.labels.back());
  const Stopwatch watch;
  QStringList import{"import", QString::fromStdString(ct.string()), "--case", "same.glisson"};
  if (const QString series = first_series(ct, folder); !series.isEmpty()) import << "--series" << series;
  run(folder, import);
  for (std::size_t n = 0; n < sitting.seeds.size(); ++n) {
    const std::string file = "seeds_" + std::to_string(n) + ".json";
    segmentation::write_seeds(folder / file, sitting.seeds[n]);
    QStringList segment{"segment", "--case", "same.glisson", "--seeds", QString::fromStdString(file)};
    if (n > 0) segment << "--correct";
    run(folder, segment);
    comparison.voxels_apart.push_back(
        apart(read_labels(folder / "same.glisson/labels.seg.nrrd").voxels, sitting.labels[n]));
  }
  comparison.seconds = watch.seconds();
  return comparison;
}

}  // namespace glisson::stopwatch
