#include "app/commands/commands.hpp"
#include "app/run/journal.hpp"
#include "app/run/motion_text.hpp"
#include "app/run/number_format.hpp"
#include "io/files/output_folder.hpp"
#include "io/keys/scene_units.hpp"
#include "io/motions/motion_csv.hpp"
#include "io/motions/motion_record.hpp"
#include "io/pictures/picture_set.hpp"
#include "io/reports/motion_figures.hpp"
#include "io/results/run_manifest.hpp"
#include "solver/base/failure.hpp"
#include "solver/problem/motion_measures.hpp"
#include "solver/problem/motion_processing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

constexpr const char* motion_file = "motion.txt";

/// "0.3 g" or "2.9 m/s2" in m/s2. Throws InputError.
double parse_peak(const std::string& text)
{
    const auto written = split_quantity(text);
    const auto value = written ? to_si(*written, Dimension::acceleration) : std::nullopt;
    if (!value || written->unit.empty() || !(*value > 0.0))
        throw InputError("--peak: '" + text +
                         "' is no peak acceleration\nexpected: a number above 0 with its unit, "
                         "as \"0.3 g\" or \"2.9 m/s2\"");
    return *value;
}

void require_band(const MotionChoice& choice)
{
    if (choice.low_cut > 0.0 && choice.high_cut > 0.0 && choice.low_cut >= choice.high_cut)
        throw InputError(
            fmt::format("no frequency passes from --low-cut {:g} Hz to --high-cut {:g} Hz: the first "
                        "must be the smaller one",
                        choice.low_cut, choice.high_cut));
}

MotionRecord read_record(const MotionChoice& choice, Journal& journal)
{
    Diagnostics findings("record");
    const SourcePlace place{choice.file};
    const StatedUnit unit{choice.unit, "--unit", "--unit g or --unit m/s2", place};
    auto record = read_motion_record(choice.file, place, unit, findings);
    if (!record) throw_findings(findings, "");
    for (const RecordDoubt& doubt : doubt_record(record->motion, record->unit_hint, 1.0))
        findings.add(warning_at(place, "", "plausibility", doubt.what, doubt.expected, doubt.hint));
    if (!findings.empty()) journal.complain(findings.render(""));
    return std::move(*record);
}

/// A record on its way to a model, and what was done to it.
struct Processed {
    SampledMotion motion;
    SampledMotion part;             // of the record that was kept
    std::vector<std::string> steps; // one a line
    std::string note;               // the same in short

    void tell(const std::string& step, const std::string& in_short)
    {
        steps.push_back(step);
        note += (note.empty() ? "" : ", ") + in_short;
    }
};

void trim(const std::string& words, Processed& processed)
{
    const PlotRange times = parse_range(words);
    const double end = duration(processed.motion);
    processed.motion = trimmed(processed.motion, times.low, times.high);
    if (processed.motion.accelerations.size() < 2)
        throw InputError(fmt::format("--trim {}: there are fewer than two values between {:g} s and {:g} s\n"
                                     "expected: FROM:TO within 0:{:g}",
                                     words, times.low, times.high, end));
    processed.part = processed.motion;
    const std::string kept = fmt::format("{:g} to {:g} s", times.low, std::min(times.high, end));
    processed.tell("trimmed: " + kept + " of the record", kept);
}

std::string corner_text(const MotionChoice& choice)
{
    if (choice.high_cut == 0.0) return fmt::format("above {:g} Hz", choice.low_cut);
    if (choice.low_cut == 0.0) return fmt::format("below {:g} Hz", choice.high_cut);
    return fmt::format("from {:g} to {:g} Hz", choice.low_cut, choice.high_cut);
}

/// In the order of the manual: trimmed, freed of its line, filtered, scaled.
Processed process(const MotionChoice& choice, const SampledMotion& record)
{
    Processed processed{record, record, {}, ""};
    if (!choice.trim.empty()) trim(choice.trim, processed);
    if (choice.baseline == "linear") {
        processed.motion = without_linear_baseline(std::move(processed.motion));
        processed.tell("freed of the straight line that fits its accelerations best", "straight line off");
    }
    if (choice.low_cut > 0.0 || choice.high_cut > 0.0) {
        processed.motion = band_passed(processed.motion, {choice.low_cut, choice.high_cut});
        processed.tell("filtered: what lies " + corner_text(choice) + " is kept", corner_text(choice));
    }
    if (!choice.peak.empty()) {
        const double peak = parse_peak(choice.peak), present = measure(processed.motion).peak_acceleration;
        processed.motion = scaled_to_peak(std::move(processed.motion), peak);
        const std::string factor = short_number(present > 0.0 ? peak / present : 1.0, 4);
        processed.tell("multiplied by " + factor + " to a peak of " +
                           short_number(peak / standard_gravity, 4) + " g",
                       "times " + factor);
    }
    return processed;
}

std::vector<std::string> comments_of(const MotionChoice& choice, const Processed& processed)
{
    std::vector<std::string> comments{"Quicksand " + program_version(),
                                      "record: " + choice.file.filename().string()};
    comments.insert(comments.end(), processed.steps.begin(), processed.steps.end());
    return comments;
}

void draw(const MotionChoice& choice, const SampledMotion& record, const Processed& processed,
          const std::vector<OscillatorPeaks>& spectrum, const fs::path& folder)
{
    const std::string title = choice.file.filename().string(),
                      done = processed.steps.empty() ? "" : "processed";
    std::vector<NamedMotion> histories{{done, processed.motion, {}}}, spectra{{done, {}, spectrum}};
    if (!done.empty()) {
        std::vector<double> periods;
        for (const OscillatorPeaks& peaks : spectrum) periods.push_back(peaks.period);
        histories.push_back({"as recorded", processed.part, {}});
        spectra.push_back({"as recorded", {}, response_spectrum(record, periods, choice.damping / 100.0)});
    }
    const std::string damping = short_number(choice.damping, 3) + " % damping";
    draw_pictures(
        {plot_drawing(motion_histories_plot(title, processed.note, histories), folder / "histories.png"),
         plot_drawing(motion_spectra_plot("Response spectra of " + title,
                                          damping + (done.empty() ? "" : "; " + processed.note), spectra),
                      folder / "spectrum.png")});
}

} // namespace

ExitCode examine_motion(const MotionChoice& choice)
{
    Journal journal;
    require_band(choice);
    const MotionRecord record = read_record(choice, journal);
    const Processed processed = process(choice, record.motion);
    const auto spectrum =
        response_spectrum(processed.motion, spectral_periods(processed.motion), choice.damping / 100.0);
    const fs::path folder = choice.directory.empty()
                                ? fs::path("results") / (choice.file.stem().string() + "-motion")
                                : choice.directory;
    make_output_folder(folder, motion_file);
    journal.keep(folder / motion_file);
    journal.say(choice.file.string());
    for (const std::string& step : processed.steps) journal.say("  " + step);
    journal.say(describe_motion_measures(processed.motion, "--baseline linear or --low-cut") +
                describe_spectrum(spectrum, choice.damping));

    const std::vector<std::string> comments = comments_of(choice, processed);
    std::vector<std::string> of_spectrum = comments;
    of_spectrum.push_back(fmt::format("damping: {:g} %", choice.damping));
    write_record_csv(folder / "record.csv", processed.motion, comments);
    write_histories_csv(folder / "histories.csv", processed.motion, comments);
    write_spectrum_csv(folder / "spectrum.csv", spectrum, of_spectrum);
    draw(choice, record.motion, processed, spectrum, folder);
    journal.say(
        "In " + folder.string() +
        ": histories.csv and .png, spectrum.csv and .png, and record.csv for a scene's motion.file with "
        "motion.unit = \"m/s2\"");
    return ExitCode::good;
}

} // namespace quicksand
