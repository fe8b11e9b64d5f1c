#include "app/stress/rows/row_files.hpp"

#include "io/files/atomic_file.hpp"

namespace quicksand {

RowFiles files_of(const std::filesystem::path& laboratory, const StressRow& row)
{
    return {laboratory / row.group / row.name};
}

void write_row(const StressRow& row, const RowFiles& files)
{
    std::filesystem::create_directories(files.folder);
    for (const auto& path : {files.results(), files.margin()}) std::filesystem::remove_all(path);
    write_atomically(files.drawing(), row.drawing);
    write_atomically(files.scene(), row.scene);
}

void remove_results(const RowFiles& files)
{
    for (const auto& path : {files.results(), files.words(), files.complaints(), files.margin()})
        std::filesystem::remove_all(path);
}

} // namespace quicksand
