#include "io/laws/ubcsand_keys.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace quicksand {
namespace {

const KeyTable& material_table()
{
    static const KeyTable table = [] {
        KeyTable keys = {"file", "", "Keys", {}};
        keys.keys.push_back({.pattern = "materials", .type = ValueType::named_tables, .doc = "Soils."});
        keys.keys.push_back({.pattern = "materials.*", .type = ValueType::table, .doc = "A soil."});
        keys.keys.push_back({.pattern = "materials.*.model",
                             .type = ValueType::word,
                             .required = true,
                             .words = {"ubcsand"},
                             .doc = "Law."});
        for (const SceneKey& key : ubcsand_keys()) keys.keys.push_back(key);
        return keys;
    }();
    return table;
}

struct Reading {
    SceneValues values;
    Diagnostics findings;
    UbcSandParameters parameters;

    std::string shown(const std::string& key) const
    {
        const auto found = std::find_if(values.keys.begin(), values.keys.end(), [&](const ResolvedKey& k) {
            return k.path == "materials.sand." + key;
        });
        return found == values.keys.end() ? "" : found->value;
    }
};

Reading read(const std::string& keys)
{
    const std::string text = "[materials.sand]\nmodel = \"ubcsand\"\n" + keys;
    Reading reading;
    const auto document = read_document("test.toml", text, {}, reading.findings);
    reading.values = check_document(material_table(), *document, reading.findings);
    const NamedTable sand = reading.values.named["materials"].front();
    reading.parameters = resolve_ubcsand(sand, reading.values, reading.findings);
    return reading;
}

void expect_equal(const UbcSandParameters& a, const UbcSandParameters& b)
{
    EXPECT_DOUBLE_EQ(a.elastic_shear_number, b.elastic_shear_number);
    EXPECT_DOUBLE_EQ(a.elastic_bulk_number, b.elastic_bulk_number);
    EXPECT_DOUBLE_EQ(a.plastic_shear_number, b.plastic_shear_number);
    EXPECT_DOUBLE_EQ(a.failure_ratio, b.failure_ratio);
    EXPECT_DOUBLE_EQ(a.peak_friction_deg, b.peak_friction_deg);
    EXPECT_DOUBLE_EQ(a.secondary_factor, b.secondary_factor);
    EXPECT_DOUBLE_EQ(a.stress_floor, b.stress_floor);
}

TEST(UbcSandKeys, ABlowCountADensityAndAPresetGiveTheGenericSet)
{
    expect_equal(read("n1_60 = 10").parameters, ubcsand_from_blow_count(10.0));
    expect_equal(read("relative_density = \"60 %\"").parameters, ubcsand_from_relative_density(0.6));
    expect_equal(read("preset = \"nevada_sand_dr55\"").parameters, nevada_sand_55());
}

TEST(UbcSandKeys, EveryKeyReplacesItsParameterOnly)
{
    for (const SceneKey& key : ubcsand_keys()) {
        const std::string name(last_part(key.pattern));
        if (name == "n1_60" || name == "relative_density" || key.type == ValueType::word) continue;
        const Reading plain = read("n1_60 = 10");
        const double low = key.plausible.lower;
        const double value = low > 0.0 && number_text(low) != plain.shown(name) ? low : key.plausible.upper;
        const Reading changed = read("n1_60 = 10\n" + name + " = " + number_text(value));
        EXPECT_FALSE(changed.findings.has_errors()) << changed.findings.render("");
        EXPECT_EQ(changed.shown(name), number_text(value));
        EXPECT_NE(plain.shown(name), changed.shown(name)) << name;
    }
}

TEST(UbcSandKeys, WhatFollowsFromAKeyFollowsTheOneGiven)
{
    const UbcSandParameters set =
        read("n1_60 = 20\nelastic_shear_number = 800\nconstant_volume_friction_deg = 31").parameters;
    EXPECT_DOUBLE_EQ(set.elastic_bulk_number, 560.0);
    EXPECT_DOUBLE_EQ(set.plastic_shear_number, 0.003 * 800.0 * 400.0 + 100.0);
    EXPECT_DOUBLE_EQ(set.peak_friction_deg, 31.0 + 2.0 + 1.0);
}

TEST(UbcSandKeys, TheWordOfTheLawGivesTheSetAndKeysReplaceItsNumbers)
{
    const UbcSandParameters set = read("n1_60 = 10\nlaw = \"calibrated\"").parameters,
                            expected = calibrated(ubcsand_from_blow_count(10.0));
    expect_equal(set, expected);
    EXPECT_DOUBLE_EQ(set.confining_exponent, expected.confining_exponent);
    EXPECT_DOUBLE_EQ(set.reconsolidation_slope, expected.reconsolidation_slope);
    EXPECT_EQ(set.out_of_plane, OutOfPlaneStress::within_failure);
    const UbcSandParameters replaced =
        read("n1_60 = 10\nlaw = \"calibrated\"\nconfining_exponent = 0.1").parameters;
    EXPECT_DOUBLE_EQ(replaced.confining_exponent, 0.1);
    EXPECT_DOUBLE_EQ(replaced.lateral_exponent, expected.lateral_exponent);
    const UbcSandParameters published = read("n1_60 = 10\nlaw = \"published\"").parameters;
    expect_equal(published, ubcsand_from_blow_count(10.0));
    EXPECT_EQ(published.out_of_plane, OutOfPlaneStress::free);
}

TEST(UbcSandKeys, AMeasuredShearModulusGivesTheElasticNumber)
{
    // at 100 kPa and K0 = 1/2 the mean stress in the plane is 75 kPa
    const UbcSandParameters set = read("n1_60 = 10\nsmall_strain_shear_modulus = \"60 MPa\"").parameters;
    EXPECT_NEAR(set.elastic_shear_number * 100e3 * std::sqrt(0.75), 60e6, 1.0);
    EXPECT_DOUBLE_EQ(set.elastic_bulk_number, 0.7 * set.elastic_shear_number);
}

TEST(UbcSandKeys, TheListOfKeysShowsTheNumbers)
{
    const Reading reading = read("n1_60 = 13.915");
    EXPECT_EQ(reading.shown("elastic_shear_number"), "1043.88");
    EXPECT_EQ(reading.shown("failure_ratio"), "0.741089");
    EXPECT_EQ(reading.shown("peak_friction_deg"), "34.3915");
    EXPECT_EQ(reading.shown("secondary_factor"), "0.6");
}

TEST(UbcSandKeys, TheListOfKeysShowsTheDensityInEveryWay)
{
    const Reading preset = read("preset = \"nevada_sand_dr55\"");
    EXPECT_EQ(preset.shown("n1_60"), "13.915");
    EXPECT_EQ(preset.shown("relative_density"), "0.55");
    EXPECT_EQ(preset.shown("preset"), "nevada_sand_dr55");
    const Reading blows = read("n1_60 = 10");
    EXPECT_EQ(blows.shown("n1_60"), "10");
    EXPECT_EQ(blows.shown("relative_density"), "0.466252");
    EXPECT_EQ(blows.shown("preset"), "none");
}

TEST(UbcSandKeys, TheListOfKeysKeepsWhatIsGivenAsItIsWritten)
{
    const Reading sand = read("relative_density = 0.5481772395\nfailure_ratio = 0.7410891234");
    EXPECT_EQ(sand.shown("relative_density"), "0.5481772395");
    EXPECT_EQ(sand.shown("failure_ratio"), "0.7410891234");
    EXPECT_EQ(sand.shown("n1_60"), "13.8229");
}

TEST(UbcSandKeys, ASandWithoutDensityIsRefused)
{
    EXPECT_EQ(read("").findings.render(""),
              R"(test.toml:1:1: error[missing-key]: [materials.sand] has no density
expected: one of n1_60, relative_density and preset
hint: n1_60 = 13.9, relative_density = 0.55 or preset = "nevada_sand_dr55" gives all other parameters their values
)");
}

TEST(UbcSandKeys, ASandOfTwoDensitiesIsRefused)
{
    EXPECT_EQ(read("n1_60 = 10\nrelative_density = 0.5").findings.render(""),
              R"(test.toml:4:20: error[conflict]: [materials.sand] has a density already, by n1_60
expected: one of n1_60, relative_density and preset
hint: remove one of the two
)");
}

TEST(UbcSandKeys, StiffnessThatIsThePoreWatersIsRefused)
{
    const std::string text = read("n1_60 = 10\nelastic_bulk_number = 22000").findings.render("");
    EXPECT_NE(text.find("test.toml:1:1: error[range]: UBCSAND: elastic_bulk_number = 22000, but it must be"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("this is the drained stiffness, not the pore water's"), std::string::npos) << text;
}

} // namespace
} // namespace quicksand
