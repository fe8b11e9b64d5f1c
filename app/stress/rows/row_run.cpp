#include "app/stress/rows/row_run.hpp"

#include "app/run/session.hpp"
#include "io/files/csv_file.hpp"
#include "solver/run/simulation.hpp"
#include "solver/verification/studies/step_margin.hpp"

#include <chrono>

namespace quicksand {

namespace {

Vector2 middle_of(const Particles& particles)
{
    double mass = 0.0;
    Vector2 moment = Vector2::Zero();
    for (std::size_t p = 0; p < particles.size(); ++p) {
        mass += particles.mass_solid[p];
        moment += particles.mass_solid[p] * particles.position[p];
    }
    return moment / mass;
}

/// Give grains and water the velocity and the spin of the row.
void set_in_motion(const StressRow& row, Particles& particles)
{
    if (row.is_plain()) return;
    const Vector2 middle = middle_of(particles);
    const bool flows = !particles.velocity_fluid.x.empty();
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Vector2 arm = particles.position[p] - middle;
        const Vector2 velocity = row.velocity + row.spin * Vector2(-arm.y(), arm.x());
        particles.velocity_solid.set(p, velocity);
        particles.affine_velocity_solid.xy[p] = -row.spin;
        particles.affine_velocity_solid.yx[p] = row.spin;
        if (!flows) continue;
        particles.velocity_fluid.set(p, velocity);
        particles.affine_velocity_fluid.xy[p] = -row.spin;
        particles.affine_velocity_fluid.yx[p] = row.spin;
    }
}

/// The margin as it is at the start of the shaking, and what it cost.
void measure_margin(const AssembledCase& assembled, const RowFiles& files)
{
    const auto start = std::chrono::steady_clock::now();
    State state = assembled.state;
    begin_shaking(assembled.problem, state);
    const double margin = step_margin(assembled.problem, state);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    CsvFile file =
        CsvFile::begin(files.margin(), {"largest stable step over the own one"}, {"margin", "seconds"});
    file.add_row({csv_number(margin), csv_number(seconds.count())});
    file.flush();
}

} // namespace

ExitCode run_row(const StressRow& row, const RowFiles& files)
{
    Journal journal;
    RunChoice choice;
    choice.scene.scene = files.scene();
    choice.scene.threads = 1;
    choice.directory = files.results();
    choice.overwrite = true;
    SceneSetup setup = set_up_scene(choice.scene, journal);
    setup.assembled.problem.step_fraction *= row.step_factor;
    if (row.measures_step) measure_margin(setup.assembled, files);
    set_in_motion(row, setup.assembled.state.particles);
    return run_session(choice, std::move(setup), journal).code();
}

} // namespace quicksand
