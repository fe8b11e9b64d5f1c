#include "io/keys/scene_schema.hpp"

#include <algorithm>

namespace quicksand {

namespace {

std::string type_text(const SceneKey& key)
{
    switch (key.type) {
    case ValueType::table:
    case ValueType::named_tables:
        return "table";
    case ValueType::number:
        return "number";
    case ValueType::integer:
        return "whole number";
    case ValueType::text:
        return "text";
    case ValueType::path:
        return "file name";
    case ValueType::point:
        return "[x, y]";
    case ValueType::point_list:
        return "list of [x, y]";
    case ValueType::count_pair:
        return "[whole number, whole number]";
    case ValueType::number_table:
        return "table of numbers";
    case ValueType::list_table:
        return "table of lists of numbers";
    case ValueType::text_list:
        return "list of texts";
    case ValueType::number_list:
    case ValueType::quantity_list:
        return "list of numbers";
    case ValueType::count_list:
        return "list of whole numbers";
    case ValueType::quantity:
        return "number or quantity";
    case ValueType::value_list:
        return "list of values";
    case ValueType::word:
        break;
    }
    std::string words;
    for (const std::string_view word : key.words)
        words += (words.empty() ? "\"" : ", \"") + std::string(word) + '"';
    return words;
}

std::string default_text(const SceneKey& key)
{
    if (key.required) return "required";
    if (key.default_value) {
        const bool words = key.type == ValueType::text || key.type == ValueType::word;
        return words ? '"' + value_text(*key.default_value) + '"' : value_text(*key.default_value);
    }
    if (!key.derived.key.empty())
        return std::string(key.derived.key) + " / " + number_text(key.derived.divisor);
    std::string choices;
    for (const auto& [word, choice] : key.derived.choices) {
        choices += (choices.empty() ? "" : ", ") + std::string(choice) + " on " + std::string(word);
    }
    return choices.empty() ? std::string(key.default_note) : choices;
}

bool is_bounded(const Interval& interval)
{
    return interval.lower > Interval().lower || interval.upper < Interval().upper;
}

std::string use_text(const SceneKey& key)
{
    std::string text;
    for (const std::string_view word : key.when.words) {
        text += (text.empty() ? "with " + std::string(key.when.sibling) + " = " : " or ") + '"' +
                std::string(word) + '"';
    }
    if (key.saturated_only && key.flows.empty())
        text += (text.empty() ? "" : ", ") + std::string("with [water]");
    for (const std::string_view flow : key.flows) {
        const bool first = flow == key.flows.front();
        text += (first ? std::string(text.empty() ? "" : ", ") + "with water.flow = " : " or ") + '"' +
                std::string(flow) + '"';
    }
    if (key.used_by_seepage) text += " or water.initial_flow = \"seepage\"";
    return text;
}

template <class Number>
std::string list_text(const std::vector<Number>& numbers)
{
    std::string list;
    for (const Number value : numbers) {
        list += (list.empty() ? "" : ", ") + number_text(static_cast<double>(value));
    }
    return "[" + list + "]";
}

} // namespace

std::string shown_path(std::string_view pattern)
{
    std::string path(pattern);
    if (const auto star = path.find('*'); star != std::string::npos) path.replace(star, 1, "NAME");
    return path;
}

bool is_table(const SceneKey& key)
{
    return key.type == ValueType::table || key.type == ValueType::named_tables;
}

std::vector<KeyProperty> key_properties(const SceneKey& key)
{
    std::vector<KeyProperty> list;
    const auto add = [&](std::string name, std::string text) {
        if (!text.empty()) list.push_back({std::move(name), std::move(text)});
    };
    const std::string unit(si_symbol(key.dimension));
    add("is", type_text(key) + (unit.empty() ? "" : " in " + unit));
    add("default", default_text(key));
    add("used", use_text(key));
    add("range", is_bounded(key.allowed) ? describe(key.allowed, key.dimension) : "");
    add("usual", is_bounded(key.plausible) ? describe(key.plausible, key.dimension) : "");
    return list;
}

std::string describe(const Interval& interval, Dimension dimension)
{
    const bool below = interval.upper<Interval().upper, above = interval.lower> Interval().lower;
    const std::string lower = quantity_text(interval.lower, dimension),
                      upper = quantity_text(interval.upper, dimension);
    if (interval.lower == interval.upper) return lower;
    if (below && above && !interval.lower_open && !interval.upper_open) {
        return number_text(interval.lower) + " to " + upper;
    }
    std::string text;
    if (above)
        text = (interval.lower_open ? "more than " : "at least ") +
               (below ? number_text(interval.lower) : lower);
    if (below && above) text += " and ";
    if (below) text += (interval.upper_open ? "less than " : "at most ") + upper;
    return text.empty() ? "any number" : text;
}

std::string value_text(const SceneValue& value)
{
    struct Writer {
        std::string operator()(double number) const { return number_text(number); }
        std::string operator()(std::int64_t number) const { return std::to_string(number); }
        std::string operator()(const std::string& text) const { return text; }
        std::string operator()(const Vector2& point) const
        {
            return "[" + number_text(point.x()) + ", " + number_text(point.y()) + "]";
        }
        std::string operator()(const std::pair<int, int>& pair) const
        {
            return "[" + std::to_string(pair.first) + ", " + std::to_string(pair.second) + "]";
        }
        std::string operator()(const std::map<std::string, double>& numbers) const
        {
            std::string text;
            for (const auto& [name, number] : numbers) {
                text += (text.empty() ? " " : ", ") + join_path({name}) + " = " + number_text(number);
            }
            return text.empty() ? "{}" : "{" + text + " }";
        }
        std::string operator()(const std::map<std::string, std::vector<double>>& lists) const
        {
            std::string text;
            for (const auto& [name, numbers] : lists) {
                text += (text.empty() ? " " : ", ") + join_path({name}) + " = " + list_text(numbers);
            }
            return text.empty() ? "{}" : "{" + text + " }";
        }
        std::string operator()(const std::vector<int>& counts) const { return list_text(counts); }
        std::string operator()(const std::vector<std::string>& texts) const
        {
            std::string list;
            for (const std::string& text : texts) list += (list.empty() ? "\"" : ", \"") + text + '"';
            return "[" + list + "]";
        }
        std::string operator()(const std::vector<double>& numbers) const
        {
            std::string list;
            for (const double number : numbers) list += (list.empty() ? "" : ", ") + number_text(number);
            return "[" + list + "]";
        }
        std::string operator()(const std::vector<Vector2>& points) const
        {
            std::string list;
            for (const Vector2& point : points) list += (list.empty() ? "" : ", ") + operator()(point);
            return "[" + list + "]";
        }
    };
    return std::visit(Writer(), value);
}

std::string describe_keys(const KeyTable& table, std::string_view pattern)
{
    std::string text;
    for (const SceneKey& key : table.keys) {
        const std::string path = shown_path(key.pattern);
        if (path.find(pattern) == std::string::npos) continue;
        if (is_table(key)) {
            text += (text.empty() ? "" : "\n") + ("[" + path + "]  ") + std::string(key.doc) + "\n";
            if (!key.default_note.empty()) text += "    absent   " + std::string(key.default_note) + "\n";
            continue;
        }
        text += path + "\n    " + std::string(key.doc) + "\n";
        for (const KeyProperty& property : key_properties(key)) {
            text +=
                "    " + property.name + std::string(9 - property.name.size(), ' ') + property.text + "\n";
        }
    }
    return text;
}

std::string keys_markdown(const KeyTable& table)
{
    constexpr std::string_view columns =
        "\n| key | is | default | range | usual | meaning |\n|---|---|---|---|---|---|\n";
    std::string text = "# " + std::string(table.title) + "\n" + std::string(columns);
    for (const SceneKey& key : table.keys) {
        if (is_table(key)) {
            const bool holds_keys = key.type == ValueType::table;
            text += "\n## [" + shown_path(key.pattern) + "]\n\n" + std::string(key.doc) + "\n" +
                    (holds_keys ? std::string(columns) : "");
            continue;
        }
        std::map<std::string, std::string> cells;
        for (const KeyProperty& property : key_properties(key)) cells[property.name] = property.text;
        if (!cells["used"].empty()) cells["default"] += " (" + cells["used"] + ")";
        text += "| `" + std::string(last_part(key.pattern)) + "` | " + cells["is"] + " | " +
                cells["default"] + " | " + cells["range"] + " | " + cells["usual"] + " | " +
                std::string(key.doc) + " |\n";
    }
    return text;
}

} // namespace quicksand
