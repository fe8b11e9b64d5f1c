#include "io/results/run_manifest.hpp"
#include "solver/base/failure.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace quicksand {

TEST(RunManifest, HashIsFnv1aOfTheText)
{
    // published values of the FNV-1a 64 test suite
    EXPECT_EQ(scene_hash("", {}), "cbf29ce484222325");
    EXPECT_EQ(scene_hash("foobar", {}), "85944171f73967e8");
    EXPECT_NE(scene_hash("foobar", {"a=1"}), scene_hash("foobar", {"a=2"}));
    EXPECT_NE(scene_hash("foo", {"bar"}), scene_hash("foobar", {}));
}

TEST(RunManifest, TellsWhatTheRunWasAndHowItEnded)
{
    const fixtures::TemporaryFolder folder;
    const Scene scene = fixtures::small_scene();
    RunManifest manifest = begin_manifest(scene, {"time.end=2"}, 2, 48);
    write_run_manifest(folder / "run_manifest.json", manifest);
    auto json = nlohmann::json::parse(fixtures::text_of(folder / "run_manifest.json"));
    EXPECT_EQ(json["status"], "running");
    EXPECT_EQ(json["scene_hash"], scene_hash(scene.text, {"time.end=2"}));
    EXPECT_EQ(json["version"], program_version());
    EXPECT_EQ(json["outputs"],
              nlohmann::json({"fields.pvd", "grid.pvd", "probes/rider.csv", "probes/point.csv",
                              "probes/crest.csv", "probes/line.csv", "history.csv", "steps.csv"}));
    EXPECT_FALSE(json.contains("resumed_at_s"));

    manifest.status = RunStatus::failed;
    manifest.exit_reason = "not a number in the pore pressure";
    manifest.steps = 1000;
    manifest.wall_time = 2.0;
    manifest.resumed_at = 0.5;
    manifest.end_time = utc_now();
    write_run_manifest(folder / "run_manifest.json", manifest);
    json = nlohmann::json::parse(fixtures::text_of(folder / "run_manifest.json"));
    EXPECT_EQ(json["status"], "failed");
    EXPECT_EQ(json["exit_reason"], manifest.exit_reason);
    EXPECT_EQ(json["particle_steps_per_s"], 24000.0);
    EXPECT_EQ(json["resumed_at_s"], 0.5);
    EXPECT_EQ(json["overrides"][0], "time.end=2");
    EXPECT_EQ(std::string(json["end_time"]).size(), std::string("2025-01-01T00:00:00Z").size());
    EXPECT_FALSE(fixtures::any_temporary_file(folder.path()));
}

TEST(RunManifest, ItsStatusReadsBack)
{
    const fixtures::TemporaryFolder folder;
    const std::filesystem::path file = folder / "run_manifest.json";
    EXPECT_EQ(read_run_status(file), std::nullopt);
    RunManifest manifest = begin_manifest(fixtures::small_scene(), {}, 1, 1);
    for (const RunStatus status :
         {RunStatus::running, RunStatus::finished, RunStatus::failed, RunStatus::stopped}) {
        manifest.status = status;
        write_run_manifest(file, manifest);
        EXPECT_EQ(read_run_status(file), status);
    }
    for (const char* damaged :
         {"", "[]", "{\"status\": 1}", "{\"status\": \"lost\"}", "{\"status\": \"fin"}) {
        std::ofstream(file) << damaged;
        EXPECT_EQ(read_run_status(file), std::nullopt) << damaged;
    }
}

TEST(RunManifest, TellsWhichInputHasChanged)
{
    const fixtures::TemporaryFolder folder;
    Scene scene = fixtures::small_scene();
    scene.file = folder / "scene.toml";
    const auto given = [](const char* path, const char* value) { return ResolvedKey{path, value, "", true}; };
    const std::vector<ResolvedKey> keys = {given("title", "no file"), given("geometry.file", "a.geo"),
                                           given("motion.file", "record.csv"),
                                           given("boundaries.\"a b\".history", "load.csv")};
    std::ofstream(folder / "a.geo") << "Include \"layers.geo\";\n";
    for (const char* name : {"layers.geo", "record.csv", "load.csv"}) std::ofstream(folder / name) << name;
    RunManifest manifest = begin_manifest(scene, {}, 1, 1);
    const std::filesystem::path file = folder / "run_manifest.json";
    EXPECT_NO_THROW(require_same_inputs(file, input_files(scene, keys))); // there is none yet
    write_run_manifest(file, manifest);
    EXPECT_NO_THROW(require_same_inputs(file, input_files(scene, keys))); // it tells of no files
    manifest.inputs = input_files(scene, keys);
    ASSERT_EQ(manifest.inputs.size(), 4U);
    EXPECT_EQ(manifest.inputs[1].key, "geometry.file > layers.geo");
    write_run_manifest(file, manifest);
    EXPECT_NO_THROW(require_same_inputs(file, input_files(scene, keys)));
    for (const char* name : {"layers.geo", "record.csv", "load.csv"}) {
        std::ofstream(folder / name) << "edited";
        try {
            require_same_inputs(file, input_files(scene, keys));
            ADD_FAILURE() << name << " may change";
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(std::string(name) + ": the file has changed"),
                      std::string::npos)
                << error.what();
        }
        std::ofstream(folder / name) << name;
    }
}

TEST(RunManifest, SurvivesAFileNameThatIsNotUtf8)
{
    const fixtures::TemporaryFolder folder;
    Scene scene = fixtures::small_scene();
    scene.file = "d\xffke.toml";
    write_run_manifest(folder / "run_manifest.json", begin_manifest(scene, {}, 1, 1));
    EXPECT_TRUE(nlohmann::json::accept(fixtures::text_of(folder / "run_manifest.json")));
}

} // namespace quicksand
