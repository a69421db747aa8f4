// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/mask_model.h"

#include "glisson/core/error.h"
#include "glisson/engine/commands/set_mask_network.h"
#include "glisson/engine/parts/live.h"
#include "glisson/network/mask_sheet.h"
#include "glisson/ui/common/error_texts.h"
#include "glisson/ui/common/user_settings.h"

namespace glisson::ui {
namespace {

const QString kKey = QStringLiteral("mask_network");

}  // namespace

MaskModel::MaskModel(EngineBridge& engine, PlaybackModel& playback, QObject* parent)
    : QObject(parent), engine_(engine), playback_(playback) {
  connect(&engine_, &EngineBridge::live_changed, this, &MaskModel::read_live);
  couplings_.add(playback_.is_playing, [this](bool is) {
    if (!is) say({});
  });
  const QString chosen = user_settings()->value(kKey).toString();
  playback_.mask_network = chosen;
  name = QString::fromStdString(std::filesystem::path(chosen.toStdString()).filename().string());
}

void MaskModel::choose(const std::filesystem::path& network) {
  try {
    (void)network::read_mask_sheet(network);
  } catch (const Error& problem) {
    return say(error_text(problem.what()), QStringLiteral("error"));
  }
  say({});
  std::error_code failure;
  const std::filesystem::path whole = std::filesystem::absolute(network, failure);
  use(QString::fromStdString((failure ? network : whole).string()));
}

void MaskModel::remove() {
  say({});
  use({});
}

void MaskModel::use(const QString& network) {
  playback_.mask_network = network;
  name = QString::fromStdString(std::filesystem::path(network.toStdString()).filename().string());
  const auto settings = user_settings();
  if (network.isEmpty())
    settings->remove(kKey);
  else
    settings->setValue(kKey, network);
  if (playback_.is_playing && engine_.snapshot()->tracking)
    engine_.post(engine::SetMaskNetwork{network.toStdString()});
}

void MaskModel::read_live() {
  const auto& live = engine_.state()[part::live];
  if (!live || !playback_.is_playing) return;
  if (live->mask)
    tell(*live);
  else if (tells_live_)
    say({});  // the network was removed
  tells_live_ = live->mask.has_value();
}

void MaskModel::tell(const engine::LiveState& live) {
  const engine::MaskStatus& mask = *live.mask;
  if (!mask.problem.empty())
    return say(
        tr("The mask network has failed; the organ is followed without it. %1").arg(error_text(mask.problem)),
        QStringLiteral("error"));
  if (!mask.age) return say(tr("The mask network has no mask yet; the organ is followed without it."));
  if (!mask.is_used)
    return say(tr("The mask network is too slow: its last mask is %1 s old and is not used.")
                   .arg(*mask.age, 0, 'f', 1),
               QStringLiteral("warning"));
  if (const auto& use = live.overlay.mask)
    say(tr("Masked of the organ in sight: %1 %. The mask is %2 ms old.")
            .arg(1e2 * use->share, 0, 'f', 0)
            .arg(1e3 * use->age, 0, 'f', 0),
        level_of(live.overlay.validity) == Level::valid ? QString() : QStringLiteral("warning"));
}

void MaskModel::say(const QString& text, const QString& how) {
  tone = how;
  said = text;
}

}  // namespace glisson::ui
