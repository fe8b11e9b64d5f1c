#include "app/commands/commands.hpp"
#include "app/run/number_format.hpp"
#include "io/results/result_reader.hpp"
#include "io/results/stage_table.hpp"

#include <iostream>

namespace quicksand {

ExitCode extract_probe(const ProbeChoice& choice)
{
    const ExtractRequest request{choice.at, choice.fields,
                                 choice.rides_with_soil ? ProbeKind::material : ProbeKind::fixed};
    const HistoryTable table = extract_history(with_histories(choice.results), request);
    write_history_table(choice.file, table);
    std::cout << grouped(static_cast<long long>(table.rows.size())) << " times of "
              << table.columns.size() - 1 << " columns written to " << choice.file.string() << '\n';
    return ExitCode::good;
}

} // namespace quicksand
