// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/rival_pictures.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QPainter>
#include <QTimer>
#include <QToolButton>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>

#include "glisson/engine/commands/choose_rival.h"
#include "glisson/engine/obstacle.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/ui/common/texts.h"
#include "glisson/ui/scene/picture_image.h"

namespace glisson::ui {
namespace {

constexpr QSize kSize(100, 62);
constexpr int kFiner = 2;  ///< drawn so much larger, then made smaller
const QColor kOrgan(86, 180, 233), kPoints(240, 228, 66);

/// Where a place before the camera comes to lie in a picture; empty: the lens does not map it.
using Projection = std::function<std::optional<QPointF>(const Eigen::Vector3d&)>;

/// As the left camera sees it, its picture cut to the size's shape.
QImage beneath(const engine::StereoInput& input, const Camera& camera, const QSize& size,
               Projection& projection) {
  const QImage whole = scene::copy_to_image(input.frame.left);
  const double scale = std::max(size.width() / static_cast<double>(whole.width()),
                                size.height() / static_cast<double>(whole.height()));
  const QImage scaled = whole.scaled(QSize(static_cast<int>(std::ceil(scale * whole.width())),
                                           static_cast<int>(std::ceil(scale * whole.height()))),
                                     Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  const QPoint cut((scaled.width() - size.width()) / 2, (scaled.height() - size.height()) / 2);
  projection = [camera, scale, cut](const Eigen::Vector3d& p) -> std::optional<QPointF> {
    if (!camera.maps(p)) return {};
    const Eigen::Vector2d pixel = scale * camera.project(p);
    return QPointF(pixel.x(), pixel.y()) - cut;
  };
  return scaled.copy(QRect(cut, size));
}

/// Without a picture: along the sight, so that all places and the points are in it.
QImage empty_one(const Registration& registration, const Points& cloud, const QSize& size,
                 Projection& projection) {
  Eigen::AlignedBox2d all;
  const auto add = [&all](const Points& points) {
    for (Eigen::Index i = 0; i < points.rows(); ++i) all.extend(points.row(i).head<2>().transpose());
  };
  add(registration.nodes_in_camera);
  add(cloud);
  for (const RegistrationRival& rival : registration.rivals) add(rival.nodes_in_camera);
  const double scale = 0.94 * std::min(size.width() / all.sizes().x(), size.height() / all.sizes().y());
  const Eigen::Vector2d middle = all.center();
  projection = [scale, middle, size](const Eigen::Vector3d& p) -> std::optional<QPointF> {
    const Eigen::Vector2d at = scale * (p.head<2>() - middle);
    return QPointF(size.width() / 2.0 + at.x(), size.height() / 2.0 + at.y());
  };
  QImage image(size, QImage::Format_RGB32);
  image.fill(QColor(16, 19, 24));
  QPainter painter(&image);
  painter.setPen(QPen(kPoints, 2.0));
  for (Eigen::Index i = 0; i < cloud.rows(); ++i)
    if (const auto at = projection(cloud.row(i).transpose())) painter.drawPoint(*at);
  return image;
}

/// The organ's outline, filled: which of its triangles lies before which does not show.
QImage silhouette(const BoundarySurface& surface, const Points& nodes, const QSize& size,
                  const Projection& projection) {
  QImage image(size, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  painter.setPen(QPen(kOrgan, 1.0));  // no seams
  painter.setBrush(kOrgan);
  for (int t = 0; t < surface.mesh.triangle_count(); ++t) {
    QPolygonF corners;
    for (int k = 0; k < 3; ++k) {
      const int node = surface.node_of_vertex[static_cast<std::size_t>(surface.mesh.triangles(t, k))];
      if (const auto at = projection(nodes.row(node).transpose())) corners << *at;
    }
    if (corners.size() == 3) painter.drawPolygon(corners);
  }
  return image;
}

}  // namespace

RivalPictures::RivalPictures(EngineBridge& engine, RegistrationModel& model, QWidget* parent)
    : QWidget(parent), engine_(engine), model_(model) {
  setObjectName(QStringLiteral("rival_pictures"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  for (std::size_t k = 0; k < kMost; ++k) {
    auto* button = new QToolButton(this);
    button->setObjectName(QStringLiteral("take_rival_%1").arg(k + 1));
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setIconSize(kSize);
    row->addWidget(button);
    connect(button, &QToolButton::clicked, this, [this, k] { take(k); });
    buttons_[k] = button;
  }
  row->addStretch(1);
  connect(&engine_, &EngineBridge::case_changed, this, &RivalPictures::show_case);
  connect(&engine_, &EngineBridge::finished, this, &RivalPictures::finish);
  couplings_.add(model.rival_words, [this](const QStringList& words) {
    for (std::size_t k = 0; k < kMost; ++k) {
      buttons_[k]->setVisible(static_cast<int>(k) < words.size());
      buttons_[k]->setText(words.value(static_cast<int>(k)));
    }
    setVisible(!words.isEmpty());
    show_case();
  });
  couplings_.add(model.is_being_made, [this](bool) { show_case(); });
}

void RivalPictures::take(std::size_t rival) {
  if (taking_ || !shown_) return;
  taking_ = engine_.post(engine::ChooseRival{rival, shown_});
  show_case();
}

void RivalPictures::finish(const engine::Outcome& outcome) {
  if (outcome.id != taking_) return;
  QTimer::singleShot(QApplication::doubleClickInterval(), this, [this] {
    taking_.reset();
    show_case();
  });
}

QString RivalPictures::obstacle() const {
  if (taking_) return tr("A place is being taken.");
  if (model_.is_being_made) return RegistrationModel::wait_words();
  return obstacle_text(engine::obstacle(engine_.state(), engine::ChooseRival{}));
}

void RivalPictures::show_case() {
  const engine::CaseState& now = engine_.state();
  const auto& registration = now[part::registration];
  const QString why_not = obstacle();
  for (QToolButton* button : buttons_) {
    button->setEnabled(why_not.isEmpty());
    button->setToolTip(why_not.isEmpty() ? tr("The organ lies here: take this place") : why_not);
  }
  const bool is_shown = registration == shown_ && now[part::frame] == frame_;
  if (is_shown || !registration || registration->rivals.empty() || !now[part::model]) return;
  const BoundarySurface& surface = now[part::model]->model.surface;
  if (registration->nodes_in_camera.rows() != now[part::model]->model.mesh.vertex_count()) return;
  shown_ = registration;
  frame_ = now[part::frame];
  const QSize size = kFiner * kSize;
  Projection projection;
  const Points cloud = now[part::cloud] ? now[part::cloud]->points : Points(0, 3);
  const QImage below = now[part::frame] && now[part::rig]
                           ? beneath(*now[part::frame], now[part::rig]->left, size, projection)
                           : empty_one(*registration, cloud, size, projection);
  for (std::size_t k = 0; k < std::min(kMost, registration->rivals.size()); ++k) {
    QImage image = below;
    QPainter painter(&image);
    painter.setOpacity(0.55);
    painter.drawImage(0, 0, silhouette(surface, registration->rivals[k].nodes_in_camera, size, projection));
    painter.end();
    buttons_[k]->setIcon(
        QPixmap::fromImage(image.scaled(kSize, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)));
  }
}

}  // namespace glisson::ui
