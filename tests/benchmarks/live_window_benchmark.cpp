// SPDX-License-Identifier: GPL-3.0-or-later
// From the camera to the screen in the real window: a case that is registered and has a video is opened, its
// video followed in the live view, and told how old the pictures were when they had been painted, how many
// were shown a second, and what the processor had to do for it.
//   glisson demo --headless --out DIR
//   xvfb-run -a -s "-screen 0 1280x800x24" build/bench/benchmarks/live_window_benchmark DIR/patient.glisson
//   [SECONDS]
#include <QApplication>
#include <QEventLoop>
#include <QPushButton>
#include <QTest>
#include <QTimer>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>

#include "glisson/engine/parts/live.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/video.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/guidance/guidance_panel.h"
#include "glisson/ui/shell/main_window.h"
#include "glisson/ui/shell/run_window.h"

namespace {

using namespace glisson;

void wait_until(const char* what, const std::function<bool()>& condition) {
  if (QTest::qWaitFor(condition, 60000)) return;
  std::fprintf(stderr, "%s: not within a minute\n", what);
  std::exit(1);
}

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "live_window_benchmark CASE [SECONDS]\n");
    return 2;
  }
  const double seconds = argc > 2 ? std::atof(argv[2]) : 8.0;
  qputenv("LC_ALL", "C.UTF-8");
  ui::prepare_application();
  QApplication application(argc, argv);
  ui::dress_application(application);
  ui::MainWindow window;
  window.resize(1280, 800);
  window.show();
  window.open(argv[1]);
  const auto is_idle = [&] { return window.engine().tasks().empty() && !window.drawables().is_preparing(); };
  wait_until("the case", [&] { return is_idle() && window.engine().state()[part::registration]; });
  if (!window.engine().state()[part::video]) {
    std::fprintf(stderr, "%s: has no video\n", argv[1]);
    return 1;
  }
  window.show_step(ui::MainWindow::guidance);
  window.findChild<QPushButton*>(QStringLiteral("show_picture"))->click();
  QTest::qWait(1000);
  const ui::LiveViewModel& live = window.findChild<ui::GuidancePanel*>()->live();
  std::string told;
  QObject::connect(&live, &ui::LiveViewModel::times_told, &window,
                   [&told](const ui::ScreenTimes& times) { told = line_of(times); });
  int frames = 0, valid = 0;
  double tracking = 0.0, drawing = 0.0;
  QObject::connect(&live, &ui::LiveViewModel::picture_changed, &window, [&] {
    const ui::PaintedOverlay& shown = live.on_screen();
    if (!shown.is_live) return;
    ++frames;
    valid += shown.overlay.level() == Level::valid;
    tracking += shown.overlay.milliseconds;
    drawing += 1e3 * shown.draw;
  });
  const auto measure = [&](const char* what) {
    told.clear();
    window.findChild<ui::TaskButton*>(QStringLiteral("start_tracking"))->trigger();
    wait_until("the first picture", [&] { return live.screen_times().count() > 0; });
    frames = valid = 0;
    tracking = drawing = 0.0;
    const double before = processor_seconds();
    QEventLoop loop;  // sleeps while there is nothing to do, as the window's own
    QTimer::singleShot(std::chrono::milliseconds(static_cast<int>(1e3 * seconds)), &loop, &QEventLoop::quit);
    loop.exec();
    const double spent = processor_seconds() - before;
    const auto& state = window.engine().state()[part::live];
    const int late = state ? state->frames_late : 0, dropped = state ? state->frames_dropped : 0;
    const bool goes_on = window.engine().snapshot()->tracking;
    if (goes_on) window.findChild<QPushButton*>(QStringLiteral("stop_tracking"))->click();
    wait_until("the end of the live view", [&] { return !told.empty(); });
    std::printf(
        "%-5s %s%s\n      shown %d (%d valid), late %d, dropped %d; a frame: %.1f ms tracking, %.1f ms "
        "drawing, %.1f ms of processor in all\n",
        what, told.c_str(), goes_on ? "" : " (the video ended before)", frames, valid, late, dropped,
        tracking / frames, drawing / frames, 1e3 * spent / frames);
    std::fflush(stdout);
    QTest::qWait(1000);
  };
  measure("cold");
  measure("warm");
  return 0;
}
