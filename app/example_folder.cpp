#include "app/example_folder.hpp"

#include "io/file_error.hpp"

namespace quicksand {

std::vector<std::string> example_names()
{
    return {"column", "dike"};
}

std::filesystem::path example_folder(const std::string& name)
{
    namespace fs = std::filesystem;
    const fs::path program = fs::read_symlink("/proc/self/exe");
    const fs::path installed =
        program.parent_path().parent_path() / "share" / "quicksand" / "examples" / name;
    const fs::path source = fs::path(QUICKSAND_EXAMPLES) / name;
    for (const fs::path& folder : {installed, source}) {
        if (fs::exists(folder / "scene.toml")) return folder;
    }
    throw FileError(installed, "cannot find the example", "the installation is not complete", "");
}

} // namespace quicksand
