// SPDX-License-Identifier: GPL-3.0-or-later
#include "overlay_blend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/core/hal/intrin.hpp>
#include <opencv2/imgproc.hpp>

#include "glisson/patient/label_map.h"

namespace glisson::scene {
namespace {

constexpr float kDepthStep = 6e-3F;             ///< metres; a larger step between neighbours is a silhouette
constexpr int kHatchPeriod = 7;                 ///< pixels
constexpr float kBand = 10e-3F;                 ///< metres between lines of equal depth
constexpr float kDarkest = 60e-3F;              ///< metres below the surface; deeper is not drawn darker
constexpr float kDeepest = 0.6F;                ///< of a vessel's opacity that stays at any depth
constexpr int kBoldLine = 3;                    ///< pixels
const cv::Vec3f kOutlineColour(235, 235, 235);  // blue, green, red

cv::Vec3f bgr(Label structure) {
  const std::array<double, 3> rgb = structure_colour(structure);
  return {static_cast<float>(255 * rgb[2]), static_cast<float>(255 * rgb[1]),
          static_cast<float>(255 * rgb[0])};
}

cv::Rect rect_of(const PixelBox& box) { return {box.left, box.top, box.width, box.height}; }

/// Colours weighted by their opacity, and the opacity: what is to be laid over the frame at each pixel.
using Veil = cv::Mat4b;

cv::Vec4b veil_of(const cv::Vec3f& colour, float alpha) {
  const auto byte = [](float value) { return cv::saturate_cast<std::uint8_t>(value); };
  return {byte(alpha * colour[0]), byte(alpha * colour[1]), byte(alpha * colour[2]), byte(255.0F * alpha)};
}

/// Lays a colour over what is there.
void mix(cv::Vec4b& there, const cv::Vec3f& colour, float alpha) {
  for (int c = 0; c < 3; ++c)
    there[c] =
        cv::saturate_cast<std::uint8_t>((1.0F - alpha) * static_cast<float>(there[c]) + alpha * colour[c]);
  there[3] = cv::saturate_cast<std::uint8_t>((1.0F - alpha) * static_cast<float>(there[3]) + 255.0F * alpha);
}

/// Nothing shines through, for lines of OpenCV's.
cv::Scalar solid(double blue, double green, double red) { return {blue, green, red, 255.0}; }
cv::Scalar solid(const cv::Vec3f& colour) { return solid(colour[0], colour[1], colour[2]); }

/// A silhouette of the structure at this pixel: its neighbour shows another one, none, or one far behind.
bool on_edge(const SurfaceLayer& layer, int row, int column, std::size_t pixel) {
  const float farthest =
      1.0F / (layer.depth(pixel) + kDepthStep);  // inverse: one division for all neighbours
  for (const auto& [down, right] : {std::pair{0, 1}, {1, 0}, {0, -1}, {-1, 0}}) {
    const int y = row + down, x = column + right;
    if (y < 0 || x < 0 || y >= layer.height || x >= layer.width) continue;
    const std::size_t next = layer.at(y, x);
    if (layer.kind[next] != layer.kind[pixel] || layer.inverse_depth[next] < farthest) return true;
  }
  return false;
}

/// The window around what is looked at: 1 inside, 0 outside, smooth between.
class Window {
 public:
  Window(const SurfaceLayer& layer, const OverlayStyle& style, const std::optional<Eigen::Vector2d>& focus)
      : is_there_(style.look == Look::focus && focus.has_value()),
        radius_(static_cast<float>(style.window * layer.height)) {
    if (is_there_) centre_ = focus->cast<float>();
  }
  bool is_there() const { return is_there_; }
  float radius() const { return radius_; }
  const Eigen::Vector2f& centre() const { return centre_; }
  /// All that is inside, and its line.
  cv::Rect box() const {
    const int reach = static_cast<int>(std::ceil(radius_)) + 4;
    return {static_cast<int>(std::floor(centre_.x())) - reach,
            static_cast<int>(std::floor(centre_.y())) - reach, 2 * reach + 1, 2 * reach + 1};
  }
  float at(int row, int column) const {
    constexpr float kRim = 6.0F;  // pixels
    if (!is_there_) return 0.0F;
    const float distance =
        (Eigen::Vector2f(static_cast<float>(column), static_cast<float>(row)) - centre_).norm();
    return std::clamp((radius_ - distance) / kRim, 0.0F, 1.0F);
  }

 private:
  bool is_there_;
  float radius_;
  Eigen::Vector2f centre_ = Eigen::Vector2f::Zero();
};

/// Depth of a pixel's vessel below the liver's surface along the line of sight, metres.
float depth_below(const OverlayLayers& layers, std::size_t pixel) {
  return std::max(0.0F, layers.vessels.depth(pixel) - layers.liver.depth(pixel)) * layers.sight[pixel];
}

/// Whether a line of equal depth, two pixels wide, runs through this pixel.
bool on_contour(const OverlayLayers& layers, int row, int column, std::size_t pixel) {
  const SurfaceLayer& vessels = layers.vessels;
  const auto band = [&](std::size_t place) { return static_cast<int>(depth_below(layers, place) / kBand); };
  for (const auto& [down, right] : {std::pair{0, 1}, {1, 0}, {0, -1}, {-1, 0}}) {
    const int y = row + down, x = column + right;
    if (y < 0 || x < 0 || y >= vessels.height || x >= vessels.width) continue;
    const std::size_t next = vessels.at(y, x);
    if (vessels.kind[next] == vessels.kind[pixel] && layers.liver.kind[next] != 0 &&
        band(next) != band(pixel))
      return true;
  }
  return false;
}

/// One vessel's pixel.
class VesselInk {
 public:
  VesselInk(const OverlayLayers& layers, const OverlayStyle& style, const Window& window)
      : layers_(layers), style_(style), window_(window), opacity_(static_cast<float>(style.opacity)) {
    for (std::size_t i = 0; i < fades_.size(); ++i)
      fades_[i] = kDeepest + (1.0F - kDeepest) * std::exp(-(static_cast<float>(i) + 0.5F) * kFadeStep /
                                                          static_cast<float>(style.fade_depth));
  }

  cv::Vec4b at(int v, int u, std::size_t pixel) const {
    const SurfaceLayer& vessels = layers_.vessels;
    const float below = depth_below(layers_, pixel);
    const float fade = fades_[std::min(fades_.size() - 1, static_cast<std::size_t>(below / kFadeStep))];
    const bool edge = on_edge(vessels, v, u, pixel);
    const bool outlines_only = style_.look == Look::outlines || window_.is_there();
    // Hepatic veins are hatched: colour must not be the only cue.
    const bool gap = vessels.kind[pixel] == kHepatic && !edge && (u + v) % kHatchPeriod >= kHatchPeriod / 2;
    const float facing = static_cast<float>(vessels.facing[pixel]) / 255.0F;
    // What is deeper is darker.
    const float deep = std::min(1.0F, below / kDarkest);
    const float light = edge ? 1.25F : 0.5F + 0.7F * facing * facing;
    const cv::Vec3f colour = colours_[vessels.kind[pixel]] * light;
    if (style_.look == Look::contours && !edge) return contour(v, u, pixel, below, colour, fade, gap);
    const float body = outlines_only ? 0.0F : gap ? 0.3F : 0.8F;
    const cv::Vec4b outside = veil_of(colour * (1.0F - 0.3F * deep), opacity_ * fade * (edge ? 1.0F : body));
    const float inside = window_.at(v, u);
    if (inside <= 0.0F) return outside;
    // Nothing shines through.
    const cv::Vec4b solid = veil_of(colour * ((1.0F - 0.6F * deep) * (gap ? 0.65F : 1.0F)), 0.97F);
    return solid * inside + outside * (1.0F - inside);
  }

 private:
  cv::Vec4b contour(int v, int u, std::size_t pixel, float below, const cv::Vec3f& colour, float fade,
                    bool gap) const {
    if (on_contour(layers_, v, u, pixel)) return veil_of({15, 15, 15}, 0.9F);
    const bool is_odd = static_cast<int>(below / kBand) % 2 == 1;
    return veil_of(colour * (is_odd ? 0.6F : 1.1F), opacity_ * fade * (gap ? 0.4F : 0.9F));
  }

  const OverlayLayers& layers_;
  const OverlayStyle& style_;
  const Window& window_;
  float opacity_;
  /// By depth. A tenth of a millimetre is nothing that the picture's grey levels could show.
  static constexpr float kFadeStep = 1e-4F;
  std::array<float, 2048> fades_{};
  std::array<cv::Vec3f, 4> colours_ = {cv::Vec3f(), bgr(structure::kPortalVein),
                                       bgr(structure::kHepaticVeins), bgr(structure::kArtery)};
};

/// Of the part `box` of the picture.
Veil vessel_veil(const OverlayLayers& layers, const OverlayStyle& style, const Window& window,
                 const cv::Rect& box) {
  const SurfaceLayer& vessels = layers.vessels;
  const VesselInk ink(layers, style, window);
  Veil veil = Veil::zeros(box.size());
  cv::parallel_for_(cv::Range(0, box.height), [&](const cv::Range& rows) {
    for (int v = rows.start; v < rows.end; ++v)
      for (int u = 0; u < box.width; ++u) {
        const std::size_t pixel = vessels.at(box.y + v, box.x + u);
        if (vessels.kind[pixel] != kNoVessel && layers.liver.kind[pixel] != 0)
          veil(v, u) = ink.at(box.y + v, box.x + u, pixel);
      }
  });
  cv::GaussianBlur(veil, veil, {3, 3}, 0.7, 0.7);  // smooth edges
  return veil;
}

/// Inside the window tissue steps back: what is drawn there lies in it, not on it.
void open_window(Veil& veil, const OverlayLayers& layers, const Window& window) {
  if (!window.is_there()) return;
  const cv::Rect box = window.box() & cv::Rect(0, 0, veil.cols, veil.rows);
  for (int v = box.y; v < box.y + box.height; ++v)
    for (int u = box.x; u < box.x + box.width; ++u)
      if (layers.liver.kind[layers.liver.at(v, u)] != 0) mix(veil(v, u), {0, 0, 0}, 0.45F * window.at(v, u));
  const cv::Point centre(cvRound(window.centre().x()), cvRound(window.centre().y()));
  cv::circle(veil, centre, cvRound(window.radius()), solid(20, 20, 20), 3, cv::LINE_AA);
  cv::circle(veil, centre, cvRound(window.radius()), solid(200, 200, 200), 1, cv::LINE_AA);
}

/// What remains of a value below something of that opacity.
int shining_through(int value, int opacity) { return ((255 - opacity) * value + 127) / 255; }

/// The same of sixteen values at once, with what lies over them. Dividing by 255 is two shifts: exact up to
/// 2^16.
cv::v_uint8x16 laid(const cv::v_uint8x16& value, const cv::v_uint8x16& over, const cv::v_uint8x16& through) {
  const auto shine = [](const cv::v_uint16x8& product) {
    const cv::v_uint16x8 sum = product + cv::v_setall_u16(127);
    return (sum + cv::v_setall_u16(1) + (sum >> 8)) >> 8;
  };
  cv::v_uint16x8 low, high;
  cv::v_mul_expand(value, through, low, high);
  return cv::v_pack(shine(low), shine(high)) + over;
}

/// As many pixels of a row as go in sixteens. @return how many.
template <class Pixel>
int lay_wide(Pixel* below, const cv::Vec4b* veil, int count) {
  constexpr int kAtOnce = 16;
  int u = 0;
  for (; u + kAtOnce <= count; u += kAtOnce) {
    cv::v_uint8x16 blue, green, red, opacity, b, g, r, a;
    cv::v_load_deinterleave(veil[u].val, blue, green, red, opacity);
    if (!cv::v_check_any(opacity != cv::v_setzero_u8())) continue;
    const cv::v_uint8x16 through = cv::v_setall_u8(255) - opacity;
    if constexpr (Pixel::channels == 3) {
      cv::v_load_deinterleave(below[u].val, b, g, r);
      cv::v_store_interleave(below[u].val, laid(b, blue, through), laid(g, green, through),
                             laid(r, red, through));
    } else {
      cv::v_load_deinterleave(below[u].val, b, g, r, a);
      cv::v_store_interleave(below[u].val, laid(b, blue, through), laid(g, green, through),
                             laid(r, red, through), laid(a, opacity, through));
    }
  }
  return u;
}

/// @param Pixel of a picture, or of a veil, whose opacity grows by the same rule.
template <class Pixel>
void lay(cv::Mat_<Pixel> below, const Veil& veil) {
  cv::parallel_for_(cv::Range(0, below.rows), [&](const cv::Range& rows) {
    for (int v = rows.start; v < rows.end; ++v)
      for (int u = lay_wide(below[v], veil[v], below.cols); u < below.cols; ++u) {
        const cv::Vec4b& over = veil(v, u);
        if (over[3] == 0) continue;
        Pixel& pixel = below(v, u);
        for (int c = 0; c < Pixel::channels; ++c)
          pixel[c] = static_cast<std::uint8_t>(std::min(255, shining_through(pixel[c], over[3]) + over[c]));
      }
  });
}

/// Whether a vessel hides a lesion here: in the window things stand one behind the other.
bool is_hidden(const OverlayLayers& layers, std::size_t pixel) {
  return layers.vessels.kind[pixel] != kNoVessel &&
         layers.vessels.inverse_depth[pixel] > layers.lesions.inverse_depth[pixel];
}

/// One pass over the picture. @return where each lesion is seen, by its label.
std::array<cv::Rect, 256> lay_bodies(Veil& veil, const OverlayLayers& layers, const Window& window) {
  std::array<cv::Rect, 256> seen{};
  const SurfaceLayer& lesions = layers.lesions;
  const PixelBox& touched = lesions.touched;
  for (int v = touched.top; v < touched.bottom(); ++v)
    for (int u = touched.left; u < touched.right(); ++u) {
      const std::size_t pixel = lesions.at(v, u);
      if (lesions.kind[pixel] == 0 || layers.liver.kind[pixel] == 0) continue;
      cv::Rect& box = seen[lesions.kind[pixel]];
      box = box.empty() ? cv::Rect(u, v, 1, 1) : (box | cv::Rect(u, v, 1, 1));
      const float facing = static_cast<float>(lesions.facing[pixel]) / 255.0F;
      const float inside = window.at(v, u);
      const float veiled = (u - v + 4096) % kHatchPeriod < 2 ? 0.45F : 0.22F;
      const float solid = is_hidden(layers, pixel) ? 0.0F : 0.85F;
      mix(veil(v, u), bgr(lesions.kind[pixel]) * (0.6F + 0.4F * facing),
          inside * solid + (1.0F - inside) * veiled);
    }
  return seen;
}

void lay_lesions(Veil& veil, const OverlayLayers& layers, const Window& window) {
  const std::array<cv::Rect, 256> seen = lay_bodies(veil, layers, window);
  const SurfaceLayer& lesions = layers.lesions;
  for (std::size_t lesion = 1; lesion < seen.size(); ++lesion) {
    const cv::Rect& box = seen[lesion];
    if (box.empty()) continue;
    cv::Mat1b mask(box.size());
    for (int v = 0; v < box.height; ++v)
      for (int u = 0; u < box.width; ++u) {
        const std::size_t pixel = lesions.at(box.y + v, box.x + u);
        mask(v, u) = lesions.kind[pixel] == lesion && layers.liver.kind[pixel] != 0 ? 255 : 0;
      }
    std::vector<std::vector<cv::Point>> contours;
    cv::findContours(mask, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_SIMPLE, box.tl());
    cv::polylines(veil, contours, true, solid(20, 20, 20), 4, cv::LINE_AA);
    cv::polylines(veil, contours, true, solid(bgr(static_cast<Label>(lesion))), 2, cv::LINE_AA);
  }
}

void lay_outline(Veil& veil, const SurfaceLayer& liver, bool is_bold) {
  const cv::Mat1b mask(liver.height, liver.width, const_cast<std::uint8_t*>(liver.kind.data()));
  // With room for a smooth line's width.
  const cv::Rect box = rect_of(liver.touched.around(kBoldLine + 2, liver.width, liver.height));
  if (box.empty()) return;
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(mask(box), contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_SIMPLE, box.tl());
  const cv::Rect inside = box & cv::Rect(1, 1, veil.cols - 2, veil.rows - 2);
  const auto draw = [&](int width, const cv::Vec3f& colour, float opacity) {
    cv::Mat1b line = cv::Mat1b::zeros(veil.size());
    cv::polylines(line, contours, true, cv::Scalar(255), width, cv::LINE_AA);
    for (int v = inside.y; v < inside.y + inside.height; ++v)
      for (int u = inside.x; u < inside.x + inside.width; ++u)  // the picture's own border is no outline
        if (line(v, u) != 0) mix(veil(v, u), colour, opacity * static_cast<float>(line(v, u)) / 255.0F);
  };
  if (!is_bold) return draw(1, kOutlineColour, 0.5F);
  draw(kBoldLine + 2, {20, 20, 20}, 0.6F);
  draw(kBoldLine, kOutlineColour, 0.9F);
}

}  // namespace

void blend_layers(Canvas& frame, OverlayLayers& layers, const OverlayStyle& style,
                  const std::optional<Eigen::Vector2d>& focus) {
  const int width = layers.liver.width, height = layers.liver.height, times = frame.width / width;
  cv::Mat3b picture(frame.height, frame.width, reinterpret_cast<cv::Vec3b*>(frame.bytes->data()));
  layers.veil.assign(4 * layers.liver.kind.size(), 0);
  Veil veil(height, width, reinterpret_cast<cv::Vec4b*>(layers.veil.data()));
  std::optional<Eigen::Vector2d> reduced_focus;
  if (focus) reduced_focus = ((focus->array() + 0.5) / times - 0.5).matrix();
  const Window window(layers.liver, style, reduced_focus);
  open_window(veil, layers, window);
  // With room for the smoothing.
  const cv::Rect vessels = rect_of(layers.vessels.touched.around(3, width, height));
  if (!vessels.empty()) lay<cv::Vec4b>(veil(vessels), vessel_veil(layers, style, window, vessels));
  if (style.outline) lay_outline(veil, layers.liver, style.bold_outline);
  lay_lesions(veil, layers, window);
  // All that was drawn: within the liver and its lines, or the window.
  cv::Rect drawn = rect_of(layers.liver.touched.around(kBoldLine + 2, width, height));
  if (window.is_there()) drawn |= window.box() & cv::Rect(0, 0, width, height);
  if (drawn.empty()) return;
  if (times == 1) return lay<cv::Vec3b>(picture(drawn), veil(drawn));
  Veil grown;
  cv::resize(veil(drawn), grown, drawn.size() * times, 0.0, 0.0, cv::INTER_LINEAR);
  lay<cv::Vec3b>(picture(cv::Rect(drawn.tl() * times, grown.size())), grown);
}

}  // namespace glisson::scene
