// SPDX-License-Identifier: GPL-3.0-or-later
#include "overlay_blend.h"

#include <array>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "glisson/patient/label_map.h"
#include "glisson/ui/scene/pinhole_camera.h"

namespace glisson::scene {
namespace {

constexpr float kNothing = 1e9F;                ///< depth where nothing was drawn, metres
constexpr float kFullCoverage = 96.0F;          ///< the darkest shading of OverlayLayers, a little below
constexpr float kDepthStep = 3e-3F;             ///< metres; a larger step between neighbours is a silhouette
constexpr int kHatchPeriod = 7;                 ///< pixels
const cv::Vec3f kOutlineColour(235, 235, 235);  // blue, green, red

cv::Vec3f bgr(Label structure) {
  const std::array<double, 3> rgb = structure_colour(structure);
  return {static_cast<float>(255 * rgb[2]), static_cast<float>(255 * rgb[1]),
          static_cast<float>(255 * rgb[0])};
}

/// One layer as the distorted camera sees it.
struct BentLayer {
  cv::Mat3b shade;  ///< red, green, blue channels of the layer
  cv::Mat1f depth;  ///< metres along z
};

BentLayer bend(const Raster& raster, const cv::Mat1f& map_x, const cv::Mat1f& map_y) {
  BentLayer bent;
  if (raster.rgba.empty()) {
    bent.shade = cv::Mat3b::zeros(map_x.size());
    bent.depth = cv::Mat1f(map_x.size(), kNothing);
    return bent;
  }
  const cv::Mat rgba(raster.height, raster.width, CV_8UC4, const_cast<std::uint8_t*>(raster.rgba.data()));
  cv::Mat rgb;
  cv::cvtColor(rgba, rgb, cv::COLOR_RGBA2RGB);
  cv::remap(rgb, bent.shade, map_x, map_y, cv::INTER_LINEAR, cv::BORDER_CONSTANT, cv::Scalar());
  const cv::Mat1f depth(raster.height, raster.width, const_cast<float*>(raster.depth.data()));
  cv::remap(depth, bent.depth, map_x, map_y, cv::INTER_NEAREST, cv::BORDER_CONSTANT, cv::Scalar(1.0));
  bent.depth.forEach([](float& d, const int*) {
    d = d < 1.0F ? static_cast<float>(metric_depth(d, OverlayLayers::kNear, OverlayLayers::kFar)) : kNothing;
  });
  return bent;
}

void mix(cv::Vec3b& pixel, const cv::Vec3f& colour, float alpha) {
  for (int c = 0; c < 3; ++c)
    pixel[c] =
        cv::saturate_cast<std::uint8_t>((1.0F - alpha) * static_cast<float>(pixel[c]) + alpha * colour[c]);
}

/// Which of the three channels a pixel shows, -1: none.
int channel_at(const cv::Vec3b& shade) {
  const int sum = shade[0] + shade[1] + shade[2];
  if (sum < static_cast<int>(kFullCoverage) / 2) return -1;
  return shade[0] >= shade[1] && shade[0] >= shade[2] ? 0 : shade[1] >= shade[2] ? 1 : 2;
}

bool on_edge(const BentLayer& layer, int v, int u, int channel) {
  for (const auto& [dv, du] : {std::pair{0, 1}, {1, 0}, {0, -1}, {-1, 0}}) {
    const int y = v + dv, x = u + du;
    if (y < 0 || x < 0 || y >= layer.shade.rows || x >= layer.shade.cols) continue;
    if (channel_at(layer.shade(y, x)) != channel) return true;
    if (layer.depth(y, x) - layer.depth(v, u) > kDepthStep) return true;
  }
  return false;
}

void lay_vessels(cv::Mat3b& picture, const BentLayer& vessels, const BentLayer& liver,
                 const OverlayStyle& style) {
  const std::array<cv::Vec3f, 3> colours = {bgr(structure::kPortalVein), bgr(structure::kHepaticVeins),
                                            bgr(structure::kArtery)};
  const std::array<bool, 3> wanted = {style.portal_vein, style.hepatic_veins, style.arteries};
  const auto fade_depth = static_cast<float>(style.fade_depth), opacity = static_cast<float>(style.opacity);
  cv::parallel_for_(cv::Range(0, picture.rows), [&](const cv::Range& rows) {
    for (int v = rows.start; v < rows.end; ++v)
      for (int u = 0; u < picture.cols; ++u) {
        const int channel = channel_at(vessels.shade(v, u));
        if (channel < 0 || !wanted[static_cast<std::size_t>(channel)] || liver.depth(v, u) >= kNothing)
          continue;
        const cv::Vec3b& shade = vessels.shade(v, u);
        const float sum = static_cast<float>(shade[0] + shade[1] + shade[2]);
        const float below = std::max(0.0F, vessels.depth(v, u) - liver.depth(v, u));
        const float fade = 0.25F + 0.75F * std::exp(-below / fade_depth);
        const bool edge = on_edge(vessels, v, u, channel);
        // Hepatic veins are hatched: colour must not be the only cue.
        const bool gap = channel == 1 && !edge && (u + v) % kHatchPeriod >= kHatchPeriod / 2;
        const float alpha = opacity * fade *
                            (edge  ? 1.0F
                             : gap ? 0.3F
                                   : 0.75F) *
                            std::min(1.0F, sum / kFullCoverage);
        mix(picture(v, u),
            colours[static_cast<std::size_t>(channel)] * (edge ? 0.75F : 0.35F + 0.65F * sum / 255.0F),
            alpha);
      }
  });
}

void lay_lesions(cv::Mat3b& picture, const BentLayer& lesions, const BentLayer& liver) {
  const cv::Vec3f colour = bgr(structure::kFirstLesion);
  cv::Mat1b mask = cv::Mat1b::zeros(picture.size());
  for (int v = 0; v < picture.rows; ++v)
    for (int u = 0; u < picture.cols; ++u) {
      if (channel_at(lesions.shade(v, u)) < 0 || liver.depth(v, u) >= kNothing) continue;
      mask(v, u) = 255;
      const float value = static_cast<float>(lesions.shade(v, u)[0]) / 255.0F;
      mix(picture(v, u), colour * (0.4F + 0.6F * value), (u - v + 4096) % kHatchPeriod < 2 ? 0.45F : 0.22F);
    }
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(mask, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_SIMPLE);
  cv::polylines(picture, contours, true, cv::Scalar(20, 20, 20), 4, cv::LINE_AA);
  cv::polylines(picture, contours, true, cv::Scalar(colour), 2, cv::LINE_AA);
}

void lay_outline(cv::Mat3b& picture, const BentLayer& liver) {
  const cv::Mat1b mask = liver.depth < kNothing;
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(mask, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_SIMPLE);
  cv::Mat1b line = cv::Mat1b::zeros(picture.size());
  cv::polylines(line, contours, true, cv::Scalar(255), 1, cv::LINE_AA);
  for (int v = 1; v + 1 < picture.rows; ++v)
    for (int u = 1; u + 1 < picture.cols; ++u)  // the picture's own border is no outline
      if (line(v, u) != 0) mix(picture(v, u), kOutlineColour, 0.5F * static_cast<float>(line(v, u)) / 255.0F);
}

}  // namespace

Picture blend_layers(const Picture& frame, const LayerRasters& layers, const LensMaps& lens,
                     const OverlayStyle& style) {
  const cv::Mat source(frame.height, frame.width, frame.channels == 1 ? CV_8UC1 : CV_8UC3,
                       const_cast<std::uint8_t*>(frame.bytes->data()));
  auto bytes =
      std::make_shared<std::vector<std::uint8_t>>(static_cast<std::size_t>(3 * frame.width * frame.height));
  cv::Mat3b picture(frame.height, frame.width, reinterpret_cast<cv::Vec3b*>(bytes->data()));
  if (frame.channels == 1)
    cv::cvtColor(source, picture, cv::COLOR_GRAY2BGR);
  else
    source.copyTo(picture);
  const cv::Mat1f map_x(frame.height, frame.width, const_cast<float*>(lens.x.data()));
  const cv::Mat1f map_y(frame.height, frame.width, const_cast<float*>(lens.y.data()));
  const BentLayer liver = bend(layers.liver, map_x, map_y);
  lay_vessels(picture, bend(layers.vessels, map_x, map_y), liver, style);
  if (style.outline) lay_outline(picture, liver);
  if (style.lesions) lay_lesions(picture, bend(layers.lesions, map_x, map_y), liver);
  return {frame.width, frame.height, 3, bytes};
}

}  // namespace glisson::scene
