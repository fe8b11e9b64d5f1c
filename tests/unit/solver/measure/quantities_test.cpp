// The table of quantities: rows that cannot be mistaken for each other, and what is made of them.
#include "solver/measure/body_quantities.hpp"
#include "solver/measure/quantities.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace quicksand {
namespace {

TEST(Quantities, HaveNamesAndColumnsOfTheirOwn)
{
    std::set<std::string> names, columns;
    for (const Quantity& quantity : all_quantities()) {
        EXPECT_FALSE(quantity.label.empty() || quantity.unit.empty() || quantity.meaning.empty())
            << quantity.name;
        for (std::size_t c = 0; c < component_count(quantity.form); ++c) {
            EXPECT_TRUE(names.insert(component_name(quantity, c)).second) << quantity.name;
            if ((quantity.places & at_probes) == 0) continue;
            EXPECT_TRUE(columns.insert(probe_column(quantity, c)).second) << quantity.name;
        }
    }
}

TEST(Quantities, AreKnownByAParticleUnlessAProbeFindsThem)
{
    for (const Quantity& quantity : all_quantities()) {
        EXPECT_NE(quantity.places, 0) << quantity.name;
        EXPECT_EQ(quantity.value == nullptr, quantity.found_by == FoundBy::change) << quantity.name;
        EXPECT_TRUE(quantity.value != nullptr || quantity.places == at_probes) << quantity.name;
        const bool averaged = quantity.found_by == FoundBy::average && (quantity.places & at_probes) != 0;
        EXPECT_TRUE(!averaged || (quantity.places & on_nodes) != 0) << quantity.name;
    }
}

TEST(Quantities, NameTheirNumbersWithUnits)
{
    const Quantity& displacement = quantity_named("displacement");
    EXPECT_EQ(component_name(displacement, 1), "displacement_y");
    EXPECT_EQ(component_label(displacement, 1), "Vertical displacement, up");
    EXPECT_EQ(probe_column(displacement, 1), "uy_m");
    EXPECT_EQ(probe_column(quantity_named("acceleration"), 0), "ax_m_s2");
    EXPECT_EQ(probe_column(quantity_named("position"), 0), "x_m");
    EXPECT_EQ(probe_column(quantity_named("shear_stress_xy"), 0), "shear_stress_xy_Pa");
    EXPECT_EQ(probe_column(quantity_named("ru"), 0), "ru");
    EXPECT_EQ(component_label(quantity_named("stress"), 0), "Effective stress xx, tension positive");
    EXPECT_EQ(unit_suffix("N s"), "_N_s");
    EXPECT_EQ(unit_suffix("-"), "");
}

TEST(Quantities, AreFoundByTheNamesOfTheirNumbers)
{
    const QuantityComponent found = find_component("stress_xy");
    ASSERT_NE(found.quantity, nullptr);
    EXPECT_EQ(found.quantity->name, "stress");
    EXPECT_EQ(found.component, 3U);
    EXPECT_EQ(find_component("stress").quantity, nullptr);
    EXPECT_EQ(find_component("half_cycles").quantity, nullptr);
}

TEST(Quantities, OfALawsMemoryHaveAColumnPerMaterial)
{
    Problem problem;
    problem.materials.resize(3);
    problem.materials[0].law = LinearElastic{1e7, 0.3};
    problem.materials[1].law = UbcSand();
    problem.materials[2].law = UbcSand();
    const std::vector<RememberedQuantity> remembered = remembered_quantities(problem);
    ASSERT_FALSE(remembered.empty());
    const auto cycles = std::find_if(remembered.begin(), remembered.end(),
                                     [](const auto& each) { return each.name == "half_cycles"; });
    ASSERT_NE(cycles, remembered.end());
    EXPECT_EQ(cycles->column[0], -1);
    EXPECT_EQ(cycles->column[1], static_cast<std::int32_t>(column_of(memory_of(UbcSand()), "half_cycles")));
    EXPECT_EQ(cycles->column[2], cycles->column[1]);
    for (const RememberedQuantity& each : remembered) {
        for (const Quantity& quantity : all_quantities()) EXPECT_NE(each.name, quantity.name);
    }
}

TEST(BodyQuantities, HaveColumnsOfTheirOwn)
{
    std::set<std::string> columns;
    for (const BodyQuantity& quantity : all_body_quantities()) {
        EXPECT_TRUE(columns.insert(column_name(quantity)).second) << quantity.name;
        EXPECT_NE(quantity.value, nullptr) << quantity.name;
        EXPECT_FALSE(quantity.meaning.empty()) << quantity.name;
    }
}

} // namespace
} // namespace quicksand
