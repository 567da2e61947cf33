#include "raytracer/tracer/camera.h"

#include <algorithm>
#include <cmath>

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

namespace {

long double largest(const ExtendedVec& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

int exponentOf(long double magnitude) { return magnitude > 0 ? std::ilogb(magnitude) : 0; }

}  // namespace

Camera::Camera(const CameraDescription& camera, const SceneFrame& frame)
    : perspective_(camera.type == CameraDescription::Type::Perspective) {
    const ExtendedVec v = camera.up, w = -ExtendedVec(camera.look), u = glm::cross(v, w);
    const ExtendedVec forward = perspective_ ? -static_cast<long double>(camera.focal_length) * w : -w;

    const double film = std::max({std::abs(camera.film_left), std::abs(camera.film_right),
                                  std::abs(camera.film_bottom), std::abs(camera.film_top)});
    const int filmExponent = exponentOf(film);
    const double left = std::scalbn(camera.film_left, -filmExponent),
                 right = std::scalbn(camera.film_right, -filmExponent),
                 bottom = std::scalbn(camera.film_bottom, -filmExponent),
                 top = std::scalbn(camera.film_top, -filmExponent);
    left_ = static_cast<Real>(left);
    right_ = static_cast<Real>(right);
    bottom_ = static_cast<Real>(bottom);
    top_ = static_cast<Real>(top);
    // A unit of the film is |u| wide and, seen along w, |u| / |w| high; |w| to within a factor of sqrt(3).
    longEdge_ = static_cast<Real>(std::max(std::abs(right - left), std::abs(top - bottom)) /
                                  std::max(1.0L, largest(w)));

    const ExtendedVec filmU = scaled(u, filmExponent), filmV = scaled(v, filmExponent);
    const long double direction =
        perspective_ ? std::max({largest(filmU), largest(filmV), largest(forward)}) : largest(forward);
    directionExponent_ = exponentOf(direction);
    const int filmScale = perspective_ ? -directionExponent_ : -frame.exponent;
    u_ = Vec3(scaled(filmU, filmScale));
    v_ = Vec3(scaled(filmV, filmScale));
    forward_ = Vec3(scaled(forward, -directionExponent_));
    eye_ = Vec3(frame.pointToFrame(camera.eye));
    filmFromFrame_ = glm::inverse(Mat3(u_, v_, forward_));
}

Vec3 Camera::onFilm(const Vec3& point) const {
    const Vec3 seen = filmFromFrame_ * (point - eye_);
    return perspective_ ? Vec3(seen.x / seen.z, seen.y / seen.z, seen.z) : seen;
}

std::optional<Vec2> Camera::uvOf(const Vec3& point) const {
    const Vec3 seen = onFilm(point);
    const auto isBetween = [](Real x, Real a, Real b) { return min(a, b) <= x && x <= max(a, b); };
    if (!(seen.z > 0 && isBetween(seen.x, left_, right_) && isBetween(seen.y, bottom_, top_)))
        return std::nullopt;
    return Vec2(seen);
}

Real Camera::farthest() const { return maxComponent(perspective_ ? abs(eye_) : abs(eye_) + film()); }

Real Camera::width(Real t) const {
    const Real onFilm = maxComponent(abs(u_)) * longEdge_;
    return perspective_ ? t * onFilm : onFilm;
}

Real Camera::reach() const { return maxComponent(film() + abs(perspective_ ? forward_ : eye_)) / width(1); }

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
