// SPDX-License-Identifier: GPL-3.0-or-later
#include "overlay_blend.h"

#include <array>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "glisson/patient/label_map.h"

namespace glisson::scene {
namespace {

constexpr float kDepthStep = 6e-3F;             ///< metres; a larger step between neighbours is a silhouette
constexpr int kHatchPeriod = 7;                 ///< pixels
constexpr float kDeepest = 0.35F;               ///< of a vessel's opacity that stays at any depth
const cv::Vec3f kOutlineColour(235, 235, 235);  // blue, green, red

cv::Vec3f bgr(Label structure) {
  const std::array<double, 3> rgb = structure_colour(structure);
  return {static_cast<float>(255 * rgb[2]), static_cast<float>(255 * rgb[1]),
          static_cast<float>(255 * rgb[0])};
}

/// Colours weighted by their opacity, and the opacity: what is to be laid over the frame at each pixel.
using Veil = cv::Mat4b;

cv::Vec4b veil_of(const cv::Vec3f& colour, float alpha) {
  const auto byte = [](float value) { return cv::saturate_cast<std::uint8_t>(value); };
  return {byte(alpha * colour[0]), byte(alpha * colour[1]), byte(alpha * colour[2]), byte(255.0F * alpha)};
}

void mix(cv::Vec3b& pixel, const cv::Vec3f& colour, float alpha) {
  for (int c = 0; c < 3; ++c)
    pixel[c] =
        cv::saturate_cast<std::uint8_t>((1.0F - alpha) * static_cast<float>(pixel[c]) + alpha * colour[c]);
}

/// A silhouette of the structure at this pixel: its neighbour shows another one, none, or one far behind.
bool on_edge(const SurfaceLayer& layer, int row, int column, std::size_t pixel) {
  const float here = layer.depth(pixel);
  for (const auto& [down, right] : {std::pair{0, 1}, {1, 0}, {0, -1}, {-1, 0}}) {
    const int y = row + down, x = column + right;
    if (y < 0 || x < 0 || y >= layer.height || x >= layer.width) continue;
    const std::size_t next = layer.at(y, x);
    if (layer.kind[next] != layer.kind[pixel] || layer.depth(next) - here > kDepthStep) return true;
  }
  return false;
}

Veil vessel_veil(const OverlayLayers& layers, const OverlayStyle& style) {
  const std::array<cv::Vec3f, 4> colours = {cv::Vec3f(), bgr(structure::kPortalVein),
                                            bgr(structure::kHepaticVeins), bgr(structure::kArtery)};
  const auto fade_depth = static_cast<float>(style.fade_depth), opacity = static_cast<float>(style.opacity);
  const SurfaceLayer& vessels = layers.vessels;
  Veil veil = Veil::zeros(vessels.height, vessels.width);
  cv::parallel_for_(cv::Range(0, vessels.height), [&](const cv::Range& rows) {
    for (int v = rows.start; v < rows.end; ++v)
      for (int u = 0; u < vessels.width; ++u) {
        const std::size_t pixel = vessels.at(v, u);
        if (vessels.kind[pixel] == kNoVessel || layers.liver.kind[pixel] == 0) continue;
        const float below = std::max(0.0F, vessels.depth(pixel) - layers.liver.depth(pixel));
        const float fade = kDeepest + (1.0F - kDeepest) * std::exp(-below / fade_depth);
        const bool edge = on_edge(vessels, v, u, pixel);
        // Hepatic veins are hatched: colour must not be the only cue.
        const bool gap =
            vessels.kind[pixel] == kHepatic && !edge && (u + v) % kHatchPeriod >= kHatchPeriod / 2;
        const float alpha = opacity * fade * (edge ? 1.0F : gap ? 0.3F : 0.8F);
        const float facing = static_cast<float>(vessels.facing[pixel]) / 255.0F;
        const cv::Vec3f colour =
            colours[vessels.kind[pixel]] * (edge ? 1.25F : 0.7F + 0.5F * facing * facing);
        veil(v, u) = veil_of(colour, alpha);
      }
  });
  cv::GaussianBlur(veil, veil, {3, 3}, 0.7, 0.7);  // smooth edges
  return veil;
}

void lay(cv::Mat3b& picture, const Veil& veil) {
  cv::parallel_for_(cv::Range(0, picture.rows), [&](const cv::Range& rows) {
    for (int v = rows.start; v < rows.end; ++v)
      for (int u = 0; u < picture.cols; ++u) {
        const cv::Vec4b& over = veil(v, u);
        if (over[3] == 0) continue;
        for (int c = 0; c < 3; ++c) {
          const int below = ((255 - over[3]) * picture(v, u)[c] + 127) / 255;
          picture(v, u)[c] = static_cast<std::uint8_t>(std::min(255, below + over[c]));
        }
      }
  });
}

void lay_lesion(cv::Mat3b& picture, const OverlayLayers& layers, std::uint8_t lesion) {
  const cv::Vec3f colour = bgr(lesion);
  const SurfaceLayer& lesions = layers.lesions;
  cv::Mat1b mask = cv::Mat1b::zeros(picture.size());
  for (int v = 0; v < picture.rows; ++v)
    for (int u = 0; u < picture.cols; ++u) {
      const std::size_t pixel = lesions.at(v, u);
      if (lesions.kind[pixel] != lesion || layers.liver.kind[pixel] == 0) continue;
      mask(v, u) = 255;
      const float facing = static_cast<float>(lesions.facing[pixel]) / 255.0F;
      mix(picture(v, u), colour * (0.6F + 0.4F * facing), (u - v + 4096) % kHatchPeriod < 2 ? 0.45F : 0.22F);
    }
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(mask, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_SIMPLE);
  cv::polylines(picture, contours, true, cv::Scalar(20, 20, 20), 4, cv::LINE_AA);
  cv::polylines(picture, contours, true, cv::Scalar(colour), 2, cv::LINE_AA);
}

void lay_lesions(cv::Mat3b& picture, const OverlayLayers& layers) {
  std::array<bool, 256> there{};
  for (const std::uint8_t kind : layers.lesions.kind) there[kind] = true;
  for (std::size_t lesion = 1; lesion < there.size(); ++lesion)
    if (there[lesion]) lay_lesion(picture, layers, static_cast<std::uint8_t>(lesion));
}

void lay_outline(cv::Mat3b& picture, const SurfaceLayer& liver) {
  const cv::Mat1b mask(liver.height, liver.width, const_cast<std::uint8_t*>(liver.kind.data()));
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(mask, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_SIMPLE);
  cv::Mat1b line = cv::Mat1b::zeros(picture.size());
  cv::polylines(line, contours, true, cv::Scalar(255), 1, cv::LINE_AA);
  for (int v = 1; v + 1 < picture.rows; ++v)
    for (int u = 1; u + 1 < picture.cols; ++u)  // the picture's own border is no outline
      if (line(v, u) != 0) mix(picture(v, u), kOutlineColour, 0.5F * static_cast<float>(line(v, u)) / 255.0F);
}

}  // namespace

Picture blend_layers(const Picture& frame, const OverlayLayers& layers, const OverlayStyle& style) {
  const cv::Mat source(frame.height, frame.width, frame.channels == 1 ? CV_8UC1 : CV_8UC3,
                       const_cast<std::uint8_t*>(frame.bytes->data()));
  auto bytes =
      std::make_shared<std::vector<std::uint8_t>>(static_cast<std::size_t>(3 * frame.width * frame.height));
  cv::Mat3b picture(frame.height, frame.width, reinterpret_cast<cv::Vec3b*>(bytes->data()));
  if (frame.channels == 1)
    cv::cvtColor(source, picture, cv::COLOR_GRAY2BGR);
  else
    source.copyTo(picture);
  lay(picture, vessel_veil(layers, style));
  if (style.outline) lay_outline(picture, layers.liver);
  lay_lesions(picture, layers);
  return {frame.width, frame.height, 3, bytes};
}

}  // namespace glisson::scene
