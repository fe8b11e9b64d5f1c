#include "io/files/csv_file.hpp"

#include "io/files/atomic_file.hpp"
#include "io/files/file_error.hpp"
#include "solver/base/failure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <sstream>
#include <system_error>
#include <utility>

namespace quicksand {

namespace fs = std::filesystem;

namespace {

void append_number(double value, std::string& text)
{
    if (!std::isnan(value)) fmt::format_to(std::back_inserter(text), "{}", value);
}

} // namespace

std::string csv_number(double value)
{
    std::string text;
    append_number(value, text);
    return text;
}

std::string csv_text(const std::string& text)
{
    std::string result = "\"";
    for (const char letter : text) result += letter == '"' ? "\"\"" : std::string(1, letter);
    return result + '"';
}

std::string csv_header(const std::vector<std::string>& comments, const std::vector<std::string>& columns)
{
    std::string text;
    for (const std::string& comment : comments) text += "# " + comment + "\n";
    return text + fmt::format("{}\n", fmt::join(columns, ","));
}

CsvRow csv_cells(const std::string& line)
{
    CsvRow cells;
    std::size_t begin = 0;
    for (std::size_t comma = line.find(','); comma != std::string::npos; comma = line.find(',', begin)) {
        cells.push_back(line.substr(begin, comma - begin));
        begin = comma + 1;
    }
    cells.push_back(line.substr(begin));
    return cells;
}

double csv_value(const std::string& cell)
{
    double value = 0.0;
    const auto parsed = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    return parsed.ec == std::errc() ? value : std::numeric_limits<double>::quiet_NaN();
}

CsvFile::CsvFile(fs::path path, std::vector<std::string> columns)
    : path_(std::move(path)), columns_(std::move(columns)), file_(std::fopen(path_.c_str(), "ab"))
{
    if (!file_) throw FileError(path_, "cannot open for writing", system_reason(errno), "");
}

CsvFile CsvFile::begin(const fs::path& path, const std::vector<std::string>& comments,
                       const std::vector<std::string>& columns)
{
    std::error_code error;
    if (path.has_parent_path()) fs::create_directories(path.parent_path(), error);
    if (error) throw FileError(path.parent_path(), "cannot create the folder", error.message(), "");
    write_atomically(path, csv_header(comments, columns));
    return CsvFile(path, columns);
}

CsvFile CsvFile::resume(const fs::path& path, const std::vector<std::string>& comments,
                        const std::vector<std::string>& columns, double time)
{
    if (!fs::exists(path)) return begin(path, comments, columns);
    const std::string text = read_text(path);
    std::string kept;
    std::vector<std::string> rows;
    bool header_seen = false;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        const bool torn = stream.eof(); // no line end: the row was cut off by a kill or a full disk
        if (line.starts_with('#')) {
            kept += line + "\n";
        } else if (!header_seen) {
            if (torn || csv_cells(line) != columns)
                throw FileError(path, "cannot go on with the file", "its columns are not those of this run",
                                "use --overwrite to begin anew");
            header_seen = true;
            kept += line + "\n";
        } else if (!torn && csv_value(line.substr(0, line.find(','))) <= time) {
            kept += line + "\n";
            rows.push_back(line);
        }
    }
    if (!header_seen) return begin(path, comments, columns);
    if (kept != text) write_atomically(path, kept);
    CsvFile file(path, columns);
    for (const std::string& row : rows) file.remember(row);
    return file;
}

void CsvFile::remember(const std::string& line)
{
    CsvRow row = csv_cells(line);
    if (!first_row_) first_row_ = row;
    if (!last_rows_.empty() && last_rows_.front().front() != row.front()) last_rows_.clear();
    last_rows_.push_back(std::move(row));
}

std::optional<double> CsvFile::last_time() const
{
    if (last_rows_.empty()) return std::nullopt;
    return csv_value(last_rows_.front().front());
}

double CsvFile::value(const CsvRow& row, const std::string& column) const
{
    const auto found = std::find(columns_.begin(), columns_.end(), column);
    ENSURE(found != columns_.end());
    return csv_value(row.at(static_cast<std::size_t>(found - columns_.begin())));
}

void CsvFile::add_row(const CsvRow& row)
{
    pending_ += fmt::format("{}\n", fmt::join(row, ","));
}

void CsvFile::add_numbers(const std::vector<double>& numbers)
{
    for (const double& number : numbers) {
        if (&number != numbers.data()) pending_ += ',';
        append_number(number, pending_);
    }
    pending_ += '\n';
}

void CsvFile::flush()
{
    errno = 0;
    const bool written = std::fwrite(pending_.data(), 1, pending_.size(), file_.get()) == pending_.size();
    if (!written || std::fflush(file_.get()) != 0)
        throw FileError(path_, "cannot write", system_reason(errno), "the rows before are complete");
    pending_.clear();
}

} // namespace quicksand
