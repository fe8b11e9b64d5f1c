#include "app/commands/commands.hpp"
#include "app/run/number_format.hpp"
#include "io/files/atomic_file.hpp"
#include "io/reports/run_page.hpp"
#include "io/results/stage_table.hpp"

#include <iostream>

namespace quicksand {

ExitCode write_report(const ReportChoice& choice)
{
    ReportRequest request;
    request.results = with_histories(choice.results);
    request.required_height = choice.required_height;
    request.field = choice.field;
    request.notify = [](const std::string& text) { std::cerr << text << std::endl; };
    const std::string page = run_page(request);
    const std::filesystem::path file =
        choice.output.empty() ? request.results / "report.html" : choice.output;
    write_atomically(file, page);
    std::cout << file.string() << " (" << bytes_text(static_cast<double>(page.size()))
              << "): open it in a browser, whose print makes a PDF\n";
    return ExitCode::good;
}

} // namespace quicksand
