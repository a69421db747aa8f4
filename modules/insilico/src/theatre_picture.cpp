// SPDX-License-Identifier: GPL-3.0-or-later
#include "theatre_picture.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>

#include "rows.h"

#include "glisson/core/statistics.h"

namespace glisson::insilico {
namespace {

constexpr int kFilmSteps = 4096;
constexpr float kFilmRange = 9.0F;  // light beyond it is white
constexpr float kGamma = 1.0F / 2.2F;
constexpr float kLiverLevel = 0.50F;  // of full scale, where the liver's median red comes to lie

/// The curve of the film: a soft shoulder, then gamma.
float develop(float light) { return std::pow(1.0F - std::exp(-light), kGamma); }

/// Red, green, blue: the lens spreads a point over its neighbours.
void soften(std::vector<float>& light, int width, int height) {
  constexpr float kSide = 0.17F, kMiddle = 1.0F - 2.0F * kSide;
  const auto w = static_cast<std::size_t>(width) * 3;
  for_each_row(height, [&](int y) {
    float* row = light.data() + static_cast<std::size_t>(y) * w;
    float before[3] = {row[0], row[1], row[2]};
    for (std::size_t i = 0; i < w; ++i) {
      const float now = row[i], after = i + 3 < w ? row[i + 3] : now;
      row[i] = kMiddle * now + kSide * (before[i % 3] + after);
      before[i % 3] = now;
    }
  });
  const std::vector<float> source = light;
  for_each_row(height, [&](int y) {
    const float* row = source.data() + static_cast<std::size_t>(y) * w;
    const float* above = y > 0 ? row - w : row;
    const float* below = y + 1 < height ? row + w : row;
    float* out = light.data() + static_cast<std::size_t>(y) * w;
    for (std::size_t i = 0; i < w; ++i) out[i] = kMiddle * row[i] + kSide * (above[i] + below[i]);
  });
}

std::uint64_t scramble(std::uint64_t x) {  // splitmix64
  x += 0x9E3779B97F4A7C15ULL;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
  return x ^ (x >> 31);
}

}  // namespace

Painter::Painter(const StereoRig& rig, std::uint64_t seed, double noise_levels, double reference_distance)
    : left_(left_rays(rig)),
      right_(right_rays(rig)),
      tissue_(seed),
      focal_left_(static_cast<float>(rig.left.matrix(0, 0))),
      focal_right_(static_cast<float>(rig.right.matrix(0, 0))),
      reference_(static_cast<float>(reference_distance)),
      seed_(seed) {
  // The light leaves a crescent above the two lenses.
  lamp_ = 0.5F * right_.origin + Eigen::Vector3f(0.0F, -0.004F, 0.0F);
  right_axis_ = rig.right_from_left.rotation.row(2).transpose().cast<float>();
  film_.resize(kFilmSteps);
  for (int i = 0; i < kFilmSteps; ++i) {  // steps of the light's square root: fine where it is dark
    const float root = static_cast<float>(i) / (kFilmSteps - 1);
    film_[static_cast<std::size_t>(i)] = 255.0F * develop(kFilmRange * root * root);
  }
  gauss_.resize(1 << 16);
  std::mt19937_64 random(seed + 101);
  for (std::size_t i = 0; i + 1 < gauss_.size(); i += 2) {  // Box and Muller
    const double u = (static_cast<double>(random() >> 11) + 0.5) * 0x1.0p-53;
    const double v = static_cast<double>(random() >> 11) * 0x1.0p-53;
    const double r = noise_levels * std::sqrt(-2.0 * std::log(u)), a = 2.0 * std::numbers::pi * v;
    gauss_[i] = static_cast<float>(r * std::cos(a));
    gauss_[i + 1] = static_cast<float>(r * std::sin(a));
  }
}

/// What the rays of one row met. Liver and wall apart, so that each one's colour is found for all at once.
struct Painter::Row {
  struct Part {
    TissuePoints points;
    std::vector<std::size_t> pixels;
    std::vector<Eigen::Vector3f> normals, places, to_eye;
    std::vector<Look> looks;
    void clear() {
      points.clear();
      pixels.clear();
      normals.clear();
      places.clear();
      to_eye.clear();
    }
  };
  std::vector<RayHit> hits;
  Part liver, wall, tool;
  Part& part(RayHit::Thing thing) {
    if (thing == RayHit::Thing::organ) return liver;
    return thing == RayHit::Thing::wall ? wall : tool;
  }
};

namespace {

const PaintedSurface& painted(const PaintedScene& scene, RayHit::Thing thing) {
  if (thing == RayHit::Thing::organ) return scene.liver;
  return thing == RayHit::Thing::wall ? scene.wall : scene.tool;
}

}  // namespace

void Painter::meet(Eye eye, int y, const RayCaster& caster, const PaintedScene& scene, Row& row) const {
  const RayTable& table = rays(eye);
  const float pixel = 1e3F / (eye == Eye::left ? focal_left_ : focal_right_);
  for (Row::Part* part : {&row.liver, &row.wall, &row.tool}) part->clear();
  const std::size_t first = static_cast<std::size_t>(y) * static_cast<std::size_t>(table.width);
  row.hits.resize(static_cast<std::size_t>(table.width));
  caster.cast(table.origin, table.directions.data() + first, table.width, row.hits.data());
  for (std::size_t i = first; i < first + static_cast<std::size_t>(table.width); ++i) {
    const Eigen::Vector3f& ray = table.directions[i];
    const RayHit& hit = row.hits[i - first];
    if (hit.thing == RayHit::Thing::nothing) continue;
    const PaintedSurface& surface = painted(scene, hit.thing);
    Eigen::Vector3f rest = Eigen::Vector3f::Zero(), normal = Eigen::Vector3f::Zero();
    for (int k = 0; k < 3; ++k) {
      const int v = surface.triangles(hit.triangle, k);
      rest += hit.barycentric[k] * surface.rest_mm.row(v).transpose();
      normal += hit.barycentric[k] * surface.normals.row(v).transpose();
    }
    normal.normalize();
    const Eigen::Vector3f to_eye = -ray.normalized();
    float facing = normal.dot(to_eye);
    if (facing < 0.05F) {  // a smoothed normal may turn away at the outline
      normal = (normal + (0.05F - facing) * to_eye).normalized();
      facing = 0.05F;
    }
    Row::Part& part = row.part(hit.thing);
    part.points.add(rest, pixel * hit.parameter / std::sqrt(facing));
    part.pixels.push_back(i);
    part.normals.push_back(normal);
    part.places.push_back(table.origin + hit.parameter * ray);
    part.to_eye.push_back(to_eye);
  }
}

Eigen::Array3f Painter::shade(const Eigen::Vector3f& p, const Eigen::Vector3f& normal,
                              const Eigen::Vector3f& to_eye, const Look& look,
                              const Eigen::Vector3f& lean) const {
  const Eigen::Vector3f wet = (normal - (lean - normal.dot(lean) * normal)).normalized();
  Eigen::Vector3f to_lamp = lamp_ - p;
  const float distance = to_lamp.norm();
  to_lamp /= distance;
  const float off_axis = -to_lamp.z();  // cosine to the optical axis
  const float cone = std::clamp((off_axis - 0.45F) / 0.45F, 0.0F, 1.0F);
  const float lamp = reference_ * reference_ / (distance * distance) * cone * (1.4F - 0.4F * cone);
  // Light that entered beside the point comes out here too: softer than Lambert's cosine.
  const float diffuse = std::max(0.0F, 0.85F * wet.dot(to_lamp) + 0.15F);
  const float mirror = std::max(0.0F, wet.dot((to_lamp + to_eye).normalized()));
  const auto square = [](float x) { return x * x; };
  const float eighth = square(square(square(mirror)));
  const float broad = eighth * square(eighth);        // exponent 24
  const float glint = square(square(square(broad)));  // exponent 192
  const float gloss = look.gloss * (0.75F * glint + 0.020F * broad);
  return lamp * (diffuse * look.albedo + gloss * Eigen::Array3f(1.0F, 0.97F, 0.93F));
}

std::vector<float> Painter::light(Eye eye, const RayCaster& caster, const PaintedScene& scene) const {
  const RayTable& table = rays(eye);
  const Eigen::Vector3f axis = eye == Eye::left ? left_axis_ : right_axis_;
  std::vector<float> light(table.directions.size() * 3, 0.0F);
  for_each_row(table.height, [&](int y) {
    thread_local Row row;  // keeps its memory from row to row
    meet(eye, y, caster, scene, row);
    tissue_.liver(row.liver.points, row.liver.looks);
    tissue_.wall(row.wall.points, row.wall.looks);
    Tissue::steel(row.tool.points, row.tool.looks);
    for (const RayHit::Thing thing : {RayHit::Thing::organ, RayHit::Thing::wall, RayHit::Thing::tool}) {
      const Row::Part* part = &row.part(thing);
      const Eigen::Matrix3f& turn = painted(scene, thing).camera_from_rest;
      for (std::size_t j = 0; j < part->pixels.size(); ++j) {
        const Look& look = part->looks[j];
        const float cosine = -part->to_eye[j].dot(axis);  // natural vignetting, half of it corrected
        const Eigen::Array3f seen =
            cosine * cosine *
            shade(part->places[j], part->normals[j], part->to_eye[j], look, turn * look.bump);
        for (int c = 0; c < 3; ++c) light[3 * part->pixels[j] + static_cast<std::size_t>(c)] = seen[c];
      }
    }
  });
  soften(light, table.width, table.height);
  return light;
}

void Painter::expose(const RayCaster& caster, const PaintedScene& scene) {
  const std::vector<float> seen = light(Eye::left, caster, scene);
  const std::vector<float> depth = caster.organ_depth(left_);
  std::vector<float> red;
  for (std::size_t i = 0; i < depth.size(); ++i)
    if (depth[i] > 0.0F) red.push_back(seen[3 * i]);
  if (red.empty()) return;
  const float middle = upper_median(std::move(red));
  // develop(exposure * median) = level
  exposure_ = -std::log(1.0F - std::pow(kLiverLevel, 1.0F / kGamma)) / std::max(middle, 1e-6F);
}

Picture Painter::picture(Eye eye, int frame, const RayCaster& caster, const PaintedScene& scene) const {
  const std::vector<float> seen = light(eye, caster, scene);
  const RayTable& table = rays(eye);
  auto bytes = std::make_shared<std::vector<std::uint8_t>>(seen.size());
  const std::uint64_t stream =
      scramble(seed_ ^ scramble(static_cast<std::uint64_t>(frame) * 2 + (eye == Eye::left ? 0 : 1)));
  for_each_row(table.height, [&](int y) {
    const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(table.width);
    for (std::size_t i = row; i < row + static_cast<std::size_t>(table.width); ++i) {
      const std::uint64_t bits = scramble(stream + i);
      for (std::size_t c = 0; c < 3; ++c) {
        const float root = std::sqrt(std::min(1.0F, exposure_ * seen[3 * i + c] / kFilmRange));
        const float level =
            film_[static_cast<std::size_t>(root * (kFilmSteps - 1))] + gauss_[(bits >> (16 * c)) & 0xFFFFU];
        (*bytes)[3 * i + 2 - c] = static_cast<std::uint8_t>(std::clamp(level + 0.5F, 0.0F, 255.0F));
      }
    }
  });
  return {table.width, table.height, 3, std::move(bytes)};
}

}  // namespace glisson::insilico
