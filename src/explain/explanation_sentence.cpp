#include <algorithm>
#include <cmath>
#include <map>

#include "raytracer/explain/explanation_text.h"
#include "raytracer/pictures/image.h"
#include "raytracer/util/text.h"

namespace raytracer {

namespace {

std::string nameOf(const SceneDescription& scene, std::size_t shape) {
    const ShapeDescription& described = scene.shapes[shape];
    return std::string(typeName(described.type)) + " " + inQuotes(scene.transforms[described.transform].name);
}

// "the light", "both lights", "light 2", "lights 0 and 2"
std::string lightNames(const std::vector<std::size_t>& some, std::size_t all) {
    if (all == 1) return "the light";
    if (some.size() == all) return all == 2 ? "both lights" : "all " + std::to_string(all) + " lights";
    std::vector<std::string> numbers;
    numbers.reserve(some.size());
    for (const std::size_t light : some) numbers.push_back(std::to_string(light));
    return (some.size() == 1 ? "light " : "lights ") + listed(numbers, "and");
}

// The words before a light's name.
std::string reachOf(const LightExplanation& light, const SceneDescription& scene) {
    if (!(light.N_L > 0)) return "turned away from ";
    if (!light.shadowedBy) return "lit by ";
    const std::string by = nameOf(scene, *light.shadowedBy);
    const bool isClear = materialOf(scene, *light.shadowedBy).refractive;
    return isClear ? "lit through the " + by + " by " : "in the shadow of the " + by + " from ";
}

std::string reachOfLights(const RayExplanation& ray, const SceneDescription& scene) {
    std::vector<std::string> order;
    std::map<std::string, std::vector<std::size_t>> lights;
    for (std::size_t i = 0; i < ray.lights.size(); ++i) {
        const std::string reach = reachOf(ray.lights[i], scene);
        if (lights[reach].empty()) order.push_back(reach);
        lights[reach].push_back(i);
    }
    std::string text;
    for (const std::string& reach : order)
        text += ", " + reach + lightNames(lights[reach], ray.lights.size());
    return text;
}

struct Part {
    std::string name, term;  // "81 % is NAME", "without TERM"
    glm::dvec3 color{0};
};

std::vector<Part> partsOf(const RayExplanation& ray) {
    std::vector<Part> parts{{"ambient light", "its ambient light"},
                            {"diffuse light", "its diffuse light"},
                            {"specular light", "its specular light"},
                            {"what it mirrors", "the reflected ray"},
                            {"what is seen through it", "the refracted ray"}};
    for (const LightExplanation& light : ray.lights) {
        parts[0].color += light.ambient;
        parts[1].color += light.diffuse * light.S_L;
        parts[2].color += light.specular * light.S_L;
    }
    for (const RayExplanation& next : ray.rays)
        parts[next.kind == RayKind::Reflection ? 3 : 4].color += next.brought;
    return parts;
}

// What a light's shadow adds to the colour: zero or less.
glm::dvec3 shadowOf(const LightExplanation& light) {
    return (light.S_L - 1.0) * (light.diffuse + light.specular);
}

// What all shadows of the tree add to the pixel's colour.
glm::dvec3 shadowsOf(const RayExplanation& ray) {
    glm::dvec3 sum(0);
    for (const LightExplanation& light : ray.lights) sum += ray.weight * shadowOf(light);
    for (const RayExplanation& next : ray.rays) sum += shadowsOf(next);
    return sum;
}

// "81 % of the red is ambient light, 19 % what it mirrors": the parts of the strongest channel, from 1 % on.
// Negative parts, of lights with a negative colour, are left out.
std::string shares(const RayExplanation& ray) {
    int channel = 0;
    for (const int other : {1, 2})
        if (ray.color[other] > ray.color[channel]) channel = other;
    std::vector<Part> parts = partsOf(ray);
    std::ranges::stable_sort(parts, std::greater(), [=](const Part& part) { return part.color[channel]; });
    double all = 0;
    for (const Part& part : parts) all += std::max(0.0, part.color[channel]);
    if (!(ray.color[channel] > 0 && all > 0)) return "black";  // small parts may underflow
    constexpr const char* names[] = {"red", "green", "blue"};
    std::string text;
    for (const Part& part : parts) {
        const double percent = std::round(100 * (part.color[channel] / all));
        if (percent < 1) continue;
        const std::string share = formatted("%.0f %% ", percent);
        text += text.empty() ? share + "of the " + names[channel] + " is " : ", " + share;
        text += part.name;
    }
    return text;
}

}  // namespace

std::string explanationSentence(const RayExplanation& explanation, const SceneDescription& scene) {
    if (!explanation.hit) return "nothing is hit: black";
    return nameOf(scene, explanation.shape) + reachOfLights(explanation, scene) + ": " + shares(explanation);
}

std::vector<std::string> missingTerms(const RayExplanation& explanation, const std::uint8_t* bytes) {
    std::vector<std::string> terms;
    const auto isThere = [&](const glm::dvec3& color) {
        return toByte(color.x) == bytes[0] && toByte(color.y) == bytes[1] && toByte(color.z) == bytes[2];
    };
    const auto add = [&](const std::string& term, const glm::dvec3& change) {
        if (change != glm::dvec3(0) && isThere(explanation.color - change)) terms.push_back(term);
    };
    if (!explanation.hit || isThere(explanation.color)) return terms;
    for (const Part& part : partsOf(explanation)) add(part.term, part.color);
    for (std::size_t i = 0; explanation.lights.size() > 1 && i < explanation.lights.size(); ++i) {
        const LightExplanation& light = explanation.lights[i];
        const std::string of = " of light " + std::to_string(i);
        add("the ambient term" + of, light.ambient);
        add("the diffuse term" + of, light.diffuse * light.S_L);
        add("the specular term" + of, light.specular * light.S_L);
        add("the whole term" + of, light.sum);
    }
    for (std::size_t i = 0; i < explanation.lights.size(); ++i) {
        add("the shadow from light " + std::to_string(i), shadowOf(explanation.lights[i]));
    }
    if (terms.empty()) add("any shadow", shadowsOf(explanation));
    return terms;
}

}  // namespace raytracer
