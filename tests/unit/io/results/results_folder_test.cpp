#include "io/files/file_error.hpp"
#include "io/results/results_folder.hpp"
#include "solver/base/failure.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace quicksand {

using fixtures::TemporaryFolder;

namespace {

void touch(const std::filesystem::path& path, const std::string& text = "")
{
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text;
}

void pretend_former_run(const TemporaryFolder& folder)
{
    touch(folder / "run_manifest.json");
    touch(folder / "scene.toml", "title = \"other\"\n");
    touch(folder / "fields.pvd");
    touch(folder / "fields/frame_000000.vtu");
    touch(folder / "fields/frame_000001.vtu.tmp");
    touch(folder / "probes/a.csv", "# Quicksand 0.1.0\n");
    touch(folder / "checkpoint/state.h5");
}

std::string folder_refusal(const TemporaryFolder& folder, FolderUse use)
{
    try {
        prepare_results_folder(folder.path(), fixtures::small_scene(), use);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST(ResultsFolder, IsMadeWithACopyOfTheScene)
{
    const TemporaryFolder folder;
    const Scene scene = fixtures::small_scene();
    const ResultsFolder results = prepare_results_folder(folder / "a/b", scene, FolderUse::fresh);
    EXPECT_EQ(fixtures::text_of(results.scene_copy()), scene.text);
    EXPECT_EQ(results.log(), folder / "a/b/log.txt");
}

TEST(ResultsFolder, OfAReportTakesThePresentSceneAndOneWriterAtATime)
{
    const TemporaryFolder folder;
    Scene scene = fixtures::small_scene();
    prepare_report_folder(folder / "report", "check.txt", scene);
    touch(folder / "report/check.txt");
    touch(folder / "report/fields.pvd"); // of the report
    scene.text += "# edited\n";
    const ResultsFolder held = prepare_report_folder(folder / "report", "check.txt", scene);
    EXPECT_EQ(fixtures::text_of(held.scene_copy()), scene.text);
    EXPECT_THROW(prepare_report_folder(folder / "report", "check.txt", scene), InputError);
    pretend_former_run(folder);
    EXPECT_THROW(prepare_report_folder(folder.path(), "check.txt", scene), InputError);
    touch(folder / "check.txt"); // the run has come into the folder of a report
    EXPECT_THROW(prepare_report_folder(folder.path(), "check.txt", scene), InputError);
}

TEST(ResultsFolder, RemovesFramesAlone)
{
    const TemporaryFolder folder;
    remove_frames({folder.path()}); // there are none
    for (const char* frame : {"fields.pvd", "fields/frame_000000.vtu", "fields/frame_000001.vtu.tmp",
                              "grid.pvd", "grid/frame_000000.vtu"})
        touch(folder / frame);
    for (const char* other : {"fields/picture.png", "stability.csv"}) touch(folder / other);
    remove_frames({folder.path()});
    for (const char* gone :
         {"fields.pvd", "fields/frame_000000.vtu", "fields/frame_000001.vtu.tmp", "grid.pvd", "grid"})
        EXPECT_FALSE(std::filesystem::exists(folder / gone)) << gone;
    for (const char* kept : {"fields/picture.png", "stability.csv"})
        EXPECT_TRUE(std::filesystem::exists(folder / kept)) << kept;
}

TEST(ResultsFolder, RefusesAFormerRun)
{
    const TemporaryFolder folder;
    pretend_former_run(folder);
    EXPECT_EQ(folder_refusal(folder, FolderUse::fresh),
              folder.path().string() +
                  " holds a former run (fields.pvd). Choose another folder, or run with --resume to go on "
                  "with it, or run with --overwrite to replace it");
    EXPECT_TRUE(std::filesystem::exists(folder / "fields/frame_000000.vtu"));
}

TEST(ResultsFolder, KeepsOtherRunsOut)
{
    const TemporaryFolder folder;
    {
        const ResultsFolder first =
            prepare_results_folder(folder.path(), fixtures::small_scene(), FolderUse::fresh);
        const std::string message = folder_refusal(folder, FolderUse::overwrite);
        EXPECT_NE(message.find("is being written by another run"), std::string::npos) << message;
        EXPECT_NE(message.find("choose another folder"), std::string::npos) << message;
        EXPECT_TRUE(std::filesystem::exists(first.scene_copy())) << "nothing is removed";
    }
    touch(folder / "run_manifest.json");
    EXPECT_EQ(folder_refusal(folder, FolderUse::overwrite), "") << "the first run is over";
}

TEST(ResultsFolder, CannotBeHeldWhereThereIsNone)
{
    const TemporaryFolder folder;
    try {
        const FolderLock lock(folder / "nowhere");
        FAIL() << "there is no such folder";
    } catch (const FileError& error) {
        EXPECT_NE(std::string(error.what()).find("cannot open the folder"), std::string::npos)
            << error.what();
    }
}

TEST(ResultsFolder, OverwriteRemovesOnlyWhatQuicksandWrote)
{
    const TemporaryFolder folder;
    pretend_former_run(folder);
    touch(folder / "notes.txt", "mine");
    touch(folder / "probes/measured.csv", "t,u\n");
    touch(folder / "fields/picture.png");
    prepare_results_folder(folder.path(), fixtures::small_scene(), FolderUse::overwrite);
    for (const char* kept : {"notes.txt", "probes/measured.csv", "fields/picture.png", "scene.toml"})
        EXPECT_TRUE(std::filesystem::exists(folder / kept)) << kept;
    for (const char* gone : {"run_manifest.json", "fields.pvd", "fields/frame_000000.vtu",
                             "fields/frame_000001.vtu.tmp", "probes/a.csv", "checkpoint"})
        EXPECT_FALSE(std::filesystem::exists(folder / gone)) << gone;
    EXPECT_EQ(fixtures::text_of(folder / "scene.toml"), fixtures::small_scene().text);
}

TEST(ResultsFolder, OverwriteRemovesTheManifestLast)
{
    const TemporaryFolder folder;
    pretend_former_run(folder);
    touch(folder / "log.txt/mine"); // a folder that cannot be removed: it ends the removal as a kill would
    try {
        prepare_results_folder(folder.path(), fixtures::small_scene(), FolderUse::overwrite);
        ADD_FAILURE() << "no error";
    } catch (const FileError& error) {
        EXPECT_NE(std::string(error.what()).find("log.txt: cannot remove the file of the former run: "),
                  std::string::npos)
            << error.what();
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "fields.pvd"));
    EXPECT_TRUE(std::filesystem::exists(folder / "run_manifest.json"));
    std::filesystem::remove_all(folder / "log.txt");
    EXPECT_NE(folder_refusal(folder, FolderUse::fresh).find("--overwrite"), std::string::npos);
    EXPECT_EQ(folder_refusal(folder, FolderUse::overwrite), "");
}

TEST(ResultsFolder, AdvisesNothingThatItWouldRefuse)
{
    const TemporaryFolder folder;
    touch(folder / "log.txt");
    const std::string message = folder_refusal(folder, FolderUse::fresh);
    EXPECT_NE(message.find("Choose another folder"), std::string::npos) << message;
    EXPECT_EQ(message.find("--overwrite"), std::string::npos) << message;
    EXPECT_EQ(message.find("--resume"), std::string::npos) << message;
}

TEST(ResultsFolder, OverwriteLeavesAForeignFolderAlone)
{
    const TemporaryFolder folder;
    touch(folder / "history.csv", "somebody else's");
    EXPECT_NE(folder_refusal(folder, FolderUse::overwrite).find("no run_manifest.json"), std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(folder / "history.csv"));
}

TEST(ResultsFolder, NeverReplacesTheSceneItself)
{
    const TemporaryFolder folder;
    Scene scene = fixtures::small_scene();
    scene.file = folder / "scene.toml";
    touch(scene.file, scene.text);
    try {
        prepare_results_folder(folder.path(), scene, FolderUse::overwrite);
        ADD_FAILURE() << "no error";
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()),
                  folder.path().string() + " is the scene's own folder: choose another one for the results");
    }
    EXPECT_TRUE(std::filesystem::exists(scene.file));
}

TEST(ResultsFolder, ResumeNeedsACheckpoint)
{
    const TemporaryFolder folder;
    EXPECT_NE(folder_refusal(folder, FolderUse::resume).find("checkpoint/state.h5"), std::string::npos);
    pretend_former_run(folder);
    EXPECT_EQ(folder_refusal(folder, FolderUse::resume), "");
    EXPECT_TRUE(std::filesystem::exists(folder / "fields/frame_000000.vtu"));
}

TEST(ResultsFolder, RefusesAFileInItsPlace)
{
    const TemporaryFolder folder;
    touch(folder / "out");
    EXPECT_THROW(prepare_results_folder(folder / "out", fixtures::small_scene(), FolderUse::fresh),
                 InputError);
}

} // namespace quicksand
