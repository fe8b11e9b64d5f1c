#include "io/reports/motion_figures.hpp"
#include "solver/base/conventions.hpp"

#include <gtest/gtest.h>

namespace quicksand {

TEST(MotionFigures, ShowAccelerationsInG)
{
    const SampledMotion record{0.005, {0.0, 1.25, -2.0, 1.0 / 3.0}};
    const std::vector<NamedMotion> motions{{"processed", record, response_spectrum(record, {0.1, 1.0}, 0.05)},
                                           {"as recorded", record, {}}};
    const LinePlot histories = motion_histories_plot("a.AT2", "a note", motions);
    ASSERT_EQ(histories.panels.size(), 3U);
    EXPECT_EQ(histories.panels[0].y_label, "Acceleration [g]");
    ASSERT_EQ(histories.panels[0].curves.size(), 2U);
    EXPECT_EQ(histories.panels[0].curves[1].name, "processed") << "is drawn last, on top";
    EXPECT_DOUBLE_EQ(histories.panels[0].curves[1].y[2], -2.0 / standard_gravity);
    const LinePlot spectra = motion_spectra_plot("a.AT2", "", motions);
    EXPECT_EQ(spectra.panels[0].y_label, "Pseudo-acceleration [g]");
    EXPECT_EQ(spectra.panels[2].x_scale, AxisScale::logarithmic);
}

} // namespace quicksand
