#include "io/faces/boundary_keys.hpp"

#include "io/faces/boundary_kinds.hpp"

namespace quicksand {

namespace {

using enum ValueType;

template <class Kind>
std::vector<std::string_view> words_of(const std::vector<Kind>& kinds)
{
    std::vector<std::string_view> words;
    for (const Kind& kind : kinds) words.push_back(kind.word);
    return words;
}

/// The keys of the kinds, each used with the word of its kind alone.
template <class Kind>
void add_keys(std::string_view sibling, const std::vector<Kind>& kinds, std::vector<SceneKey>& keys)
{
    for (const Kind& kind : kinds) {
        for (SceneKey key : kind.keys) {
            key.when = {sibling, {kind.word}};
            keys.push_back(std::move(key));
        }
    }
}

using WordPairs = std::vector<std::pair<std::string_view, std::string_view>>;

/// Words of the water by those of the soil beside it, where the scene gives none.
const WordPairs& water_beside_soil()
{
    static const WordPairs pairs = [] {
        WordPairs all;
        for (const SceneSoilKind& kind : soil_kinds()) all.emplace_back(kind.word, kind.water);
        return all;
    }();
    return pairs;
}

/// "free, fixed or tied to the opposite side."
const std::string& doc_of_soil()
{
    static const std::string doc = [] {
        std::string text;
        const std::vector<SceneSoilKind>& kinds = soil_kinds();
        for (std::size_t k = 0; k < kinds.size(); ++k)
            text += (k == 0 ? "" : k + 1 < kinds.size() ? ", " : ", or ") + std::string(kinds[k].doc);
        return text + ".";
    }();
    return doc;
}

// One row, one key: the formatter would make it ten lines.
// clang-format off

std::vector<SceneKey> keys_of_every_kind()
{
    return {
        {.pattern = "boundaries", .type = named_tables, .doc = "Conditions on the physical curves."},
        {.pattern = "boundaries.*", .type = table, .doc = "One physical curve of the drawing, by its name."},
        {.pattern = "boundaries.*.soil", .type = word, .default_value = "free",
         .words = words_of(soil_kinds()), .doc = doc_of_soil()},
        {.pattern = "boundaries.*.water", .type = word, .saturated_only = true,
         .derived = {.sibling = "soil", .choices = water_beside_soil()},
         .words = words_of(water_kinds()),
         .doc = "Whether pore water passes the curve, with the still water or the phreatic line beyond it, or what "
                "head or pressure it has there."},
        // no part of the condition: it tells which two curves belong together
        {.pattern = "boundaries.*.tied_to", .type = text, .required = true, .when = {"soil", {"tied"}},
         .doc = "The opposite curve, whose points of equal height move together with this one's."},
    };
}

std::vector<SceneKey> history_keys()
{
    const Interval positive{.lower = 0.0, .lower_open = true};
    return {
        {.pattern = "boundaries.*.ramp_time", .dimension = Dimension::time, .default_note = "at once",
         .allowed = positive,
         .doc = "Time over which what acts on the curve rises linearly, a head from the water at rest, "
                "or from where the stage before left it, as a load does that the stage changes."},
        {.pattern = "boundaries.*.frequency", .dimension = Dimension::frequency, .default_note = "no wave",
         .allowed = positive, .doc = "What acts on the curve varies as sin(2 pi f t) times its value, a head or pore pressure about the water at rest."},
        {.pattern = "boundaries.*.history", .type = path, .default_note = "constant",
         .doc = "Two columns, time in s and the factor on what acts on the curve, of a head or pore pressure on its difference from the water at rest; linear in between. Headers with other units are refused."},
    };
}

// clang-format on

} // namespace

std::vector<SceneKey> boundary_keys()
{
    std::vector<SceneKey> keys = keys_of_every_kind();
    add_keys("soil", soil_kinds(), keys);
    add_keys("water", water_kinds(), keys);
    for (SceneKey& key : history_keys()) keys.push_back(std::move(key));
    return keys;
}

} // namespace quicksand
