#include "geometry/drawing/drawing_store.hpp"

#include "geometry/drawing/geo_script.hpp"
#include "geometry/drawing/text_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <string_view>
#include <system_error>

namespace quicksand {

namespace {

using nlohmann::json;
namespace fs = std::filesystem;

/// Whether nothing but the text decides what gmsh makes of it. Words within others only make it careful.
bool is_whole(std::string_view text)
{
    constexpr std::string_view words[] = {"ShapeFromFile", "GetEnv", "Rand",       "Cpu",
                                          "Memory",        "Today",  "FileExists", "CurrentDir"};
    return std::none_of(std::begin(words), std::end(words),
                        [&](std::string_view word) { return text.find(word) != std::string_view::npos; });
}

/// A program that was installed anew reads drawings anew.
std::string identity_of(const fs::path& program)
{
    return fmt::format("{} {} {}", program.string(), fs::file_size(program),
                       fs::last_write_time(program).time_since_epoch().count());
}

} // namespace

DrawingStore::DrawingStore(const fs::path& folder, const fs::path& drawing, const fs::path& helper,
                           const std::vector<std::string>& arguments)
{
    if (folder.empty()) return;
    json made_from = {identity_of(helper), arguments};
    for (const fs::path& file : opened_files(drawing)) {
        const std::string text = read_text(file);
        if (!is_whole(text)) return;
        made_from.push_back({file.filename().string(), text});
    }
    try {
        made_from_ = made_from.dump();
    } catch (const json::exception&) {
        return; // bytes that are no text: they could not be told apart
    }
    file_ = folder / fmt::format("{:016x}.json", std::hash<std::string>()(made_from_));
}

std::optional<json> DrawingStore::find() const
{
    if (file_.empty()) return std::nullopt;
    std::ifstream stream(file_);
    const json kept = json::parse(stream, nullptr, false);
    // another drawing may have the same number
    if (!kept.is_object() || !kept.contains("result") || kept.value("made_from", json()) != made_from_)
        return std::nullopt;
    return kept["result"];
}

void DrawingStore::keep(const json& result) const
{
    if (file_.empty()) return;
    // whole or not at all: other runs read it at any time
    const fs::path part = file_.string() + "." + std::to_string(getpid());
    std::error_code failure;
    fs::create_directories(file_.parent_path(), failure);
    std::ofstream stream(part);
    stream << json{{"made_from", made_from_}, {"result", result}}.dump();
    stream.close();
    if (stream) fs::rename(part, file_, failure);
    if (!stream || failure) fs::remove(part, failure);
}

} // namespace quicksand
