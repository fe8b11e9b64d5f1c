#include "app/stages/former_run.hpp"

#include "io/results/run_record.hpp"

namespace quicksand {

FormerRun former_run(const ResultsFolder& folder, const SceneHashes& hashes)
{
    if (!std::filesystem::exists(folder.manifest())) return FormerRun::none;
    const RunRecord record = read_run_record(folder.manifest());
    if (record.state_hash != hashes.state) return FormerRun::none;
    if (record.status == "finished" && record.scene_hash == hashes.scene) return FormerRun::finished;
    return std::filesystem::exists(folder.checkpoint()) ? FormerRun::with_checkpoint
                                                        : FormerRun::without_checkpoint;
}

void take_up(FormerRun former, RunChoice& choice)
{
    choice.resume = former == FormerRun::with_checkpoint;
    choice.overwrite = former == FormerRun::without_checkpoint;
}

} // namespace quicksand
