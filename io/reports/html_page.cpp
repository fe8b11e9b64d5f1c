#include "io/reports/html_page.hpp"

#include "io/files/atomic_file.hpp"
#include "solver/base/failure.hpp"

#include <fmt/format.h>
#include <vtkBase64Utilities.h>

#include <array>

namespace quicksand {

namespace {

constexpr std::string_view style = R"(
body { font: 15px/1.45 "DejaVu Sans", Arial, sans-serif; color: #1a1a1a; max-width: 1180px; margin: 2em auto; padding: 0 1.5em; }
h1 { font-size: 1.7em; margin-bottom: 0.2em; }
h2 { font-size: 1.2em; border-bottom: 1px solid #bbb; padding-bottom: 0.2em; margin-top: 2em; }
table { border-collapse: collapse; margin: 0.8em 0; }
th, td { border: 1px solid #ccc; padding: 0.25em 0.7em; text-align: left; vertical-align: top; }
th { background: #f0f0f0; }
img { max-width: 100%; height: auto; }
figure { margin: 1em 0; }
figcaption { color: #555; font-size: 0.9em; }
pre { background: #f6f6f6; border: 1px solid #ddd; padding: 0.8em; overflow-x: auto; font-size: 0.85em; white-space: pre-wrap; }
input[type=range] { width: 100%; }
.good { color: #00603a; } .usable { color: #8a5a00; } .bad { color: #a00000; }
.box { display: inline-block; width: 0.9em; height: 0.9em; border: 1px solid #333; }
@media print { h2 { break-after: avoid; } figure, tr { break-inside: avoid; } input[type=range], button { display: none; } }
)";

// Without scripts the last frame stays in view.
constexpr std::string_view script = R"(
document.querySelectorAll('.animation').forEach(function (animation) {
  var frames = animation.querySelectorAll('figure'), slider = animation.querySelector('input'),
      button = animation.querySelector('button'), timer = null;
  function show() {
    frames.forEach(function (frame, k) { frame.hidden = k !== Number(slider.value); });
  }
  slider.addEventListener('input', show);
  button.addEventListener('click', function () {
    if (timer) { clearInterval(timer); timer = null; button.textContent = 'Play'; return; }
    button.textContent = 'Stop';
    timer = setInterval(function () {
      slider.value = (Number(slider.value) + 1) % frames.length;
      show();
    }, 400);
  });
  show();
});
)";

/// "data:image/png;base64,..." of the file.
std::string data_address(const std::filesystem::path& png)
{
    const std::string bytes = read_text(png);
    std::vector<unsigned char> encoded(bytes.size() / 3 * 4 + 8);
    const unsigned long length = vtkBase64Utilities::Encode(
        reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), encoded.data());
    return "data:image/png;base64," +
           std::string(encoded.begin(), encoded.begin() + static_cast<long>(length));
}

std::string figure(const std::filesystem::path& png, std::string_view caption, std::string_view attributes)
{
    const std::string text = html_text(caption);
    return fmt::format("<figure{}><img alt=\"{}\" src=\"{}\"><figcaption>{}</figcaption></figure>\n",
                       attributes, text, data_address(png), text);
}

} // namespace

std::string html_text(std::string_view text)
{
    std::string result;
    for (const char letter : text) {
        switch (letter) {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '>':
            result += "&gt;";
            break;
        case '"':
            result += "&quot;";
            break;
        case '\'':
            result += "&#39;";
            break;
        default:
            result += letter;
        }
    }
    return result;
}

std::string html_table(const std::vector<std::vector<std::string>>& rows)
{
    std::string html = "<table>\n";
    const char* kind = "th";
    for (const std::vector<std::string>& row : rows) {
        html += "<tr>";
        for (const std::string& cell : row) html += fmt::format("<{0}>{1}</{0}>", kind, html_text(cell));
        html += "</tr>\n";
        kind = "td";
    }
    return html + "</table>\n";
}

std::string html_section(std::string_view heading, std::string_view body)
{
    return fmt::format("<section>\n<h2>{}</h2>\n{}</section>\n", html_text(heading), body);
}

std::string html_source(std::string_view summary, std::string_view text)
{
    return fmt::format("<details><summary>{}</summary><pre>{}</pre></details>\n", html_text(summary),
                       html_text(text));
}

std::string html_picture(const std::filesystem::path& png, std::string_view caption)
{
    return figure(png, caption, "");
}

std::string html_animation(const std::vector<std::filesystem::path>& pngs,
                           const std::vector<std::string>& captions)
{
    ENSURE(!pngs.empty() && pngs.size() == captions.size());
    std::string html = "<div class=\"animation\">\n";
    for (std::size_t k = 0; k < pngs.size(); ++k) // the last frame, which tells most, is shown first
        html += figure(pngs[k], captions[k], k + 1 == pngs.size() ? "" : " hidden");
    return html +
           fmt::format(
               "<input type=\"range\" min=\"0\" max=\"{0}\" value=\"{0}\" step=\"1\" aria-label=\"time\">\n"
               "<button type=\"button\">Play</button>\n</div>\n",
               pngs.size() - 1);
}

std::string html_page(std::string_view title, std::string_view body)
{
    return fmt::format("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                       "<title>{0}</title>\n<style>{1}</style>\n</head>\n<body>\n{2}<script>{3}</script>\n"
                       "</body>\n</html>\n",
                       html_text(title), style, body, script);
}

} // namespace quicksand
