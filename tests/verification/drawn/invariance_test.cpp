// A submerged dike that shakes answers alike wherever it is drawn, mirrored, and at 1/50 of its size.
//
// A model at 1/s of the size has s times the gravity, the base's acceleration and the frequency; stresses,
// pressures, velocities and k are the same, k at s times the gravity.
#include "tests/fixtures/drawn_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace quicksand {
namespace {

using namespace fixtures;

/// The dike as it is drawn, or a copy of it.
struct Copy {
    Vector2 shift = Vector2::Zero(); // [m]
    double side = 1.0;               // -1: mirrored
    double size = 1.0;               // of the first one's [-]

    Vector2 place(const Vector2& x) const { return size * Vector2(side * x.x(), x.y()) + shift; }
    /// As the first one would have it: vectors but for their sizes, stress but for its sign.
    Vector2 vector(const Vector2& v) const { return {side * v.x(), v.y()}; }
};

struct Course {
    std::string scheme, soil;
    double amplitude = 0.0; // of the base [m/s2]
    double duration = 0.0;  // [s]
    bool settles = false;   // first
};

const std::string elastic_soil = R"(model = "linear_elastic"
shear_modulus = "30 MPa"
poisson_ratio = 0.3
)";
const std::string ubcsand_soil = R"(model = "ubcsand"
relative_density = "55 %"
)";

/// A slope of 1:2 between a crest of 5.3 m and ground of 2.1 m, on cells of 1 m, so that it runs off the grid
/// lines.
AssembledCase shaken_dike(const Copy& copy, const Course& course)
{
    std::vector<NamedCorner> corners = {{{0.0, 0.0}, "base"},     {{17.0, 0.0}, "right"},
                                        {{17.0, 2.1}, "surface"}, {{11.4, 2.1}, "surface"},
                                        {{5.0, 5.3}, "surface"},  {{0.0, 5.3}, "left"}};
    for (NamedCorner& corner : corners) corner.place = copy.place(corner.place);
    if (copy.side < 0.0) { // anticlockwise again
        std::vector<NamedCorner> reversed;
        for (std::size_t k = corners.size(); k > 0; --k)
            reversed.push_back({corners[k % corners.size()].place, corners[k - 1].edge});
        corners = reversed;
    }
    const auto text = [](double value) { return std::to_string(value); };
    const double h = copy.size, g = 10.0 / copy.size;
    const std::string tables =
        "[analysis]\nscheme = \"" + course.scheme + "\"\n[sampling]\nparticles_per_cell = [2, 2]\n" +
        "[gravity]\nacceleration = " + text(g) + "\n[water]\nlevel = " + text(copy.place({0.0, 7.0}).y()) +
        "\n[materials.soil]\n" + course.soil +
        "porosity = 0.4\nhydraulic_conductivity = 1e-3\nconductivity_gravity = " + text(g) +
        "\n[regions.soil]\nmaterial = \"soil\"\n[boundaries.base]\nsoil = \"fixed\"\n[boundaries.left]\nsoil "
        "= \"roller\"\n[boundaries.right]\nsoil = \"roller\"\n[motion]\nkind = \"sine\"\namplitude = " +
        text(course.amplitude / copy.size) + "\nfrequency = " + text(2.0 / copy.size) + "\nramp_cycles = 0\n";
    const Vector2 corner = copy.side > 0.0 ? Vector2(0.0, 0.0) : Vector2(20.0, 0.0);
    AssembledCase assembled =
        assemble(scene_with(h, copy.place(corner), 20, 8, tables), polygon_section(corners));
    auto& sine = std::get<SineMotion>(assembled.problem.base_motion);
    sine.amplitude *= copy.side;
    return assembled;
}

/// What is compared of a particle; displacements over the size, the rest as it is.
struct Answer {
    Vector2 drawn; // where the first one has it [m]
    Vector2 displacement, velocity;
    double pressure = 0.0, horizontal = 0.0, vertical = 0.0, shear = 0.0; // [Pa]
};

std::vector<Answer> shake(const Copy& copy, const Course& course)
{
    AssembledCase assembled = shaken_dike(copy, course);
    RelaxationControls controls;
    controls.tolerance = 1e-6;
    if (course.settles) {
        relax(assembled.problem, controls, assembled.state);
    } else {
        begin_shaking(assembled.problem, assembled.state);
    }
    run(assembled.problem, course.duration * copy.size, {}, assembled.state);
    const Particles& particles = assembled.state.particles;
    std::vector<Answer> answers;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Vector2 x = particles.reference_position[p] - copy.shift;
        answers.push_back({copy.vector(x / copy.size),
                           copy.vector(particles.position[p] - particles.reference_position[p]) / copy.size,
                           copy.vector(particles.velocity_solid[p]), particles.pore_pressure[p],
                           particles.stress.xx[p], particles.stress.yy[p],
                           copy.side * particles.stress.xy[p]});
    }
    return answers;
}

const Answer& nearest(const std::vector<Answer>& answers, const Vector2& drawn)
{
    return *std::min_element(answers.begin(), answers.end(), [&](const Answer& a, const Answer& b) {
        return (a.drawn - drawn).squaredNorm() < (b.drawn - drawn).squaredNorm();
    });
}

/// The largest differences of the copy's answers from the first one's, over the largest amounts.
void expect_alike(const Copy& copy, const Course& course, double most)
{
    const std::vector<Answer> first = shake({}, course), other = shake(copy, course);
    ASSERT_EQ(first.size(), other.size());
    struct Compared {
        const char* name;
        double amount = 0.0, difference = 0.0;
    };
    Compared displacement{"displacement"}, velocity{"velocity"}, pressure{"pressure"}, stress{"stress"};
    const auto compare = [](Compared& compared, double a, double b) {
        compared.amount = std::max(compared.amount, std::abs(a));
        compared.difference = std::fmax(compared.difference, std::abs(a - b));
    };
    for (const Answer& a : first) {
        const Answer& b = nearest(other, a.drawn);
        EXPECT_LT((a.drawn - b.drawn).norm(), 1e-3);
        for (int axis = 0; axis < 2; ++axis) {
            compare(displacement, a.displacement[axis], b.displacement[axis]);
            compare(velocity, a.velocity[axis], b.velocity[axis]);
        }
        compare(pressure, a.pressure, b.pressure);
        compare(stress, a.horizontal, b.horizontal);
        compare(stress, a.vertical, b.vertical);
        compare(stress, a.shear, b.shear);
    }
    for (const Compared& each : {displacement, velocity, pressure, stress})
        EXPECT_LT(each.difference, most * each.amount) << each.name;
}

const std::string pm4sand_soil = R"(model = "pm4sand"
relative_density = "55 %"
)";

const Copy moved_dike{{1000.0, 500.0}, 1.0, 1.0};
const Copy mirrored_dike{{0.0, 0.0}, -1.0, 1.0};
const Copy model_dike{{0.0, 0.0}, 1.0, 0.02};

constexpr double elastic_difference = 1e-6, sand_difference = 1e-3;

Course elastic_course(const std::string& scheme)
{
    return {scheme, elastic_soil, 1.0, 0.5, false};
}

TEST(Invariance, AMovedDikeAnswersAlike)
{
    for (const char* scheme : {"explicit", "semi_implicit", "implicit"})
        expect_alike(moved_dike, elastic_course(scheme), elastic_difference);
}

TEST(Invariance, AMirroredDikeAnswersAlike)
{
    for (const char* scheme : {"explicit", "semi_implicit", "implicit"})
        expect_alike(mirrored_dike, elastic_course(scheme), elastic_difference);
}

TEST(Invariance, AModelOfTheDikeAnswersAlike)
{
    for (const char* scheme : {"explicit", "semi_implicit", "implicit"})
        expect_alike(model_dike, elastic_course(scheme), elastic_difference);
}

// Before it liquefies: sand is another one at every beginning of loading, which rounding may shift by a step.
TEST(Invariance, SandAnswersAlikeBeforeItLiquefies)
{
    for (const char* scheme : {"semi_implicit", "implicit"}) {
        const Course course{scheme, ubcsand_soil, 0.8, 0.5, true};
        for (const Copy& copy : {moved_dike, mirrored_dike, model_dike})
            expect_alike(copy, course, sand_difference);
    }
}

// A mirror image has the same rounding: settled soil differs by no more, and sand counts the same half
// cycles.
TEST(Invariance, SandSettlesAndShakesAlikeInAMirror)
{
    for (const char* law : {"published", "calibrated"}) {
        const std::string of_law = "law = \"" + std::string(law) + "\"\n";
        for (const std::string& soil : {ubcsand_soil + of_law, pm4sand_soil + of_law})
            expect_alike(mirrored_dike, {"explicit", soil, 0.8, 0.5, true}, 1e-7);
        expect_alike(mirrored_dike, {"semi_implicit", ubcsand_soil + of_law, 0.8, 0.5, true}, 1e-5);
    }
}

} // namespace
} // namespace quicksand
