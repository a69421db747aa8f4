// SPDX-License-Identifier: GPL-3.0-or-later
// What this machine gives the program, tried out rather than asked for.
#include <sys/statvfs.h>
#include <sys/sysinfo.h>
#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkVersion.h>

#include <Eigen/Core>
#include <thread>

#include "cli.h"
#include "commands.h"
#include "exit_code.h"
#include "glisson/core/claim.h"
#include "glisson/core/files.h"
#include "glisson/core/log_file.h"
#include "glisson/network/runner.h"
#include "glisson/stereo/codecs.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/stereo/picture_reader.h"
#include "glisson/stereo/source.h"
#include "glisson/ui/scene/offscreen_renderer.h"
#include "glisson/volume/io.h"
#include "glisson/volume/reader_program.h"

namespace glisson::app {
namespace fs = std::filesystem;
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
      miss(QString::fromStdString(failure.what()));
    }
  }
  void miss(const QString& sentence) { missing_ << sentence; }
  const QStringList& missing() const { return missing_; }

 private:
  Session& session_;
  QStringList missing_;
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

void tell_machine(Findings& found) {
  constexpr double kLeastMemory = 7.5, kLeastSpace = 5.0;
  const unsigned cores = std::thread::hardware_concurrency();
  found.say_number("cores", cores);
  if (cores < 2) found.miss(Cli::tr("There is one processor core: the live view needs two."));
  struct sysinfo memory = {};
  if (::sysinfo(&memory) == 0) {
    const double total = static_cast<double>(memory.totalram) * memory.mem_unit / kGigabyte;
    found.say_number("memory_gb", total);
    if (total < kLeastMemory)
      found.miss(Cli::tr("There are %1 GB of memory: large CTs need 8.").arg(total, 0, 'f', 1));
  }
  const fs::path work = work_folder();
  found.say_text("folder_of_work", work.string());
  struct statvfs disk = {};
  if (::statvfs(work.c_str(), &disk) == 0) {
    const double space = static_cast<double>(disk.f_bavail) * static_cast<double>(disk.f_frsize) / kGigabyte;
    found.say_number("free_space_gb", space);
    if (space < kLeastSpace)
      found.miss(Cli::tr("%1 has %2 GB left: archives are unpacked there.")
                     .arg(QString::fromStdString(work.string()))
                     .arg(space, 0, 'f', 1));
  }
  found.say_text("folder_of_logs", (state_folder() / "log").string());
  const bool display = qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY");
  found.say_number("display", display ? 1.0 : 0.0);
  if (!display) found.miss(Cli::tr("There is no display: the window cannot open, all else works."));
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

void try_locks() {
  const TemporaryFolder folder;
  Claim one, two;
  if (Claim::make_file(folder.path(), "", one).empty() || !one.take())
    throw FileError(
        folder.path().string() +
        ": this file system has no locks, so that two programs may write one case. Keep cases elsewhere.");
}

void try_volumes() {
  const TemporaryFolder folder;
  Image image;
  image.grid.size = {4, 4, 4};
  image.grid.spacing_mm = {1.0, 1.0, 1.0};
  image.voxels = std::make_shared<std::vector<std::int16_t>>(64, std::int16_t{40});
  write_image(folder.path() / "tried.nrrd", image);
  if (*read_image(folder.path() / "tried.nrrd", RunContext())->voxels != *image.voxels)
    throw FileError("tried.nrrd: a volume reads back differently from what was written. Check the disk.");
}

void try_recording() {
  const TemporaryFolder folder;
  const Picture grey{320, 240, 3,
                     std::make_shared<std::vector<std::uint8_t>>(320UL * 240 * 3, std::uint8_t{128})};
  stereo::VideoWriter writer(folder.path() / "tried.mkv", grey.width, grey.height, 25.0);
  for (int frame = 0; frame < 5; ++frame) writer.write(grey);
  writer.close();  // counts the frames that can be read back
}

void tell_codecs(Findings& found) {
  const std::vector<std::string> codecs = stereo::video_codecs();
  std::string list;
  for (const std::string& codec : codecs) list += (list.empty() ? "" : ", ") + codec;
  found.say_text("video_codecs", list);
  for (const char* codec : {"mpeg4", "h264"})
    if (std::find(codecs.begin(), codecs.end(), codec) == codecs.end())
      found.miss(Cli::tr("A video in %1 could not be written and read back here: OpenCV's FFmpeg lacks it.")
                     .arg(QString::fromLatin1(codec)));
}

/// Draws, and asks the driver meanwhile who it is: the context is current only then.
void try_drawing(Findings& found) {
  vtkNew<vtkRenderer> renderer;
  std::string report;
  vtkNew<vtkCallbackCommand> asks;
  asks->SetClientData(&report);
  asks->SetCallback([](vtkObject* caller, unsigned long, void* told, void*) {
    auto* window = vtkRenderer::SafeDownCast(caller)->GetRenderWindow();
    if (window != nullptr) *static_cast<std::string*>(told) = window->ReportCapabilities();
  });
  renderer->AddObserver(vtkCommand::EndEvent, asks);
  scene::OffscreenRenderer drawing(64, 64);
  if (drawing.render(*renderer).empty())
    throw Error("drawing: nothing was drawn. Check the graphics driver.");
  for (const QString& line : QString::fromStdString(report).split('\n')) {
    for (const char* name : {"vendor", "renderer", "version"}) {
      const QString start = QStringLiteral("OpenGL %1 string:").arg(QLatin1String(name));
      if (line.trimmed().startsWith(start))
        found.say_text(std::string("opengl_") + name,
                       line.trimmed().mid(start.size()).trimmed().toStdString());
    }
  }
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
  tell_confinement(found);
  found.try_out("locks", try_locks);
  found.try_out("volumes", try_volumes);
  found.try_out("recording", try_recording);
  tell_codecs(found);
  found.try_out("drawing", [&] { try_drawing(found); });
  session.figures["missing"] = static_cast<double>(found.missing().size());
  session.finish();
  for (const QString& sentence : found.missing()) say(Cli::tr("missing: ") + sentence);
  const bool works = std::all_of(session.figures.begin(), session.figures.end(), [](const auto& figure) {
    return !figure.first.starts_with("works_") || figure.second == 1.0;
  });
  return works ? kDone : kIncomplete;
}

}  // namespace glisson::app
