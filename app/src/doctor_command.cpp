// SPDX-License-Identifier: GPL-3.0-or-later
// What this machine gives the program, tried out rather than asked for.
#include <vtkVersion.h>

#include <Eigen/Core>

#include "cli.h"
#include "commands.h"
#include "exit_code.h"
#include "glisson/core/log_file.h"
#include "glisson/core/machine.h"
#include "glisson/network/runner.h"
#include "glisson/stereo/codecs.h"
#include "glisson/stereo/picture_reader.h"
#include "glisson/ui/scene/try_drawing.h"
#include "glisson/volume/reader_program.h"
#include "glisson/volume/self_test.h"

namespace glisson::app {
namespace {

constexpr double kGigabyte = 1e9;

/// What was found, and what is missing.
class Findings {
 public:
  explicit Findings(Session& session) : session_(session) {}

  void say_text(const std::string& key, const std::string& value) { session_.texts[key] = value; }
  void say_number(const std::string& key, double value) { session_.figures[key] = value; }
  /// Tries something; what it throws is what is missing.
  void try_out(const std::string& key, const std::function<void()>& work) {
    try {
      work();
      session_.figures["works_" + key] = 1.0;
    } catch (const std::exception& failure) {
      session_.figures["works_" + key] = 0.0;
      all_work_ = false;
      miss(QString::fromStdString(failure.what()));
    }
  }
  void miss(const QString& sentence) { missing_ << sentence; }
  const QStringList& missing() const { return missing_; }
  /// All that was tried out.
  bool all_work() const { return all_work_; }

 private:
  Session& session_;
  QStringList missing_;
  bool all_work_ = true;
};

void tell_versions(Findings& found) {
  found.say_text("version_glisson", GLISSON_VERSION);
  found.say_text("version_qt", qVersion());
  found.say_text("version_vtk", vtkVersion::GetVTKVersion());
  found.say_text("version_eigen", std::to_string(EIGEN_WORLD_VERSION) + "." +
                                      std::to_string(EIGEN_MAJOR_VERSION) + "." +
                                      std::to_string(EIGEN_MINOR_VERSION));
  // These are what the program was built with.
  found.say_text("built_with_itk", GLISSON_ITK);
  found.say_text("built_with_opencv", GLISSON_OPENCV);
  found.say_text("built_with_cgal", GLISSON_CGAL);
  found.say_text("built_with_embree", GLISSON_EMBREE);
  found.say_text("built_with_openigtlink", GLISSON_OPENIGTLINK);
  found.say_text("built_with_compiler", __VERSION__);
  found.say_text(
      "system", QSysInfo::prettyProductName().toStdString() + ", " + QSysInfo::kernelVersion().toStdString());
}

QString lack_text(MachineLack lack, const Machine& machine) {
  switch (lack) {
    case MachineLack::cores:
      return Cli::tr("There is one processor core: the live view needs two.");
    case MachineLack::memory:
      return Cli::tr("There are %1 GB of memory: large CTs need 8.")
          .arg(*machine.memory / kGigabyte, 0, 'f', 1);
    case MachineLack::space:
      return Cli::tr("%1 has %2 GB left: archives are unpacked there.")
          .arg(QString::fromStdString(machine.work.string()))
          .arg(*machine.space / kGigabyte, 0, 'f', 1);
  }
  return QString();
}

void tell_machine(Findings& found) {
  const Machine machine = this_machine();
  found.say_number("cores", machine.cores);
  if (machine.memory) found.say_number("memory_gb", *machine.memory / kGigabyte);
  found.say_text("folder_of_work", machine.work.string());
  if (machine.space) found.say_number("free_space_gb", *machine.space / kGigabyte);
  for (const MachineLack lack : lacks_of(machine)) found.miss(lack_text(lack, machine));
  found.say_text("folder_of_logs", (state_folder() / "log").string());
  found.say_number("display", has_display() ? 1.0 : 0.0);
  if (!has_display()) found.miss(Cli::tr("There is no display: the window cannot open, all else works."));
}

/// Of the machine, not of a patient's files: told here, not with each file.
void tell_confinement(Findings& found) {
  std::vector<std::string> escapes = reader_escapes();
  for (const auto& more : {stereo::picture_reader_escapes(), network::network_escapes()})
    escapes.insert(escapes.end(), more.begin(), more.end());
  found.say_number("readers_confined", escapes.empty() ? 1.0 : 0.0);
  if (!escapes.empty())
    found.miss(Cli::tr(
        "This computer's kernel does not shut in the programs that read foreign files: read only files "
        "that you trust."));
}

void tell_codecs(Findings& found) {
  const std::vector<std::string> codecs = stereo::video_codecs();
  std::string list;
  for (const std::string& codec : codecs) list += (list.empty() ? "" : ", ") + codec;
  found.say_text("video_codecs", list);
  for (const std::string& codec : stereo::lacking_codecs(codecs))
    found.miss(Cli::tr("A video in %1 could not be written and read back here: OpenCV's FFmpeg lacks it.")
                   .arg(QString::fromStdString(codec)));
}

void tell_drawing(Findings& found) {
  for (const auto& [name, value] : scene::try_drawing()) found.say_text("opengl_" + name, value);
}

}  // namespace

int run_doctor(const QStringList& given) {
  Arguments arguments("doctor",
                      Cli::tr("Tells what the program finds on this machine, tries out what it needs "
                              "and says what is missing. Reads no patient's data."));
  if (!arguments.parse(given)) return 0;
  Session session(arguments);
  Findings found(session);
  tell_versions(found);
  tell_machine(found);
  found.try_out("readers", [&] { tell_confinement(found); });
  found.try_out("locks", try_locks);
  found.try_out("volumes", try_volumes);
  found.try_out("recording", [&] {
    stereo::try_recording();
    tell_codecs(found);
  });
  found.try_out("drawing", [&] { tell_drawing(found); });
  session.figures["missing"] = static_cast<double>(found.missing().size());
  session.finish();
  for (const QString& sentence : found.missing()) say(Cli::tr("missing: ") + sentence);
  return found.all_work() ? kDone : kIncomplete;
}

}  // namespace glisson::app
