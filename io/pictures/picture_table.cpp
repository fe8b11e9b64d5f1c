#include "io/pictures/picture_table.hpp"

#include "io/files/atomic_file.hpp"
#include "io/files/csv_file.hpp"

#include <algorithm>
#include <cstddef>
#include <sstream>

namespace quicksand {
namespace {

std::string without_mark(const std::string& comment)
{
    const std::size_t begin = comment.find_first_not_of("# ");
    return begin == std::string::npos ? "" : comment.substr(begin);
}

void add_row(const std::string& line, PictureTable& table)
{
    const CsvRow cells = csv_cells(line);
    if (cells.size() != table.columns.size()) return;
    for (std::size_t c = 0; c < cells.size(); ++c) table.values[c].push_back(csv_value(cells[c]));
}

} // namespace

const std::vector<double>* PictureTable::find(std::string_view column) const
{
    const auto found = std::find(columns.begin(), columns.end(), column);
    return found == columns.end() ? nullptr : &values[static_cast<std::size_t>(found - columns.begin())];
}

std::string PictureTable::comment(std::string_view key) const
{
    const auto found = std::find_if(comments.begin(), comments.end(),
                                    [key](const std::string& text) { return text.starts_with(key); });
    return found == comments.end() ? "" : found->substr(key.size());
}

PictureTable read_picture_table(const std::filesystem::path& file)
{
    PictureTable table;
    std::istringstream text(read_text(file));
    for (std::string line; std::getline(text, line);) {
        if (line.ends_with('\r')) line.pop_back();
        if (line.empty()) continue;
        if (line.front() == '#') {
            table.comments.push_back(without_mark(line));
        } else if (table.columns.empty()) {
            table.columns = csv_cells(line);
            table.values.resize(table.columns.size());
        } else {
            add_row(line, table);
        }
    }
    return table;
}

} // namespace quicksand
