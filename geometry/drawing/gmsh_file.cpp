#include "geometry/drawing/gmsh_file.hpp"

#include "geometry/drawing/child_process.hpp"
#include "geometry/drawing/drawing_store.hpp"
#include "geometry/drawing/geo_script.hpp"
#include "geometry/drawing/lower_case.hpp"
#include "geometry/drawing/nearest_name.hpp"
#include "geometry/section/region_locator.hpp"
#include "geometry/section/section_check.hpp"
#include "solver/base/failure.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>

namespace quicksand {

namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr std::size_t most_errors_shown = 6;

/// A file in the temporary folder that goes with its owner.
class ScratchFile {
public:
    ScratchFile() : path_((fs::temp_directory_path() / "quicksand-gmsh-XXXXXX").string())
    {
        const int descriptor = mkstemp(path_.data());
        if (descriptor < 0) {
            const std::string reason = system_reason(errno);
            throw FileError(fs::temp_directory_path(), "no scratch file can be made here", reason, "");
        }
        close(descriptor);
    }
    ~ScratchFile() { unlink(path_.c_str()); }
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;
    const std::string& path() const { return path_; }

private:
    std::string path_;
};

std::string lower_case_extension(const fs::path& file)
{
    return lower_case(file.extension().string());
}

void check_parameters(const GmshRequest& request, const std::vector<std::string>& declared)
{
    for (const auto& [name, value] : request.parameters) {
        if (!std::isfinite(value))
            throw InputError(fmt::format("parameter {} = {} is not a number", name, value));
        if (std::find(declared.begin(), declared.end(), name) != declared.end()) continue;
        std::string text = fmt::format("{} declares no parameter \"{}\"", request.file.string(), name);
        const std::string nearest = nearest_name(name, declared);
        if (!nearest.empty()) text += fmt::format("; did you mean \"{}\"?", nearest);
        text += declared.empty() ? std::string("\nit declares none")
                                 : fmt::format("\ndeclared: {}", fmt::join(declared, ", "));
        throw InputError(
            text + fmt::format("\nhint: a parameter is declared so: DefineConstant[ {} = 1.0 ];", name));
    }
}

std::string first_bytes(const fs::path& file, std::size_t count)
{
    std::ifstream stream(file, std::ios::binary);
    std::string bytes(count, '\0');
    stream.read(bytes.data(), static_cast<std::streamsize>(count));
    bytes.resize(static_cast<std::size_t>(stream.gcount()));
    return bytes;
}

/// What can be said of the file without gmsh, which takes a missing file or rubbish for an empty model.
void check_file(const GmshRequest& request)
{
    const std::string name = request.file.string();
    if (!fs::exists(request.file)) throw InputError(fmt::format("{}: there is no such file", name));
    if (fs::is_directory(request.file)) {
        throw InputError(fmt::format("{}: is a folder, not a .geo or .msh file", name));
    }
    if (!fs::is_regular_file(request.file)) throw InputError(fmt::format("{}: is not a regular file", name));
    if (!std::ifstream(request.file))
        throw InputError(fmt::format("{}: cannot be read: {}", name, std::strerror(errno)));
    const std::string extension = lower_case_extension(request.file);
    if (extension != ".geo" && extension != ".geo_unrolled" && extension != ".msh") {
        throw InputError(fmt::format("{}: a section is a .geo, .geo_unrolled or .msh file", name));
    }
    const std::string head = first_bytes(request.file, 4096);
    if (head.empty()) throw InputError(fmt::format("{}: the file is empty", name));
    if (extension == ".msh") {
        if (head.rfind("$MeshFormat", 0) != 0) {
            throw InputError(fmt::format("{}: is not a gmsh mesh: it does not begin with $MeshFormat\n"
                                         "hint: save it with gmsh as MSH 2.2 or 4.1",
                                         name));
        }
        refuse_side_effects(request.file); // of options in a file beside it
        check_parameters(request, {});
        return;
    }
    if (head.find('\0') != std::string::npos) throw InputError(fmt::format("{}: is not a text file", name));
    refuse_side_effects(request.file);
    refuse_unfinished_line(request.file);
    check_parameters(request, declared_parameters(request.file));
}

/// What the helper is to do with a file.
std::vector<std::string> settings_of(const GmshRequest& request)
{
    std::vector<std::string> settings = {fmt::format("{:.17g}", request.curve_tolerance),
                                         fmt::format("{:.17g}", request.quad_size.value_or(0.0))};
    for (const auto& [name, value] : request.parameters) {
        settings.push_back(name);
        settings.push_back(fmt::format("{:.17g}", value));
    }
    return settings;
}

json run_helper(const GmshRequest& request, const fs::path& helper, const std::vector<std::string>& settings)
{
    const ScratchFile scratch;
    std::vector<std::string> arguments = {fs::absolute(request.file).string(), scratch.path()};
    arguments.insert(arguments.end(), settings.begin(), settings.end());
    const ChildResult child = run_program(helper, arguments, request.time_limit);
    const std::string name = request.file.string();
    if (child.end == ChildEnd::out_of_time) {
        throw InputError(fmt::format("{}: gmsh was stopped after {:g} s\n"
                                     "hint: look for a loop or macro without end{}",
                                     name, request.time_limit,
                                     request.quad_size ? ", or ask for larger quadrilaterals" : ""));
    }
    if (child.end == ChildEnd::signalled) {
        throw InputError(
            fmt::format("{}: gmsh crashed on it ({})\n"
                        "hint: look for a macro that calls itself, or crossing outlines; the gmsh program "
                        "itself will show where it stops",
                        name, strsignal(child.code)));
    }
    std::ifstream stream(scratch.path());
    json result = json::parse(stream, nullptr, false);
    if (child.code != 0) {
        throw FileError(scratch.path(),
                        fmt::format("gmsh gave no result for {} (exit code {})", name, child.code),
                        fmt::format("is {} full?", fs::temp_directory_path().string()), "");
    }
    // gmsh's Exit ends the helper with success before it has written anything
    if (result.is_discarded()) {
        throw InputError(fmt::format("{}: gmsh ended before the drawing was complete\n"
                                     "hint: take Exit out of the file",
                                     name));
    }
    return result;
}

bool is_usable(const json& result)
{
    return result["gmsh_errors"].empty() && result["faults"].empty() && result["mesh_errors"].empty();
}

json ask_gmsh(const GmshRequest& request)
{
    const fs::path helper = find_gmsh_helper();
    const std::vector<std::string> settings = settings_of(request);
    const char* folder = std::getenv(drawing_store_variable);
    const DrawingStore store(folder == nullptr ? "" : folder, request.file, helper, settings);
    if (std::optional<json> kept = store.find()) return *std::move(kept);
    json result = run_helper(request, helper, settings);
    if (is_usable(result)) store.keep(result);
    return result;
}

/// The first few lines; gmsh's names of the file are cut down to how the user wrote it.
std::string list_lines(const json& lines, const fs::path& file)
{
    std::string text;
    for (std::size_t k = 0; k < std::min(lines.size(), most_errors_shown); ++k) {
        std::string line = lines[k];
        const std::string whole = fs::absolute(file).string();
        const std::size_t at = line.find(whole);
        if (at != std::string::npos) line.replace(at, whole.size(), file.filename().string());
        text += "\n  " + line;
    }
    if (lines.size() > most_errors_shown)
        text += fmt::format("\n  and {} more", lines.size() - most_errors_shown);
    return text;
}

std::string hint_for_reading(const fs::path& file, const std::string& first_error)
{
    if (lower_case_extension(file) == ".msh") return "is the file complete? Save it again as MSH 2.2 or 4.1";
    if (first_error.find("syntax error") != std::string::npos) {
        return "is there a ; missing in the line before, or a word misspelt?";
    }
    return "the first line is usually the cause of the others";
}

Ring read_ring(const json& points)
{
    Ring ring;
    for (const json& point : points) ring.emplace_back(point[0].get<double>(), point[1].get<double>());
    return ring;
}

double signed_area(const Ring& ring)
{
    return area(Region{"", {Polygon{ring, {}}}});
}

/// Turn the rings of one outline (outer ones counter-clockwise, holes clockwise) into polygons.
std::vector<Polygon> assemble_polygons(const json& rings)
{
    std::vector<Polygon> polygons;
    std::vector<Ring> holes;
    for (const json& points : rings) {
        Ring ring = read_ring(points);
        if (signed_area(ring) >= 0.0) {
            polygons.push_back({std::move(ring), {}});
        } else {
            holes.push_back(std::move(ring));
        }
    }
    // a hole belongs to the smallest outer ring around it
    for (Ring& hole : holes) {
        Polygon* owner = &polygons.front();
        double least = std::numeric_limits<double>::infinity();
        const Vector2 inside_hole = 0.5 * (hole[0] + hole[1]);
        for (Polygon& polygon : polygons) {
            const double size = signed_area(polygon.outer);
            if (size >= least || !contains(Polygon{polygon.outer, {}}, inside_hole)) continue;
            least = size;
            owner = &polygon;
        }
        owner->holes.push_back(std::move(hole));
    }
    return polygons;
}

/// Turn the segment so that the soil lies on its left, where it lies on one side only.
Segment orient_segment(const RegionLocator& soil, Segment segment)
{
    const auto [left, right] = regions_beside(soil, segment);
    if (right && !left) std::swap(segment.start, segment.end);
    return segment;
}

void read_regions(const json& surfaces, Section& section)
{
    for (const json& surface : surfaces) {
        Region region{surface["name"], {}};
        for (const json& rings : surface["outlines"]) {
            for (Polygon& polygon : assemble_polygons(rings)) region.polygons.push_back(std::move(polygon));
        }
        for (const json& quad : surface.value("quads", json::array())) {
            MeshQuad mesh_quad;
            for (std::size_t k = 0; k < 4; ++k) mesh_quad.corners[k] = Vector2(quad[2 * k], quad[2 * k + 1]);
            mesh_quad.region = section.regions.size();
            section.quads.push_back(mesh_quad);
        }
        section.regions.push_back(std::move(region));
    }
}

void read_curves(const json& curves, Section& section)
{
    const RegionLocator soil(section);
    for (const json& entry : curves) {
        NamedCurve curve{entry["name"], {}};
        for (const json& line : entry["lines"]) {
            const Ring points = read_ring(line);
            for (std::size_t k = 0; k + 1 < points.size(); ++k) {
                curve.segments.push_back(orient_segment(soil, {points[k], points[k + 1]}));
            }
        }
        section.curves.push_back(std::move(curve));
    }
}

Section read_section(const json& result)
{
    Section section;
    read_regions(result["surfaces"], section);
    read_curves(result["curves"], section);
    for (const json& entry : result["points"]) {
        section.points.push_back({entry["name"], Vector2(entry["at"][0], entry["at"][1])});
    }
    for (const json& entry : result.value("nameless", json::array()))
        section.nameless.push_back({Vector2(entry[0], entry[1]), Vector2(entry[2], entry[3])});
    bound_section(section);
    return section;
}

} // namespace

fs::path find_gmsh_helper()
{
    const fs::path folder = fs::read_symlink("/proc/self/exe").parent_path();
    const fs::path places[] = {folder / "quicksand-gmsh", folder / "../libexec/quicksand/quicksand-gmsh"};
    for (const fs::path& place : places) {
        if (fs::exists(place)) return place.lexically_normal();
    }
    throw FileError(places[0], "cannot find the program that reads .geo and .msh files",
                    fmt::format("it is neither here nor at {}\n"
                                "hint: install Quicksand completely (cmake --install)",
                                places[1].lexically_normal().string()),
                    "");
}

Section read_gmsh_file(const GmshRequest& request)
{
    check_file(request);
    const json result = ask_gmsh(request);
    const std::string name = request.file.string();
    if (!result["gmsh_errors"].empty()) {
        throw InputError(fmt::format("{}: gmsh cannot read it:{}\nhint: {}", name,
                                     list_lines(result["gmsh_errors"], request.file),
                                     hint_for_reading(request.file, result["gmsh_errors"][0])));
    }
    if (!result["faults"].empty()) {
        const std::string hint = result.value("hint", "");
        throw InputError(fmt::format("{}: the section cannot be used:{}{}{}", name,
                                     list_lines(result["faults"], request.file),
                                     hint.empty() ? "" : "\nhint: ", hint));
    }
    const Section section = read_section(result);
    if (!result["mesh_errors"].empty()) {
        const std::vector<std::string> findings = check_outlines(section);
        throw InputError(
            fmt::format("{}: gmsh cannot mesh the section:{}\nhint: {}", name,
                        list_lines(result["mesh_errors"], request.file),
                        findings.empty() ? "try another size of the quadrilaterals" : findings.front()));
    }
    return section;
}

} // namespace quicksand
