#include "app/sweep/engine_files.hpp"

#include "geometry/drawing/gmsh_file.hpp"
#include "io/files/atomic_file.hpp"
#include "solver/base/failure.hpp"

#include <fmt/format.h>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

constexpr const char* first_line = "#!/bin/sh\n";

bool is_plain(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("_-./=:,+@%").find(c) != std::string_view::npos;
}

std::string shell_word(const std::string& word)
{
    bool plain = !word.empty();
    std::string quoted = "'";
    for (const char c : word) {
        plain = plain && is_plain(c);
        quoted += c == '\'' ? "'\\''" : std::string(1, c);
    }
    return plain ? word : quoted + "'";
}

/// `folder` in the command that a user types.
std::string in_folder(const SweepPlan& plan, const std::string& command)
{
    return "cd " + shell_word(plan.folder.string()) + " && " + command;
}

std::string write_parallel(const SweepPlan& plan)
{
    write_atomically(plan.folder / "run_parallel.sh",
                     fmt::format("{}# Started again it goes on: finished runs end at once, others from their "
                                 "checkpoint.\nparallel --jobs {} --joblog parallel.log < commands.txt\n",
                                 first_line, plan.jobs));
    return in_folder(plan, "sh run_parallel.sh");
}

std::string write_slurm(const SweepPlan& plan)
{
    const std::string at_once = plan.jobs > 1 ? fmt::format("%{}", plan.jobs) : "";
    write_atomically(plan.folder / "sweep.slurm",
                     fmt::format("{}#SBATCH --job-name=quicksand\n#SBATCH --array=1-{}{}\n"
                                 "#SBATCH --cpus-per-task={}\n#SBATCH --output=logs/slurm_%a.txt\n"
                                 "# Submitted again it goes on: finished runs end at once, others from their "
                                 "checkpoint.\n"
                                 "exec sh -c \"exec $(sed -n \"${{SLURM_ARRAY_TASK_ID}}p\" commands.txt)\"\n",
                                 first_line, plan.runs.size(), at_once, plan.threads));
    return in_folder(plan, "sbatch sweep.slurm");
}

/// A mark for each run that has ended well: the results themselves are there before a run has ended.
std::string write_snakemake(const SweepPlan& plan)
{
    write_atomically(
        plan.folder / "Snakefile",
        fmt::format("# Started again it goes on: runs that have ended are left out, others go on from their "
                    "checkpoint.\n# After a kill of snakemake itself: snakemake --unlock\n"
                    "lines = open(\"commands.txt\").read().splitlines()\n"
                    "commands = {{f\"run_{{k:04}}\": line for k, line in enumerate(lines, 1)}}\n\n"
                    "rule all:\n    input: expand(\"ended/{{name}}\", name=commands)\n\n"
                    "rule one_run:\n    output: touch(\"ended/{{name}}\")\n    threads: {}\n"
                    "    params: command=lambda wildcards: commands[wildcards.name]\n"
                    "    shell: \"{{params.command}}\"\n",
                    plan.threads));
    return in_folder(plan, fmt::format("snakemake --keep-going --cores {}", plan.jobs * plan.threads));
}

} // namespace

std::string shell_line(const std::vector<std::string>& words)
{
    std::string line;
    for (const std::string& word : words) line += (line.empty() ? "" : " ") + shell_word(word);
    return line;
}

std::string write_engine_files(const SweepPlan& plan, std::string_view engine)
{
    std::string commands;
    const std::string program = fs::read_symlink("/proc/self/exe").string();
    const std::string drawings = drawing_store_variable + ("=" + drawings_of(plan).string());
    for (const CheckedRun& run : plan.runs) {
        std::vector<std::string> words = words_of(plan, run);
        words.insert(words.begin(), {"env", drawings, program});
        const std::string line = shell_line(words);
        if (line.find('\n') != std::string::npos)
            throw InputError("a path with a line break cannot stand in commands.txt: " + line);
        commands += line + '\n';
    }
    write_atomically(plan.folder / "commands.txt", commands);
    if (engine == "parallel") return write_parallel(plan);
    if (engine == "slurm") return write_slurm(plan);
    ENSURE(engine == "snakemake");
    return write_snakemake(plan);
}

} // namespace quicksand
