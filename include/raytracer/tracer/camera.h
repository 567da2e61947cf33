// Pixels to rays.
#pragma once

#include <optional>

#include "raytracer/geometry/ray.h"
#include "raytracer/scene/scene_description.h"
#include "raytracer/tracer/scene_frame.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// The assignment's camera: frame v = up, w = -look, u = v x w, taken as given. Positions are in the scene's
// frame; the film is measured in units of a power of two and directions are scaled by one, so that no
// magnitude of the file's numbers overflows.
class Camera {
  public:
    Camera() = default;
    Camera(const CameraDescription& description, const SceneFrame& frame);

    // Film coordinates of a point of the picture, (0, 0) at its top left, (width, height) at its bottom
    // right; the centre of pixel (x, y) is (x + 1/2, y + 1/2).
    template <class T>
    Vec2T<T> getPixelUV(const T& x, const T& y, int width, int height) const {
        return {T(left_) + T(right_ - left_) * x / T(static_cast<Real>(width)),
                T(bottom_) + T(top_ - bottom_) * (T(1) - y / T(static_cast<Real>(height)))};
    }

    template <class T>
    RayT<T> getRay(const Vec2T<T>& uv) const {
        const Vec3T<T> onFilm = uv.x * Vec3T<T>(u_) + uv.y * Vec3T<T>(v_), eye(eye_), forward(forward_);
        return perspective_ ? RayT<T>{eye, onFilm + forward, {}} : RayT<T>{eye + onFilm, forward, {}};
    }

    // The film coordinates where a point is seen, about; nothing where it is not in the picture.
    std::optional<Vec2> uvOf(const Vec3& point) const;

    // Along any axis, of the points where its rays start.
    Real farthest() const;

    // How wide the picture is at t of its rays: as many pixels as along its longer edge, by a pixel's shorter
    // side.
    Real width(Real t) const;

    // The largest number that its rays' directions (orthographic: origins) are sums of, in such widths.
    Real reach() const;

    // A ray's direction here is the scene file's divided by 2^directionExponent, in the frame's unit.
    int directionExponent() const { return directionExponent_; }

  private:
    Vec3 film() const { return Real(2) * (abs(u_) + abs(v_)); }  // its coordinates are at most 2

    bool perspective_ = true;
    Vec3 eye_{0}, u_{1, 0, 0}, v_{0, 1, 0};
    Vec3 forward_{0, 0, -1};  // perspective: -d w; orthographic: -w
    Real left_ = -1, right_ = 1, bottom_ = -1, top_ = 1;
    Real longEdge_ = 2;  // in |u|
    int directionExponent_ = 0;
};

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
