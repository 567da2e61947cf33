// Pixels to rays.
#pragma once

#include <optional>

#include "raytracer/geometry/ray.h"
#include "raytracer/scene/scene_description.h"
#include "raytracer/tracer/scene_frame.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// The assignment's camera: the frame v = up, w = -look, u = v x w, used as given. Positions are in the
// scene's frame. Film coordinates and directions are scaled by powers of two, so that no number of the file,
// however large or small, overflows.
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

    // The inverse of getPixelUV.
    Vec2 pixelOf(const Vec2& uv, Real width, Real height) const {
        return {(uv.x - left_) / (right_ - left_) * width,
                (Real(1) - (uv.y - bottom_) / (top_ - bottom_)) * height};
    }

    // The approximate film coordinates at which a point is seen, and its distance from the eye, along the
    // camera's axis, in units that depend on the camera. Behind the eye the distance is 0 or less. Where
    // numbers are too large or too small, they are infinite or NaN.
    Vec3 onFilm(const Vec3& point) const;
    // The first two; nothing where the point is not in the picture.
    std::optional<Vec2> uvOf(const Vec3& point) const;

    bool isPerspective() const { return perspective_; }
    // From the eye to a point; orthographic: the direction of all rays.
    Vec3 viewOf(const Vec3& point) const { return perspective_ ? point - eye_ : forward_; }

    // The largest coordinate, along any axis, of the points where rays start.
    Real farthest() const;

    // The width of the picture at t along its rays: the number of pixels along its longer edge, times the
    // shorter side of a pixel.
    Real width(Real t) const;

    // The largest number in the sums that make a ray's direction (orthographic: its origin), in units of
    // width(1).
    Real reach() const;

    // A ray's direction here, in the frame's unit, is the scene file's divided by 2^directionExponent.
    int directionExponent() const { return directionExponent_; }

  private:
    Vec3 film() const { return Real(2) * (abs(u_) + abs(v_)); }  // film coordinates are at most 2

    bool perspective_ = true;
    Vec3 eye_{0}, u_{1, 0, 0}, v_{0, 1, 0};
    Vec3 forward_{0, 0, -1};  // perspective: -d w; orthographic: -w
    Mat3 filmFromFrame_{1};   // the inverse of (u, v, forward)
    Real left_ = -1, right_ = 1, bottom_ = -1, top_ = 1;
    Real longEdge_ = 2;  // in |u|
    int directionExponent_ = 0;
};

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
