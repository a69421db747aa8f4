// SPDX-License-Identifier: GPL-3.0-or-later
#include "track_record.h"

#include <QRegularExpression>
#include <utility>

#include "glisson/core/files.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/experiments/evaluate.h"
#include "glisson/geometry/rigid.h"
#include "glisson/patient/label_map.h"
#include "glisson/patient/overlay_record.h"

namespace glisson::app {
namespace fs = std::filesystem;
namespace {

/// Those that are there already are replaced.
void append(Figures& figures, const Figures& more) {
  for (const auto& [key, value] : more) figures[key] = value;
}

QString numbered(const QString& pattern, int number) {
  static const QRegularExpression kNumber("%0?(\\d*)d");
  const QRegularExpressionMatch match = kNumber.match(pattern);
  QString name = pattern;
  return name.replace(match.capturedStart(), match.capturedLength(),
                      QString("%1").arg(number, match.captured(1).toInt(), 10, QChar('0')));
}

}  // namespace

TrackRecord::TrackRecord(Session& session, const ModelArgument& argument, const Arguments& arguments,
                         fs::path folder, int digits)
    : session_(session),
      argument_(argument),
      arguments_(arguments),
      folder_(std::move(folder)),
      digits_(digits),
      model_(session.state()[part::model]),
      evaluation_(model_->model, *session.state()[part::registration], 30.0) {}

void TrackRecord::add(int number, const OverlayFrame& overlay) {
  evaluation_.add(overlay);
  const std::string level = level_code(overlay.level()), reason = validity_code(overlay.validity);
  OverlayLine line;
  line.number = number;
  line.unit = argument_.unit;
  line.overlay = overlay;
  if (overlay.level() != Level::valid) session_.figures["frames_" + reason] += 1.0;
  for (const LesionVerdict& verdict : overlay.lesions) {
    const std::string lesion = structure_name(verdict.lesion);
    session_.figures[lesion + "_frames_" + level_code(verdict.level)] += 1.0;
  }
  if (overlay.nodes_in_camera.rows() > 0) {
    line.camera_from_model =
        fit_rigid<CameraFrame, CtFrame>(model_->model.mesh.vertices, overlay.nodes_in_camera).matrix();
    Eigen::Matrix4d pose = *line.camera_from_model;
    pose.topRightCorner<3, 1>() /= metres_per(argument_.unit);
    const auto mark = [](double value) { return Eigen::MatrixXd::Constant(1, 1, value); };
    // As the registration's doubts: what is said is a field's name.
    NamedArrays marks = {{"camera_from_model", pose},
                         {"frame", mark(number)},
                         {"level_" + level, mark(1.0)},
                         {"reason_" + reason, mark(1.0)}};
    if (overlay.doubtful) marks["doubtful"] = mark(1.0);
    line.mesh = QString("registered_%1.%2")
                    .arg(number, digits_, 10, QChar('0'))
                    .arg(argument_.surface ? "vtp" : "vtu")
                    .toStdString();
    write_mesh(line.mesh, overlay, marks);
    if (arguments_.has("truth")) compare(number, overlay);
  }
  lines_ += overlay_line(line) + "\n";
}

void TrackRecord::write_mesh(const std::string& name, const OverlayFrame& overlay,
                             const NamedArrays& marks) const {
  Registration registration = *session_.state()[part::registration];
  registration.nodes_in_camera = overlay.nodes_in_camera;
  registration.residual = overlay.residual;
  write_deformed(folder_ / name, argument_, session_, registration, marks);
}

void TrackRecord::finish(bool whole) {
  lines_ += overlay_record_end(whole, frames()) + "\n";
  write_file_atomically(folder_ / "frames.jsonl", lines_);
  session_.figures["complete"] = whole ? 1.0 : 0.0;
  append(session_.figures, evaluation_.times().counts());
  append(session_.figures, evaluation_.times().percentiles());
  append(session_.figures, evaluation_.displacement());
  if (!arguments_.has("truth")) return;
  append(session_.figures, evaluation_.errors());
  session_.figures["frames_compared"] = evaluation_.compared();
}

void TrackRecord::compare(int number, const OverlayFrame& overlay) {
  const fs::path path = numbered(arguments_.value("truth"), number).toStdString();
  if (!fs::exists(path)) return;  // truth may be given for some frames only
  const Points truth = experiments::read_true_nodes(path, argument_.unit);
  const Figures errors = evaluation_.compare(overlay, truth, path.string());
  const QString frame = QString("frame_%1_tre_volume_mean_mm").arg(number, digits_, 10, QChar('0'));
  session_.figures[frame.toStdString()] = errors.at("tre_volume_mean_mm");
}

}  // namespace glisson::app
