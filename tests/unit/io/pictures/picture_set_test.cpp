#include "io/frames/vtk_series.hpp"
#include "io/pictures/picture_field.hpp"
#include "io/pictures/picture_set.hpp"
#include "io/results/output_observers.hpp"
#include "solver/base/failure.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <string>

namespace quicksand {

using fixtures::TemporaryFolder;

namespace {

void run_small_scene(bool saturated, const std::filesystem::path& results)
{
    const Problem problem = fixtures::small_problem(saturated);
    State state = fixtures::small_state(problem);
    const Scene scene = fixtures::small_scene();
    const auto observers = make_output_observers(scene, problem, state, {results, "abc", "abc", false});
    std::vector<Observer*> pointers;
    for (const auto& observer : observers) pointers.push_back(observer.get());
    run(problem, scene.end_time, pointers, state);
}

std::vector<std::string> names_of(const std::vector<std::filesystem::path>& files)
{
    std::vector<std::string> names;
    for (const auto& file : files) names.push_back(file.filename().string());
    return names;
}

std::string refusal(const std::filesystem::path& results, const PictureRequest& request)
{
    try {
        draw_results(results, request);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST(DrawResults, MakesTheDefaultSet)
{
    const TemporaryFolder folder;
    run_small_scene(true, folder.path());
    const auto files = draw_results(folder.path(), {});
    EXPECT_EQ(names_of(files),
              (std::vector<std::string>{"excess_pore_pressure.png", "displacement.png", "shear_strain.png",
                                        "probe_crest.png", "probe_line.png", "probe_point.png",
                                        "probe_rider.png", "history.png"}));
    for (const auto& file : files) {
        EXPECT_EQ(file.parent_path(), folder / "pictures");
        EXPECT_GT(std::filesystem::file_size(file), 5'000u) << file;
        EXPECT_LT(std::filesystem::file_size(file), 1'000'000u) << file;
    }
}

TEST(DrawResults, OfADrySceneShowsTheEffectiveStress)
{
    const TemporaryFolder folder;
    run_small_scene(false, folder.path());
    EXPECT_EQ(names_of(draw_results(folder.path(), {})).front(), "mean_effective_stress.png");
}

TEST(DrawResults, DrawsOneFieldAtTheNearestTime)
{
    const TemporaryFolder folder;
    run_small_scene(true, folder.path());
    std::string remark;
    PictureRequest request;
    request.field = "displacement_x";
    request.time = 0.011;
    request.exaggeration = 100.0;
    request.notify = [&remark](const std::string& text) { remark = text; };
    EXPECT_EQ(names_of(draw_results(folder.path(), request)),
              std::vector<std::string>{"displacement_x_0.01s.png"});
    EXPECT_EQ(remark, "there is no frame at t = 0.011 s; drawn is the nearest, t = 0.01 s");

    request.output = folder / "elsewhere/u.png";
    EXPECT_EQ(draw_results(folder.path(), request), std::vector<std::filesystem::path>{request.output});
    EXPECT_TRUE(std::filesystem::exists(request.output));
}

TEST(DrawResults, RefusesWhatMakesNoSense)
{
    const TemporaryFolder folder;
    run_small_scene(true, folder.path());
    PictureRequest request;
    request.field = "excess_pore_presure";
    const std::string unknown = refusal(folder.path(), request);
    EXPECT_NE(unknown.find("did you mean 'excess_pore_pressure'?"), std::string::npos) << unknown;
    EXPECT_NE(unknown.find("velocity_solid, velocity_solid_x"), std::string::npos) << unknown;
    EXPECT_FALSE(std::filesystem::exists(folder / "pictures"));

    request.field = "";
    request.range = PlotRange{0.0, 1.0};
    EXPECT_NE(refusal(folder.path(), request).find("--field"), std::string::npos);
    request.field = "ru";
    request.range = PlotRange{1.0, 0.0};
    EXPECT_NE(refusal(folder.path(), request).find("the range 1:0 is empty"), std::string::npos);
    request = {};
    request.output = "a.png";
    EXPECT_NE(refusal(folder.path(), request).find("the default set has several"), std::string::npos);
    request = {};
    request.exaggeration = -1.0;
    EXPECT_EQ(refusal(folder.path(), request),
              "displacements cannot be drawn -1 times as large: zero or more is allowed");
}

TEST(DrawResults, NeedsAFrame)
{
    const TemporaryFolder folder;
    const VtkSeries empty(folder / "fields.pvd");
    EXPECT_EQ(refusal(folder.path(), {}), (folder / "fields.pvd").string() + ": there is no frame in it yet");
}

TEST(ParseRange, ReadsTwoNumbersAndRefusesTheRest)
{
    EXPECT_EQ(parse_range("-1.5:9e3").low, -1.5);
    EXPECT_EQ(parse_range("-1.5:9e3").high, 9000.0);
    for (const std::string text : {"", ":", "1", "1:", "a:2", "1:2:3", "nan:1", "0:inf", "1 :2"}) {
        try {
            parse_range(text);
            ADD_FAILURE() << text;
        } catch (const InputError& error) {
            EXPECT_EQ(error.what(),
                      "'" + text +
                          "' is no range: write two numbers in SI units with a colon between, as in "
                          "0:9e3");
        }
    }
}

TEST(DrawnField, TakesMagnitudesUnitsAndSigns)
{
    ParticleFrame frame;
    frame.scalars = {{"displacement_x", {3.0, -3.0}},  {"displacement_y", {4.0, 0.0}},
                     {"velocity_solid_x", {1.0, 1.0}}, {"velocity_solid_y", {0.0, 0.0}},
                     {"shear_strain", {0.0, 0.1}},     {"particle_id", {0.0, 1.0}}};
    frame.units = {{"displacement_x", "m"}, {"displacement_y", "m"}, {"shear_strain", "-"}};
    EXPECT_EQ(drawn_field(frame, "displacement")->values, (std::vector<double>{5.0, 3.0}));
    EXPECT_EQ(drawn_field(frame, "displacement")->unit, "m");
    EXPECT_EQ(drawn_field(frame, "displacement")->colours, ColourMap::sequential);
    EXPECT_EQ(drawn_field(frame, "displacement_x")->colours, ColourMap::diverging);
    EXPECT_EQ(drawn_field(frame, "velocity")->label, "Velocity of the grains");
    EXPECT_EQ(drawn_field(frame, "shear_strain")->unit, "%");
    EXPECT_FALSE(drawn_field(frame, "velocity_fluid"));
    EXPECT_EQ(drawable_fields(frame),
              (std::vector<std::string>{"displacement", "displacement_x", "displacement_y", "shear_strain",
                                        "velocity_solid", "velocity_solid_x", "velocity_solid_y"}));
}

} // namespace quicksand
