// SPDX-License-Identifier: GPL-3.0-or-later
// How long after a mouse event the stroke is seen: the whole window with the real engine, on a CT of 512 x
// 512 x 500 voxels (see large_scene.h), a hand that moves 125 times a second. A place of the stroke counts as
// seen when the slice has been painted with labels that have it.
//   xvfb-run -a -s "-screen 0 1280x800x24" build/bench/benchmarks/stroke_benchmark
#include <QApplication>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <QTest>
#include <QWindow>
#include <algorithm>
#include <cstdio>
#include <deque>

#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/import_labels.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/ui/segmentation/segmentation_panel.h"
#include "glisson/ui/shell/main_window.h"
#include "glisson/ui/shell/run_window.h"
#include "large_scene.h"

namespace {

using namespace glisson;
using ui::SliceView;

constexpr Label kDrawn = structure::kHepaticVeins;  ///< has no voxel on the way of the strokes

/// Opens the scene from memory where a file would be read.
Cancellable<engine::Applied> from_memory(const engine::CaseState& state, const engine::Command& command,
                                         const RunContext& context, const engine::Services&) {
  engine::Applied applied;
  applied.state = state;
  if ((command.as<engine::ImportImage>() != nullptr))
    applied.state[part::image] = std::make_shared<const Image>(bench::scene().image);
  else if ((command.as<engine::ImportLabels>() != nullptr))
    applied.state[part::labels] = std::make_shared<const LabelMap>(bench::scene().labels);
  else
    return engine::apply(state, command, context);
  return applied;
}

template <class Condition>
void wait_until(const Condition& condition) {
  if (QTest::qWaitFor(condition, 60000)) return;
  std::fprintf(stderr, "the window did not come to rest\n");
  std::exit(1);
}

/// Says when a view has been painted since it was last asked.
class Painted : public QObject {
 public:
  explicit Painted(QWidget& of) { of.installEventFilter(this); }
  bool take() { return std::exchange(painted_, false); }
  bool eventFilter(QObject*, QEvent* event) override {
    painted_ = painted_ || event->type() == QEvent::Paint;
    return false;
  }

 private:
  bool painted_ = false;
};

struct Place {
  qint64 sent = 0;  ///< nanoseconds
  Eigen::Vector3i voxel;
};

class Hand {
 public:
  explicit Hand(ui::MainWindow& window)
      : window_(window), view_(window.views().slice(scene::Plane::axial)), painted_(view_) {}

  /// Draws for a second along an arc in the liver. @return milliseconds from each event to its being seen.
  std::vector<double> stroke(double turn) {
    constexpr int kEvents = 125;
    constexpr qint64 kApart = 8'000'000;  // nanoseconds
    std::vector<double> latencies;
    std::deque<Place> waiting;
    QElapsedTimer clock;
    clock.start();
    for (int n = 0; n < kEvents || !waiting.empty();) {
      if (n < kEvents && clock.nsecsElapsed() >= n * kApart) {
        const double angle = turn + 2.0 * n / kEvents;
        const Eigen::Vector3d p = bench::scene().p_at({45.0 * std::cos(angle), 40.0 * std::sin(angle), 0.0});
        waiting.push_back(
            {clock.nsecsElapsed(), send(n == 0 ? QEvent::MouseButtonPress : QEvent::MouseMove, p)});
        if (++n == kEvents) send(QEvent::MouseButtonRelease, p);
      }
      QCoreApplication::processEvents();
      if (clock.elapsed() > 60000) {
        std::fprintf(stderr, "a place of the stroke was never seen\n");
        std::exit(1);
      }
      if (!painted_.take()) continue;
      const LabelVolume& seen = window_.views().state().labels()->voxels;
      while (!waiting.empty() && seen.at(waiting.front().voxel) == kDrawn) {
        latencies.push_back(1e-6 * static_cast<double>(clock.nsecsElapsed() - waiting.front().sent));
        waiting.pop_front();
      }
    }
    wait_until([this] { return window_.engine().tasks().empty(); });
    return latencies;
  }

 private:
  Eigen::Vector3i send(QEvent::Type type, const Eigen::Vector3d& p) {
    const QPointF at = view_.widget_point(Point<CtFrame>(p));
    const bool moves = type == QEvent::MouseMove;
    QMouseEvent event(type, at, view_.mapToGlobal(at), moves ? Qt::NoButton : Qt::LeftButton,
                      type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&view_, &event);
    return bench::scene().image.grid.index_of(Point<CtFrame>(p)).array().round().cast<int>().matrix();
  }

  ui::MainWindow& window_;
  SliceView& view_;
  Painted painted_;
};

void report(const char* what, std::vector<double> ms) {
  std::sort(ms.begin(), ms.end());
  const auto part = [&](double share) {
    return ms[static_cast<std::size_t>(share * static_cast<double>(ms.size() - 1))];
  };
  std::printf("%-40s %8.1f %8.1f %8.1f\n", what, part(0.5), part(0.95), part(1.0));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  qputenv("LC_ALL", "C.UTF-8");
  ui::prepare_application();
  QApplication application(argc, argv);
  ui::dress_application(application);
  engine::Engine::Options options;
  options.apply = from_memory;
  ui::MainWindow window(std::move(options));
  window.resize(1280, 800);
  window.show();
  const auto settle = [&] { wait_until([&] { return window.engine().tasks().empty(); }); };
  window.engine().post(engine::ImportImage{});
  window.engine().post(engine::ImportLabels{});
  wait_until([&] { return window.windowHandle() != nullptr && window.windowHandle()->isExposed(); });
  settle();
  if (!window.engine().state()[part::labels]) return 1;
  window.show_step(ui::MainWindow::segmentation);
  ui::EditSession& session = window.findChild<ui::SegmentationPanel*>()->session();
  Hand hand(window);
  const auto measure = [&](const char* what, bool ball, double radius, editing::EditableRegion::Area area) {
    ui::EditSettings settings = session.settings();
    settings.label = kDrawn;
    settings.ball = ball;
    settings.brush_radius = radius;
    settings.region.area = area;
    session.set_settings(settings);
    session.set_tool(ui::edit_tool("paint"));
    wait_until([&] { return !window.views().label_surfaces().is_making(); });
    std::vector<double> all;
    for (int n = 0; n < 2; ++n) {
      const std::vector<double> once = hand.stroke(2.0 * n);
      all.insert(all.end(), once.begin(), once.end());
      session.undo();
      settle();
    }
    report(what, all);
  };
  using Area = editing::EditableRegion::Area;
  measure("(first strokes: everything is cold)", false, 5e-3, Area::everywhere);
  std::printf("%-40s %8s %8s %8s\n", "from the event to the slice, ms", "median", "95 %", "most");
  measure("disc, 10 mm", false, 5e-3, Area::everywhere);
  measure("ball, 10 mm", true, 5e-3, Area::everywhere);
  measure("ball, 30 mm", true, 15e-3, Area::everywhere);
  measure("ball, 10 mm, inside the liver", true, 5e-3, Area::inside_liver);
  return 0;
}
