// quicksand-gmsh: read one file with gmsh and write what it holds as JSON.
//
//   quicksand-gmsh FILE RESULT CURVE_TOLERANCE QUAD_SIZE [NAME VALUE]...
//
// A tolerance of 0 stands for 1e-4 of the model's size, a quad size of 0 for outlines only. Everything wrong
// with the file goes into RESULT; the exit code is 0 once RESULT is written. Only Quicksand calls this
// program, and it stops this program at its time limit.
#include "geometry/drawing/execution_guard.hpp"
#include "geometry/drawing/gmsh_model.hpp"

#include <nlohmann/json.hpp>
#include <sys/prctl.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <set>
#include <sstream>
#include <string_view>

namespace quicksand {

namespace {

using nlohmann::json;

constexpr rlim_t most_memory = rlim_t(8) << 30; // a loop without end stops here [bytes]
constexpr int highest_tag = 1'000'000;          // of a physical group; names are looked for up to it [-]
constexpr int most_quads = 4'000'000;
constexpr const char* group_words[] = {"Physical Point", "Physical Curve", "Physical Surface"};

/// The distinct lines gmsh has logged as errors since its log was started.
std::vector<std::string> logged_errors()
{
    std::vector<std::string> log, errors;
    gmsh::logger::get(log);
    std::set<std::string> seen;
    constexpr std::string_view mark = "Error: ";
    for (const std::string& line : log) {
        if (line.compare(0, mark.size(), mark) != 0) continue;
        const std::string text = line.substr(mark.size());
        if (seen.insert(text).second) errors.push_back(text);
    }
    return errors;
}

/// Run one step of gmsh; what it throws (a std::string) joins the errors it logs.
template <class Step>
std::vector<std::string> errors_of(const Step& step)
{
    gmsh::logger::start();
    std::string thrown;
    try {
        step();
    } catch (const std::string& text) {
        thrown = text;
    } catch (const std::exception& error) {
        thrown = error.what();
    }
    std::vector<std::string> errors = logged_errors();
    gmsh::logger::stop();
    if (!thrown.empty() && errors.empty()) errors.push_back(thrown);
    return errors;
}

/// A number as one writes it, six digits.
std::string write_number(double number)
{
    std::ostringstream text;
    text << number;
    return text.str();
}

/// Add what is wrong with the groups of a dimension: without a name, or named and empty.
void check_groups(int dimension, const gmsh::vectorpair& groups, json& faults)
{
    const std::string word = group_words[dimension];
    int highest = 0;
    for (const auto& [group_dimension, tag] : groups) {
        highest = std::max(highest, tag);
        if (group_dimension != dimension) continue;
        std::string name;
        gmsh::model::getPhysicalName(dimension, tag, name);
        const std::string number = std::to_string(tag);
        if (name.empty()) {
            faults.push_back(word + "(" + number + ") has no name; write " + word + "(\"name\", " + number +
                             ") = {...};");
        } else if (tag > highest_tag) {
            faults.push_back(word + "(\"" + name + "\", " + number + ") has a tag above " +
                             std::to_string(highest_tag) + "; leave it out: " + word + "(\"" + name +
                             "\") = {...};");
        }
    }
    // gmsh drops a group whose entities do not exist, but keeps its name
    const int last = std::min(highest, highest_tag) + 1000;
    for (int tag = 1; tag <= last; ++tag) {
        std::string name;
        gmsh::model::getPhysicalName(dimension, tag, name);
        std::vector<int> entities;
        if (!name.empty()) gmsh::model::getEntitiesForPhysicalGroup(dimension, tag, entities);
        if (name.empty() || !entities.empty()) continue;
        faults.push_back(word + "(\"" + name + "\") is empty: what it lists does not exist in the model");
    }
}

std::vector<PhysicalGroup> groups_of(int dimension)
{
    gmsh::vectorpair tags;
    gmsh::model::getPhysicalGroups(tags, dimension);
    std::vector<PhysicalGroup> groups;
    for (const auto& [group_dimension, tag] : tags) {
        PhysicalGroup group;
        gmsh::model::getPhysicalName(dimension, tag, group.name);
        gmsh::model::getEntitiesForPhysicalGroup(dimension, tag, group.entities);
        groups.push_back(std::move(group));
    }
    return groups;
}

json faults_of_groups()
{
    json faults = json::array();
    gmsh::vectorpair groups, surfaces;
    gmsh::model::getPhysicalGroups(groups);
    for (int dimension = 2; dimension >= 0; --dimension) check_groups(dimension, groups, faults);
    if (!faults.empty() || !groups_of(2).empty()) return faults;

    gmsh::model::getEntities(surfaces, 2);
    faults.push_back(surfaces.empty() ? "it has no surface: nothing says where the soil is"
                                      : "it has " + std::to_string(surfaces.size()) +
                                            " surface(s) but no physical surface: "
                                            "Quicksand takes the soil from named physical surfaces");
    return faults;
}

/// Whether the surfaces came as elements, without geometry.
bool is_discrete(const std::vector<PhysicalGroup>& surfaces)
{
    std::string type;
    for (const PhysicalGroup& group : surfaces) {
        for (const int surface : group.entities) {
            gmsh::model::getType(2, surface, type);
            if (type.rfind("Discrete", 0) == 0) return true;
        }
    }
    return false;
}

/// Size of the model's box [m].
double model_size()
{
    double lower[3], upper[3];
    gmsh::model::getBoundingBox(-1, -1, lower[0], lower[1], lower[2], upper[0], upper[1], upper[2]);
    return std::hypot(upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2]);
}

/// x and y of the points; one off the plane z = 0 is a fault.
json flatten(const Polyline& line, const std::string& owner, json& faults)
{
    const double thickness = 1e-9 * model_size();
    json points = json::array();
    for (const Point3& point : line) {
        if (!(std::abs(point[2]) <= thickness)) {
            faults.push_back(owner + " leaves the plane z = 0 at (" + write_number(point[0]) + ", " +
                             write_number(point[1]) + ", " + write_number(point[2]) +
                             "); a section is drawn in x and y, with y up");
            break;
        }
        points.push_back({point[0], point[1]});
    }
    return points;
}

std::string quote_group(int dimension, const PhysicalGroup& group)
{
    return std::string(group_words[dimension]) + "(\"" + group.name + "\")";
}

json flatten_all(const std::vector<Polyline>& lines, const std::string& owner, json& faults)
{
    json flat = json::array();
    for (const Polyline& line : lines) {
        flat.push_back(flatten(line, owner, faults));
        if (!faults.empty()) break;
    }
    return flat;
}

/// Boxes of drawn surfaces that no group has.
void write_nameless(json& result)
{
    std::set<int> named;
    for (const PhysicalGroup& group : groups_of(2))
        named.insert(group.entities.begin(), group.entities.end());
    gmsh::vectorpair surfaces;
    gmsh::model::getEntities(surfaces, 2);
    for (const auto& [dimension, surface] : surfaces) {
        if (named.count(surface) > 0) continue;
        double lower[3], upper[3];
        gmsh::model::getBoundingBox(2, surface, lower[0], lower[1], lower[2], upper[0], upper[1], upper[2]);
        result["nameless"].push_back({lower[0], lower[1], upper[0], upper[1]});
    }
}

/// Outlines, curves and points of geometry drawn in a .geo file.
void write_drawing(double curve_tolerance, json& result)
{
    CurveDrawings drawings(curve_tolerance > 0.0 ? curve_tolerance : 1e-4 * model_size());
    json& faults = result["faults"];
    for (const PhysicalGroup& group : groups_of(2)) {
        json outlines = json::array();
        for (const int surface : group.entities) {
            outlines.push_back(
                flatten_all(outline_surface(surface, drawings), quote_group(2, group), faults));
        }
        result["surfaces"].push_back({{"name", group.name}, {"outlines", outlines}});
    }
    for (const PhysicalGroup& group : groups_of(1)) {
        std::vector<Polyline> lines;
        for (const int curve : group.entities) lines.push_back(drawings.draw(curve));
        result["curves"].push_back(
            {{"name", group.name}, {"lines", flatten_all(lines, quote_group(1, group), faults)}});
    }
}

/// The same of a mesh read from a file.
void write_mesh_outlines(const NodeTable& nodes, json& result)
{
    json& faults = result["faults"];
    for (const PhysicalGroup& group : groups_of(2)) {
        const std::vector<Polyline> rings = outline_elements(group, nodes);
        if (rings.empty()) faults.push_back(quote_group(2, group) + " has no elements");
        json outlines = json::array({flatten_all(rings, quote_group(2, group), faults)});
        result["surfaces"].push_back({{"name", group.name}, {"outlines", outlines}});
    }
    for (const PhysicalGroup& group : groups_of(1)) {
        const std::vector<Polyline> chords = chords_of_elements(group, nodes);
        if (chords.empty()) {
            faults.push_back(quote_group(1, group) +
                             " has no line elements; save the mesh with its physical curves");
        }
        result["curves"].push_back(
            {{"name", group.name}, {"lines", flatten_all(chords, quote_group(1, group), faults)}});
    }
}

void write_points(json& result)
{
    for (const PhysicalGroup& group : groups_of(0)) {
        for (const int point : group.entities) {
            std::vector<double> at;
            gmsh::model::getValue(0, point, {}, at);
            result["points"].push_back({{"name", group.name}, {"at", {at.at(0), at.at(1)}}});
        }
    }
}

void write_quads(const NodeTable& nodes, json& result)
{
    const std::vector<PhysicalGroup> surfaces = groups_of(2);
    json& faults = result["faults"];
    for (std::size_t surface = 0; surface < surfaces.size(); ++surface) {
        json quads = json::array();
        for (const Quad& quad : quads_of_elements(surfaces[surface], nodes)) {
            quads.push_back({quad[0][0], quad[0][1], quad[1][0], quad[1][1], quad[2][0], quad[2][1],
                             quad[3][0], quad[3][1]});
        }
        if (quads.empty()) faults.push_back(quote_group(2, surfaces[surface]) + " was left without elements");
        result["surfaces"][surface]["quads"] = std::move(quads);
    }
}

/// Recombined quadrilaterals. Algorithm 8, meant for them, crashes gmsh 4.8; recombination 3 leaves the
/// fewest triangles.
void mesh_with_quads(double quad_size)
{
    for (const auto& [option, value] :
         std::initializer_list<std::pair<const char*, double>>{{"Mesh.Algorithm", 6},
                                                               {"Mesh.RecombineAll", 1},
                                                               {"Mesh.RecombinationAlgorithm", 3},
                                                               {"Mesh.MeshSizeFromPoints", 0},
                                                               {"Mesh.MeshSizeFromCurvature", 0},
                                                               {"Mesh.MeshSizeExtendFromBoundary", 0},
                                                               {"Mesh.MeshSizeMin", quad_size},
                                                               {"Mesh.MeshSizeMax", quad_size},
                                                               {"Mesh.ElementOrder", 1}}) {
        gmsh::option::setNumber(option, value);
    }
    gmsh::model::mesh::clear();
    gmsh::model::mesh::generate(2);
}

double drawn_area(const json& surfaces)
{
    double twice = 0.0;
    for (const json& surface : surfaces) {
        for (const json& rings : surface["outlines"]) {
            for (const json& ring : rings) {
                Polyline line;
                for (const json& point : ring) line.push_back({point[0], point[1], 0.0});
                twice += twice_signed_area(line);
            }
        }
    }
    return 0.5 * twice;
}

void read_model(double curve_tolerance, double quad_size, json& result)
{
    json& faults = result["faults"];
    faults = faults_of_groups();
    if (!faults.empty()) {
        result["hint"] = "name soil, boundaries and points so: Physical Surface(\"sand\") = {1}; "
                         "Physical Curve(\"base\") = {1};";
        return;
    }

    const bool as_elements = is_discrete(groups_of(2));
    if (as_elements) {
        write_mesh_outlines(NodeTable(), result);
    } else {
        write_drawing(curve_tolerance, result);
    }
    write_nameless(result);
    write_points(result);
    if (!faults.empty() || quad_size <= 0.0) return;

    if (!as_elements) {
        if (drawn_area(result["surfaces"]) > most_quads * quad_size * quad_size) {
            faults.push_back("quadrilaterals of " + write_number(quad_size) + " m would be more than " +
                             std::to_string(most_quads) + " in this section");
            return;
        }
        result["mesh_errors"] = errors_of([&] { mesh_with_quads(quad_size); });
        if (!result["mesh_errors"].empty()) return;
    }
    write_quads(NodeTable(), result);
}

/// Open the file with its parameters replaced.
std::vector<std::string> open_file(int argument_count, char** arguments)
{
    std::string program = arguments[0], set_number = "-setnumber";
    std::vector<char*> options = {program.data()};
    for (int k = 5; k + 1 < argument_count; k += 2) {
        options.insert(options.end(), {set_number.data(), arguments[k], arguments[k + 1]});
    }
    // false: a user's own gmsh options must not change results
    gmsh::initialize(static_cast<int>(options.size()), options.data(), false);
    // errors are logged instead of thrown: thrown while meshing they end the process
    gmsh::option::setNumber("General.AbortOnError", 0);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.NumThreads", 1);
    return errors_of([&] { gmsh::open(arguments[1]); });
}

json read_file(int argument_count, char** arguments)
{
    json result = {{"gmsh_errors", json::array()}, {"mesh_errors", json::array()}, {"faults", json::array()},
                   {"surfaces", json::array()},    {"curves", json::array()},      {"points", json::array()}};
    try {
        result["gmsh_errors"] = open_file(argument_count, arguments);
        if (result["gmsh_errors"].empty())
            read_model(std::stod(arguments[3]), std::stod(arguments[4]), result);
    } catch (const std::string& text) {
        result["faults"].push_back(text);
    } catch (const std::bad_alloc&) {
        result["faults"].push_back(
            "it needs more memory than gmsh is given (8 GiB); is there a loop without end?");
    } catch (const std::exception& error) {
        result["faults"].push_back(std::string("gmsh failed on it: ") + error.what());
    }
    return result;
}

} // namespace

} // namespace quicksand

int main(int argument_count, char** arguments)
{
    if (argument_count < 5) return EXIT_FAILURE;
    prctl(PR_SET_PDEATHSIG, SIGKILL); // never outlive the program that asked
#ifndef __SANITIZE_ADDRESS__          // whose shadow memory is larger than any limit
    const rlimit memory = {quicksand::most_memory, quicksand::most_memory};
    setrlimit(RLIMIT_AS, &memory);
#endif
    quicksand::forbid_other_programs();
    const nlohmann::json result = quicksand::read_file(argument_count, arguments);
    std::ofstream file(arguments[2]);
    // error texts may quote bytes of a file that is not text
    file << result.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    file.flush();
    // gmsh's own clean-up has nothing left to do, and may crash after errors
    std::_Exit(file ? EXIT_SUCCESS : EXIT_FAILURE);
}
