// SPDX-License-Identifier: GPL-3.0-or-later
#include "kill_trial.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <random>
#include <set>
#include <thread>
#include <vector>

#include "glisson/core/child_process.h"
#include "glisson/core/claim.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/stopwatch.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/parts/image.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/volume/io.h"

namespace glisson::experiments {
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

/// Asks for a cancel when its time has come, and not any more once it is gone.
class Deadline {
 public:
  Deadline(std::shared_ptr<CancelFlag> flag, double seconds)
      : thread_([this, flag = std::move(flag), seconds] {
          std::unique_lock lock(mutex_);
          if (!over_.wait_for(lock, std::chrono::duration<double>(seconds), [this] { return gone_; }))
            flag->request();
        }) {}
  ~Deadline() {
    {
      const std::lock_guard lock(mutex_);
      gone_ = true;
    }
    over_.notify_all();
    thread_.join();
  }
  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;

 private:
  std::mutex mutex_;
  std::condition_variable over_;
  bool gone_ = false;
  std::thread thread_;  // last: it uses the others
};

/// Thrown inside a trial that was cancelled; never leaves kill_at_work.
struct Cancelled {};

using Words = std::vector<std::string>;

class Trial {
 public:
  Trial(fs::path program, const fs::path& folder, fs::path patient, const RunContext& context)
      : program_(std::move(program)),
        folder_(folder),
        work_(folder / "work"),
        patient_(std::move(patient)),
        context_(context),
        random_(context.random("kills")) {
    fs::create_directory(work_);
    voxels_[0] = write_ct(folder_ / "one.nrrd", 0, random_);
    voxels_[1] = write_ct(folder_ / "two.nrrd", 1, random_);
    for (int n = 0; n < 2; ++n) seconds_import_ = in_peace(import(n));
    if (!patient_.empty()) seconds_record_ = in_peace(record());
    expected_ = names_in(folder_);
  }

  KillTrial run(int kills) {
    for (int n = 0; found_.kills < kills; ++n) {
      if (context_.cancelled()) throw Cancelled();
      context_.progress(static_cast<double>(found_.kills) / kills, "soak.kills");
      const bool records = !patient_.empty() && n % 4 == 3;
      kill_once(records ? record() : import(n), records ? seconds_record_ : seconds_import_);
      look(records);
      if (n % 10 == 9) peace();
    }
    peace();
    return found_;
  }

 private:
  Words import(int n) const {
    return {"import", (folder_ / (n % 2 == 0 ? "one.nrrd" : "two.nrrd")).string(), "--replace", "--case",
            (folder_ / "a.glisson").string()};
  }
  Words record() const {
    return {"overlay",
            "--case",
            patient_.string(),
            "--frames",
            std::to_string(kFrames),
            "--out",
            (folder_ / "o.mkv").string()};
  }
  /// With a folder for its work that no other program uses: what lies in there afterwards was left by one of
  /// these.
  Cancellable<ChildExit> start(const Words& arguments, const RunContext& context) const {
    Words words = {"TMPDIR=" + work_.string(), program_.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return run_child("/usr/bin/env", words, context, {});  // it becomes the program
  }
  double in_peace(const Words& arguments) const {
    const Stopwatch watch;
    const auto end = start(arguments, context_);
    if (!end) throw Cancelled();
    if (end->code != 0)
      throw Error("trial: 'glisson " + arguments.front() + "' failed with nobody in its way. Try it alone.");
    return watch.seconds();
  }
  void kill_once(const Words& arguments, double seconds) {
    const auto killed = std::make_shared<CancelFlag>();
    const Deadline deadline(killed, std::uniform_real_distribution<double>(0.02, 1.05)(random_) * seconds);
    const bool ended = start(arguments, RunContext({}, killed, context_.seed())).has_value();
    ended ? ++found_.came_through : ++found_.kills;
    found_.littered += !ended && names_in(folder_) != expected_;
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
    found_.left += sweep_leftovers(work_);  // that start has swept there, too
  }

  fs::path program_, folder_, work_, patient_;
  RunContext context_;
  std::mt19937_64 random_;
  std::vector<std::int16_t> voxels_[2];
  double seconds_import_ = 1.0, seconds_record_ = 1.0;
  std::set<std::string> expected_;
  KillTrial found_;
};

}  // namespace

Figures KillTrial::figures() const {
  return {{"kill_times", kills},       {"kill_came_through", came_through},
          {"kill_littered", littered}, {"kill_recovered", recovered},
          {"kill_broken", broken},     {"kill_left", left}};
}

Cancellable<KillTrial> kill_at_work(const fs::path& program, const fs::path& folder, const fs::path& patient,
                                    int kills, const RunContext& context) {
  try {
    return Trial(program, folder, patient, context).run(kills);
  } catch (const Cancelled&) {
    return {};
  }
}

}  // namespace glisson::experiments
