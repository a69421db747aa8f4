// SPDX-License-Identifier: GPL-3.0-or-later
#include "kill_trial.h"

#include <QElapsedTimer>
#include <QProcess>
#include <algorithm>
#include <random>
#include <set>

#include "glisson/core/files.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/parts/image.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/volume/io.h"

namespace glisson::app {
namespace fs = std::filesystem;
namespace {

constexpr int kFrames = 8;  ///< of a recording

/// Noise, so that nothing is compressed away and saving takes its time.
std::vector<std::int16_t> write_ct(const fs::path& path, std::int16_t add, std::mt19937_64 random) {
  constexpr int kEdge = 96;
  Image image;
  image.grid.size = {kEdge, kEdge, kEdge};
  image.grid.spacing_mm = {1.5, 1.5, 1.5};
  auto voxels = std::make_shared<std::vector<std::int16_t>>(static_cast<std::size_t>(kEdge) * kEdge * kEdge);
  for (std::int16_t& voxel : *voxels) voxel = static_cast<std::int16_t>(random() % 400 + add);
  image.voxels = voxels;
  write_image(path, image);
  return *voxels;
}

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename().string());
  return names;
}

class Trial {
 public:
  Trial(const fs::path& folder, fs::path patient, const RunContext& context)
      : folder_(folder), patient_(std::move(patient)), context_(context), random_(context.random("kills")) {
    voxels_[0] = write_ct(folder_ / "one.nrrd", 0, random_);
    voxels_[1] = write_ct(folder_ / "two.nrrd", 1, random_);
    for (int n = 0; n < 2; ++n) seconds_import_ = in_peace(import(n));
    if (!patient_.empty()) seconds_record_ = in_peace(record());
    expected_ = names_in(folder_);
  }

  KillTrial run(int kills) {
    for (int n = 0; found_.kills + found_.came_through < kills; ++n) {
      if (context_.cancelled()) throw Interrupted();
      context_.progress(static_cast<double>(n) / kills, "soak.kills");
      const bool records = !patient_.empty() && n % 4 == 3;
      kill_once(records ? record() : import(n), records ? seconds_record_ : seconds_import_);
      look(records);
      if (n % 10 == 9) peace();
    }
    peace();
    return found_;
  }

 private:
  QStringList import(int n) const {
    return {"import", n % 2 == 0 ? "one.nrrd" : "two.nrrd", "--case", "a.glisson"};
  }
  QStringList record() const {
    return {
        "overlay", "--case", QString::fromStdString(patient_.string()), "--frames", QString::number(kFrames),
        "--out",   "o.mkv"};
  }
  void start(QProcess& process, const QStringList& arguments) const {
    process.setWorkingDirectory(QString::fromStdString(folder_.string()));
    process.setStandardOutputFile(QProcess::nullDevice());
    process.start(QCoreApplication::applicationFilePath(), arguments);
    if (!process.waitForStarted()) throw FileError("glisson: could not be started for the trial.");
  }
  double in_peace(const QStringList& arguments) const {
    QProcess process;
    QElapsedTimer timer;
    timer.start();
    start(process, arguments);
    process.waitForFinished(-1);
    if (process.exitCode() != 0)
      throw Error("trial: " + process.readAllStandardError().trimmed().toStdString());
    return 1e-3 * static_cast<double>(timer.elapsed());
  }
  void kill_once(const QStringList& arguments, double seconds) {
    QProcess process;
    start(process, arguments);
    const double at = std::uniform_real_distribution<double>(0.02, 1.05)(random_) * seconds;
    const bool ended = process.waitForFinished(static_cast<int>(1e3 * at));
    process.kill();  // SIGKILL
    process.waitForFinished(-1);
    ended ? ++found_.came_through : ++found_.kills;
    found_.littered += names_in(folder_) != expected_;
  }
  void look(bool records) {
    try {
      if (records) {
        stereo::StereoVideo film(folder_ / "o.mkv");
        int frames = 0;
        for (StereoFrame frame; film.read(frame);) ++frames;
        found_.broken += frames != kFrames;
        return;
      }
      const auto found = engine::open_case(folder_ / "a.glisson", RunContext());
      const auto& voxels = *(*found)[part::image]->voxels;
      found_.broken += voxels != voxels_[0] && voxels != voxels_[1];
    } catch (const Error&) {
      ++found_.broken;
    }
  }
  /// The next start, which must find and remove what was left.
  void peace() {
    in_peace(import(0));
    if (!patient_.empty()) in_peace(record());
    const std::set<std::string> now = names_in(folder_);
    for (const std::string& name : now) {
      const bool is_recovered = name.starts_with("recovered-");
      if (is_recovered) fs::remove(folder_ / name);
      found_.recovered += is_recovered;
      found_.left += !is_recovered && !expected_.contains(name);
    }
  }

  fs::path folder_, patient_;
  RunContext context_;
  std::mt19937_64 random_;
  std::vector<std::int16_t> voxels_[2];
  double seconds_import_ = 1.0, seconds_record_ = 1.0;
  std::set<std::string> expected_;
  KillTrial found_;
};

}  // namespace

KillTrial kill_at_work(const fs::path& folder, const fs::path& patient, int kills,
                       const RunContext& context) {
  return Trial(folder, patient, context).run(kills);
}

}  // namespace glisson::app
