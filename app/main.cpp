// The program quicksand: one command a call, failures sorted into exit codes.
#include "app/commands/command_line.hpp"
#include "app/machine/process_settings.hpp"
#include "io/files/file_error.hpp"
#include "solver/base/failure.hpp"

#include <filesystem>
#include <iostream>
#include <new>
#include <system_error>

namespace {

using quicksand::ExitCode;

ExitCode report(const char* what, ExitCode code)
{
    std::cout.flush();
    std::cerr << what << std::endl;
    return code;
}

ExitCode report_bug(const char* what)
{
    report(what, ExitCode::bug);
    std::cerr
        << "This is a bug of Quicksand, not of your input. Please report it with this text and the scene."
        << std::endl;
    return ExitCode::bug;
}

/// Of a thread that the system does not start; what else it refuses is told where it is asked for.
ExitCode report_refusal(const std::system_error& error)
{
    if (error.code() != std::errc::resource_unavailable_try_again) return report_bug(error.what());
    return report("the system does not start another thread\nhint: ask for fewer with --threads, or raise "
                  "the limits of memory (ulimit -v) or of processes (ulimit -u)",
                  ExitCode::files);
}

ExitCode execute(int argument_count, char** arguments)
{
    try {
        return quicksand::execute_command_line(argument_count, arguments);
    } catch (const quicksand::InputError& error) {
        return report(error.what(), ExitCode::input);
    } catch (const quicksand::NumericalError& error) {
        return report(error.what(), ExitCode::numerical);
    } catch (const quicksand::FileError& error) {
        return report(error.what(), ExitCode::files);
    } catch (const std::filesystem::filesystem_error& error) {
        return report(error.what(), ExitCode::files);
    } catch (const std::system_error& error) {
        return report_refusal(error);
    } catch (const std::bad_alloc&) {
        return report("not enough memory\nhint: larger cells and fewer particles per cell need less",
                      ExitCode::files);
    } catch (const std::exception& error) {
        return report_bug(error.what());
    }
}

/// A full disk under the standard output may show only now. A failure that has been told goes before it, and
/// a reader who has left wants no more: files and log.txt are complete without him.
ExitCode require_output(ExitCode code)
{
    std::cout.flush();
    if (std::cout || code != ExitCode::good || quicksand::reader_has_left()) return code;
    return report("standard output cannot be written: the output is incomplete", ExitCode::files);
}

} // namespace

int main(int argument_count, char** arguments)
{
    quicksand::apply_process_settings(arguments);
    quicksand::let_writes_fail();
    return static_cast<int>(require_output(execute(argument_count, arguments)));
}
