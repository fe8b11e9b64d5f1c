#include "solver/faces/boundary.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {
namespace {

const Segment level{{0.0, 0.0}, {2.0, 0.0}}, upright{{2.0, 0.0}, {2.0, 1.0}};

/// A kind that says no more than it has to.
struct Rail {};

GrainHold hold_of(const Rail&, const Segment&, Stage)
{
    return GrainHold::normal;
}

static_assert(SoilKind<Rail> && SoilKind<FreeFace> && SoilKind<ViscousFace>);
static_assert(!SoilKind<Boundary> && !SoilKind<SoilCondition> && !SoilKind<Drained>,
              "what is no kind is not answered by the defaults");

TEST(FaceInterface, AnswersForAKindWhatItDoesNotSay)
{
    const Rail rail;
    EXPECT_FALSE(lies_in_soil(rail) || lets_go(rail) || moves(rail) || presses(rail) || absorbs_waves(rail));
    EXPECT_EQ(displacement_of(rail, level, 1.0), Vector2(0.0, 0.0));
    EXPECT_FALSE(impedance_beyond(rail).has_value());
}

struct Answers {
    SoilCondition soil;
    GrainHold settling, shaking; // of a level segment
    bool lies_in_soil = false, lets_go = false, moves = false, presses = false, absorbs_waves = false;
};

TEST(SoilCondition, AsksItsKind)
{
    using enum GrainHold;
    const MovingWall smooth{{MotionQuantity::velocity, WallGrip::smooth, Vector2::Zero(), 1.0, {}}};
    const Answers kinds[] = {
        {.soil = FreeFace{}, .settling = none, .shaking = none},
        {.soil = FreeFace{SurfaceLoad{}}, .settling = none, .shaking = none, .presses = true},
        {.soil = FixedWall{}, .settling = GrainHold::all, .shaking = GrainHold::all},
        {.soil = RollerWall{}, .settling = normal, .shaking = normal},
        {.soil = TiedSide{}, .settling = none, .shaking = none, .lies_in_soil = true},
        {.soil = MovingWall{}, .settling = GrainHold::all, .shaking = GrainHold::all, .moves = true},
        {.soil = smooth, .settling = normal, .shaking = normal, .moves = true},
        {.soil = ViscousFace{},
         .settling = GrainHold::all,
         .shaking = none,
         .lets_go = true,
         .absorbs_waves = true},
        {.soil = ViscousFace{.held = FaceHold::always},
         .settling = GrainHold::all,
         .shaking = GrainHold::all},
        {.soil = FreeFieldSide{},
         .settling = normal,
         .shaking = none,
         .lets_go = true,
         .presses = true,
         .absorbs_waves = true},
        {.soil = FreeFieldSide{FaceHold::always}, .settling = normal, .shaking = normal, .presses = true},
    };
    for (const Answers& expected : kinds) {
        const SoilCondition& soil = expected.soil;
        SCOPED_TRACE(soil.index());
        EXPECT_EQ(grains_held_by(soil, level, Stage::relaxation), expected.settling);
        EXPECT_EQ(grains_held_by(soil, level, Stage::shaking), expected.shaking);
        EXPECT_EQ(lies_in_soil(soil), expected.lies_in_soil);
        EXPECT_EQ(lets_go(soil), expected.lets_go);
        EXPECT_EQ(moves(soil), expected.moves);
        EXPECT_EQ(presses(soil), expected.presses);
        EXPECT_EQ(absorbs_waves(soil), expected.absorbs_waves);
        const bool acts = expected.presses || expected.lets_go || expected.absorbs_waves;
        EXPECT_EQ(acts_on_soil({"curve", soil}), acts);
    }
}

TEST(SoilCondition, ASteepViscousFaceSettlesAsARoller)
{
    EXPECT_EQ(grains_held_by(ViscousFace{}, upright, Stage::relaxation), GrainHold::normal);
}

TEST(SoilCondition, RockBeyondHasItsOwnImpedance)
{
    EXPECT_FALSE(impedance_beyond(SoilCondition(ViscousFace{})).has_value());
    const SoilCondition rock = ViscousFace{HalfSpace{2400.0, 800.0, 1600.0}};
    EXPECT_EQ(impedance_beyond(rock)->normal, 2400.0 * 1600.0);
    EXPECT_EQ(impedance_beyond(rock)->shear, 2400.0 * 800.0);
}

TEST(SoilCondition, AMovingWallComesToItsPlaceWithinTheStep)
{
    const SoilCondition pushed = MovingWall{
        {MotionQuantity::displacement, WallGrip::smooth, {0.0, 0.0}, 0.2, {SineHistory{0.5}, 0.0}}};
    const Segment top{{4.0, 3.0}, {0.0, 3.0}};
    const double turned = std::sin(std::acos(-1.0) / 3.0);
    EXPECT_LT((displacement_of(pushed, top, 1.0 / 3.0) - Vector2(0.0, -0.2 * turned)).norm(), 1e-15);
    const Vector2 before = displacement_of(pushed, top, 0.3), after = displacement_of(pushed, top, 0.37);
    EXPECT_LT((before + 0.07 * velocity_of(pushed, top, 0.3, 0.07) - after).norm(), 1e-15);
}

TEST(Boundary, HoldsTheWaterAsItHoldsTheGrains)
{
    const auto hold = [](const SoilCondition& soil, const WaterCondition& water) {
        return hold_of(Boundary{"curve", soil, water}, level, Stage::shaking).water;
    };
    EXPECT_EQ(hold(FixedWall{}, Drained{}), WaterHold::none);
    EXPECT_EQ(hold(FixedWall{}, Impervious{}), WaterHold::sealed);
    EXPECT_EQ(hold(FreeFace{}, Impervious{}), WaterHold::with_grains);
    EXPECT_EQ(hold(ViscousFace{}, Impervious{}), WaterHold::with_grains);
    EXPECT_EQ(hold(FixedWall{}, PrescribedWater{}), WaterHold::none);
    EXPECT_EQ(hold(TiedSide{}, Impervious{}), WaterHold::none) << "it lies in the soil";
}

} // namespace
} // namespace quicksand
