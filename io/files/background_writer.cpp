#include "io/files/background_writer.hpp"

#include "solver/base/threads.hpp"
#include "solver/run/simulation.hpp"

#include <chrono>
#include <utility>

namespace quicksand {

void BackgroundWriter::write(const State& state, Job job)
{
    finish();
    copy_ = state;
    under_way_ = std::async(std::launch::async, [this, job = std::move(job)] {
        set_thread_count(1); // of this thread: the others belong to the run
        job(copy_);
    });
}

void BackgroundWriter::report_failure()
{
    if (under_way_.valid() && under_way_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
        under_way_.get();
}

void BackgroundWriter::finish()
{
    if (under_way_.valid()) under_way_.get();
}

void BackgroundWriter::wait() const
{
    if (under_way_.valid()) under_way_.wait();
}

} // namespace quicksand
