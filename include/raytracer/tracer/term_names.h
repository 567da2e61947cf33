// Terms and passes by the names that the command line and the stages of the course use.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "raytracer/tracer/render_options.h"

namespace raytracer {

struct TermName {
    const char* name;
    bool Terms::*term;
};

inline constexpr TermName termNames[] = {
    {"ambient", &Terms::ambient},   {"diffuse", &Terms::diffuse},         {"specular", &Terms::specular},
    {"shadows", &Terms::shadows},   {"reflections", &Terms::reflections}, {"refraction", &Terms::refraction},
    {"textures", &Terms::textures},
};

inline bool isTerm(std::string_view name) {
    return std::ranges::find(termNames, name, &TermName::name) != std::end(termNames);
}

// Whether nothing is lit.
constexpr bool isDark(const Terms& terms) { return !terms.ambient && !terms.diffuse && !terms.specular; }

constexpr Pass passNamed(std::string_view name) {
    return name == "raycast" ? Pass::Raycast : name == "normals" ? Pass::Normals : Pass::Color;
}

inline constexpr Terms noTerms{false, false, false, false, false, false, false};

// The terms of a comma-separated list without blanks; all of them for an empty one.
inline Terms termsNamed(const std::string& list) {
    if (list.empty()) return {};
    Terms terms = noTerms;
    for (const TermName& known : termNames)
        terms.*known.term = ("," + list + ",").find("," + std::string(known.name) + ",") != std::string::npos;
    return terms;
}

}  // namespace raytracer
