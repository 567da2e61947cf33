// Mistakes in transforms and in the camera. These are edits of the scene's description, too.
#include <array>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "mistake.h"

namespace raytracer {

namespace {

glm::dmat4 part(const TransformDescription& transform, char which) {
    const glm::dmat4 unit(1);
    if (which == 't' && transform.translate) return glm::translate(unit, *transform.translate);
    if (which == 's' && transform.scale) return glm::scale(unit, *transform.scale);
    if (which == 'r' && transform.rotate)
        return glm::rotate(unit, glm::radians(transform.rotate->degrees), transform.rotate->axis);
    return unit;
}

// Makes the transform the product of its parts in this order, times its matrix.
void reorder(TransformDescription& transform, const std::array<char, 3>& order) {
    glm::dmat4 product = part(transform, order[0]) * part(transform, order[1]) * part(transform, order[2]);
    if (transform.matrix) product *= *transform.matrix;
    transform.matrix = product;
    transform.translate.reset();
    transform.rotate = {};
    transform.scale.reset();
}

const char* wordOf(char part) { return part == 't' ? "translate" : part == 'r' ? "rotate" : "scale"; }

Edit ofTransforms(const std::function<void(TransformDescription&)>& change) {
    return [=](SceneDescription& scene, RenderOptions&) {
        for (TransformDescription& transform : scene.transforms) change(transform);
    };
}

void turnBy(TransformDescription& transform, double (*degrees)(double)) {
    if (transform.rotate) transform.rotate->degrees = degrees(transform.rotate->degrees);
}

// Edits the camera so that it sees the picture flipped, turned or shifted.
using CameraEdit = std::function<void(CameraDescription& camera, const ImageSize& size)>;

void flipLeftRight(CameraDescription& camera, const ImageSize&) {
    std::swap(camera.film_left, camera.film_right);
}

void flipUpDown(CameraDescription& camera, const ImageSize&) {
    std::swap(camera.film_bottom, camera.film_top);
}

void turnUpsideDown(CameraDescription& camera, const ImageSize& size) {
    flipLeftRight(camera, size);
    flipUpDown(camera, size);
}

void lookBack(CameraDescription& camera, const ImageSize&) {
    if (camera.type == CameraDescription::Type::Perspective) {
        camera.focal_length = -camera.focal_length;
    } else {  // the new look flips u; the film's signs undo that
        camera.look = -camera.look;
        camera.film_left = -camera.film_left;
        camera.film_right = -camera.film_right;
    }
}

// Turns the picture clockwise: what was on the left is at the top. Recall that u = up x -look.
void turnClockwise(CameraDescription& camera, const ImageSize&) {
    camera.up = -glm::cross(camera.up, -camera.look);
    const CameraDescription before = camera;
    camera.film_left = before.film_bottom;
    camera.film_right = before.film_top;
    camera.film_bottom = -before.film_right;
    camera.film_top = -before.film_left;
}

void turnCounterclockwise(CameraDescription& camera, const ImageSize& size) {
    turnClockwise(camera, size);
    turnUpsideDown(camera, size);
}

void transpose(CameraDescription& camera, const ImageSize& size) {
    turnClockwise(camera, size);
    flipLeftRight(camera, size);
}

// A corner of a pixel, relative to its centre, in pixels to the right and up.
struct Corner {
    const char* name;
    double x, y;
};
constexpr Corner corners[] = {{"top left", -0.5, 0.5},
                              {"top right", 0.5, 0.5},
                              {"bottom left", -0.5, -0.5},
                              {"bottom right", 0.5, -0.5}};

// The first and the last pixel of a row look through the film's edges.
void edgeToEdge(CameraDescription& camera, const ImageSize& size) {
    const auto widen = [](double& low, double& high, int pixels) {
        const double more = (high - low) / (pixels - 1) / 2;
        low -= more;
        high += more;
    };
    widen(camera.film_left, camera.film_right, size.width);
    widen(camera.film_bottom, camera.film_top, size.height);
}

// Whether the camera can be turned. turnClockwise needs u = v x w and -u x w = v, so w must have unit length
// and be perpendicular to v. A picture that is not square is stretched: u and v are exchanged, as fractions
// of the film from 0 to 1.
bool canTurn(const CameraDescription& camera) {
    constexpr double threeDecimals = 2e-3;  // error of vectors written so, as in scene_advice.cpp
    const auto near = [](double value, double expected) {
        return std::abs(value - expected) < threeDecimals;
    };
    return near(glm::length(camera.look), 1) && near(glm::dot(camera.up, camera.look), 0);
}

}  // namespace

void addTransformMistakes(Mistakes& mistakes) {
    const std::size_t first = mistakes.size();
    mistakes.add("whose rotations take degrees as radians", "Is glm::radians(degrees) passed to glm::rotate?",
                 "rotation", ofTransforms([](TransformDescription& transform) {
                     turnBy(transform, [](double degrees) { return glm::degrees(degrees); });
                 }));
    mistakes.add("whose rotations go in the other sense",
                 "A positive angle is counter-clockwise around the axis.", "rotation",
                 ofTransforms([](TransformDescription& transform) {
                     turnBy(transform, [](double degrees) { return -degrees; });
                 }));
    mistakes.add("without rotations", "Is rotate read?", "rotation",
                 ofTransforms([](TransformDescription& transform) { transform.rotate = {}; }));
    mistakes.add("without scales", "Is scale read?", "scale",
                 ofTransforms([](TransformDescription& transform) { transform.scale.reset(); }));
    mistakes.add("without translations", "Is translate read?", "translation",
                 ofTransforms([](TransformDescription& transform) { transform.translate.reset(); }));
    // Last of the edits, since it puts all parts into the matrix.
    constexpr std::array<char, 3> orders[] = {
        {'t', 's', 'r'}, {'s', 'r', 't'}, {'r', 's', 't'}, {'r', 't', 's'}, {'s', 't', 'r'}};
    for (const auto& order : orders)
        mistakes.add(std::string("whose transforms are ") + wordOf(order[0]) + " * " + wordOf(order[1]) +
                         " * " + wordOf(order[2]),
                     "The transform is translate * rotate * scale: a point is scaled first.", "order",
                     ofTransforms([=](TransformDescription& transform) { reorder(transform, order); }));
    for (std::size_t i = first; i < mistakes.size(); ++i) mistakes[i].moves = true;
}

// Turned pictures come before rays through corners: those are corners of the pixels as they are shown.
void addCameraMistakes(Mistakes& mistakes, const SceneDescription& scene, const RenderOptions& options) {
    const auto add = [&](const std::string& what, const char* hint, const char* kind,
                         const CameraEdit& edit) {
        mistakes.add(what, hint, kind,
                     [edit](SceneDescription& edited, RenderOptions& to) { edit(edited.camera, to.size); });
    };
    add("that looks back", "The ray goes along u U + v V - d W, with W = -look.", "look", lookBack);
    add("flipped up and down", "Row 0 of the picture is its top: v = top there.", "film", flipUpDown);
    add("flipped left and right", "u = up x -look, and grows to the right.", "film", flipLeftRight);
    add("turned by 180 degrees", "Is the film mirrored, as behind a pinhole?", "film", turnUpsideDown);
    if (canTurn(scene.camera)) {
        const char* const turned = "Are x and y, or width and height, exchanged?";
        add("turned clockwise by 90 degrees", turned, "film", turnClockwise);
        add("turned counter-clockwise by 90 degrees", turned, "film", turnCounterclockwise);
        add("with rows and columns exchanged", turned, "film", transpose);
    }
    const char* const middle = "A pixel's ray goes through its centre: x + 0.5, y + 0.5.";
    for (const Corner& corner : corners)
        add("whose rays go through the pixels' " + std::string(corner.name) + " corners", middle, "pixel",
            [&corner](CameraDescription& camera, const ImageSize& size) {
                const double right = corner.x * (camera.film_right - camera.film_left) / size.width;
                const double up = corner.y * (camera.film_top - camera.film_bottom) / size.height;
                camera.film_left += right;
                camera.film_right += right;
                camera.film_bottom += up;
                camera.film_top += up;
            });
    if (options.size.width > 1 && options.size.height > 1)
        add("whose rays go from edge to edge of the film", "A pixel's width is (right - left) / width.",
            "pixel", edgeToEdge);
}

}  // namespace raytracer
