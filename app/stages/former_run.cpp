#include "app/stages/former_run.hpp"

#include "io/results/run_record.hpp"

namespace quicksand {

FormerRun former_run(const ResultsFolder& folder, const std::string& hash)
{
    if (!std::filesystem::exists(folder.manifest())) return FormerRun::none;
    const RunRecord record = read_run_record(folder.manifest());
    if (record.scene_hash != hash) return FormerRun::none;
    if (record.status == "finished") return FormerRun::finished;
    return std::filesystem::exists(folder.checkpoint()) ? FormerRun::with_checkpoint
                                                        : FormerRun::without_checkpoint;
}

void take_up(FormerRun former, RunChoice& choice)
{
    choice.resume = former == FormerRun::with_checkpoint;
    choice.overwrite = former == FormerRun::without_checkpoint;
}

} // namespace quicksand
