// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/tool_model.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "glisson/core/error.h"
#include "glisson/engine/parts/live.h"
#include "glisson/patient/label_map.h"
#include "glisson/ui/common/error_texts.h"
#include "glisson/ui/common/texts.h"

namespace glisson::ui {
namespace {

constexpr int kLook = 100;  ///< milliseconds from one look at the tool to the next
/// Seconds; an older pose says nothing of where the tool is now, nor an older frame of where the organ is.
constexpr double kFreshPose = 0.5;

std::unique_ptr<guidance::ToolMeter> meter_of(const scene::DrawableModel& drawable) {
  guidance::CarriedSurface organ;
  std::vector<guidance::CarriedSurface> lesions;
  for (const scene::DrawableSurface& surface : drawable.surfaces) {
    if (surface.binding.tetrahedron.empty()) continue;
    guidance::CarriedSurface carried{surface.structure, surface.mesh, surface.binding};
    if (surface.structure == structure::kParenchyma)
      organ = std::move(carried);
    else if (is_lesion(surface.structure))
      lesions.push_back(std::move(carried));
  }
  if (organ.mesh.triangle_count() == 0) return nullptr;
  return std::make_unique<guidance::ToolMeter>(*drawable.model, std::move(organ), std::move(lesions));
}

}  // namespace

ToolModel::ToolModel(EngineBridge& engine, DrawableSource& drawables, PlaybackModel& playback,
                     ReviewModel& review, LiveViewModel& live, QObject* parent)
    : QObject(parent),
      engine_(engine),
      drawables_(drawables),
      playback_(playback),
      review_(review),
      live_(live) {
  connect(&looks_, &QTimer::timeout, this, &ToolModel::look);
  connect(&engine_, &EngineBridge::live_changed, this, &ToolModel::read_live);
}

ToolModel::~ToolModel() = default;

void ToolModel::switch_on(const QString& address) {
  switch_off();
  try {
    receiver_ =
        std::make_unique<openigtlink::Receiver>(openigtlink::parse_tool(address.trimmed().toStdString()));
  } catch (const Error& failure) {
    return say(error_text(failure.what()), QStringLiteral("error"));
  }
  is_on = true;
  looks_.start(kLook);
  look();
}

void ToolModel::switch_off() {
  looks_.stop();
  if (receiver_) live_.touch({});
  receiver_.reset();
  meter_.reset();
  measured_.reset();
  is_on = false;
  say({}, {});
}

void ToolModel::look() {
  const auto tool = receiver_->tool();
  switch (receiver_->connection()) {
    case openigtlink::Connection::failed: {
      const QString why = error_text(receiver_->problem().c_str());
      switch_off();
      return say(why, QStringLiteral("error"));
    }
    case openigtlink::Connection::ended:
      switch_off();
      return say(tr("The server has closed the connection."), QStringLiteral("error"));
    case openigtlink::Connection::waiting:
      return say(tr("Connecting…"), QStringLiteral("warning"));
    case openigtlink::Connection::connected:
      break;
  }
  if (tool && tool->age <= kFreshPose) return tell(*tool);
  live_.touch({});
  say(tool ? tr("The tool's pose is %1 s old: it is not used.").arg(tool->age, 0, 'f', 1)
           : tr("Connected; no pose of this tool has come."),
      QStringLiteral("warning"));
}

QString ToolModel::not_followed() {
  return tr("The tool's pose comes in; the organ is not followed just now.");
}

/// Corrections change the live part, too, and make its frame no younger.
void ToolModel::read_live() {
  const auto& live = engine_.state()[part::live];
  if (!live) return frame_.reset();
  const std::pair frame(live->overlay.index, live->overlay.seconds);
  if (frame_ == frame) return;
  frame_ = frame;
  taken_ = playback_.feed().sent_at(live->overlay.index);
}

QString ToolModel::why_not_now() const {
  if (review_.is_reviewing || live_.shows_kept())
    return tr("The tool's pose comes in; a former moment is on the screen, and nothing is told of it.");
  if (playback_.is_paused) return tr("The tool's pose comes in; the video is paused.");
  if (!frame_ || !taken_ || !engine_.snapshot()->tracking) return not_followed();
  const double age = std::chrono::duration<double>(VideoFeed::Clock::now() - *taken_).count();
  if (age <= kFreshPose) return {};
  return tr("The tool's pose comes in; the last picture is %1 s old: it is not used.").arg(age, 0, 'f', 1);
}

guidance::ToolMeter* ToolModel::meter() {
  const engine::Snapshot& now = *engine_.snapshot();
  const auto& live = now.state[part::live];
  const auto& drawable = drawables_.drawable();
  if (!live || !drawable || now.stage(part::live) == engine::StageState::stale ||
      live->overlay.level() == Level::withdrawn ||
      live->overlay.nodes_in_camera.rows() != drawable->model->mesh.vertex_count())
    return nullptr;
  if (measured_ != drawable) {
    meter_ = meter_of(*drawable);
    measured_ = drawable;
  }
  if (meter_) meter_->move(live->overlay.nodes_in_camera);
  return meter_.get();
}

void ToolModel::tell(const openigtlink::ReceivedTool& tool) {
  QString why = why_not_now();
  const guidance::ToolMeter* now = why.isEmpty() ? meter() : nullptr;
  if (now == nullptr) {
    live_.touch({});
    if (why.isEmpty()) why = not_followed();
    return say(why, QStringLiteral("warning"));
  }
  const Label lesion = live_.chosen;
  const guidance::ToolMeasures measures = now->measure(tool.camera_from_tool.translation, lesion);
  live_.touch(measures.touched);
  const OverlayFrame& overlay = engine_.state()[part::live]->overlay;
  bool is_rough = overlay.level() != Level::valid;
  const auto length = [](double metres, int decimals) {
    return tr("%1 mm").arg(1e3 * metres, 0, 'f', decimals);
  };
  QString text = (measures.is_inside ? tr("Tip inside the organ, %1 below its surface")
                                     : tr("Tip to the organ's surface: %1"))
                     .arg(length(measures.to_surface, is_rough ? 0 : 1));
  const auto verdict = std::find_if(overlay.lesions.begin(), overlay.lesions.end(),
                                    [&](const LesionVerdict& one) { return one.lesion == lesion; });
  const bool is_shown = verdict != overlay.lesions.end() && verdict->level != Level::withdrawn;
  if (is_shown && !std::isnan(measures.to_lesion)) {
    is_rough = is_rough || verdict->level != Level::valid;
    QString distance = length(measures.to_lesion, is_rough ? 0 : 1);
    if (is_rough && verdict->reach > 0.0) distance = tr("%1 (±%2)").arg(distance, length(verdict->reach, 0));
    text += QLatin1Char('\n') + tr("Tip to %1: %2").arg(structure_text(lesion), distance);
  }
  say(text, is_rough ? QStringLiteral("warning") : QStringLiteral("good"));
}

void ToolModel::say(const QString& text, const QString& how) {
  tone = how;
  said = text;
}

}  // namespace glisson::ui
