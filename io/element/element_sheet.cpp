#include "io/element/element_sheet.hpp"

#include "io/element/element_panels.hpp"
#include "io/element/element_table.hpp"

namespace quicksand {

namespace {

constexpr std::size_t table_rows = 18; // that stand beside a panel

} // namespace

LaboratorySheet report_sheet(const ElementOutcome& outcome, const std::string& title)
{
    LaboratorySheet sheet;
    sheet.title = title.empty() ? "Element test " + outcome.test.name : title + " – " + outcome.test.name;
    sheet.details = describe_conditions(outcome);
    for (NamedPanel& named : element_panels(outcome)) sheet.panels.push_back(std::move(named.panel));
    sheet.table = result_table(outcome, table_rows);
    return sheet;
}

void draw_element_pictures(const ElementOutcome& outcome, const std::string& title, ElementResults& results)
{
    LaboratorySheet sheet = report_sheet(outcome, title);
    std::vector<Drawing> pages = {sheet_drawing(sheet, results.add(outcome.test.name, "report.png"))};
    sheet.table.clear();
    for (NamedPanel& named : element_panels(outcome)) {
        sheet.panels = {std::move(named.panel)};
        pages.push_back(sheet_drawing(sheet, results.add(outcome.test.name, named.name + ".png")));
    }
    draw_pictures(pages);
}

} // namespace quicksand
