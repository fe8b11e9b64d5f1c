// Results that a run goes on from: the stage before, or those that --from names.
#pragma once

#include "app/run/session.hpp"
#include "io/scene/scene_file.hpp"
#include "io/tables/scene_stage.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace quicksand {

/// The folder that RESULTS or RESULTS:STAGE means; of a run with stages and without a name that of its last
/// one that has an end to go on from. Throws InputError.
std::filesystem::path folder_of_end(const std::string& from);

/// Have particles parted at the water lines of the results that the scene goes on from: it goes on
/// with the same particles, whatever its own water. Leaves it as it is where the results do not tell them.
/// Throws InputError, FileError.
void part_as_in(const std::filesystem::path& folder, SceneReading& reading);

/// The same of the results that are resumed, whose scheme stays where the scene leaves it open: another end
/// of the run would choose another one.
void resume_as_in(const std::filesystem::path& folder, SceneReading& reading);

/// The end of a finished run as the origin of another one, whose scene was read as `now`. Throws InputError
/// where it has not ended well or is of another drawing, grid or water.
Origin origin_from(const std::filesystem::path& folder, const std::vector<ResolvedKey>& now,
                   const AssembledCase& assembled);

/// The end of a finished run as a state of the whole body of another scene. Throws InputError likewise.
State end_as_state(const std::filesystem::path& folder, const SceneSetup& setup);

} // namespace quicksand
