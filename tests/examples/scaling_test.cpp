// The shake table at the scale of its model and in full scale is the same problem: lengths and times 120
// times as large, accelerations a 120th, velocities, stresses and pressures as they are.
#include "io/pictures/picture_table.hpp"
#include "tests/examples/program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace quicksand {

namespace {

using namespace testing_program;

constexpr double scale = 120.0;
constexpr double scaling_tolerance = 0.01; // of a history's largest value

/// What the model's value is multiplied by to be that in full scale.
double scale_of(const std::string& column)
{
    static const std::map<std::string, double> factors = {
        {"time_s", scale}, {"distance_m", scale}, {"x_m", scale},           {"y_m", scale},
        {"ux_m", scale},   {"uy_m", scale},       {"ax_m_s2", 1.0 / scale}, {"ay_m_s2", 1.0 / scale}};
    const auto found = factors.find(column);
    return found == factors.end() ? 1.0 : found->second;
}

/// Largest difference over the largest value, both in full scale [-].
double difference(const std::vector<double>& model, const std::vector<double>& full, double factor)
{
    double most = 0.0, apart = 0.0;
    for (std::size_t row = 0; row < std::min(model.size(), full.size()); ++row) {
        if (std::isnan(model[row]) && std::isnan(full[row])) continue;
        most = std::max(most, std::abs(full[row]));
        apart = std::max(apart, std::abs(factor * model[row] - full[row]));
    }
    return most > 0.0 ? apart / most : apart;
}

/// Seven cycles on cells three times as large, 3 of them side by side. Later the sand liquefies and enlarges
/// rounding: a porosity that is 1e-14 larger moves the surface's shear stress by 5 % of its largest one.
void run_shortened(const std::string& scene, double length, const std::filesystem::path& results)
{
    const auto metres = [&](double value) { return std::to_string(length * value); };
    const Outcome run = run_program(
        "run " + example("shake_table") + "/" + scene +
        " --threads 1 --set grid.cell_size=" + metres(0.0225) + " --set 'grid.origin=[" + metres(-0.0675) +
        ",0.0]' --set 'grid.cells=[9,16]'" + " --set 'geometry.parameters={ width = " + metres(0.0675) +
        ", height = " + metres(0.315) + " }' --until " + metres(0.04) + " -o " + results.string());
    ASSERT_EQ(run.code, 0) << run.output;
}

TEST(ShakeTable, IsTheSameInModelScaleAndInFullScale)
{
    const WorkFolder folder;
    run_shortened("scene.toml", 1.0, folder / "model");
    run_shortened("prototype.toml", scale, folder / "full");
    for (const char* probe : {"height_13m", "height_25m", "surface", "centre_line"}) {
        const std::string file = std::string("probes/") + probe + ".csv";
        const PictureTable model = read_picture_table(folder / ("model/" + file)),
                           full = read_picture_table(folder / ("full/" + file));
        ASSERT_EQ(model.columns, full.columns);
        ASSERT_GT(model.values.front().size(), 180U);
        ASSERT_EQ(model.values.front().size(), full.values.front().size());
        for (std::size_t c = 0; c < model.columns.size(); ++c) {
            const std::string& column = model.columns[c];
            EXPECT_LT(difference(model.values[c], full.values[c], scale_of(column)), scaling_tolerance)
                << probe << ' ' << column;
        }
    }
    const PictureTable lower = read_picture_table(folder / "full/probes/height_25m.csv");
    const std::vector<double>& ru = *lower.find("ru");
    EXPECT_GT(*std::max_element(ru.begin(), ru.end()), 0.3) << "the shaking should have raised pressures";
}

} // namespace

} // namespace quicksand
