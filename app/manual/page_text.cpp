#include "app/manual/page_text.hpp"

#include "io/results/run_manifest.hpp"

#include <cctype>

namespace quicksand {

std::string plain(std::string_view text)
{
    std::string guarded;
    for (const char letter : text) {
        switch (letter) {
        case '\\':
            guarded += "\\e";
            break;
        case '-': // a hyphen cannot be copied into a shell
            guarded += "\\-";
            break;
        case '\'':
            guarded += "\\(aq";
            break;
        case '"':
            guarded += "\\(dq";
            break;
        case '`':
            guarded += "\\(ga";
            break;
        case '^':
            guarded += "\\(ha";
            break;
        case '~':
            guarded += "\\(ti";
            break;
        default:
            guarded += letter;
        }
    }
    return guarded.starts_with('.') ? "\\&" + guarded : guarded;
}

std::string bold(std::string_view text)
{
    return "\\fB" + plain(text) + "\\fR";
}

std::string italic(std::string_view text)
{
    return "\\fI" + plain(text) + "\\fR";
}

std::string page_head(const std::string& name, int part, std::string_view about)
{
    std::string title;
    for (const char letter : name)
        title += static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
    const std::string manual = part == 1 ? "User Commands" : "File Formats";
    return ".TH " + plain(title) + " " + std::to_string(part) + " " QUICKSAND_RELEASE_DATE + " \"Quicksand " +
           program_version() + "\" \"" + manual + "\"\n" + section("NAME") + plain(name) + " \\- " +
           plain(about) + "\n";
}

std::string section(std::string_view title)
{
    return ".SH " + plain(title) + "\n";
}

std::string subsection(std::string_view title)
{
    return ".SS " + plain(title) + "\n";
}

std::string line(std::string_view text)
{
    return plain(text) + "\n";
}

std::string next_paragraph()
{
    return ".PP\n";
}

std::string entry(const std::string& term, const std::string& text)
{
    return ".TP\n" + term + "\n" + text + "\n";
}

} // namespace quicksand
