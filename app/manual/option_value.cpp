#include "app/manual/option_value.hpp"

#include <string_view>

namespace quicksand {

namespace {

/// The words of "{a,b,c}", which is how CLI11 describes a choice; none when the text is no such list.
std::vector<std::string> listed_words(const std::string& text)
{
    if (!text.starts_with('{') || !text.ends_with('}')) return {};
    return CLI::detail::split(text.substr(1, text.size() - 2), ',');
}

std::string validator_text(CLI::Option& option)
{
    try {
        return option.get_validator()->get_description();
    } catch (const CLI::OptionNotFound&) {
        return "";
    }
}

} // namespace

OptionValue value_of(CLI::Option& option)
{
    OptionValue value;
    if (option.get_items_expected_max() == 0) return value;
    const std::string text = validator_text(option);
    value.words = listed_words(text);
    if (value.words.empty()) value.allowed = text;
    if (option.get_positional()) {
        value.name = option.get_name(true);
        return value;
    }
    const std::string type = option.get_type_name(); // the validator's text stands behind it
    value.name = text.empty() ? type : type.substr(0, type.size() - text.size() - 1);
    return value;
}

} // namespace quicksand
