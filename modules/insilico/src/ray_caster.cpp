// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/insilico/ray_caster.h"

#include <embree3/rtcore.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "glisson/core/error.h"
#include "glisson/geometry/rigid.h"
#include "rows.h"

namespace glisson::insilico {
namespace {

template <class OtherFrame>
RayTable make_rays(const Camera& camera, const Rigid<CameraFrame, OtherFrame>& left_from_camera) {
  RayTable table;
  table.width = camera.width;
  table.height = camera.height;
  table.origin = left_from_camera.translation.template cast<float>();
  table.directions.resize(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height));
  for_each_row(camera.height, [&](int y) {
    for (int x = 0; x < camera.width; ++x) {
      const Eigen::Vector3d ray = camera.ray({x, y});
      table.directions[static_cast<std::size_t>(y) * static_cast<std::size_t>(camera.width) +
                       static_cast<std::size_t>(x)] =
          (left_from_camera.rotation * ray).template cast<float>();
    }
  });
  return table;
}

void write_vertices(RTCGeometry geometry, const Points& vertices) {
  auto* out = static_cast<float*>(rtcGetGeometryBufferData(geometry, RTC_BUFFER_TYPE_VERTEX, 0));
  for (Eigen::Index i = 0; i < vertices.size(); ++i) out[i] = static_cast<float>(vertices.data()[i]);
}

}  // namespace

RayTable left_rays(const StereoRig& rig) { return make_rays(rig.left, Rigid<CameraFrame, CameraFrame>{}); }
RayTable right_rays(const StereoRig& rig) { return make_rays(rig.right, rig.right_from_left.inverse()); }

struct RayCaster::Impl {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  RTCGeometry organ = nullptr;
  unsigned wall = RTC_INVALID_GEOMETRY_ID, tool = RTC_INVALID_GEOMETRY_ID;
  Eigen::Index organ_vertices = 0;

  Impl() {
    // One thread: commits are short, and the caller's own threads share the pixels.
    device = rtcNewDevice("threads=1,set_affinity=0");
    if (device == nullptr) throw NumericalError("the ray caster could not be started (Embree: no device)");
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_DYNAMIC | RTC_SCENE_FLAG_ROBUST);
  }
  ~Impl() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  RTCGeometry add(const TriangleMesh& mesh, RTCBuildQuality quality, unsigned* id) const {
    require(mesh.triangle_count() > 0, "the ray caster is given a surface with triangles");
    require(mesh.triangles.minCoeff() >= 0 && mesh.triangles.maxCoeff() < mesh.vertex_count(),
            "the triangles of a surface name its vertices");
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryBuildQuality(geometry, quality);
    rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                            static_cast<std::size_t>(mesh.vertex_count()));
    write_vertices(geometry, mesh.vertices);
    auto* indices = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), static_cast<std::size_t>(mesh.triangle_count())));
    for (Eigen::Index i = 0; i < mesh.triangles.size(); ++i)
      indices[i] = static_cast<std::uint32_t>(mesh.triangles.data()[i]);
    rtcCommitGeometry(geometry);
    *id = rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);  // the scene keeps it
    return geometry;
  }
  void replace(const TriangleMesh& mesh, unsigned& id) const {
    if (id != RTC_INVALID_GEOMETRY_ID) rtcDetachGeometry(scene, id);
    id = RTC_INVALID_GEOMETRY_ID;
    if (mesh.triangle_count() > 0) add(mesh, RTC_BUILD_QUALITY_MEDIUM, &id);
    commit();
  }
  RayHit::Thing thing(unsigned id) const {
    if (id == wall) return RayHit::Thing::wall;
    return id == tool ? RayHit::Thing::tool : RayHit::Thing::organ;
  }
  void commit() const {
    rtcCommitScene(scene);
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE)
      throw NumericalError("the ray caster could not take the surface (Embree reports an error)");
  }
};

RayCaster::RayCaster(const TriangleMesh& organ) : impl_(std::make_unique<Impl>()) {
  unsigned id = 0;
  impl_->organ = impl_->add(organ, RTC_BUILD_QUALITY_REFIT, &id);
  impl_->organ_vertices = organ.vertices.rows();
  impl_->commit();
}
RayCaster::~RayCaster() = default;
RayCaster::RayCaster(RayCaster&&) noexcept = default;
RayCaster& RayCaster::operator=(RayCaster&&) noexcept = default;

void RayCaster::move_organ(const Points& vertices) {
  require(vertices.rows() == impl_->organ_vertices, "the organ keeps its vertices when it moves");
  write_vertices(impl_->organ, vertices);
  rtcUpdateGeometryBuffer(impl_->organ, RTC_BUFFER_TYPE_VERTEX, 0);
  rtcCommitGeometry(impl_->organ);
  impl_->commit();
}

void RayCaster::set_wall(const TriangleMesh& wall) {
  require(wall.triangle_count() > 0, "the ray caster is given a surface with triangles");
  impl_->replace(wall, impl_->wall);
}

void RayCaster::set_tool(const TriangleMesh& tool) { impl_->replace(tool, impl_->tool); }

RayHit RayCaster::cast(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  RTCRayHit ray{};
  ray.ray.org_x = origin.x();
  ray.ray.org_y = origin.y();
  ray.ray.org_z = origin.z();
  ray.ray.dir_x = direction.x();
  ray.ray.dir_y = direction.y();
  ray.ray.dir_z = direction.z();
  ray.ray.tfar = std::numeric_limits<float>::infinity();
  ray.ray.mask = 0xFFFFFFFFU;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(impl_->scene, &context, &ray);
  RayHit hit;
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return hit;
  hit.thing = impl_->thing(ray.hit.geomID);
  hit.triangle = static_cast<int>(ray.hit.primID);
  hit.parameter = ray.ray.tfar;
  hit.barycentric = {1.0F - ray.hit.u - ray.hit.v, ray.hit.u, ray.hit.v};
  return hit;
}

void RayCaster::cast(const Eigen::Vector3f& origin, const Eigen::Vector3f* directions, int count,
                     RayHit* hits) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  for (int first = 0; first < count; first += 8) {
    alignas(32) RTCRayHit8 ray{};
    alignas(32) int valid[8];
    for (int k = 0; k < 8; ++k) {
      valid[k] = first + k < count ? -1 : 0;
      const Eigen::Vector3f& way = directions[std::min(first + k, count - 1)];
      ray.ray.org_x[k] = origin.x();
      ray.ray.org_y[k] = origin.y();
      ray.ray.org_z[k] = origin.z();
      ray.ray.dir_x[k] = way.x();
      ray.ray.dir_y[k] = way.y();
      ray.ray.dir_z[k] = way.z();
      ray.ray.tfar[k] = std::numeric_limits<float>::infinity();
      ray.ray.mask[k] = 0xFFFFFFFFU;
      ray.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
      ray.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect8(valid, impl_->scene, &context, &ray);
    for (int k = 0; k < 8 && first + k < count; ++k) {
      RayHit& hit = hits[first + k];
      hit = RayHit{};
      if (ray.hit.geomID[k] == RTC_INVALID_GEOMETRY_ID) continue;
      hit.thing = impl_->thing(ray.hit.geomID[k]);
      hit.triangle = static_cast<int>(ray.hit.primID[k]);
      hit.parameter = ray.ray.tfar[k];
      hit.barycentric = {1.0F - ray.hit.u[k] - ray.hit.v[k], ray.hit.u[k], ray.hit.v[k]};
    }
  }
}

bool RayCaster::sees(const Eigen::Vector3d& origin, const Eigen::Vector3d& target, double slack) const {
  const Eigen::Vector3d way = target - origin;
  const double length = way.norm();
  if (length <= slack) return true;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray{};
  ray.org_x = static_cast<float>(origin.x());
  ray.org_y = static_cast<float>(origin.y());
  ray.org_z = static_cast<float>(origin.z());
  ray.dir_x = static_cast<float>(way.x() / length);
  ray.dir_y = static_cast<float>(way.y() / length);
  ray.dir_z = static_cast<float>(way.z() / length);
  ray.tfar = static_cast<float>(length - slack);
  ray.mask = 0xFFFFFFFFU;
  rtcOccluded1(impl_->scene, &context, &ray);
  return ray.tfar >= 0.0F;  // Embree sets it to minus infinity when something is in the way
}

std::vector<float> RayCaster::organ_depth(const RayTable& rays) const {
  std::vector<float> depth(rays.directions.size(), 0.0F);
  for_each_row(rays.height, [&](int y) {
    const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(rays.width);
    std::vector<RayHit> hits(static_cast<std::size_t>(rays.width));
    cast(rays.origin, rays.directions.data() + row, rays.width, hits.data());
    for (std::size_t x = 0; x < hits.size(); ++x)
      if (hits[x].thing == RayHit::Thing::organ) depth[row + x] = hits[x].parameter;
  });
  return depth;
}

}  // namespace glisson::insilico
